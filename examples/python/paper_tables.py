# %% [markdown]
# # The tables of the paper, as printed and as they are
#
# What one learns: bilateral contact without dimensions, the paper's own truncation beside the true answer, and why 83 of 144 printed figures are not the true ones.
#
#     python examples/python/paper_tables.py
#
# S. M. Mkhitaryan prints three tables: settlement, tilt and edge pressures of loaded punches, and moments that keep a punch level. The printed figures are in the repository as text, because the last
# printed digit counts. The chapter *Errata* of the book tells how each reading was found; `shtaerman reproduce` prints all of it.

# %%
import json
from decimal import Decimal
from pathlib import Path

import shtaerman as st

ROOT = next(folder for folder in (Path.cwd(), *Path.cwd().parents) if (folder / "crates/shtaerman/data").is_dir())
paper = json.loads((ROOT / "crates/shtaerman/data/paper_tables.json").read_text(encoding="utf-8"))


def punch(lambda0: str, profile: str, *, n: int | None = None, **load: float) -> st.Contact:
    """The base `lambda0 profile`, held on its whole width; with `n` the degenerate kernel of that degree, as the paper truncates it."""
    how = {} if n is None else {"method": "spectral", "n": n}
    stated = {"lambda0": float(lambda0), "poisson_ratio": 0.25, "profile": f"{lambda0} * ({profile})", "force": 0.001}
    return st.solve(**stated, **load, contact="bilateral", **how, audit=False)


def agrees(printed: str, value: float) -> bool:
    """Whether a value is the printed one to its last digit: half a unit of it, and a little, as nobody knows how a half was rounded."""
    unit = Decimal(1).scaleb(Decimal(printed).as_tuple().exponent)
    return abs(Decimal(printed) - Decimal(value)) <= unit * Decimal("0.5001")


count = {"true": 0, "truncated": 0, "pressure formula": 0, "sign": 0, "misprint": 0}

# %% [markdown]
# **Tables 1 and 2**: settlement and tilt. Their captions are swapped in print. With the paper's truncation every figure comes out to its last digit but one, a misprint; some are not the true ones, as
# `n = 45` is not enough for them.

# %%
for name in ("table1", "table2"):
    table = paper[name]
    for lambda0, delta0, alpha0, *_ in table["rows"]:
        true = punch(lambda0, table["profile_over_lambda0"], moment=0.0001)
        cut = punch(lambda0, table["profile_over_lambda0"], moment=0.0001, n=table["n"])
        for printed, exact, papers in ((delta0, true.settlement, cut.settlement), (alpha0, true.tilt, cut.tilt)):
            if agrees(printed, exact):
                count["true"] += 1
            elif agrees(printed, papers):
                count["truncated"] += 1
                print(f"{name}, lambda0 = {lambda0}: printed {printed}, n = 45 gives {papers:.8g}, true is {exact:.10g}")
            else:
                count["misprint"] += 1
                print(f"{name}, lambda0 = {lambda0}: printed {printed}, true is {exact:.6f}: a misprint")
                assert agrees(printed, 10 * exact) or agrees("-0.00015", exact)

# %% [markdown]
# **Edge pressures.** The printed (3.8) lacks `- f0(xi)`, and has `alpha0` for `theta0` before the sum of the odd part. So the printed means of both edges are the true ones of the truncated system plus
# `f0(1)`, and the printed differences are `2 |alpha0|` but for the sum times `alpha0^2`: they are no pressures. The true ones under the parabola are negative: the punch pulls.

# %%
print("\n lambda0   printed p0(-1), p0(1)      true p0(-1), p0(1)")
for name in ("table1", "table2"):
    table = paper[name]
    for lambda0, _, _, left, right in table["rows"]:
        true = punch(lambda0, table["profile_over_lambda0"], moment=0.0001)
        cut = punch(lambda0, table["profile_over_lambda0"], moment=0.0001, n=table["n"])
        even = 0.5 * (cut.pressure_left + cut.pressure_right) + float(lambda0)
        # The odd part is -alpha0 (1 - theta0 S) at the right edge with the sum S, and as printed -alpha0 (1 - alpha0 S).
        odd = 0.5 * (cut.pressure_right - cut.pressure_left)
        total = (1.0 + odd / cut.tilt) / cut.theta0
        for printed, sign in ((left, 1.0), (right, -1.0)):
            assert agrees(printed, even + sign * cut.tilt * (1.0 - cut.tilt * total))
            assert not agrees(printed, true.pressure_left if sign > 0 else true.pressure_right)
            count["pressure formula"] += 1
        if name == "table1":
            assert true.pressure_left < 0.0 and true.pressure_right < 0.0
            print(f"{lambda0:>8}   {left:>9}  {right:>9}   {true.pressure_left:14.8f} {true.pressure_right:14.8f}")

# %% [markdown]
# **Table 3**: the moment that keeps the punch level. It is printed without its sign; and the right half was computed with `n = 25`, so that its last digits differ from those of the left half, though the
# moment depends on the odd part of the base alone and is the same.

# %%
table3 = paper["table3"]
for half, columns in (("left", slice(1, 3)), ("right", slice(3, 5))):
    table = table3[half]
    for lambda0, *figures in table3["rows"]:
        delta0, moment = [lambda0, *figures][columns]
        true = punch(lambda0, table["profile_over_lambda0"], tilt=0.0)
        cut = punch(lambda0, table["profile_over_lambda0"], tilt=0.0, n=table["n"])
        assert agrees(delta0, cut.settlement) and agrees(moment, -cut.moment)
        count["true" if agrees(delta0, true.settlement) else "truncated"] += 1
        count["sign"] += 1
lambda0, _, left, _, right = table3["rows"][-1]
print(f"\nlambda0 = {lambda0}: moments printed {left} and {right}, true is {punch(lambda0, 'xi', tilt=0.0).moment:.10f}")

# %% [markdown]
# What the printed tables are worth.

# %%
print(count)
assert count == {"true": 61, "truncated": 10, "pressure formula": 48, "sign": 24, "misprint": 1}
assert sum(count.values()) == 144
