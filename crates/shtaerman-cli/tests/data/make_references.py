"""Writes references.json: bilateral contacts solved by a method that shares nothing with the program.

    p0(xi) + theta0 int_{-1}^{1} ln(1/|xi - s|) p0(s) ds = delta0 - alpha0 xi - f0(xi),   int p0 = P0,   int xi p0 = M0

Product-integration collocation: p0 is a polynomial of degree ORDER - 1 on each of a set of panels that halve towards both ends
(to 2^-LEVELS), where p0 behaves as (1 -+ xi) ln(1 -+ xi). The integral over the panel of the collocation point is exact,
    int_{-1}^{1} ln|t - s| P_k(s) ds = 2 (Q_{k+1}(t) - Q_{k-1}(t))/(2k + 1),   k >= 1, |t| <= 1,
with the Legendre functions of the second kind; over the other panels it is a Gauss rule of 400 (480) points. Pressures at other places
come from the equation itself. Every problem is solved twice, with 20 and with 24 points a panel; the script stops where
the two differ by more than 2e-13 of the largest pressure (displacement), and checks the closed form of theta0 = 0.

Needs NumPy:  python make_references.py
"""

import json
from pathlib import Path

import numpy as np
from numpy.polynomial import legendre

LEVELS = 44


def log_moments(order, t):
    """int_{-1}^{1} ln|t - s| P_k(s) ds for k < order and one t in [-1, 1]."""
    k = np.arange(1, order)
    if abs(t) == 1.0:
        return np.concatenate([[2 * np.log(2.0) - 2], -2.0 / (k * (k + 1)) * np.sign(t) ** k])
    q = np.zeros(order + 1)
    q[0] = np.arctanh(t)
    q[1] = t * q[0] - 1.0
    for j in range(1, order):
        q[j + 1] = ((2 * j + 1) * t * q[j] - j * q[j - 1]) / (j + 1)
    first = (1 + t) * np.log1p(t) + (1 - t) * np.log1p(-t) - 2
    return np.concatenate([[first], 2 * (q[2:] - q[:-2]) / (2 * k + 1)])


class Layer:
    """The kernel ln(1/|x - s|) on graded panels; independent of theta0."""

    def __init__(self, order):
        self.order = order
        inner = 1.0 - 2.0 ** -np.arange(0, LEVELS + 1)  # 0, 1/2, 3/4, ...
        right = np.concatenate([inner, [1.0]])
        self.breaks = np.concatenate([-right[::-1], right[1:]])
        self.local, self.rule = legendre.leggauss(order)
        self.to_legendre = np.linalg.inv(legendre.legvander(self.local, order - 1))
        self.fine, self.fine_rule = legendre.leggauss(20 * order)
        self.spread = legendre.legvander(self.fine, order - 1) @ self.to_legendre
        half = 0.5 * np.diff(self.breaks)
        middle = 0.5 * (self.breaks[1:] + self.breaks[:-1])
        self.half, self.middle = half, middle
        self.x = (middle[:, None] + half[:, None] * self.local).ravel()
        self.weights = (half[:, None] * self.rule).ravel()
        self.matrix = np.array([self.row(x, i // order) for i, x in enumerate(self.x)])

    def row(self, x, own):
        """Weights w with int ln(1/|x - s|) p(s) ds = w . p(nodes), x on the panel `own`."""
        parts = []
        for panel, (half, middle) in enumerate(zip(self.half, self.middle)):
            # A place between two panels is an end of both.
            touching = x in (self.breaks[panel], self.breaks[panel + 1])
            if panel == own or touching:
                t = 1.0 if x == self.breaks[panel + 1] else -1.0 if touching else (x - middle) / half
                moments = log_moments(self.order, t)
                plain = np.zeros(self.order)
                plain[0] = 2.0
                parts.append(-half * (moments + np.log(half) * plain) @ self.to_legendre)
            else:
                distance = np.abs((x - middle) - half * self.fine)
                parts.append(-half * (self.fine_rule * np.log(distance)) @ self.spread)
        return np.concatenate(parts)

    def panel(self, x):
        return int(np.clip(np.searchsorted(self.breaks, x) - 1, 0, len(self.half) - 1))

    def solve(self, theta0, profile, vertical, rotational, places):
        """delta0, alpha0, P0, M0, pressures at the places and the stiffness."""
        x, w = self.x, self.weights
        sides = np.stack([np.ones_like(x), x, profile(x)], axis=1)
        solved = np.linalg.solve(np.eye(len(x)) + theta0 * self.matrix, sides)
        (c11, c12, f1), (c21, c22, f2) = w @ solved, (w * x) @ solved
        # P = c11 delta - c12 alpha - f1, M = c21 delta - c22 alpha - f2: four unknowns delta, alpha, P, M
        rows = [[c11, -c12, -1, 0], [c21, -c22, 0, -1]]
        right = [f1, f2]
        name, value = vertical
        rows.append({"settlement": [1, 0, 0, 0], "force": [0, 0, 1, 0]}[name])
        right.append(value)
        name, value = rotational
        eccentric = name == "eccentricity"
        rows.append({"tilt": [0, 1, 0, 0], "moment": [0, 0, 0, 1], "eccentricity": [0, 0, -value, 1]}[name])
        right.append(0.0 if eccentric else value)
        delta, alpha, force, moment = np.linalg.solve(np.array(rows, float), np.array(right, float))
        p = delta * solved[:, 0] - alpha * solved[:, 1] - solved[:, 2]
        at = [delta - alpha * s - profile(np.array(s)) - theta0 * self.row(s, self.panel(s)) @ p for s in places]
        return np.array([delta, alpha, force, moment]), np.array(at, float), np.array([[c11, c12], [c21, c22]])


PLACES = [-1.0, -0.999, -0.6, 0.0, 0.3, 0.95, 1.0]
LAYERS = [Layer(20), Layer(24)]


def reference(theta0, profile, vertical, rotational):
    coarse, fine = (layer.solve(theta0, profile, vertical, rotational, PLACES) for layer in LAYERS)
    for one, other in zip(coarse, fine):
        scale = max(1e-300, np.abs(other).max())
        assert np.abs(one - other).max() <= 2e-13 * scale, (theta0, vertical, rotational, one - other)
    if theta0 == 0.0:
        (delta, alpha, _, _), p, _ = fine
        s = np.array(PLACES)
        assert np.allclose(p, delta - alpha * s - profile(s), rtol=0, atol=1e-14 * max(1, np.abs(p).max()))
        assert np.allclose(fine[2], [[2, 0], [0, 2 / 3]], rtol=1e-14, atol=1e-14)
    return fine


PROFILES = {
    "0": lambda x: 0.0 * x,
    "exp(xi)": np.exp,
    "xi^4 - xi/2": lambda x: x**4 - x / 2,
}


def dimensionless(theta0, profile, vertical, rotational, head=None):
    (delta, alpha, force, moment), p, stiffness = reference(theta0, PROFILES[profile], vertical, rotational)
    head = head or f"theta0 = {theta0!r}\n"
    toml = f'[dimensionless]\n{head}profile = "{profile}"\n'
    toml += "".join(f"{name} = {value!r}\n" for name, value in (vertical, rotational))
    return {
        "name": f"theta0 = {theta0:.6g}, f0 = {profile}, {vertical[0]} and {rotational[0]}",
        "toml": toml,
        "theta0": theta0,
        "half_width": 1.0,
        "settlement": delta,
        "tilt": alpha,
        "force": force,
        "moment": moment,
        "stiffness": stiffness.tolist(),
        "places": PLACES,
        "pressures": p.tolist(),
    }


def physical(name, toml, E, nu, chi, a, profile, vertical, rotational, body=None):
    """All in SI; p = E p0, delta = chi E delta0, alpha = (chi E/a) alpha0, P = a E P0, M = a^2 E M0."""
    compliance = (1 - nu**2) / E + ((1 - body[1] ** 2) / body[0] if body else 0.0)
    theta0 = 2 / np.pi * a * compliance / chi
    scale = {"settlement": chi * E, "tilt": chi * E / a, "force": a * E, "moment": a * a * E, "eccentricity": a}
    scaled = [(key, value / scale[key]) for key, value in (vertical, rotational)]
    (delta, alpha, force, moment), p, k = reference(theta0, lambda xi: profile(a * xi) / (chi * E), *scaled)
    coupling = a / chi
    return {
        "name": name,
        "toml": toml,
        "theta0": theta0,
        "half_width": a,
        "settlement": delta * scale["settlement"],
        "tilt": alpha * scale["tilt"],
        "force": force * scale["force"],
        "moment": moment * scale["moment"],
        "stiffness": [[k[0, 0] * coupling, k[0, 1] * a * coupling], [k[1, 0] * a * coupling, k[1, 1] * a * a * coupling]],
        "places": [a * s for s in PLACES],
        "pressures": (E * p).tolist(),
    }


INCH, LBF = 0.0254, 4.4482216152605
PSI = LBF / INCH**2

FLAT, EXP, QUARTIC = "0", "exp(xi)", "xi^4 - xi/2"
CASES = [
    dimensionless(0.0, FLAT, ("force", 1.0), ("moment", 0.25)),
    dimensionless(0.0, EXP, ("settlement", 2.5), ("tilt", -0.4)),
    dimensionless(0.05, QUARTIC, ("force", 1.7), ("moment", -0.31)),
    dimensionless(0.05, EXP, ("settlement", 3.0), ("moment", 0.1)),
    dimensionless(1.0, FLAT, ("force", 1.0), ("eccentricity", 0.2)),
    dimensionless(1.0, EXP, ("force", 2.0), ("tilt", 0.0)),
    dimensionless(1.0, QUARTIC, ("settlement", 2.0), ("eccentricity", -0.1)),
    dimensionless(13.0, QUARTIC, ("force", 1.7), ("moment", -0.31)),
    dimensionless(13.0, EXP, ("settlement", 9.0), ("tilt", 0.3)),
    dimensionless(13.0, FLAT, ("settlement", 5.0), ("moment", 0.05)),
    dimensionless(60.0, QUARTIC, ("force", 1.0), ("tilt", 0.0)),
    dimensionless(60.0, EXP, ("force", 1.0), ("moment", 0.2)),
    dimensionless(60.0, FLAT, ("settlement", 40.0), ("eccentricity", 0.3)),
    dimensionless(
        2 * (1 - 0.25**2) * 10.0 / np.pi, QUARTIC, ("force", 0.5), ("moment", 0.0), "lambda0 = 10.0\npoisson_ratio = 0.25\n"
    ),
    physical(
        "steel on a coarse surface, force and moment",
        '[foundation]\nyoung_modulus = "200 GPa"\npoisson_ratio = 0.3\nroughness = "1.2e-13 m/Pa"\n'
        '[punch]\nhalf_width = "5 mm"\nprofile = "x^2 / (2*0.8)"\n'
        '[load]\nforce = "0.8 MN/m"\nmoment = "100 N"\n',
        200e9, 0.3, 1.2e-13, 5e-3, lambda x: x**2 / 1.6, ("force", 0.8e6), ("moment", 100.0),
    ),
    physical(
        "elastic punch in inches and pounds, settlement and tilt",
        '[foundation]\nyoung_modulus = "29e6 psi"\npoisson_ratio = 0.29\nsubgrade_modulus = "4e8 psi/in"\n'
        '[body]\nyoung_modulus = "10e6 psi"\npoisson_ratio = 0.33\n'
        '[punch]\nhalf_width = "0.25 in"\nprofile = "1e-6*cos(2*xi)"\n'
        '[load]\nsettlement = "120 uin"\ntilt = "-0.1 mrad"\n',
        29e6 * PSI, 0.29, INCH / (4e8 * PSI), 0.25 * INCH, lambda x: 1e-6 * np.cos(2 * x / (0.25 * INCH)),
        ("settlement", 120e-6 * INCH), ("tilt", -1e-4), (10e6 * PSI, 0.33),
    ),
    physical(
        "ground surface, settlement and eccentricity",
        '[foundation]\nyoung_modulus = "70 GPa"\npoisson_ratio = 0.33\nroughness = "0.003 um/MPa"\n'
        '[punch]\nhalf_width = "12 mm"\nprofile = "2e-7*exp(xi)"\n'
        '[load]\nsettlement = "4 um"\neccentricity = "1.5 mm"\n',
        70e9, 0.33, 3e-15, 12e-3, lambda x: 2e-7 * np.exp(x / 12e-3), ("settlement", 4e-6), ("eccentricity", 1.5e-3),
    ),
]

if __name__ == "__main__":
    target = Path(__file__).with_name("references.json")
    target.write_text(json.dumps({"made_by": Path(__file__).name, "cases": CASES}, indent=1) + "\n")
