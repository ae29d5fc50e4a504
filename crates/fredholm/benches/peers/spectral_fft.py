# The yardstick of ../structured.rs: the same method in NumPy. Run by ../structured_against_numpy.sh, or alone; needs numpy, scipy.
"""The paper's degenerate system for the log kernel, symmetric positive form, Toeplitz + Hankel products by FFT,
conjugate gradients with the diagonal as preconditioner, in NumPy/SciPy: the yardstick of the structured solver.

    python spectral_fft.py --n 1048576 --lambda0 100 --tol 1e-12

Solves the even system for the right-hand sides 1 and xi^2 (nu = 0.25, f0 = lambda0 xi^2, P0 = 0.001) and prints
settlement, pressure at the end and in the middle, iterations, seconds and peak memory.
"""
import argparse, math, resource, time
import numpy as np
from scipy.fft import irfft, rfft


def even_operator(n):
    """k = 0, 2, ..., n; a_k; diagonal of R; product with R (R_km = -(1/((k+m)^2-1) + 1/((k-m)^2-1)))."""
    k = np.arange(0, n + 1, 2)
    p = np.arange(len(k))
    size = 1
    while size < 3 * len(k):
        size *= 2
    toeplitz = -1 / (4.0 * p**2 - 1)
    column = np.zeros(size)
    column[: len(k)] = toeplitz
    column[size - len(k) + 1 :] = toeplitz[1:][::-1]
    t_hat = rfft(column)
    hankel = np.zeros(size)
    hankel[: 2 * len(k) - 1] = -1 / (4.0 * np.arange(2 * len(k) - 1) ** 2 - 1)
    h_hat = rfft(hankel)

    def product(x):
        y = irfft(rfft(x, size) * t_hat, size)[: len(k)]
        z = irfft(rfft(x[::-1], size) * h_hat, size)[len(k) - 1 : 2 * len(k) - 1]
        return y + z

    a = np.where(k == 0, math.log(2), 2 / np.maximum(k, 1))
    diagonal = 1 - 1 / (4.0 * k.astype(float) ** 2 - 1)
    return k, a, diagonal, product


def solve(theta, a, diagonal, product, g, tol):
    """X of (I + theta R diag(a)) X = g."""
    s = np.sqrt(theta * a)
    m = 1 / (1 + s * s * diagonal)
    b = s * g
    y, r = np.zeros_like(b), b.copy()
    z = m * r
    p, rz, goal, it = z.copy(), r @ z, tol * np.linalg.norm(b), 0
    while np.linalg.norm(r) > goal and it < 5000:
        q = p + s * product(s * p)
        alpha = rz / (p @ q)
        y += alpha * p
        r -= alpha * q
        z = m * r
        new = r @ z
        p = z + new / rz * p
        rz, it = new, it + 1
    return y / s, it


if __name__ == "__main__":
    arg = argparse.ArgumentParser()
    arg.add_argument("--n", type=int, default=2**20)
    arg.add_argument("--lambda0", type=float, default=100.0)
    arg.add_argument("--tol", type=float, default=1e-12)
    o = arg.parse_args()
    start = time.perf_counter()
    theta = 15 / (8 * math.pi) * o.lambda0
    k, a, diagonal, product = even_operator(o.n)
    kf = k.astype(float)
    r0 = -2 / (kf * kf - 1)
    r2 = -(1 / ((kf + 2) ** 2 - 1) + 1 / ((kf - 2) ** 2 - 1))
    one, i1 = solve(theta, a, diagonal, product, r0, o.tol)
    par, i2 = solve(theta, a, diagonal, product, o.lambda0 * (r0 + r2) / 2, o.tol)
    y1, y3 = theta * np.sum(a * r0 * one), theta * np.sum(a * r0 * par)
    delta = (0.001 + o.lambda0 * 2 / 3 - y3) / (2 - y1)
    x = delta * one - par
    end = delta - o.lambda0 - theta * np.sum(a * x)
    mid = delta - theta * np.sum(a * x * np.where(k % 4 == 0, 1, -1))
    seconds = time.perf_counter() - start
    print(f"n={o.n} lambda0={o.lambda0:g} iterations={i1}+{i2} seconds={seconds:.3f} "
          f"peak_MB={resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} "
          f"delta0={delta:.13g} p0_end={end:.12g} p0_mid={mid:.12g}")
