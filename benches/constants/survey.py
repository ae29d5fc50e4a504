#!/usr/bin/env python3
"""What answers owe to each constant of `crates/shtaerman/src/contact`: random problems are solved again with half and with twice of it.

    git worktree add FOLDER                                           a copy of the repository, to be thrown away
    benches/constants/survey.py rewrite FOLDER                        there each constant is a function with a factor from the environment
    cargo build --release --manifest-path FOLDER/Cargo.toml           once for all constants
    benches/constants/survey.py run FOLDER RESULTS --seed 31001       some hours of one processor; what is in RESULTS already is not done again
    benches/constants/survey.py table FOLDER RESULTS                  the table of the book, in Markdown

Of the problems of the seed the first 300 are taken whose answer, with its audit, takes less than the limit. A constant is changed only for those that reach it: the others cannot tell.
Numbers that stand in a structure count each for itself. Constants of traits, of a length of an array and of tests are left out.
"""

import argparse
import concurrent.futures
import json
import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "plausible"))
import draw  # noqa: E402
from run import difference, stated_error  # noqa: E402

CONTACT = "crates/shtaerman/src/contact"
ITEM = re.compile(r"^(pub(?:\([a-z: ]+\))? )?const ([A-Z_0-9]+): (f64|usize|u32|i32|Limits|Detail|\[Effort; 3\]|\[f64; 2\]) = ([^;]+);", re.M)
NUMBER = re.compile(r"(\b[a-z]+: )?(?<![\w.])([0-9][0-9_]*(?:\.[0-9]+)?(?:e-?[0-9]+)?)\b")
APART = re.compile(r'(//[^\n]*|"(?:[^"\\]|\\.|\\\n)*"|^\s*(?:pub(?:\([a-z: ]+\))? )?use [^;]+;|^\s+const [^;]+;|\bfn [A-Z_0-9]+\(\))', re.M)
USE = re.compile(r"((?:\b[A-Za-z_0-9]+::)?)\b([A-Z][A-Z_0-9]+)\b(?!\(|:|<[A-Za-z])")
# Places between nodes, which are irrational on purpose, are no thresholds.
PLACES = {("rough/panels/nodes.rs", "PLACES"), ("iteration.rs", "GOLDEN")}

FACTORS = """//! Factors of constants, from the environment.
#![allow(missing_docs, unreachable_pub)]
use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];
static CHOSEN: OnceLock<(usize, f64)> = OnceLock::new();
fn of(name: &str) -> Option<f64> { std::env::var(name).ok()?.parse().ok() }
fn factor(id: usize) -> f64 {
    if !REACHED[id].load(Ordering::Relaxed) && !REACHED[id].swap(true, Ordering::Relaxed)
        && let Some(path) = std::env::var_os("SURVEY_REACHED")
        && let Ok(mut file) = std::fs::OpenOptions::new().append(true).create(true).open(path) {
        let _ = file.write_all(format!("{id}\\n").as_bytes());
    }
    let (chosen, factor) = *CHOSEN.get_or_init(|| {
        (of("SURVEY_CONSTANT").map_or(usize::MAX, |id| id as usize), of("SURVEY_FACTOR").unwrap_or(1.0))
    });
    if chosen == id { factor } else { 1.0 }
}
pub fn f64(id: usize, value: f64) -> f64 { value * factor(id) }
pub fn usize(id: usize, value: usize) -> usize { ((value as f64 * factor(id)).round() as usize).max(1) }
pub fn u32(id: usize, value: u32) -> u32 { ((f64::from(value) * factor(id)).round() as u32).max(1) }
pub fn i32(id: usize, value: i32) -> i32 { (f64::from(value) * factor(id)).round() as i32 }
"""


def rewrite(folder):
    """Makes a function of each constant; writes down which there are."""
    root = Path(folder) / CONTACT
    texts = {str(path.relative_to(root)): path.read_text() for path in sorted(root.rglob("*.rs")) if path.name != "tests.rs"}
    constants, expressions = [], {}

    def part(name, constant, found):
        field, value = found.group(1) or "", found.group(2)
        place = field.strip(": ") or f"[{sum(one[0] == name and one[1].startswith(f'{constant} [') for one in constants)}]"
        constants.append((name, f"{constant} {place}", value))
        return f"{field}crate::survey::{'f64' if '.' in value or 'e' in value else 'usize'}({len(constants) - 1}, {value})"

    def function(name, item):
        visible, constant, kind, expression = item.group(1) or "", *item.group(2, 3, 4)
        if (name, constant) in PLACES:
            return item.group(0)
        expressions[constant] = expression
        if kind in ("f64", "usize", "u32", "i32"):
            constants.append((name, constant, expression))
            body = f"crate::survey::{kind}({len(constants) - 1}, {expression})"
        else:
            body = NUMBER.sub(lambda found: part(name, constant, found), expression)
        return f"#[allow(non_snake_case)] {visible}fn {constant}() -> {kind} {{ {body} }}"

    for name, text in texts.items():
        texts[name] = ITEM.sub(lambda item: function(name, item), text)

    def used(found, own):
        before, constant = found.groups()
        if constant not in expressions or (constant in own and not before) or re.fullmatch(r"[A-Z][A-Za-z]*::|f64::|usize::|u32::", before):
            return found.group(0)
        return f"{before}{constant}()"

    def untouched(piece):
        """In constants of traits, and in texts, values stand for themselves."""
        if piece.lstrip().startswith("const "):
            head, given, value = piece.partition("=")
            return f"{head}{given}{re.sub(r'(?:[a-z_]+::)*([A-Z][A-Z_0-9]+)', lambda found: expressions.get(found.group(1), found.group(0)), value)}"
        if piece.startswith('"'):
            return re.sub(r"\{([A-Z_]+)\}", lambda found: expressions.get(found.group(1), found.group(0)).removesuffix(".0"), piece)
        return piece

    for name, text in texts.items():
        # Constants that this file has, and that stay what they are.
        own = set(re.findall(r"\bconst ([A-Z_0-9]+):", text)) - set(re.findall(r"\bfn ([A-Z_0-9]+)\(\)", text))
        pieces = [untouched(piece) if place % 2 else USE.sub(lambda found: used(found, own), piece) for place, piece in enumerate(APART.split(text))]
        (root / name).write_text("".join(pieces))
    library = Path(folder) / "crates/shtaerman/src/lib.rs"
    library.write_text(re.sub(r"^((?:pub )?mod contact;)", r"\1\nmod survey;", library.read_text(), count=1, flags=re.M))
    (library.parent / "survey.rs").write_text(FACTORS.replace("COUNT", str(len(constants))))
    (Path(folder) / "constants.json").write_text(json.dumps(constants, indent=0))
    print(f"{len(constants)} constants")


class Survey:
    """Problems of a seed and what they answer with one constant changed."""

    def __init__(self, folder, seed, count, limit):
        self.binary, self.limit, self.problems = Path(folder).resolve() / "target/release/shtaerman", limit, Path(tempfile.mkdtemp(prefix="constants_"))
        self.base, drawn = [], 0
        while len(self.base) < count:
            text, trace = draw.problem(seed, drawn, f"trace_{drawn}.csv")
            (self.problems / f"{drawn}.toml").write_text(text)
            if trace:
                (self.problems / f"trace_{drawn}.csv").write_text(trace)
            reached = self.problems / f"{drawn}.reached"
            code, seconds, answer = self.solve(drawn, {"SURVEY_REACHED": str(reached)}, 1 + int(limit))
            if code in (0, 3) and seconds <= limit:
                self.base.append((drawn, code, seconds, answer, set(map(int, reached.read_text().split()))))
            drawn += 1
        print(f"{count} of {drawn} problems", flush=True)

    def solve(self, problem, environment, limit):
        with tempfile.TemporaryFile() as out:
            process = subprocess.Popen(
                [self.binary, "solve", f"{problem}.toml", "--format", "json"],
                stdout=out,
                stderr=subprocess.DEVNULL,
                cwd=self.problems,
                env=os.environ | environment,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1)),
            )
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            return process.returncode, usage.ru_utime + usage.ru_stime, out.read()

    def changed(self, base, constant, factor):
        problem, code, seconds, answer, _ = base
        environment = {"SURVEY_CONSTANT": str(constant), "SURVEY_FACTOR": str(factor)}
        other_code, other_seconds, other = self.solve(problem, environment, max(4, 1 + int(12 * seconds)))
        found = {"i": problem, "c0": code, "c": other_code, "t0": seconds, "t": other_seconds, "same": (code, answer) == (other_code, other)}
        if answer and other and answer != other:
            pair = [json.loads(text) for text in (answer, other)]
            stated = [stated_error(one, "pressure") for one in pair]
            found["numbers"] = pair[0]["physical"] != pair[1]["physical"]
            found["broken"] = difference(*pair)
            found["ratio"] = stated[1] / stated[0] if min(stated) > 0 else None
            found["audit"] = [(one.get("audit") or {}).get("kind") for one in pair]
        return found


def run(folder, results, seed, count, limit):
    constants = json.loads((Path(folder) / "constants.json").read_text())
    survey = Survey(folder, seed, count, limit)
    done = [tuple(json.loads(line)["key"]) for line in open(results)] if os.path.exists(results) else []
    with concurrent.futures.ThreadPoolExecutor(1) as pool, open(results, "a") as lines:
        for key in [(constant, factor) for constant in range(len(constants)) for factor in (0.5, 2.0) if (constant, factor) not in done]:
            bases = [base for base in survey.base if key[0] in base[4]]
            found = list(pool.map(lambda base: survey.changed(base, *key), bases))
            times = {name: sum(one[name] for one in found) for name in ("t", "t0")}
            print(json.dumps({"key": key, "n": len(bases), "r": [one for one in found if not one["same"]], **times}), file=lines, flush=True)


def told(result):
    """What became of the answers with one factor."""
    found = result["r"]
    lost = sum(one["c0"] == 0 and one["c"] > 0 and one["c"] != 130 for one in found)
    late = sum(one["c"] < 0 or one["c"] == 130 for one in found)
    won = sum(one["c0"] != 0 and one["c"] == 0 for one in found)
    broken = sum(bool(one.get("broken")) for one in found)
    audits = sum(one["audit"][0] != one["audit"][1] for one in found if "audit" in one)
    grown = max([one["ratio"] for one in found if one.get("ratio")], default=1.0)
    parts = [f"{sum(bool(one.get('numbers')) for one in found)} change" if any(one.get("numbers") for one in found) else ""]
    if not parts[0] and any("audit" in one for one in found):
        parts = ["stated errors or messages alone"]
    parts += [f"{number} {text}" for number, text in ((lost, "refused"), (late, "not ended"), (won, "won"), (broken, "beyond what is stated"), (audits, "audited otherwise")) if number]
    parts += [f"errors up to {grown:.2g} times"] if grown >= 1.5 else []
    slower = result["t"] / result["t0"] - 1 if result["t0"] else 0.0
    parts += [f"{abs(slower):.0%} {'slower' if slower > 0 else 'faster'}"] if abs(slower) > 0.15 else []
    return ", ".join(filter(None, parts)) or "nothing"


def table(folder, results):
    constants = json.loads((Path(folder) / "constants.json").read_text())
    found = {}
    for line in open(results):
        result = json.loads(line)
        found.setdefault(result["key"][0], {})[result["key"][1]] = result
    titles = [(name, title) for name, title, _ in constants]
    print("| file | constant | value | reached by | at half | at twice |\n|---|---|---|---|---|---|")
    for constant, (name, title, value) in enumerate(constants):
        # Of elements of an array that have fields.
        if titles.count((name, title)) > 1:
            title += f" {1 + titles[:constant].count((name, title))}"
        both = found.get(constant, {})
        if len(both) < 2:
            cells = ["not run"] * 3
        elif both[0.5]["n"] == 0:
            cells = ["none", "-", "-"]
        else:
            cells = [str(both[0.5]["n"]), told(both[0.5]), told(both[2.0])]
        print(f"| `{name}` | `{title}` | `{value}` | {' | '.join(cells)} |")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = arguments.add_subparsers(dest="command", required=True)
    for name in ("rewrite", "run", "table"):
        command = commands.add_parser(name)
        command.add_argument("folder")
        if name != "rewrite":
            command.add_argument("results")
        if name == "run":
            command.add_argument("--seed", type=int, default=31001)
            command.add_argument("--count", type=int, default=300)
            command.add_argument("--limit", type=float, default=0.3)
    given = vars(arguments.parse_args())
    {"rewrite": rewrite, "run": run, "table": table}[given.pop("command")](**given)


if __name__ == "__main__":
    main()
