# %% [markdown]
# # A kernel of one's own: a rough punch on a layer under antiplane shear
#
# What one learns: a kernel that is not built in is a function with its split, and what is known of its limits checks it.
#
#     python examples/python/own_kernel.py
#
# A layer of the thickness `h` on a rigid base is sheared out of its plane by a stamp of the half-width 1. Where the stress `phi` passes through a rough layer, Shtaerman's condition is
#
# `phi(x) + theta0 int_(-1)^1 ln coth(pi |x - s|/(4 h)) phi(s) ds = 1`.
#
# Near the diagonal `ln coth z = -ln z + z^2/3 + ..`, so the kernel is `A ln|x - s| + B` with `A = -1` and the smooth `B(d) = ln coth(pi d/(4 h)) + ln d`.

# %%
import math

import numpy as np

import shtaerman as st

THETA0 = 2.0


def layer(h: float) -> st.Kernel:
    def split(x: float, s: float, distance: float) -> tuple[float, float]:
        z = 0.25 * math.pi * distance / h
        # ln(z coth z): its series where the quotient would have no digits, and ln z - log1p(..) where coth z is 1 to rounding.
        if z < 1e-3:
            smooth = z * z / 3 - 7 * z**4 / 90
        else:
            smooth = math.log(z) + math.log1p(2.0 / math.expm1(2.0 * z)) if z < 300.0 else math.log(z)
        return -1.0, smooth + math.log(4.0 * h / math.pi)

    return st.Kernel(split, singularity="logarithm", even=True)


def solve(kernel: st.Kernel | str, at: list[float], **parameters: float) -> st.EquationAnswer:
    return st.equation(kind="second", lambda_=THETA0, rhs=1, kernel=kernel, at=at, **parameters)


# %% [markdown]
# From a thick layer to a thin one, each with its estimate of the error.

# %%
print("    h      force        phi(0)      phi(1)      nodes  error")
force = {}
for h in (10.0, 1.0, 0.3, 0.1):
    found = solve(layer(h), [0.0, 1.0])
    assert found.integral is not None and found.error.solution_sup is not None and found.error.solution_sup < 1e-10
    force[h] = found.integral
    print(f"{h:6.2f}  {found.integral:.9f}  {found.phi[0]:.8f}  {found.phi[1]:.8f}  {found.method.n:5d}  {found.error.solution_sup:.0e}")

# %% [markdown]
# **Thick**: the layer is a half-plane of the gauge `4 h/pi`, `ln(1/|x - s|) + ln(4 h/pi)`. The constant moves to the right-hand side, `phi = (1 - theta0 ln(4 h/pi) P) phi_1` with the solution
# `phi_1` of the built-in kernel: `1/P = 1/P_1 + theta0 ln(4 h/pi)`. What is left is of the order `h^-2`.

# %%
plane = solve("log", [0.0], a=1.0)
assert plane.integral is not None
for h in (10.0, 100.0):
    thick = solve(layer(h), [0.0]).integral
    assert thick is not None
    gauged = 1.0 / (1.0 / plane.integral + THETA0 * math.log(4.0 * h / math.pi))
    print(f"h = {h:5.1f}: force {thick:.9f}, of the half-plane {gauged:.9f}")
    assert abs(thick / gauged - 1.0) < 0.5 / h**2

# %% [markdown]
# **Thin**: a bed of springs. `int ln coth(pi |t|/(4 h)) dt = pi h` over the whole line, so that `phi = 1/(1 + theta0 pi h)` but near the ends, over a width of the order `h`.

# %%
middle = solve(layer(0.05), [0.0]).phi.item()
springs = 1.0 / (1.0 + THETA0 * math.pi * 0.05)
print(f"h = 0.05: phi(0) = {middle:.9f}, of springs {springs:.9f}")
assert abs(middle / springs - 1.0) < 1e-6

# %% [markdown]
# The solution is one: put back into the equation, with a quadrature that shares nothing with collocation (graded towards the diagonal, where the logarithm is).

# %%
nodes, weights = np.polynomial.legendre.leggauss(40)
h, x = 0.3, 0.37
kernel = layer(h)
places, masses = [], []
for end in (-1.0, 1.0):
    # From x to the end in the variable t^4: smooth where the kernel is singular; and halves that shrink towards the end, where phi has its own singularity.
    length = end - x
    cuts = [0.0, *(1.0 - 0.5**k for k in range(1, 30)), 1.0]
    for left, right in zip(cuts[:-1], cuts[1:]):
        t = 0.5 * (left + right) + 0.5 * (right - left) * nodes
        w = 0.5 * (right - left) * weights
        if left == 0.0:
            u = t / right
            places.append(x + length * right * u**4)
            masses.append(abs(length) * right * 4 * u**3 * w / right)
        else:
            places.append(x + length * t)
            masses.append(abs(length) * w)
s, mass = np.concatenate(places), np.concatenate(masses)
distance = np.abs(s - x)
values = np.log(1.0 / np.tanh(0.25 * np.pi * distance / h))
found = solve(kernel, [x, *s.tolist()])
residual = found.phi[0] + THETA0 * (mass * values) @ found.phi[1:] - 1.0
print(f"residual at x = {x}: {residual:.1e}")
assert abs(residual) < 1e-9
