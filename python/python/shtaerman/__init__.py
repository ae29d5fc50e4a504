"""Contact of a rigid punch with a rough elastic body (Shtaerman's model), with stated errors.

>>> import shtaerman as st
>>> contact = st.solve(young_modulus="200 GPa", poisson_ratio=0.3, roughness=1.2e-14, half_width="5 mm", force="0.8 MN/m")
>>> contact.mean_pressure
80000000.0
"""

from ._contact import Audit, Contact, Derivatives, Errors, Method, Sensitivities, Stress, Warned
from ._many import Contacts, solve_many
from ._parts import Foundation, Load, Punch, Solver
from ._problem import Problem
from ._profile import Profile
from ._shtaerman import ConvergenceError, __version__
from ._solve import solve

__all__ = [
    "Audit",
    "Contact",
    "Contacts",
    "ConvergenceError",
    "Derivatives",
    "Errors",
    "Foundation",
    "Load",
    "Method",
    "Problem",
    "Profile",
    "Punch",
    "Sensitivities",
    "Solver",
    "Stress",
    "Warned",
    "__version__",
    "solve",
    "solve_many",
]
