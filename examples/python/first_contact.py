# %% [markdown]
# # A first contact: a crowned steel punch on a ground steel surface
#
# What one learns: how to state a problem, what an answer has, and how sure it is.
#
#     python examples/python/first_contact.py
#
# The problem, by the names of the problem file: numbers in SI units, or text with a unit.

# %%
import numpy as np

import shtaerman as st

steel = st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa")
crowned = st.Punch(half_width="5 mm", profile="x^2 / (2*20)")
problem = st.Problem(steel, crowned, st.Load(force="0.8 MN/m"))

# %% [markdown]
# The answer, with its error: a bound from the residual of the answer itself.

# %%
contact = problem.solve()
print(f"settlement     {contact.settlement * 1e6:.5f} um")
print(f"mean pressure  {contact.mean_pressure / 1e6:.3f} MPa")
print(f"peak pressure  {contact.peak_pressure / 1e6:.3f} MPa at x = {contact.peak_pressure_at * 1e3:.1f} mm")
assert contact.error is not None and contact.error.kind == "bound"
print(f"error ({contact.error.kind}) of the pressure {contact.error.pressure:.1e} Pa, of the settlement {contact.error.settlement:.1e} m")

# %% [markdown]
# Pressures are a function of arrays. Their integral is the force, here by Gauss's rule in the angle of `x = a sin(pi t/2)`.

# %%
nodes, weights = np.polynomial.legendre.leggauss(400)
x = 5e-3 * np.sin(0.5 * np.pi * nodes)
force = 5e-3 * 0.5 * np.pi * weights @ (contact.pressure(x) * np.cos(0.5 * np.pi * nodes))
print(f"force          {force / 1e3:.6f} kN/m")
assert abs(force - 0.8e6) < 1e-9 * 0.8e6

# %% [markdown]
# The same base as a callable, and as points of a trace.

# %%
by_callable = problem.replace(profile=lambda x: x**2 / 40).solve()
places = np.linspace(-5e-3, 5e-3, 101)
by_points = problem.replace(profile=(places, places**2 / 40)).solve()
print(f"by a callable  {by_callable.settlement * 1e6:.5f} um, by points {by_points.settlement * 1e6:.5f} um")
assert abs(by_points.settlement / contact.settlement - 1.0) < 1e-9

# %% [markdown]
# Stresses below the surface, on a grid, and the largest equivalent stress there.

# %%
depth = np.linspace(0.0, 8e-3, 81)
stress = contact.stress(np.linspace(-6e-3, 6e-3, 121)[:, None], depth)
row, column = np.unravel_index(np.argmax(stress.von_mises), stress.von_mises.shape)
print(f"von Mises      {stress.von_mises.max() / 1e6:.2f} MPa at the depth of {depth[column] * 1e3:.1f} mm")
assert stress.von_mises.max() < contact.peak_pressure
