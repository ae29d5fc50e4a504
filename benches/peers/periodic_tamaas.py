"""The wave in Tamaas: conjugate gradients on a grid, tolerance 1e-10."""
import numpy as np
import tamaas as tm
from westergaard import HEIGHT, MEAN, MODULUS, PERIOD, POINTS, report

tm.initialize(1)
tm.set_log_level(tm.LogLevel.error)


def solve():
    x = np.arange(POINTS) * PERIOD / POINTS
    model = tm.Model(tm.model_type.basic_1d, [PERIOD], [POINTS])
    model.E, model.nu = MODULUS, 0.0
    solver = tm.PolonskyKeerRey(model, HEIGHT * np.cos(2 * np.pi * x / PERIOD), 1e-10)
    solver.max_iter = 20000
    solver.solve(MEAN)
    return x, np.array(model.traction).ravel()


report("Tamaas 2.9.0", solve)
