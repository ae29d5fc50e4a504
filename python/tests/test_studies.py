"""Studies of equations, of searches and of places."""

from __future__ import annotations

import math
import pickle
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Program

import shtaerman as st

EQUATION: dict[str, Any] = {
    "equation": {"kind": "first", "rhs": "1"},
    "kernel": {"name": "log", "a": 1.0},
    "study": {"vary": {"kernel.a": [0.5, 1.0, 1.5]}, "outputs": ["integral", "phi(0)", "phi(0.4)"], "audited_sample": 2},
}


def test_an_equation_is_studied_as_its_closed_form(tmp_path: Path) -> None:
    found = st.sweep(EQUATION, tmp_path / "out")
    arrays = found.arrays()
    a = arrays["kernel.a"]
    # int ln 1/|x - s| phi ds = 1.
    for x in (0.0, 0.4):
        name = f"phi({x:g})"
        exact = 1 / (math.pi * np.log(2 / a) * np.sqrt((a - x) * (a + x)))
        assert (np.abs(arrays[name] - exact) <= arrays[f"{name}_error"] + 1e-15 * exact).all()
        assert (arrays[f"{name}_error"] < 1e-12 * exact).all()
    assert np.allclose(arrays["integral"], 1 / np.log(2 / a), rtol=1e-14)
    assert found.outputs == ["integral", "phi(0)", "phi(0.4)"]
    data = found.to_xarray()
    assert data["phi(0)"].dims == ("kernel.a",)


def test_equations_are_what_st_equation_says(tmp_path: Path, program: Program) -> None:
    path = tmp_path / "study.toml"
    path.write_text(
        '[equation]\nkind = "second"\nlambda = 1.0\nrhs = "exp(x)"\n[kernel]\nname = "power"\na = 1.0\nmu = 0.3\n'
        '[study]\nvary."equation.lambda" = { from = 0.5, to = 2, count = 3 }\noutputs = ["phi(-0.3)", "integral"]\naudit = true\npart_size = 1\n'
    )
    with ThreadPoolExecutor(2) as pool:
        found = st.sweep(path, tmp_path / "out", map=pool.map)
    arrays = found.arrays()
    for case, parameter in enumerate(arrays["equation.lambda"]):
        alone = st.equation(kind="second", kernel="power", a=1.0, mu=0.3, lambda_=float(parameter), rhs="exp(x)", at=[-0.3])
        assert arrays["phi(-0.3)"][case] == alone.phi[0]
        assert arrays["phi(-0.3)_error"][case] == alone.error.solution_sup
        assert arrays["integral"][case] == alone.integral and arrays["integral_error"][case] == alone.error.integral
        assert arrays["error_kind"][case] == alone.error.kind
    subprocess.run([program.path, "sweep", "study.toml", "-o", "theirs"], cwd=tmp_path, check=True, capture_output=True)
    for part in sorted((tmp_path / "theirs").iterdir()):
        assert part.read_bytes() == (tmp_path / "out" / part.name).read_bytes()


def test_places_stresses_and_searches_are_those_of_single_calls(tmp_path: Path, steel: dict[str, Any]) -> None:
    punch = {"half_width": steel.pop("half_width"), "profile": "x^2 / 40"}
    tables: dict[str, Any] = {"foundation": {name: steel[name] for name in ("young_modulus", "poisson_ratio", "roughness")}, "punch": punch}
    load = {"force": "0.8 MN/m", "moment": 0}
    outputs = ["pressure(2 mm)", "displacement(8 mm)", "max_shear", "max_shear_depth"]
    study = {"vary": {"load.force": [4e5, 8e5]}, "outputs": outputs, "audited_sample": 0}
    arrays = st.sweep({**tables, "load": load, "study": study}, tmp_path / "out").arrays()
    for case, force in enumerate((4e5, 8e5)):
        contact = st.solve({**tables, "load": {**load, "force": force}}, audit=False)
        assert arrays["pressure(2 mm)"][case] == contact.pressure(2e-3)
        assert arrays["displacement(8 mm)"][case] == contact.displacement(8e-3)
        depth = np.linspace(1e-6, 5e-3, 400)
        sampled = contact.stress(np.linspace(-5e-3, 5e-3, 81)[:, None], depth).max_shear.max()
        assert sampled <= arrays["max_shear"][case] * (1 + 1e-9) and arrays["max_shear"][case] < 1.02 * sampled
    study = {"vary": {"foundation.roughness": [1e-14, 2e-14]}, "find": {"force": {"peak_pressure": "150 MPa"}}, "audited_sample": 0}
    arrays = st.sweep({**tables, "load": load, "study": study}, tmp_path / "found").arrays()
    for case, roughness in enumerate((1e-14, 2e-14)):
        alone = st.find("force", {**tables, "load": load}, peak_pressure="150 MPa", audit=False, roughness=roughness)
        assert arrays["found"][case] == alone.value == arrays["force"][case]


def test_results_go_to_other_processes(tmp_path: Path) -> None:
    found = st.sweep(EQUATION, tmp_path / "out")
    again = pickle.loads(pickle.dumps(found))
    assert again.folder == found.folder and again.cases == 3
    assert all((again.arrays()[name] == values).all() for name, values in found.arrays().items())
    assert again.audited_sample[0].keys() == found.audited_sample[0].keys()


def test_a_client_that_does_not_wait_is_refused(tmp_path: Path) -> None:
    class Client:
        asynchronous = True

        def map(self) -> None: ...

        def cancel(self) -> None: ...

    with pytest.raises(ValueError, match="is asynchronous"):
        st.sweep(EQUATION, tmp_path / "out", client=Client())


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"outputs": ["settlement"]}, "phi"),
        ({"vary": {"equation.rhs": ["1", "x"]}, "outputs": ["phi(2)"]}, "cannot be told"),
        ({"vary": {"kernel.b": [0.1]}}, "kernel.b"),
        ({"find": {"force": {"peak_pressure": 1}}}, "find"),
        ({"vary": {"kernel.a": {"from": 0.1, "to": 1.0, "count": 10**12}}}, "has 1000000000000 cases"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, changed: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.sweep({**EQUATION, "study": {**EQUATION["study"], **changed}}, tmp_path / "out")
    assert not (tmp_path / "out").exists()
