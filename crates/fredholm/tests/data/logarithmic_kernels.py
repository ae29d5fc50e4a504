"""Reference values for the companion of kernel 2, and for long ranges of kernels 2 and 3, into logarithmic_kernels.json.

The parameters are the doubles nearest to the decimals given. mpmath, 40 digits, integrals by Gauss-Legendre rules in variables in which the integrands are polynomials or analytic; no formula of the
library is used for them. The relation (1.2) of the companion is checked by quadrature before anything is written.
"""

import json
from mpmath import acos, cos, ellipfun, ellipk, linspace, ln, mp, mpf, pi, quad, sin, sqrt, tan

mp.dps = 40


def text(value):
    return mp.nstr(value, 22, strip_zeros=False)


def chebyshev(n, t):
    return cos(n * acos(min(max(t, mpf(-1)), mpf(1))))


def gauss(f, points, degree=8):
    return quad(f, points, method="gauss-legendre", maxdegree=degree)


def square(inner, outer, gauge):
    a, b, length = mpf(float(outer)), mpf(float(inner)), mpf(float(gauge))
    mean, radius = (a * a + b * b) / 2, (a * a - b * b) / 2

    def phi(n, x):
        return chebyshev(n, (x * x - mean) / radius)

    def by_angle(f):
        """int f w dx over (b, a) with x^2 = mean + radius cos t, w dx = dt."""
        return quad(lambda t: f(sqrt(mean + radius * cos(t))), linspace(0, pi, 9))

    eigenvalues = [pi * ln(4 * length**2 / (a * a - b * b))] + [pi / n for n in range(1, 8)]
    norms = [pi] + [pi / 2] * 7
    for n in (0, 1, 3):
        x = sqrt(mean + radius * cos(mpf(1)))
        # The singularity at t = 1 is an end of two of the ranges.
        left = quad(
            lambda t: ln(length**2 / abs(2 * radius * sin((t - 1) / 2) * sin((t + 1) / 2))) * cos(n * t),
            [0, mpf(1) / 2, 1, 2, pi],
        )
        assert abs(left - eigenvalues[n] * phi(n, x)) < mpf(10) ** -25, (inner, n)
        assert abs(by_angle(lambda s: phi(n, s) ** 2) - norms[n]) < mpf(10) ** -25
        assert abs(by_angle(lambda s: phi(n, s) * phi(n + 2, s))) < mpf(10) ** -25
    points = [b + (a - b) * mpf(share) for share in ("0", "0.03", "0.4", "0.77", "0.999", "1")]
    # x enters by its double, since near the ends the functions are steep.
    points = [mpf(float(x)) for x in points]
    integrals = {j: gauss(lambda x: phi(j, x), [b, a]) for j in (0, 1, 2, 3, 4, 7, 20, 41, 100)}
    gram = {
        f"{k},{m}": text(gauss(lambda x: phi(k, x) * phi(m, x), [b, a]))
        for k, m in ((0, 0), (0, 1), (1, 1), (1, 2), (2, 5), (3, 3), (4, 10), (20, 21), (40, 40))
    }
    potentials = []
    for share in ("0", "0.1", "0.5", "0.9", "1"):
        x = mpf(float(b + (a - b) * mpf(share)))
        ranges = [p for p in (b, x, a)]
        ranges = sorted(set(ranges))

        def kernel(s):
            return ln(length**2 / abs(x * x - s * s)) if s != x else mpf(0)

        potentials.append(
            {
                "x": text(x),
                "one": text(quad(kernel, ranges)),
                "identity": text(quad(lambda s: s * kernel(s), ranges)),
            }
        )
    return {
        "inner": inner,
        "outer": outer,
        "gauge": gauge,
        "eigenvalues": [text(v) for v in eigenvalues],
        "norms": [text(v) for v in norms],
        "functions": [
            {"x": text(x), "values": {str(n): text(phi(n, x)) for n in (0, 1, 2, 5, 20)}} for x in points
        ],
        "integrals": {str(j): text(v) for j, v in integrals.items()},
        "gram": gram,
        "potentials": potentials,
    }


def sine(alpha):
    a = mpf(float(alpha))
    sigma, tau = sin(a / 2), tan(a / 2)

    def even(j):
        return 2 * gauss(lambda x: chebyshev(2 * j, sin(x / 2) / sigma), linspace(0, a, 5))

    def odd(j):
        """In the variable with tan(x/2) = tau cos t; the pole lies 1/tau from t = pi/2."""
        cuts = [pi / 2 - c for c in (pi / 2, 1, mpf("0.3"), mpf("0.1"), mpf("0.03"), mpf("0.01"), mpf("0.003"), mpf("0.001"), mpf("0.0003"), 0)]
        f = lambda t: cos(2 * j * t) * 2 * tau * sin(t) / (1 + (tau * cos(t)) ** 2)
        return 2 * gauss(f, cuts)

    indices = (0, 1, 2, 3, 10, 50, 200)
    return {
        "alpha": alpha,
        "even": {str(j): text(even(j)) for j in indices},
        "odd": {str(j): text(odd(j)) for j in indices},
    }


def ratio(inner, outer):
    """Integrals of cos j t over x = a dn(K t/pi), by Fourier coefficients of dn: trapezoidal sums of a periodic analytic function."""
    a, b = mpf(float(outer)), mpf(float(inner))
    k2 = 1 - (b / a) ** 2
    K = ellipk(k2)
    dn = ellipfun("dn")
    out = {}
    for j in (0, 1, 2, 3, 10, 50, 200):
        if j == 0:
            out["0"] = text(a - b)
            continue
        # int_b^a cos(j t) dx by parts: a - (-1)^j b - j int_0^pi x sin(j t) dt
        x = lambda t: a * dn(K * t / pi, m=k2)
        value = gauss(lambda t: x(t) * sin(j * t), linspace(0, pi, 17), 7)
        out[str(j)] = text(a - (-1) ** j * b - j * value)
    return {"inner": inner, "outer": outer, "integrals": out}


if __name__ == "__main__":
    result = {
        "origin": "mpmath, 40 digits, by logarithmic_kernels.py; 22 digits kept",
        "square": [
            square(*case)
            for case in (
                ("0", "1", "1"),
                ("0", "2.5", "1"),
                ("0.25", "1", "1"),
                ("1", "2", "0.5"),
                ("1", "3", "1"),
                ("0.01", "1", "1"),
                ("0.000001", "1", "1"),
                ("0.999", "1", "1"),
            )
        ],
        "sine": [sine(alpha) for alpha in ("0.001", "0.3", "1.5", "3.1", "3.14")],
        "ratio": [ratio(*case) for case in (("1e-8", "1"), ("0.25", "1"), ("0.9", "1"), ("0.999", "1"))],
    }
    print(json.dumps(result, indent=1))
