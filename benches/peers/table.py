"""The lines of all programs as a table, with ratios to the last one, Shtaerman."""
import json
import sys

rows = [json.loads(line) for line in open(sys.argv[1]) if line.startswith("{")]
ours = rows[-1]
print(f"{'program':28}{'largest error':>15}{'time [ms]':>12}{'error ratio':>14}{'time ratio':>12}")
for row in rows:
    errors, times = row["error"] / ours["error"], row["milliseconds"] / ours["milliseconds"]
    print(f"{row['name']:28}{row['error']:15.2e}{row['milliseconds']:12.4g}{errors:14.3g}{times:12.3g}")
