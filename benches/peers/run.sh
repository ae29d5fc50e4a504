#!/usr/bin/env bash
# All three programs on the same problem, one after the other; FOLDER keeps the peers' environments.
set -euo pipefail
at=${1:?usage: run.sh FOLDER}
here=$(cd "$(dirname "$0")" && pwd)
export OMP_NUM_THREADS=1
if [ ! -x "$at/tamaas/bin/python" ]; then
    python3 -m venv "$at/tamaas"
    "$at/tamaas/bin/pip" -q install tamaas==2.9.0 scipy
fi
if [ ! -x "$at/contactmechanics/bin/python" ]; then
    python3 -m venv "$at/contactmechanics"
    "$at/contactmechanics/bin/pip" -q install ContactMechanics==1.8.3
fi
(cd "$here/../.." && cargo build --quiet --release --workspace --example periodic_wave)
results=$(mktemp)
trap 'rm -f "$results"' EXIT
"$at/tamaas/bin/python" "$here/periodic_tamaas.py" >> "$results"
"$at/contactmechanics/bin/python" "$here/periodic_contactmechanics.py" >> "$results"
"$here/../../target/release/examples/periodic_wave" >> "$results"
python3 "$here/table.py" "$results"
