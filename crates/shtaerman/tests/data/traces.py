"""Measured traces under a rigid punch on a rough half-plane, by product integration: origin of traces.json, the truth of unilateral/traces.rs.

    p + theta K p = delta - alpha x - f,   K p = -int ln|x - s| p(s) ds

on given zones, f the not-a-knot cubic spline through the points. Legendre polynomials on panels between the points, ever shorter towards the ends of the
zones and towards the points; their moments with the logarithm come from Legendre functions of the second kind, and the dense system is solved at their
Gauss nodes. Free edges move by Newton's method until the pressure vanishes there. It shares no code with the solvers and is exact to about 1e-14, seen by
changing nodes and panels.

The input has the traces, loads and zones near the right ones, such as those of an earlier answer:

    python traces.py < traces.json > again.json      (numpy, scipy)
"""
import json
import sys

import numpy as np
from numpy.polynomial import legendre
from scipy.interpolate import CubicSpline

NODES = 20


def moments(z, n):
    """int_{-1}^1 P_k(t) ln|z - t| dt for k < n."""
    shape = np.shape(z)
    z = np.ravel(np.asarray(z, float))
    sign = np.where(z < 0, -1.0, 1.0)
    a = np.abs(z)
    q = np.empty((n + 1, z.size))
    near = a < 1.02
    if near.any():
        y = a[near]
        d = np.maximum(np.abs(1 - y), 1e-300)
        r = np.empty((n + 1, y.size))
        r[0] = 0.5 * np.log((1 + y) / d)
        r[1] = y * r[0] - 1
        for k in range(1, n):
            r[k + 1] = ((2 * k + 1) * y * r[k] - k * r[k - 1]) / (k + 1)
        q[:, near] = r
    if (~near).any():
        # Downwards by ratios, where upwards would lose all digits.
        y = a[~near]
        ratio = 1 / (y + np.sqrt(y * y - 1))
        ratios = np.empty((n + 1, y.size))
        for k in range(n + 110, 0, -1):
            ratio = k / ((2 * k + 1) * y - (k + 1) * ratio)
            if k <= n:
                ratios[k] = ratio
        r = np.empty((n + 1, y.size))
        r[0] = np.arctanh(1 / y)
        for k in range(1, n + 1):
            r[k] = r[k - 1] * ratios[k]
        q[:, ~near] = r
    d = np.abs(1 - a)
    out = np.empty((n, z.size))
    out[0] = np.where(d > 0, (1 - a) * np.log(np.maximum(d, 1e-300)), 0) + (1 + a) * np.log(1 + a) - 2
    far = a > 30
    if far.any():
        y = a[far]
        out[0, far] = 2 * np.log(y) - 2 * sum(1 / (2 * j * (2 * j + 1) * y ** (2 * j)) for j in range(1, 8))
    for k in range(1, n):
        out[k] = 2 * (q[k + 1] - q[k - 1]) / (2 * k + 1)
    out *= sign[None, :] ** np.arange(n)[:, None]
    return out.reshape((n,) + shape)


class Panels:
    def __init__(self, zones, points, theta):
        stiff = max(theta, 1.0)
        cuts = []
        for left, right in zones:
            inside = [x for x in points if left + 1e-14 < x < right - 1e-14]
            ends = [left] + inside + [right]
            for i, (u, v) in enumerate(zip(ends[:-1], ends[1:])):
                shortest = [1e-11 / stiff if i == 0 else 0.3 / stiff, 1e-11 / stiff if i == len(ends) - 2 else 0.3 / stiff]
                graded = []
                for e in shortest:
                    distances = [0.5 * (v - u)]
                    while distances[-1] > e:
                        distances.append(distances[-1] / 2)
                    graded.append(distances)
                places = [u] + [u + d for d in graded[0][::-1]] + [v - d for d in graded[1]][1:] + [v]
                for c, d in zip(places[:-1], places[1:]):
                    count = max(1, int(np.ceil((d - c) / 0.06)))
                    cuts += [(c + (d - c) * j / count, c + (d - c) * (j + 1) / count) for j in range(count)]
        t, self.w = legendre.leggauss(NODES)
        self.series = np.array([(2 * k + 1) / 2 * self.w * legendre.legval(t, [0] * k + [1]) for k in range(NODES)])
        left, right = np.array(cuts).T
        self.middle, self.half = (left + right) / 2, (right - left) / 2
        self.x = (self.middle[:, None] + self.half[:, None] * t).ravel()
        self.weights = (self.half[:, None] * self.w).ravel()

    def potential(self, x):
        m = moments((np.asarray(x, float)[:, None] - self.middle) / self.half, NODES)
        v = np.einsum("kxp,kj->xpj", m, self.series) * (-self.half)[None, :, None]
        v -= (self.half * np.log(self.half))[None, :, None] * self.w[None, None, :]
        return v.reshape(len(x), self.x.size)


def solve(zones, points, theta, f, load):
    panels = Panels(zones, points, theta)
    x, w = panels.x, panels.weights
    n = x.size
    a, b = np.zeros((n + 2, n + 2)), np.zeros(n + 2)
    a[:n, :n] = theta * panels.potential(x) + np.eye(n)
    a[:n, n], a[:n, n + 1], b[:n] = -1, x, -f(x)
    if "force" in load:
        a[n, :n], b[n] = w, load["force"]
    else:
        a[n, n], b[n] = 1, load["settlement"]
    if "moment" in load:
        a[n + 1, :n], b[n + 1] = w * x, load["moment"]
    elif "eccentricity" in load:
        a[n + 1, :n] = w * (x - load["eccentricity"])
    else:
        a[n + 1, n + 1], b[n + 1] = 1, load["tilt"]
    s = np.linalg.solve(a, b)
    p, settlement, tilt = s[:n], s[n], s[n + 1]

    def pressure(at):
        at = np.atleast_1d(np.asarray(at, float))
        return settlement - tilt * at - f(at) - theta * (panels.potential(at) @ p)

    return settlement, tilt, w @ p, (w * x) @ p, pressure


def contact(zones, points, theta, f, load, walls):
    for _ in range(4):
        settlement, tilt, force, moment, pressure = solve(zones, points, theta, f, load)
        moved = []
        for left, right in zones:
            for at, inwards in ((left, 1), (right, -1)):
                step = 1e-5 * (right - left)
                if at not in walls:
                    here, inside = pressure([at, at + inwards * step])
                    at -= here * inwards * step / (inside - here)
                moved.append(at)
        change = np.abs(np.array(moved) - np.ravel(zones)).max()
        zones = [(moved[i], moved[i + 1]) for i in range(0, len(moved), 2)]
        if change < 1e-9:
            break
    places = [left + share * (right - left) for left, right in zones for share in (0.02, 0.31, 0.5, 0.77, 0.99)]
    gaps = np.linspace(-1, 1, 4001)
    inside = np.zeros(gaps.size, bool)
    for left, right in zones:
        inside |= (gaps >= left) & (gaps <= right)
    if len(walls) == 4:
        gaps = gaps[~inside & (np.abs(gaps) > walls[2])]
    else:
        gaps = gaps[~inside]
    assert all(pressure(places) > 0) and (gaps.size == 0 or pressure(gaps).max() < 1e-9)
    return {
        "zones": zones,
        "settlement": settlement,
        "tilt": tilt,
        "force": force,
        "moment": moment,
        "places": places,
        "pressures": pressure(places).tolist(),
    }


if __name__ == "__main__":
    rows = []
    for case in json.load(sys.stdin)["rows"]:
        xi, heights = np.array(case["xi"]), np.array(case["heights"])
        gap = case.get("inner_half_gap")
        walls = [-1.0, 1.0] + ([gap, -gap] if gap else [])
        zones = [tuple(zone) for zone in case["answer"]["zones"]]
        case["answer"] = contact(zones, xi[1:-1], case["theta0"], CubicSpline(xi, heights), case["load"], walls)
        rows.append(case)
    print(json.dumps({"origin": "traces.py: product integration on graded panels", "rows": rows}, indent=1))
