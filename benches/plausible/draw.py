"""Random problems as an engineer might state them: every geometry and ground, smooth and rough, formulas and measured traces.

Problem number `index` of a seed depends on these two alone, so that one can be drawn again by itself.
"""

import math
import random

GEOMETRIES = [("plane", 8), ("circular", 4), ("periodic", 3), ("row", 2), ("pair", 2)]
PROFILES = [("fourier", 6), ("crown", 4), ("kinks", 3), ("trace", 3), ("polynomial", 2), ("flat", 1)]


def weighted(draw, choices):
    return draw.choices([name for name, _ in choices], [weight for _, weight in choices])[0]


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def profile(draw, kind, half_width, height, is_even):
    """A formula in metres of `x` (or `r`), or the rows of a trace; `height` is how far it is from flat."""
    variable = "r" if is_even else "x"
    xi = f"({variable}/{half_width:.9e})"
    middle = 0.0 if is_even else draw.uniform(-0.5, 0.5)
    crown = f"({xi} - {middle:.6f})^2" if middle else f"{xi}^2"
    if kind == "flat":
        return "0", None
    if kind == "crown":
        return f"{height:.6e}*{crown}", None
    if kind == "polynomial":
        powers = [2, 4, 6] if is_even else [1, 2, 3, 4]
        terms = [f"{draw.uniform(-0.5, 1):.4f}*{xi}^{power}" for power in powers]
        return f"{height:.6e}*({' + '.join(terms)})", None
    if kind == "kinks":
        places = [draw.uniform(0.05, 0.9) * (1 if is_even else draw.choice([-1, 1])) for _ in range(draw.randint(1, 3))]
        terms = [f"{draw.uniform(0.1, 1):.4f}*abs({xi} - {place:.6f})" for place in places]
        return f"{height:.6e}*({' + '.join(terms)} + {draw.uniform(0, 1):.4f}*{crown})", None
    if kind == "fourier":
        waves = draw.randint(1, 30)
        terms = []
        for number in range(1, waves + 1):
            size = draw.gauss(0, 1) / number ** draw.choice([1.0, 1.5, 2.0])
            phase = 0.0 if is_even else draw.uniform(0, 2 * math.pi)
            terms.append(f"{size:.6f}*cos({number}*pi*{xi} + {phase:.6f})")
        return f"{height:.6e}*({' + '.join(terms)} + {draw.choice([0, 1, 3])}*{crown})", None
    points = int(log_uniform(draw, 8, 300))
    walk, rows = 0.0, []
    for number in range(points + 1):
        place = (number if is_even else 2 * number - points) / points
        walk = 0.9 * walk + draw.gauss(0, 0.1)
        rows.append((place * half_width, height * (place * place + walk)))
    if is_even:
        # A trace of a disk goes through its middle, and is the same on both sides.
        rows = [(-place, value) for place, value in reversed(rows[1:])] + rows
    return None, "".join(f"{place:.9e},{value:.9e}\n" for place, value in rows)


def problem(seed, index, trace_name):
    """The text of a problem file and the rows of its trace, if it has one, which the file looks for under `trace_name`."""
    draw = random.Random(f"plausible {seed} {index}")
    geometry = weighted(draw, GEOMETRIES)
    is_smooth = draw.random() < 0.3
    # A smooth punch is always free to lift off, and so is one on a power law.
    is_linear = False
    ground = "plain" if geometry in ("periodic", "row") else weighted(draw, [("plain", 6), ("graded", 2)])
    modulus = log_uniform(draw, 1e7, 5e11)
    poisson = draw.uniform(0.1, 0.45)
    half_width = log_uniform(draw, 1e-4, 1.0)
    stiffness = modulus / (1 - poisson * poisson)
    lines = ["[foundation]", f"poisson_ratio = {poisson:.4f}"]
    if ground == "graded":
        exponent = draw.uniform(0.05, 0.6)
        lines += [f"grading_exponent = {exponent:.4f}", f'grading_modulus = "{modulus / half_width ** exponent:.6e} Pa"']
    else:
        lines.append(f'young_modulus = "{modulus:.6e} Pa"')
    theta = log_uniform(draw, 0.1, 1e4)
    if is_smooth:
        lines.append("roughness = 0")
    elif draw.random() < 0.2 and ground == "plain":
        kappa = draw.uniform(0.3, 0.9)
        pressure = 1e-3 * stiffness
        lines.append(
            f"roughness = {{ displacement = {2 * half_width * 1e-3 / (math.pi * theta):.6e}, pressure = {pressure:.6e}, exponent = {kappa:.3f} }}"
        )
    else:
        is_linear = True
        lines.append(f"roughness = {2 * half_width / (math.pi * stiffness * theta):.6e}")
    strain = log_uniform(draw, 1e-6, 1e-3)
    height = half_width * strain * log_uniform(draw, 0.1, 10)
    lines.append("\n[punch]")
    if geometry == "circular":
        lines += ['geometry = "circular"', f"radius = {half_width:.9e}"]
    elif geometry == "pair":
        inner = draw.uniform(0.05, 0.7)
        lines += ['geometry = "pair"', f"outer_half_width = {half_width:.9e}", f"inner_half_gap = {inner * half_width:.9e}"]
    elif geometry == "periodic":
        # Twice the half-width of the formula to the last digit, or the wave would not close.
        lines += ['geometry = "periodic"', f"period = {2 * float(f'{half_width:.9e}')!r}"]
    elif geometry == "row":
        lines += ['geometry = "periodic"', f"period = {2 * half_width * draw.uniform(1.05, 4):.9e}", f"half_width = {half_width:.9e}"]
    else:
        lines.append(f"half_width = {half_width:.9e}")
    kind = weighted(draw, PROFILES)
    if geometry == "periodic":
        # Heights that close after a period.
        terms = [
            f"{draw.gauss(0, 1) / number:.6f}*cos({number}*pi*x/{half_width:.9e} + {draw.uniform(0, 6.28):.4f})"
            for number in range(1, draw.randint(1, 30) + 1)
        ]
        formula, trace = f"{height:.6e}*({' + '.join(terms)})", None
    else:
        # The base of a pair is measured on both punches at once, through the gap.
        formula, trace = profile(draw, kind, half_width, height, geometry == "circular")
    if trace is None:
        lines.append(f'profile = "{formula}"')
    else:
        lines.append(f'profile = {{ csv = "{trace_name}" }}')
    lines.append("\n[load]")
    force = strain * stiffness * half_width * draw.uniform(0.2, 3)
    if geometry == "circular":
        force *= half_width
    lines.append(f"force = {force:.6e}")
    if geometry == "periodic":
        lines.append("tilt = 0")
    elif geometry == "circular":
        lines.append("moment = 0")
    else:
        lines.append(draw.choice(["moment = 0", "tilt = 0", f"eccentricity = {draw.uniform(-0.3, 0.3) * half_width:.6e}"]))
    if is_linear and draw.random() < 0.1:
        lines.append('\n[solver]\ncontact = "bilateral"')
    return "\n".join(lines) + "\n", trace
