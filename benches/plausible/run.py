#!/usr/bin/env python3
"""Solves random plausible problems with one or two builds of the program: processor time, refusals, and where two builds disagree.

    benches/plausible/run.py SEED COUNT [--binary PATH] [--against PATH] [--no-audit] [--limit SECONDS] [--jobs N] [--only INDEX]

Times are of the processor, each process alone, its start included. With `--against` each problem is solved by both builds, one after the other, and answers are compared:
an answer that differs by more than both state together is listed. Needs Linux, Python 3.10 and nothing else; problems are drawn by `draw.py`.
"""

import argparse
import concurrent.futures
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import draw  # noqa: E402


def solve(binary, path, audit, limit, more=()):
    """Exit code, seconds of the processor, and the answer, if there is one."""

    command = [binary, "solve", str(path), "--format", "json"] + ([] if audit else ["--no-audit"]) + list(more)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        # Limited from outside: a limit set in the child would copy this interpreter first, which takes longer than a small problem.
        process = subprocess.Popen(command, stdout=out, stderr=err)
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (limit, limit + 1))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        text, message = out.read(), err.read().decode(errors="replace").strip().splitlines()
    answer = json.loads(text) if text else None
    return process.returncode, usage.ru_utime + usage.ru_stime, answer, message[-1] if message else ""


def stated_error(answer, name):
    """The stated error of a quantity in its unit; 0 where it is given, or nothing is stated."""
    errors = (answer["error"] or {}).get("physical") or {}
    return errors.get(name) or errors.get("pressure" if "pressure" in name else name) or 0.0


def difference(one, two):
    """The quantities that differ by more than both answers state together, each over what they state."""
    found = []
    for name in ("settlement", "tilt", "force", "moment", "peak_pressure"):
        values = [answer["physical"][name] for answer in (one, two)]
        if None in values:
            continue
        size, gap = max(map(abs, values)), abs(values[0] - values[1])
        stated = sum(stated_error(answer, name) for answer in (one, two))
        if gap > stated + 4e-16 * size:
            found.append(f"{name} {gap / size:.1e} of itself, {gap / max(stated, 1e-300):.1e} of what is stated")
    return found


def quantile(sorted_values, share):
    return sorted_values[min(len(sorted_values) - 1, int(share * len(sorted_values)))]


def describe(name, times, codes):
    times = sorted(times)
    shares = ", ".join(f"{label} {quantile(times, share) * 1e3:.1f}" for label, share in (("median", 0.5), ("90 %", 0.9), ("99 %", 0.99)))
    counts = {code: codes.count(code) for code in sorted(set(codes))}
    print(f"{name}: {len(times)} problems, milliseconds: {shares}, most {times[-1] * 1e3:.0f}; sum {sum(times):.2f} s; exit codes {counts}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("seed", type=int)
    arguments.add_argument("count", type=int)
    arguments.add_argument("--binary", default="target/release/shtaerman")
    arguments.add_argument("--against")
    arguments.add_argument("--no-audit", action="store_true")
    arguments.add_argument("--tolerance", help="of the first program alone: `--binary B --against B --no-audit --tolerance 1e-6` shows whether what ends early states enough")
    arguments.add_argument("--limit", type=int, default=60)
    arguments.add_argument("--jobs", type=int, default=1)
    arguments.add_argument("--only", type=int)
    arguments.add_argument("--keep", help="a folder for the problem files")
    given = arguments.parse_args()
    folder = Path(given.keep or tempfile.mkdtemp(prefix="plausible_"))
    folder.mkdir(parents=True, exist_ok=True)
    first = ["--set", f"solver.tolerance={given.tolerance}"] if given.tolerance else []

    def one(index):
        text, trace = draw.problem(given.seed, index, f"trace_{given.seed}_{index}.csv")
        path = folder / f"problem_{given.seed}_{index}.toml"
        path.write_text(text)
        if trace:
            (folder / f"trace_{given.seed}_{index}.csv").write_text(trace)
        binaries = [given.binary] + ([given.against] if given.against else [])
        return index, path, [solve(binary, path, not given.no_audit, given.limit, () if place else first) for place, binary in enumerate(binaries)]

    indices = [given.only] if given.only is not None else range(given.count)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        results = list(pool.map(one, indices))
    for index, path, found in results:
        code, seconds, answer, message = found[0]
        if code != 0:
            print(f"{path}: exit {code}, {seconds:.2f} s: {message[:200]}")
        elif seconds > 1.0:
            print(f"{path}: {seconds:.2f} s")
        if len(found) == 2 and found[1][2] and answer:
            for line in difference(answer, found[1][2]):
                print(f"{path}: {line}")
        if len(found) == 2 and found[1][0] != code:
            print(f"{path}: exit {code}, {found[1][0]} by the other: {found[1][3][:120]}")
    for place, name in enumerate([given.binary] + ([given.against] if given.against else [])):
        describe(name, [found[place][1] for _, _, found in results], [found[place][0] for _, _, found in results])
    if given.against:
        ratios = sorted(found[0][1] / found[1][1] for _, _, found in results if found[0][0] == found[1][0] == 0)
        pairs = [[stated_error(result[2], "pressure") for result in found] for _, _, found in results if found[0][2] and found[1][2]]
        stated = sorted(one / other for one, other in pairs if other > 0)
        print(f"time over the other's: median {quantile(ratios, 0.5):.2f}, 10 % {quantile(ratios, 0.1):.2f}, 90 % {quantile(ratios, 0.9):.2f}")
        print(f"stated error of the pressure over the other's: median {quantile(stated, 0.5):.2f}, 99 % {quantile(stated, 0.99):.1f}, most {stated[-1]:.1f}")


if __name__ == "__main__":
    main()
