# %% [markdown]
# # Calibration: the roughness `chi` from a measured load curve
#
# What one learns: exact gradients give least squares their Jacobian for little more than a solve, and with it a confidence interval.
#
#     python examples/python/calibration.py
#
# A steel ball of radius 0.5 m is pressed on a rough plate. The gauge reads the settlement with noise of 30 nm, from a zero that is not known either. The data are made here, with a seed, from a
# roughness that the fit is not told.

# %%
import functools
import math

import numpy as np
from scipy import optimize, stats

import shtaerman as st

TRUTH, ZERO, NOISE = 2.0e-14, 0.15e-6, 30e-9
plate = st.Problem(
    st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness=1e-14),
    st.Punch(geometry="circular", radius="6 mm", profile="x^2 / (2*0.5)"),
    st.Load(force="1 kN"),
)
force = np.linspace(100.0, 3000.0, 12)
generator = np.random.default_rng(1976)
exact = st.solve_many(plate.replace(roughness=TRUTH), force=force).settlement
measured = exact + ZERO + NOISE * generator.standard_normal(force.size)

# %% [markdown]
# The model: settlements at all forces, and their derivatives by `ln chi` and the zero. `value_and_gradient` takes the derivative from the linearised equation of each solved contact.


# %%
@functools.lru_cache
def settlements(chi: float) -> tuple[np.ndarray, np.ndarray]:
    """At all forces, with derivatives by ln chi. Least squares asks for values and Jacobian at the same place."""
    settlement, slope = np.empty(force.size), np.empty(force.size)
    for i, load in enumerate(force):
        contact = plate.replace(roughness=chi, force=load).solve(audit=False)
        settlement[i], gradient = st.value_and_gradient(contact, "settlement", ["roughness"])
        slope[i] = chi * gradient[0]
    return settlement, slope


def residual(unknown: np.ndarray) -> np.ndarray:
    """For ln chi and the zero in micrometres."""
    return (settlements(math.exp(unknown[0]))[0] + 1e-6 * unknown[1] - measured) / NOISE


def jacobian(unknown: np.ndarray) -> np.ndarray:
    slope = settlements(math.exp(unknown[0]))[1]
    return np.column_stack([slope, np.full(force.size, 1e-6)]) / NOISE


# %% [markdown]
# The Jacobian is right: against differences.

# %%
start = np.array([math.log(1e-14), 0.0])
h = 1e-4
difference = (residual(start + [h, 0.0]) - residual(start - [h, 0.0])) / (2 * h)
assert np.abs(jacobian(start)[:, 0] / difference - 1.0).max() < 1e-6

# %% [markdown]
# Least squares from a guess that is off by a factor of two.

# %%
fit = optimize.least_squares(residual, start, jac=jacobian, xtol=1e-10, ftol=1e-10, gtol=1e-10)
freedom = force.size - fit.x.size
spread = math.sqrt(2.0 * fit.cost / freedom)
covariance = np.linalg.inv(fit.jac.T @ fit.jac) * spread**2
reach = stats.t.ppf(0.975, freedom) * np.sqrt(np.diag(covariance))
low, high = np.exp(fit.x[0] + np.array([-1.0, 1.0]) * reach[0])
print(f"chi  = {math.exp(fit.x[0]):.4e} m/Pa, 95 % between {low:.4e} and {high:.4e}; the truth is {TRUTH:.1e}")
print(f"zero = {fit.x[1]:.4f} um +- {reach[1]:.4f}; the truth is {1e6 * ZERO:.4f}")
print(f"noise {spread * NOISE * 1e9:.1f} nm, after {settlements.cache_info().misses} times {force.size} contacts")
assert fit.success and np.abs(fit.jac.T @ fit.fun).max() < 1e-4 * np.linalg.norm(fit.jac)
assert low < TRUTH < high and abs(fit.x[1] - 1e6 * ZERO) < reach[1]

# %% [markdown]
# Is it an interval of 95 %? One in twenty would miss. For small noise the fit is linear in it: ten thousand times the noise, through the Jacobian at the truth, and the same interval each time.

# %%
at_truth = np.array([math.log(TRUTH), 1e6 * ZERO])
slopes = jacobian(at_truth)
inverse = np.linalg.inv(slopes.T @ slopes)
noise = generator.standard_normal((10_000, force.size))
moved = noise @ slopes @ inverse
left = noise - moved @ slopes.T
spreads = np.sqrt((left**2).sum(axis=1) / freedom)
covered = np.abs(moved[:, 0]) <= stats.t.ppf(0.975, freedom) * spreads * math.sqrt(inverse[0, 0])
print(f"of 10000 such experiments {100 * covered.mean():.1f} % have the truth in their interval")
# Three standard deviations of a share of 0.95 in ten thousand.
assert abs(covered.mean() - 0.95) < 3 * math.sqrt(0.95 * 0.05 / covered.size)

# %% [markdown]
# What the roughness is worth: the same ball on a smooth plate would sink less, and press harder.

# %%
rough = plate.replace(roughness=math.exp(fit.x[0])).solve()
smooth = plate.replace(roughness=0).solve()
print(f"peak {rough.peak_pressure / 1e6:.1f} MPa, smooth {smooth.peak_pressure / 1e6:.1f} MPa; contact {1e3 * rough.contact_width:.3f} mm wide, smooth {1e3 * smooth.contact_width:.3f} mm")
assert rough.peak_pressure < smooth.peak_pressure and rough.contact_width > smooth.contact_width
