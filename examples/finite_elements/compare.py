#!/usr/bin/env python3
"""Four contacts in CalculiX, with tables by `shtaerman export`, beside the answers of `shtaerman solve`.

    python3 examples/finite_elements/compare.py --shtaerman target/release/shtaerman --meshes 10,20,40

The finite-element model is half of a punch on a block in plane strain, of C3D8 elements one element thick. The punch is rigid: all its displacements are
prescribed, and its settlement is searched until the reaction is the force of the file. The rough layer is the exported table, in node-to-surface contact with
the nodes of the punch as slaves, so that the loaded width is that of the punch.

A half-plane has no end. On the far sides of the block, 100 half-widths away, the displacements are those of a half-plane under the same force as a line load
(Flamant): what that leaves out is of the order of (half-width/distance)^2. `--boundary fixed` fixes the far sides instead, as many models do.

Compared are pressures at all nodes of the punch, the width of contact and the settlement relative to a point in the depth, which depends on no gauge.
`--contact surface` takes surface-to-surface contact instead, and for the linear layer the linear law that stands in the comments of the exported file; with a table CalculiX 2.20
finds no force there.
The case `springs` is another one: the whole contact as exported springs, pressed and turned, against single solves.
Only the standard library of Python is needed, CalculiX (`ccx`) and the program.
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

# Both example files: mm, MPa, N/mm.
HALF_WIDTH = 5.0
YOUNG = 200e3
POISSON = 0.3
FORCE = 800.0
REPOSITORY = Path(__file__).resolve().parents[2]
FLAT = "examples/flat_punch.toml"
CROWNED = "examples/crowned_punch.toml"
# Radius of the crown, for a contact narrower than the punch.
RADIUS = 2e3
CROWN = 'punch.profile="x^2/(2*2)"'
POWER = "foundation.roughness={coefficient=1e-9,exponent=0.4}"

CASES = {
    "flat punch, linear layer": (FLAT, [], lambda x: 0.0),
    "flat punch, power law": (FLAT, [POWER], lambda x: 0.0),
    "crowned punch, linear layer": (CROWNED, [CROWN], lambda x: x * x / (2 * RADIUS)),
    "crowned punch, power law": (CROWNED, [CROWN, POWER], lambda x: x * x / (2 * RADIUS)),
}

# Distance of the far sides and least depth of the datum, in half-widths.
FAR = 100.0
DATUM = 10.0
# Growth of the elements outside of the punch on a mesh of ten elements under half of it; finer meshes grow more slowly.
GROWTH = 1.25
# The force is met to this share; the search takes two or three runs.
FORCE_MET = 1e-5
MOST_RUNS = 8


class Mesh:
    """Half of a block below y = 0 and of a punch on it, symmetric about x = 0: rectangles that grow away from the punch."""

    def __init__(self, count, height, far):
        self.count = count
        step = HALF_WIDTH / count
        self.thickness = step
        growth = GROWTH ** (10 / count)
        under = [HALF_WIDTH * i / count for i in range(count + 1)]
        self.x = under + [HALF_WIDTH + at for at in grown(step, growth, far - HALF_WIDTH)[1:]]
        self.depth = grown(step, growth, far)
        self.heights = [height(x) for x in under]

    def body(self, i, j, k):
        return 1 + i + len(self.x) * (j + len(self.depth) * k)

    def punch(self, i, level, k):
        return 1 + 2 * len(self.x) * len(self.depth) + i + (self.count + 1) * (level + 2 * k)

    def datum(self):
        """The first row of nodes at least the depth of the datum below."""
        return next(j for j, y in enumerate(self.depth) if y >= DATUM * HALF_WIDTH)

    def elements(self):
        """Eight nodes each, and the nodes themselves."""
        lines = ["*NODE, NSET=BODY_NODES"]
        for k in (0, 1):
            for j, y in enumerate(self.depth):
                for i, x in enumerate(self.x):
                    lines.append(f"{self.body(i, j, k)}, {x:.13e}, {-y:.12e}, {k * self.thickness:.13e}")
        lines.append("*NODE, NSET=PUNCH_NODES")
        for k in (0, 1):
            for level in (0, 1):
                for i, height in enumerate(self.heights):
                    y = height + level * self.thickness
                    lines.append(f"{self.punch(i, level, k)}, {self.x[i]:.13e}, {y:.13e}, {k * self.thickness:.13e}")
        lines.append("*ELEMENT, TYPE=C3D8, ELSET=BODY")
        number = 0
        for j in range(len(self.depth) - 1):
            for i in range(len(self.x) - 1):
                number += 1
                corners = [(i, j + 1), (i + 1, j + 1), (i + 1, j), (i, j)]
                nodes = [self.body(p, q, k) for k in (0, 1) for p, q in corners]
                lines.append(f"{number}, " + ", ".join(map(str, nodes)))
        first_of_punch = number + 1
        lines.append("*ELEMENT, TYPE=C3D8, ELSET=PUNCH")
        for i in range(self.count):
            number += 1
            corners = [(i, 0), (i + 1, 0), (i + 1, 1), (i, 1)]
            nodes = [self.punch(p, level, k) for k in (0, 1) for p, level in corners]
            lines.append(f"{number}, " + ", ".join(map(str, nodes)))
        lines.append("*SURFACE, NAME=GROUND")
        lines += [f"{i + 1}, S5" for i in range(len(self.x) - 1)]
        lines.append("*SURFACE, NAME=BASE")
        lines += [f"{first_of_punch + i}, S3" for i in range(self.count)]
        return lines


def grown(step, growth, end):
    """From 0 to the end in steps that grow, the first of about this length."""
    at = [0.0]
    while at[-1] < end:
        at.append(at[-1] + step)
        step *= growth
    return [value * end / at[-1] for value in at]


def flamant(x, y):
    """Displacements to the right and into the body, of a half-plane under the force at x = 0; zero settlement at the distance of the half-width on the surface."""
    modulus = YOUNG / (1 - POISSON**2)
    square = x * x + y * y
    shear = (1 + POISSON) * FORCE / (math.pi * YOUNG)
    right = -shear * ((1 - 2 * POISSON) * math.atan2(x, y) - x * y / square)
    down = 2 * FORCE / (math.pi * modulus) * math.log(HALF_WIDTH / math.sqrt(square)) + shear * y * y / square
    return right, down


def linear_law(text):
    """The exported file with the linear law of its comments in place of the table; as it is where there is none before the table."""
    head, _, rest = text.partition("*SURFACE INTERACTION, NAME=ROUGH_LAYER\n")
    comment = "** *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n** "
    if comment not in head:
        return text
    slope = head.split(comment)[1].split("\n")[0]
    return f"*SURFACE INTERACTION, NAME=ROUGH_LAYER\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{slope}\n"


def model(mesh, table, settlement, boundary, contact):
    """The whole input file."""
    lines = mesh.elements()
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG}, {POISSON}"]
    lines += ["*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL", "*SOLID SECTION, ELSET=PUNCH, MATERIAL=STEEL"]
    lines += [f"*INCLUDE, INPUT={table}"]
    lines += [f"*CONTACT PAIR, INTERACTION=ROUGH_LAYER, TYPE={contact.upper()} TO SURFACE", "BASE, GROUND"]
    lines += ["*NSET, NSET=WATCHED"]
    lines += [f"{mesh.body(i, 0, 0)}," for i in range(mesh.count + 1)] + [f"{mesh.body(0, mesh.datum(), 0)},"]
    lines += ["*BOUNDARY", "BODY_NODES, 3, 3", "PUNCH_NODES, 1, 1", "PUNCH_NODES, 3, 3"]
    last_i, last_j = len(mesh.x) - 1, len(mesh.depth) - 1
    lines += [f"{mesh.body(0, j, k)}, 1, 1" for k in (0, 1) for j in range(last_j)]
    lines += ["*STEP, INC=100", "*STATIC"]
    if boundary == "fixed":
        # The block gives by many times the overclosure: in one step it would leave the table, whose end has no stiffness.
        lines.append("0.05, 1.")
    lines += ["*BOUNDARY", f"PUNCH_NODES, 2, 2, {-settlement:.12e}"]
    sides = [(i, last_j) for i in range(last_i + 1)] + [(last_i, j) for j in range(last_j)]
    for i, j in sides:
        right, down = flamant(mesh.x[i], mesh.depth[j]) if boundary == "half-plane" else (0.0, 0.0)
        for k in (0, 1):
            lines.append(f"{mesh.body(i, j, k)}, 1, 1, {right:.11e}")
            lines.append(f"{mesh.body(i, j, k)}, 2, 2, {-down:.11e}")
    lines += ["*NODE PRINT, NSET=PUNCH_NODES, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=WATCHED", "U"]
    lines += ["*CONTACT FILE", "CDIS, CSTR", "*END STEP"]
    return "\n".join(lines) + "\n"


def last_block(path, mark):
    """Rows of numbers below the last line that holds the mark, in a .dat file."""
    lines = path.read_text().splitlines()
    start = max(number for number, line in enumerate(lines) if mark in line)
    rows = []
    for line in lines[start + 1 :]:
        if line.strip():
            if "(" in line:
                break
            rows.append([float(word) for word in line.split()])
    return rows


def contact_pressures(path):
    """Pressures at the slave nodes, CPRESS of a .frd file."""
    pressures, inside = {}, False
    for line in path.read_text().splitlines():
        if line.startswith(" -4"):
            inside = "CONTACT" in line
            if inside:
                pressures = {}
        elif inside and line.startswith(" -1"):
            pressures[int(line[3:13])] = float(line[49:61])
    return pressures


def calculix(options, folder, mesh, table, settlement):
    """Force, displacements of the watched nodes into the body, and pressures at the nodes of the punch."""
    program = options.ccx
    (folder / "model.inp").write_text(model(mesh, table, settlement, options.boundary, options.contact))
    for name in ("model.dat", "model.frd"):
        (folder / name).unlink(missing_ok=True)
    run = subprocess.run([program, "model"], cwd=folder, capture_output=True, text=True)
    if run.returncode != 0 or "*ERROR" in run.stdout:
        sys.exit(f"{program} failed:\n{run.stdout[-2000:]}{run.stderr}")
    total = last_block(folder / "model.dat", "total force")[0][1]
    displacements = {int(row[0]): -row[2] for row in last_block(folder / "model.dat", "displacements")}
    found = contact_pressures(folder / "model.frd")
    pressures = [found.get(mesh.punch(i, 0, 0), 0.0) for i in range(mesh.count + 1)]
    # Half of the punch.
    return -2 * total / mesh.thickness, displacements, pressures


def under_the_force(options, folder, mesh, table, guess, stiffness):
    """The settlement under the force, by the secant rule, and what CalculiX finds there."""
    tried = []
    settlement = guess
    for _ in range(MOST_RUNS):
        found = calculix(options, folder, mesh, table, settlement)
        tried.append((settlement, found[0]))
        if abs(found[0] / FORCE - 1) < FORCE_MET:
            return settlement, found
        if len(tried) > 1 and tried[-1][1] != tried[-2][1]:
            (one, force), (two, other) = tried[-2:]
            stiffness = (other - force) / (two - one)
        settlement += (FORCE - found[0]) / stiffness
    sys.exit(f"the force was not met in {MOST_RUNS} runs: {tried}")


def width(mesh, settlement, displacements):
    """Twice the place at which the overclosure passes through zero, by straight lines between nodes; that of the punch where it does not."""
    overclosure = [
        settlement - height - displacements[mesh.body(i, 0, 0)] for i, height in enumerate(mesh.heights)
    ]
    for i in range(1, len(overclosure)):
        if overclosure[i] < 0:
            share = overclosure[i - 1] / (overclosure[i - 1] - overclosure[i])
            return 2 * (mesh.x[i - 1] + share * (mesh.x[i] - mesh.x[i - 1]))
    return 2 * HALF_WIDTH


class Shtaerman:
    """The program on one of the cases."""

    def __init__(self, program, file, overrides):
        self.program = program
        self.arguments = [str(REPOSITORY / file)] + [part for text in overrides for part in ("--set", text)]

    def run(self, *arguments):
        command, *options = arguments
        words = command.split()
        run = subprocess.run([self.program, *words, *self.arguments, *options], capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{' '.join(run.args)}:\n{run.stderr}")
        return run.stdout

    def export(self, path, share, content="surface"):
        options = ["--units", "mm", "--share", str(share), "--content", content]
        self.run("export calculix", *options, "--output", str(path))

    def solve(self, places, depth):
        places = ",".join(f"{x:.13e} mm" for x in places)
        answer = json.loads(
            self.run("solve", "--format", "json", "--at", places, "--datum-depth", f"{depth:.13e} mm")
        )
        physical = answer["physical"]
        assert abs(physical["force"] / (FORCE * 1e3) - 1) < 1e-12, "the force of the file is another one"
        return answer


def compared(names, name, count, options, folder):
    """Differences of one case on one mesh, as shares of the largest pressure, the width and the settlement."""
    file, overrides, height = CASES[name]
    program = Shtaerman(options.shtaerman, file, overrides)
    mesh = Mesh(count, height, options.far * HALF_WIDTH)
    table = folder / "table.inp"
    program.export(table, options.share)
    if options.contact == "surface":
        table.write_text(linear_law(table.read_text()))
    answer = program.solve(mesh.x[: count + 1], mesh.depth[mesh.datum()])
    physical = answer["physical"]
    guess = physical["settlement"] * 1e3
    if options.boundary == "fixed":
        guess -= flamant(0.0, mesh.depth[-1])[1]
    stiffness = physical["stiffness"][0][0] * 1e-6
    settlement, found = under_the_force(options, folder, mesh, table.name, guess, stiffness)
    force, displacements, pressures = found
    exact = [pressure * 1e-6 for pressure in answer["pressure"]["pressure"]]
    peak = physical["peak_pressure"] * 1e-6
    off = max(abs(one - other) for one, other in zip(pressures, exact)) / peak
    exact_width = sum(right - left for left, right in physical["zones"]) * 1e3
    relative = settlement - displacements[mesh.body(0, mesh.datum(), 0)]
    exact_relative = physical["relative_settlement"][0]["settlement"] * 1e3
    return {
        names[0]: off,
        names[1]: width(mesh, settlement, displacements) / exact_width - 1,
        names[2]: relative / exact_relative - 1,
    }


# A spring between a fixed node and one that is pressed, and one that turns a rigid cube about the axis 3.
FORCE_SPRING = """*NODE, NSET=WATCHED
1, 0., 10., 0.
2, 0., 0., 0.
*ELEMENT, TYPE=SPRINGA, ELSET=PUNCH_FORCE
1, 1, 2
*INCLUDE, INPUT=force.inp
*BOUNDARY
1, 1, 3
2, 1, 1
2, 3, 3
*STEP, NLGEOM, INC=1000
*STATIC
0.01, 1.
*CLOAD
2, 2, {load}
*NODE PRINT, NSET=WATCHED
U
*END STEP
"""
MOMENT_SPRING = """*NODE, NSET=CUBE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
*NODE, NSET=WATCHED
9, 0., 0., 0.
10, 0., 0., 0.
11, 0., 0., -1.
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=SPRINGA, ELSET=PUNCH_MOMENT
2, 11, 10
*MATERIAL, NAME=STEEL
*ELASTIC
2.e5, 0.3
*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL
*RIGID BODY, NSET=CUBE, REF NODE=9, ROT NODE=10
*INCLUDE, INPUT=moment.inp
*BOUNDARY
9, 1, 3
10, 1, 2
11, 1, 3
*STEP, NLGEOM, INC=1000
*STATIC
0.01, 1.
*CLOAD
10, 3, {load}
*NODE PRINT, NSET=WATCHED
U
*END STEP
"""


def springs(options, folder):
    """Shares that the settlement under 0.6 of the force, and the rotation under 0.7 of the largest moment, are off by."""
    force, moment = 0.6 * FORCE, 0.7 * 0.5 * FORCE * HALF_WIDTH
    off = []
    for content, deck, load, overrides in [
        ("force", FORCE_SPRING, -force, [f"load.force={force * 1e3}"]),
        ("moment", MOMENT_SPRING, moment, [f"load.moment={moment}"]),
    ]:
        Shtaerman(options.shtaerman, CROWNED, [CROWN]).export(folder / f"{content}.inp", options.share, content)
        (folder / "spring.inp").write_text(deck.format(load=load))
        run = subprocess.run([options.ccx, "spring"], cwd=folder, capture_output=True, text=True)
        if run.returncode != 0 or "*ERROR" in run.stdout:
            sys.exit(f"{options.ccx} failed:\n{run.stdout[-2000:]}{run.stderr}")
        rows = last_block(folder / "spring.dat", "displacements")
        answer = Shtaerman(options.shtaerman, CROWNED, [CROWN, *overrides]).run("solve", "--format", "json")
        physical = json.loads(answer)["physical"]
        if content == "force":
            # The crown lifts off at zero.
            off.append(-rows[-1][2] / (physical["settlement"] * 1e3) - 1)
        else:
            off.append(rows[1][3] / -physical["tilt"] - 1)
    return off


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ccx", default="ccx", help="CalculiX")
    parser.add_argument("--shtaerman", default="shtaerman", help="the program")
    parser.add_argument("--meshes", default="10,20,40", help="elements under half of the punch")
    parser.add_argument("--case", action="append", choices=[*CASES, "springs"], help="one of the cases; may be given again")
    parser.add_argument("--share", type=float, default=1e-3, help="share of the law that the table may be off by")
    parser.add_argument("--far", type=float, default=FAR, help="distance of the far sides, in half-widths")
    parser.add_argument("--boundary", choices=["half-plane", "fixed"], default="half-plane", help="what the far sides do")
    parser.add_argument("--contact", choices=["node", "surface"], default="node", help="what is in contact with a surface")
    parser.add_argument("--most", type=float, help="fail where a difference on the last mesh is larger than this")
    options = parser.parse_args()
    options.shtaerman = str(Path(options.shtaerman).resolve()) if "/" in options.shtaerman else options.shtaerman
    names = ["pressure", "width", "settlement"]
    worst = 0.0
    print(f"{'case':30} {'elements':>8} " + " ".join(f"{name:>11}" for name in names))
    for name in options.case or [*CASES, "springs"]:
        if name == "springs":
            with tempfile.TemporaryDirectory() as folder:
                settled, turned = springs(options, Path(folder))
            print(f"springs: settlement {settled:.2e}, rotation {turned:.2e}")
            worst = max(worst, abs(settled), abs(turned))
            continue
        for count in [int(text) for text in options.meshes.split(",")]:
            with tempfile.TemporaryDirectory() as folder:
                found = compared(names, name, count, options, Path(folder))
            print(f"{name:30} {count:8} " + " ".join(f"{found[key]:11.2e}" for key in names), flush=True)
        worst = max(worst, *(abs(value) for value in found.values()))
    if options.most is not None and worst > options.most:
        sys.exit(f"a difference of {worst:.2e} is more than {options.most}")


if __name__ == "__main__":
    main()
