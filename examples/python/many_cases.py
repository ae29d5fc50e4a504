# %% [markdown]
# # Six hundred cases in one call: what roughness and load do to the peak pressure
#
# What one learns: arrays of values are broadcast as NumPy does, and a case without an answer says why.
#
#     python examples/python/many_cases.py
#
# A rough crowned punch; roughness down, force across.

# %%
import numpy as np

import shtaerman as st

problem = st.Problem(
    st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa"),
    st.Punch(half_width="5 mm", profile="x^2 / (2*20)"),
    st.Load(force="0.8 MN/m"),
)
roughness = np.geomspace(1e-15, 1e-12, 30)
force = np.linspace(0.1e6, 2e6, 20)
found = st.solve_many(problem, roughness=roughness[:, None], force=force)
print(found)

# %% [markdown]
# Arrays under the names of a contact, one stated error each.

# %%
concentration = found.peak_pressure / found.mean_pressure
print(f"the peak is {concentration.min():.3f} to {concentration.max():.3f} times the mean pressure")
print(f"relative errors up to {found.relative_error.max():.1e}")
assert found.solved.all() and concentration.min() >= 1.0

# %% [markdown]
# A rougher surface is kinder: at every force the peak falls with the roughness.

# %%
falls = (np.diff(found.peak_pressure, axis=0) <= 0.0).mean()
print(f"from one roughness to the next the peak falls in {100 * falls:.0f} % of the steps")
assert falls == 1.0

# %% [markdown]
# Cases that are none do not end the others.

# %%
odd = st.solve_many(problem, force=np.array([1e6, -1e6, np.nan]))
for value, reason in zip(odd.inputs["force"], odd.reason):
    print(f"force {value:g}: {reason or 'solved'}")
assert odd.solved.tolist() == [True, False, False]
