"""Response of a graded elastic half-space E = E0 y^mu to a wave of pressure, from the equations of elasticity.

Independent of every closed form: origin of graded.json, which the tests of grading.rs read as their truth.

Under the pressure p cos(q x) in plane strain let u_x = U sin(q x), u_y = W cos(q x), sigma_y = T cos(q x), tau_xy = S sin(q x). With q = E0 = 1
Hooke's law and equilibrium are the system

    U' =  W + 2 (1 + nu) y^-mu S
    W' = -nu/(1 - nu) U + (1 + nu)(1 - 2 nu)/(1 - nu) y^-mu T
    S' =  nu/(1 - nu) T + y^mu/(1 - nu^2) U
    T' = -S

with S(0) = 0, T(0) = -1 and decay in depth; the settlement W(0) is A(mu, nu), and A q^(mu-1) p/E0 by similarity for any q, E0. The equations of
the axisymmetric problem under p J_0(q r) are the same (u_r = U J_1, u_y = W J_0), since J_0 is a mean of plane waves: so is A.
Frobenius series about y = 0, one with U, W in whole powers and one with S, T in whole powers, are summed at the depth DEPTH in DIGITS digits; decay is
U = W = 0 there, which is wrong by about exp(-2 DEPTH).

The constants of the line load u = theta_g P |x|^-mu and of the point load u = c P r^-(1+mu) follow by the inverse transforms
int_0^inf q^(mu-1) cos(q x) dq and int_0^inf q^mu J_0(q r) dq.

    python graded.py > graded.json
"""

import json

from mpmath import mp, mpf, gamma, cos, sin, pi, sqrt, matrix, lu_solve, nstr

DIGITS = 120
DEPTH = 45
TERMS = 500
mp.dps = DIGITS


def march(mu, nu, start, shift):
    """Values (U, W, S, T) at DEPTH of the series with S, T in powers n + s and U, W in powers n + w."""
    compliance = [2 * (1 + nu), (1 + nu) * (1 - 2 * nu) / (1 - nu)]
    ratio, stiffness = nu / (1 - nu), 1 / (1 - nu**2)
    u, w, s, t = [[mpf(0)] * (TERMS + 2) for _ in range(4)]
    if shift == "displacements":  # U, W: y^n; S, T: y^(n + mu)
        u[0], w[0] = start
        du, ds = mpf(0), mu
    else:  # S, T: y^n; U, W: y^(n - mu)
        s[0], t[0] = start
        du, ds = -mu, mpf(0)
    for n in range(TERMS):
        # (n + 1 + du) u[n+1] y^(n + du) = w[n] y^(n + du) + c y^(-mu) s[m] y^(m + ds)
        # In either case y^-mu y^(m + ds) = y^(m + du) and y^mu y^(m + du) = y^(m + ds).
        u[n + 1] = (w[n] + compliance[0] * s[n]) / (n + 1 + du) if n + 1 + du != 0 else mpf(0)
        w[n + 1] = (-ratio * u[n] + compliance[1] * t[n]) / (n + 1 + du)
        s[n + 1] = (ratio * t[n] + stiffness * u[n]) / (n + 1 + ds)
        t[n + 1] = -s[n] / (n + 1 + ds)
    y = mpf(DEPTH)
    total = lambda series, power: sum(a * y ** (n + power) for n, a in enumerate(series))
    return total(u, du), total(w, du), total(s, ds), total(t, ds)


def response(mu, nu):
    """A(mu, nu)."""
    one = march(mu, nu, (mpf(1), mpf(0)), "displacements")
    two = march(mu, nu, (mpf(0), mpf(1)), "displacements")
    load = march(mu, nu, (mpf(0), mpf(-1)), "stresses")
    system = matrix([[one[0], two[0]], [one[1], two[1]]])
    return lu_solve(system, matrix([-load[0], -load[1]]))[1]


def closed(mu, nu):
    """A(mu, nu) after Popov, Hess and Willert 2019, 9.1: c = (1-nu^2) cos(pi mu/2)/(pi h E0)."""
    beta = sqrt((1 + mu) * (1 - mu * nu / (1 - nu)))
    big = 2 ** (1 + mu) * gamma((3 + mu + beta) / 2) * gamma((3 + mu - beta) / 2) / (pi * gamma(2 + mu))
    h = 2 * (1 + mu) * cos(pi * mu / 2) * gamma(1 + mu / 2)
    h /= sqrt(pi) * big * beta * sin(pi * beta / 2) * gamma((1 + mu) / 2)
    c = (1 - nu**2) * cos(pi * mu / 2) / (pi * h)
    return 2 * pi * c * gamma((1 - mu) / 2) / (2**mu * gamma((1 + mu) / 2))


def main():
    rows = []
    for mu in ["0", "0.05", "0.1", "0.25", "0.3", "0.5", "0.7", "0.9", "0.99"]:
        for nu in ["-0.5", "0", "0.2", "0.3", "0.45", "0.5"]:
            m, n = mpf(mu), mpf(nu)
            a = response(m, n)
            line = a * gamma(m) * cos(pi * m / 2) / pi if m > 0 else None
            point = a * 2**m * gamma((1 + m) / 2) / (2 * pi * gamma((1 - m) / 2))
            rows.append(
                {
                    "mu": float(m),
                    "nu": float(n),
                    "wave": nstr(a, 25),
                    "line": None if line is None else nstr(line, 25),
                    "point": nstr(point, 25),
                    "closed_form_differs_by": nstr(abs(closed(m, n) / a - 1), 3),
                }
            )
    print(json.dumps({"origin": "graded.py: series solution of the transformed equations of elasticity, E0 = 1", "rows": rows}, indent=1))


if __name__ == "__main__":
    main()
