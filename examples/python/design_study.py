# %% [markdown]
# # A design study: the crown of a roller edge that forgives misalignment
#
# What one learns: the best design for the drawing is not the best one for the shop; a study over loads and tolerances finds the difference, and a bound on the last answer says that it is no artefact.
#
#     python examples/python/design_study.py
#
# A bar of 10 mm width carries 0.8 MN/m, give or take a fifth. The assembly puts the load up to 0.4 mm off the middle. Which radius of the crown keeps the peak pressure lowest in the worst case?

# %%
import math

import numpy as np
from scipy import optimize

import shtaerman as st

steel = st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa")
FORCE = np.array([0.64e6, 0.8e6, 0.96e6])
ECCENTRICITY = np.array([0.0, 0.1e-3, 0.2e-3, 0.3e-3, 0.4e-3])


def bar(radius: float) -> st.Problem:
    base = 0 if math.isinf(radius) else f"x^2 / (2*{radius!r})"
    return st.Problem(steel, st.Punch(half_width="5 mm", profile=base), st.Load(force=0.8e6))


def peaks(radius: float) -> np.ndarray:
    """Peak pressures (Pa), a row for each force, a column for each eccentricity. By symmetry one side is enough."""
    found = st.solve_many(bar(radius), force=FORCE[:, None], eccentricity=ECCENTRICITY, outputs=["peak_pressure"])
    assert found.solved.all() and found.relative_error.max() < 1e-6
    return np.asarray(found.peak_pressure)


# %% [markdown]
# The best crown for the nominal load alone, as on the drawing; `find` has a search for it.

# %%
nominal = st.find("crown", bar(20.0)).best
assert nominal.radius is not None
print(f"nominal: radius {nominal.radius:.3f} m, peak {nominal.contact.peak_pressure / 1e6:.2f} MPa")

# %% [markdown]
# The worst of the fifteen cases, for crowns from flat to round.

# %%
radii = [math.inf, *np.geomspace(64.0, 1.0, 13).tolist()]
worst = np.array([peaks(radius).max() for radius in radii])
for radius, value in zip(radii, worst):
    print(f"radius {radius:8.2f} m: worst peak {value / 1e6:7.2f} MPa")

# %% [markdown]
# Between the two neighbours of the best one there is a single minimum, where the peak at the edge and the one in the middle change places.

# %%
best = int(np.argmin(worst))
assert 1 < best < len(radii) - 1
ends = np.log([radii[best + 1], radii[best - 1]])
search = optimize.minimize_scalar(lambda logarithm: peaks(math.exp(logarithm)).max(), bounds=tuple(ends), method="bounded", options={"xatol": 1e-6})
radius = math.exp(search.x)
robust = peaks(radius)
print(f"robust:  radius {radius:.3f} m, worst peak {robust.max() / 1e6:.2f} MPa after {search.nfev} studies of {robust.size} cases")

# %% [markdown]
# What the drawing would have cost, and what robustness costs where all is in line. A rounder crown is the better one.

# %%
of_drawing = peaks(nominal.radius)
price = robust[1, 0] / of_drawing[1, 0] - 1.0
gain = 1.0 - robust.max() / of_drawing.max()
print(f"the robust crown lowers the worst peak by {100 * gain:.1f} %, and raises that of the nominal load by {100 * price:.1f} %")
assert radius < nominal.radius and gain > 0.0 and price > 0.0
assert robust.max() <= worst.min()

# %% [markdown]
# Tolerance of the radius: how far it may be off until a tenth of the gain over the flat bar is lost.

# %%
flat = worst[0]
allowed = robust.max() + 0.1 * (flat - robust.max())


def excess(logarithm: float) -> float:
    return float(peaks(math.exp(logarithm)).max()) - allowed


smallest = math.exp(optimize.brentq(excess, math.log(radius / 5), math.log(radius), xtol=1e-4))
largest = math.exp(optimize.brentq(excess, math.log(radius), math.log(radius * 5), xtol=1e-4))
print(f"radii from {smallest:.2f} to {largest:.2f} m keep nine tenths of the gain")
assert smallest < radius < largest

# %% [markdown]
# The deciding case once more with its audit: the peak is bounded, not only computed.

# %%
row, column = np.unravel_index(np.argmax(robust), robust.shape)
contact = bar(radius).replace(force=FORCE[row], eccentricity=ECCENTRICITY[column]).solve()
error = contact.error
assert error is not None and error.kind == "bound" and error.peak_pressure is not None
print(f"worst case: force {FORCE[row] / 1e6:.2f} MN/m, {ECCENTRICITY[column] * 1e3:.1f} mm off: {contact.peak_pressure / 1e6:.3f} MPa, and the peak at most {error.peak_pressure:.1e} Pa off")
assert abs(contact.peak_pressure - robust.max()) <= error.peak_pressure + 1e-6 * robust.max()
