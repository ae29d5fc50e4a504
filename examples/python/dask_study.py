# %% [markdown]
# # A study on several processes, with Dask
#
# What one learns: how a study that outgrows one process goes to workers, and that its rows are those of single solves.
#
#     python examples/python/dask_study.py
#
# How the tolerances of a drawing spread the largest pressure, computed by the workers of a Dask cluster. Here the cluster is two processes of this machine; on others it is whatever
# `distributed.Client` is connected with. Needs `pip install './python[dask,pandas]'`.

# %%
import tempfile
from pathlib import Path

import numpy as np

import shtaerman as st

study = {
    "foundation": {"young_modulus": "210 GPa", "poisson_ratio": 0.3, "roughness": "2e-14 m/Pa"},
    "punch": {"half_width": "4 mm", "profile": "x^2 / (2*15)"},
    "load": {"force": "0.6 MN/m", "moment": 0},
    "study": {
        "design": "sobol",
        "count": 256,
        "seed": 12,
        "part_size": 16,
        "vary": {
            "foundation.roughness": {"distribution": "lognormal", "mean": "2e-14 m/Pa", "standard_deviation": "5e-15 m/Pa"},
            "load.force": {"distribution": "normal", "mean": "0.6 MN/m", "standard_deviation": "0.03 MN/m"},
        },
        "outputs": ["peak_pressure", "contact_width"],
    },
}


# %% [markdown]
# Each task computes parts and writes them into a folder that all workers see; only paths come back. A worker that dies loses nothing: its task is done again. On Windows and macOS, and in scripts
# anywhere, the cluster is started from a function, because workers are new processes that read the script.


# %%
def main() -> st.Sweep:
    from distributed import Client, LocalCluster

    folder = Path(tempfile.mkdtemp()) / "tolerances"
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        found = st.sweep(study, folder, client=client)
    pressure = found.arrays()["peak_pressure"]
    low, high = np.quantile(pressure, [0.05, 0.95]) / 1e6
    # A row is the solve of its case, to the last bit.
    rows = found.arrays()
    problem = {name: table for name, table in study.items() if name != "study"}
    alone = st.solve(problem, roughness=rows["foundation.roughness"][100], force=rows["load.force"][100], audit=False)
    assert rows["peak_pressure"][100] == alone.peak_pressure
    print(f"largest pressure: {pressure.mean() / 1e6:.1f} MPa in the mean, {low:.1f} to {high:.1f} MPa in nine of ten cases")
    return found


# %%
if __name__ == "__main__":
    main()
