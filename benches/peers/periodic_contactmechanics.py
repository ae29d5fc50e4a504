"""The wave in ContactMechanics: its constrained conjugate gradients on a line scan."""
import warnings

import numpy as np

warnings.filterwarnings("ignore")
from ContactMechanics import PeriodicFFTElasticHalfSpace, make_system  # noqa: E402
from SurfaceTopography import UniformLineScan  # noqa: E402
from westergaard import HEIGHT, MEAN, MODULUS, PERIOD, POINTS, report  # noqa: E402


def solve():
    x = np.arange(POINTS) * PERIOD / POINTS
    substrate = PeriodicFFTElasticHalfSpace((POINTS,), MODULUS, (PERIOD,))
    surface = UniformLineScan(HEIGHT * np.cos(2 * np.pi * x / PERIOD), PERIOD, periodic=True)
    system = make_system(substrate=substrate, surface=surface)
    result = system.minimize_proxy(
        external_force=MEAN * PERIOD, pentol=1e-12 * HEIGHT, forcetol=1e-9, maxiter=20000
    )
    return x, np.abs(np.asarray(result.jac).ravel() / substrate.area_per_pt)


report("ContactMechanics 1.8.3", solve)
