# %% [markdown]
# # A crown found by optimisers of SciPy, with exact gradients
#
# What one learns: `value_and_gradient()` gives what an optimiser wants, for little more than one solve.
#
#     python examples/python/crown.py
#
# A punch with the crown `s x^2/(2*20)`: without a crown the pressure peaks at the edges, with much of it in the middle.

# %%
import math

import numpy as np
from scipy import optimize

import shtaerman as st

RADIUS = 20.0
steel = st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa")


def crowned(logarithm: float, force: float = 0.8e6) -> st.Problem:
    """The crown of the radius 20 m/s, by ln s."""
    base = f"{math.exp(logarithm)!r} * x^2 / (2*{RADIUS})"
    return st.Problem(steel, st.Punch(half_width="5 mm", profile=base), st.Load(force=force))


# %% [markdown]
# The lowest peak. Where it moves from the edges to the middle the derivative changes its sign, with a jump, and that is the optimum.


# %%
def slope(logarithm: float) -> float:
    _, gradient = st.value_and_gradient(crowned(logarithm), "peak_pressure", ["profile"])
    return float(gradient[0])


best, report = optimize.brentq(slope, math.log(0.1), math.log(100.0), xtol=1e-12, full_output=True)
lowest = crowned(best).solve()
print(f"radius {RADIUS / math.exp(best):.6f} m: peak {lowest.peak_pressure / 1e6:.4f} MPa, after {report.function_calls} gradients")

# %% [markdown]
# The command line has a search of its own for that, without derivatives.

# %%
crown = st.find("crown", crowned(0.0))
assert crown.best.radius is not None
print(f"radius {crown.best.radius:.6f} m: peak {crown.best.contact.peak_pressure / 1e6:.4f} MPa, by find, after {crown.evaluations} solves")

# %% [markdown]
# Crown and force together: a peak of 150 MPa, and contact over 9 of the 10 mm.

# %%
WANTED = np.array([150e6, 9e-3])


def residual(unknown: np.ndarray) -> np.ndarray:
    contact = crowned(*unknown_of(unknown)).solve(audit=False)
    return np.array([contact.peak_pressure, contact.contact_width]) / WANTED - 1.0


def jacobian(unknown: np.ndarray) -> np.ndarray:
    logarithm, force = unknown_of(unknown)
    contact = crowned(logarithm, force).solve(audit=False)
    rows = [st.value_and_gradient(contact, name, ["profile", "force"])[1] for name in ("peak_pressure", "contact_width")]
    return np.array(rows) * np.array([1.0, force]) / WANTED[:, None]


def unknown_of(unknown: np.ndarray) -> tuple[float, float]:
    return float(unknown[0]), 1e6 * math.exp(unknown[1])


solution = optimize.least_squares(residual, x0=[math.log(10.0), 0.0], jac=jacobian, xtol=1e-14, ftol=1e-14, gtol=1e-14)
logarithm, force = unknown_of(solution.x)
both = crowned(logarithm, force).solve()
print(f"radius {RADIUS / math.exp(logarithm):.6f} m, force {force / 1e6:.6f} MN/m: peak {both.peak_pressure / 1e6:.4f} MPa, width {both.contact_width * 1e3:.6f} mm")
assert abs(lowest.peak_pressure / crown.best.contact.peak_pressure - 1.0) < 1e-8
assert abs(both.peak_pressure / 150e6 - 1.0) < 1e-9 and abs(both.contact_width / 9e-3 - 1.0) < 1e-9
