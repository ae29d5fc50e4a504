#!/bin/sh
# The structured solve against the same method in NumPy: seconds, peak memory and their ratios, one thread each.
#
#     benches/structured_against_numpy.sh [python]
#
# Needs a Python with numpy and scipy (default python3).
set -eu
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
python=${1:-python3}
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."
cargo bench --quiet --bench structured --no-run
ours=$(cargo bench --quiet --bench structured -- yardstick)
theirs=$("$python" "$here/peers/spectral_fft.py" --n 1048576 --lambda0 100 --tol 1e-12)
printf 'fredholm  %s\nnumpy     %s\n' "$ours" "$theirs"
field() { printf '%s\n' "$1" | tr ' ' '\n' | sed -n "s/^$2=//p"; }
for quantity in seconds peak_MB; do
    awk -v name="$quantity" -v a="$(field "$theirs" $quantity)" -v b="$(field "$ours" $quantity)" \
        'BEGIN { printf "%-9s numpy / fredholm = %.2f\n", name, a / b }'
done
