"""Makes potentials.csv, between.csv and functions.csv with 60 digits (mpmath): python make.py

The density has on panel j the Legendre coefficients (1 + j/64) (-1)^(k(k+1)/2) 8^-k, k < 24, exact numbers of the machine, as are the ends of the panels.
potentials.csv: mu (0: ln|x - t|, else |x - t|^-mu), x, the integral of the kernel times the density, and the density at x.
between.csv: mu, a number of the machine, what the place is from it, and the same; these places are no numbers of the machine.
functions.csv: x, ln x, x^0.3, x^1.7.
"""

import random

from mpmath import mp, mpf, log

mp.dps = 60
ORDER = 24
ends = [-1.0, *[-1 + 2.0**-k for k in range(40, 0, -2)], 0.0, 0.5, *[1 - 2.0**-k for k in range(2, 41, 2)], 1.0]


def coefficient(j, k):
    sign = -1 if (k * (k + 1) // 2) % 2 else 1
    return mpf(1 + j / 64) * sign / mpf(8) ** k


def single(mu, z):
    """int P_k(t) sigma(|z - t|) dt on [-1, 1]: the recurrence from exact starts; what it grows is less than 60 digits."""
    right, left = 1 - z, 1 + z
    times_ln = lambda d: d * log(abs(d)) if d else mpf(0)
    if mu == 0:
        first = -z if right == 0 or left == 0 else -right * left * log(abs(left / right)) / 2 - z
        values = [times_ln(right) + times_ln(left) - 2, first, z * first + mpf(2) / 3]
    else:
        signed = lambda d: abs(d) ** (1 - mu) * (1 if d > 0 else -1) if d else mpf(0)
        zeroth = (signed(right) + signed(left)) / (1 - mu)
        values = [zeroth, z * zeroth - (abs(left) ** (2 - mu) - abs(right) ** (2 - mu)) / (2 - mu)]
    for k in range(len(values) - 1, ORDER - 1):
        values.append(((2 * k + 1) * z * values[k] - (k - 1 + mu) * values[k - 1]) / (k + 2 - mu))
    return values


def far(mu, z):
    """The same for |z| >= 2, where the recurrence loses all: the series in 1/z of moments of Legendre polynomials."""
    values = []
    for k in range(ORDER):
        moment, factor = [], mpf(1)
        total = mpf(0)
        # int P_k t^j dt = 2^(k+1) j! ((j+k)/2)!/(((j-k)/2)! (j+k+1)!)
        j, m = k, mpf(2)
        for i in range(1, k + 1):
            m *= mpf(i) / (2 * i + 1)
        weight = mpf(1)
        for n in range(k):
            weight *= (mu + n) / mpf(n + 1)
        while True:
            if mu == 0:
                term = 2 * log(abs(z)) if j == 0 else -m / (j * z**j)
            else:
                term = weight * m / z**j
            total += term
            if abs(term) < mpf(10) ** -58 and j > k + 4:
                break
            m *= mpf((j + 1) * (j + 2)) / ((j - k + 2) * (j + k + 3))
            weight *= (mu + j) * (mu + j + 1) / mpf((j + 1) * (j + 2))
            j += 2
        values.append(total if mu == 0 else total * abs(z) ** (-mu))
    return values


def potential(mu, x):
    total = mpf(0)
    for j, (l, r) in enumerate(zip(ends, ends[1:])):
        half = (mpf(r) - mpf(l)) / 2
        z = (mpf(x) - (mpf(l) + mpf(r)) / 2) / half
        parts = single(mu, z) if abs(z) < 2 else far(mu, z)
        own = sum(coefficient(j, k) * part for k, part in enumerate(parts))
        if mu == 0:
            total += half * own + 2 * half * coefficient(j, 0) * log(half)
        else:
            total += half ** (1 - mu) * own
    return total


def density(x):
    for j, (l, r) in enumerate(zip(ends, ends[1:])):
        if l <= x <= r:
            t = (mpf(x) - (mpf(l) + mpf(r)) / 2) * 2 / (mpf(r) - mpf(l))
            return sum(coefficient(j, k) * mp.legendre(k, t) for k in range(ORDER))
    return mpf(0)


draw = random.Random(20)
places = [-1.0, 1.0, 0.0, 0.25, 1e-13, 1 - 2.0**-20 + 1e-15, -0.999999999, 0.5000000001]
places += [draw.uniform(-1, 1) for _ in range(40)]
places += [draw.choice([-1, 1]) * (1 - 10 ** draw.uniform(-14, -1)) for _ in range(40)]
places += [draw.choice([-1, 1]) * (1 + 10 ** draw.uniform(-14, -1)) for _ in range(12)]
with open("potentials.csv", "w") as file:
    for mu in [0.0, 0.25, 0.75]:
        for x in places:
            print(mu, repr(x), mp.nstr(potential(mpf(mu), x), 25), mp.nstr(density(x), 25), sep=",", file=file)
with open("functions.csv", "w") as file:
    for _ in range(300):
        x = draw.choice([10 ** draw.uniform(-16, 1), 1 + draw.choice([-1, 1]) * 10 ** draw.uniform(-12, -0.1), draw.uniform(0, 2)])
        row = [log(mpf(x)), mpf(x) ** mpf(0.3), mpf(x) ** mpf(1.7)]
        print(repr(x), *[mp.nstr(value, 25) for value in row], sep=",", file=file)
# Windows next to either end of the first panels, of which the places lie between the numbers of the machine.
windows = [(side * (1 - middle * 2.0**-53), r) for side in [-1, 1] for middle, r in [(20, 1e-15), (3000, 1e-13), (8100, 4e-15), (8192, 2e-14), (40000, 2e-12)]]
with open("between.csv", "w") as file:
    for mu in [0.0, 0.25, 0.75]:
        for c, r in windows:
            for _ in range(4):
                grid = 2.0**-32 * 2.0 ** (mp.frexp(mpf(r))[1] - 1)
                offset = round(float(draw.uniform(-1, 1) * r / grid)) * grid
                x = mpf(c) + mpf(offset)
                print(mu, repr(c), repr(offset), mp.nstr(potential(mpf(mu), x), 25), mp.nstr(density(x), 25), sep=",", file=file)
