"""Contact of a rigid punch with a rough elastic body (Shtaerman's model), with stated errors.

>>> import shtaerman as st
>>> contact = st.solve(young_modulus="200 GPa", poisson_ratio=0.3, roughness=1.2e-14, half_width="5 mm", force="0.8 MN/m")
>>> contact.mean_pressure
80000000.0
"""

from ._contact import Audit, Contact, Derivatives, Errors, Method, Sensitivities, Stress, Warned
from ._equation import EquationAnswer, EquationErrors, Spectrum, equation, roughness, spectrum
from ._export import export
from ._find import Crown, Crowned, Found, Shaped, find
from ._gradient import value_and_gradient
from ._kernel import Kernel
from ._many import Contacts, solve_many
from ._parts import Foundation, Load, Punch, Solver
from ._problem import Problem
from ._profile import Profile
from ._shtaerman import ConvergenceError, __version__
from ._solve import solve
from ._sweep import Sweep, sweep

__all__ = [
    "Audit",
    "Contact",
    "Contacts",
    "ConvergenceError",
    "Crown",
    "Crowned",
    "Derivatives",
    "EquationAnswer",
    "EquationErrors",
    "Errors",
    "Found",
    "Foundation",
    "Kernel",
    "Load",
    "Method",
    "Problem",
    "Profile",
    "Punch",
    "Sensitivities",
    "Shaped",
    "Solver",
    "Spectrum",
    "Stress",
    "Sweep",
    "Warned",
    "__version__",
    "equation",
    "export",
    "find",
    "roughness",
    "solve",
    "solve_many",
    "spectrum",
    "sweep",
    "value_and_gradient",
]
