"""Studies: a problem with some of its values varied, on threads, processes or a cluster."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _document as document
from . import _parquet as parquet
from . import _shtaerman as engine
from ._arrays import processors

if TYPE_CHECKING:
    import pandas
    import xarray

#: What a study may be given as.
StudyLike = str | os.PathLike[str] | Mapping[str, Any]
Array = npt.NDArray[Any]

#: Studies of more cases ask first, as on the command line.
_MANY = 1_000_000
#: A task takes at least this long (s): scheduling one costs about a millisecond.
_TASK = 0.5
#: Cases that are timed before tasks are cut.
_TIMED = 8
_FORMATS = ("csv", "npz", "parquet")


@dataclass(frozen=True)
class _Source:
    """A study as text: what goes to another process."""

    content: bytes
    name: str
    folder: str
    overrides: tuple[str, ...]

    def study(self) -> engine.Study:
        return _STUDIES.get(self)


class _Studies:
    """The last few studies that were read: each of many tasks asks for the same one."""

    MOST = 4

    def __init__(self) -> None:
        self._read: dict[_Source, engine.Study] = {}

    def get(self, source: _Source) -> engine.Study:
        found = self._read.pop(source, None)
        if found is None:
            found = engine.Study(source.content, source.name, source.folder, list(source.overrides))
        self._read[source] = found
        while len(self._read) > self.MOST:
            self._read.pop(next(iter(self._read)), None)
        return found


_STUDIES = _Studies()


@dataclass(frozen=True)
class _Task:
    """Parts that one call computes."""

    source: _Source
    version: str
    folder: str
    format: str
    parts: tuple[int, ...]
    threads: int


def _work(task: _Task) -> list[str]:
    """Computes the parts of a task that are not there, and gives the paths of all."""
    if task.version != engine.__version__:
        raise ValueError(
            f"a worker has version {engine.__version__} of shtaerman, the study was begun by {task.version}: install the same version on both"
        )
    if not os.path.isdir(task.folder):
        raise ValueError(f"a worker does not see the folder {task.folder}: it must be one that all workers and the client share")
    results = task.source.study().results(task.source.name, task.folder, task.format, True)
    return [_complete(task.source.study(), results, task.format, part, task.threads)[0] for part in task.parts]


def _complete(study: engine.Study, results: engine.Results, format: str, part: int, threads: int) -> tuple[str, bool]:
    """The path of a part, and whether it had to be computed."""
    path = os.fspath(results.path(part))
    if format != "parquet":
        return path, results.complete(part, threads)
    if parquet.read(study, part, path) is not None:
        return path, False
    parquet.write(study.columns, results.solve(part, threads), path)
    return path, True


def sweep(
    study: StudyLike,
    output: str | os.PathLike[str],
    /,
    *,
    overrides: Sequence[str] = (),
    format: str = "csv",
    threads: int | None = None,
    client: Any = None,
    map: Callable[..., Iterable[Any]] | None = None,
    shard: tuple[int, int] | None = None,
    yes: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep:
    """Computes a study into a folder, part by part; parts that are there and whole are kept.

    A study is a problem file with a table ``[study]``, as for ``shtaerman sweep``, which fills the same folder with the same bytes.

    Parameters
    ----------
    study:
        The path of a study file, its text, or a dictionary with its tables.
    output:
        The folder of the results, made where it is not there.
    overrides:
        Values of the file anew, each ``"key=value"`` as by ``--set``.
    format:
        ``"csv"``, ``"npz"``, or ``"parquet"`` (needs pyarrow).
    threads:
        How many threads compute here; as many as there are processors where left out. Ignored with ``client`` or ``map``, where each task takes one.
    client:
        A ``distributed.Client``: tasks of half a second or more go to its workers, which must see the folder; only paths come back. A task whose worker dies is done again by another.
    map:
        Anything that maps as the builtin does and may do so elsewhere: ``concurrent.futures.ProcessPoolExecutor().map``, or joblib's.
    shard:
        ``(i, n)``: the i-th of n shares of the parts, from 1 to n.
    yes:
        Whether a study of more than a million cases is meant.
    progress:
        Called with the number of parts that are done and of all.

    Returns
    -------
    Sweep
        The results.

    Raises
    ------
    ValueError
        For what is wrong with the study, for a folder that has something else, and for workers of another version.
    OSError
        Where a part cannot be written, as on a full disk; what was written stays, and the same call goes on there.

    Examples
    --------
    >>> import tempfile
    >>> import shtaerman as st
    >>> problem = {"dimensionless": {"theta0": 1.0, "profile": "xi^2", "force": 1.0, "moment": 0}}
    >>> vary = {"dimensionless.theta0": {"from": 0.1, "to": 10.0, "count": 5, "scale": "log"}}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = st.sweep({**problem, "study": {"vary": vary, "outputs": ["settlement"]}}, folder)
    ...     found.arrays()["settlement"].shape
    (5,)
    """
    if format not in _FORMATS:
        raise ValueError(f"format: must be one of {', '.join(_FORMATS)}, got {format!r}")
    if format == "parquet":
        parquet.pyarrow_of()
    if client is not None and map is not None:
        raise ValueError("sweep(): give client or map, not both")
    if map is not None and not callable(map):
        raise ValueError(f"map: must be a function that maps as the builtin does, got {type(map).__name__}")
    if client is not None and not (callable(getattr(client, "map", None)) and callable(getattr(client, "cancel", None))):
        raise ValueError(f"client: must be a distributed.Client, got {type(client).__name__}")
    if getattr(client, "asynchronous", False):
        raise ValueError("client: is asynchronous, and sweep() waits for what is computed: take a Client without asynchronous=True")
    source = _source(study, overrides)
    read = source.study()
    if read.cases > _MANY and not yes:
        raise ValueError(_too_many(read))
    folder = os.path.abspath(os.fspath(output))
    results = read.results(source.name, folder, format, False)
    chosen = _chosen(read.parts, shard)
    found = Sweep._of(source, folder, format, results, len(chosen))
    missing = [part for part in chosen if not found._is_whole(part)]
    done = len(chosen) - len(missing)
    if progress is not None and done:
        progress(done, len(chosen))
    for count in _computed(source, read, results, folder, format, missing, threads, client, map):
        done += count
        if progress is not None:
            progress(done, len(chosen))
    found._audit()
    results.sweep_out()
    return found


def _computed(
    source: _Source,
    study: engine.Study,
    results: engine.Results,
    folder: str,
    format: str,
    missing: list[int],
    threads: int | None,
    client: Any,
    map: Callable[..., Iterable[Any]] | None,
) -> Iterator[int]:
    """Computes the parts that are missing, and tells of how many at a time."""
    if client is None and map is None:
        count = processors() if threads is None else threads
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError(f"threads: must be a whole number of at least 1, got {threads!r}")
        for part in missing:
            _complete(study, results, format, part, count)
            yield 1
        return
    if not missing:
        return
    tasks = [_Task(source, engine.__version__, folder, format, parts, 1) for parts in _cut(study, missing)]
    done: Any = _distributed(client, tasks) if map is None else map(_work, tasks)
    if not isinstance(done, Iterable):
        raise ValueError(f"map: must give an iterable of what the function gave, gave {type(done).__name__}")
    for paths in done:
        yield len(paths)


def _cut(study: engine.Study, missing: list[int]) -> list[tuple[int, ...]]:
    """Parts in tasks that take long enough each."""
    cases = math.ceil(study.cases / study.parts)
    together = max(1, math.ceil(_TASK / max(_seconds(study) * cases, 1e-9)))
    return [tuple(missing[at : at + together]) for at in range(0, len(missing), together)]


def _seconds(study: engine.Study) -> float:
    """About how long one case takes."""

    def each(count: int) -> float:
        start = time.perf_counter()
        study.solve(0, count)
        return (time.perf_counter() - start) / min(count, study.cases)

    # What all cases have in common is done with the first.
    study.solve(0, 1)
    first = each(study.block)
    return each(_TIMED * study.block) if _TIMED * study.block * first < _TASK else first


def _distributed(client: Any, tasks: list[_Task]) -> Iterator[list[str]]:
    distributed: Any = import_module("distributed")
    # Not pure: a folder that was emptied is filled again.
    futures = client.map(_work, tasks, pure=False)
    try:
        for future in distributed.as_completed(futures):
            yield future.result()
    finally:
        client.cancel([future for future in futures if not future.done()])


def _chosen(parts: int, shard: tuple[int, int] | None) -> list[int]:
    if shard is None:
        return list(range(parts))
    try:
        index, count = shard
        is_right = 1 <= index <= count
    except (TypeError, ValueError):
        is_right = False
    if not is_right:
        raise ValueError(f"shard: must be (i, n) with i from 1 to n, got {shard!r}")
    return list(range(index - 1, parts, count))


def _too_many(study: engine.Study) -> str:
    start = time.perf_counter()
    study.solve(0, study.block)
    hours = (time.perf_counter() - start) / study.block * study.cases / 3600
    return f"the study has {study.cases} cases, some {hours:.1e} hours on one core: yes=True runs it, fewer values or design = 'sobol' make it smaller"


def _source(study: StudyLike, overrides: Sequence[str]) -> _Source:
    if isinstance(overrides, str) or not all(isinstance(text, str) for text in overrides):
        raise ValueError(f"overrides: must be a list of texts such as 'load.moment=0', got {overrides!r}")
    given = tuple(overrides)
    if isinstance(study, Mapping):
        return _Source(_toml(study).encode(), "study", os.getcwd(), given)
    if isinstance(study, str) and "\n" in study:
        return _Source(study.encode("utf-8", "surrogateescape"), "study", os.getcwd(), given)
    if isinstance(study, (str, os.PathLike)):
        path = os.fspath(study)
        folder = os.path.dirname(os.path.abspath(path))
        return _Source(engine.load(path), os.path.basename(path), folder, given)
    raise ValueError(f"sweep() takes a path, the text of a study file or a dictionary, got {type(study).__name__}")


def _toml(tables: Mapping[str, Any]) -> str:
    """A dictionary as the text of a study file; lists and arrays of one dimension are lists of values."""
    problem = {name: table for name, table in tables.items() if name != "study"}
    table = tables.get("study")
    if not isinstance(table, Mapping):
        raise ValueError("study: is missing: a dictionary with 'vary', such as {'load.force': {'from': 1e5, 'to': 2e6, 'count': 20}}")
    lines = [f"{document.key_text(name)} = {_value(value, f'study.{name}')}" for name, value in table.items() if value is not None]
    return document.toml(problem) + "\n[study]\n" + "\n".join(lines) + "\n"


def _value(value: Any, key: str) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{document.key_text(name)} = {_value(inner, f'{key}.{name}')}" for name, inner in value.items()) + " }"
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim == 1):
        return "[" + ", ".join(document.toml_value(item, key) for item in value) + "]"
    return document.toml_value(value, key)


class Sweep:
    """The results of a study in a folder."""

    __slots__ = ("_audited", "_chosen", "_folder", "_format", "_results", "_source")

    _source: _Source
    _folder: str
    _format: str
    _results: engine.Results
    _chosen: int
    _audited: tuple[dict[str, Array], dict[str, Array]] | None

    def __init__(self) -> None:
        raise TypeError("results are made by sweep()")

    @classmethod
    def _of(cls, source: _Source, folder: str, format: str, results: engine.Results, chosen: int) -> Sweep:
        made = cls.__new__(cls)
        made._source, made._folder, made._format, made._results = source, folder, format, results
        made._chosen, made._audited = chosen, None
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._source, self._folder, self._format, self._chosen, self._audited)

    @property
    def _study(self) -> engine.Study:
        return self._source.study()

    def _read(self, part: int) -> list[Any] | None:
        if self._format == "parquet":
            return parquet.read(self._study, part, os.fspath(self._results.path(part)))
        return self._results.arrays(part)

    def _is_whole(self, part: int) -> bool:
        return self._read(part) is not None

    def _audit(self) -> None:
        if not self._study.is_audited:
            plain, audited = self._study.audited_sample()
            names = self._study.columns
            self._audited = (_named(names, [plain]), _named(names, [audited]))

    @property
    def cases(self) -> int:
        """How many cases the study has."""
        return self._study.cases

    @property
    def folder(self) -> str:
        """Where the results are."""
        return self._folder

    @property
    def variables(self) -> list[str]:
        """The keys that vary."""
        return self._study.variables

    @property
    def outputs(self) -> list[str]:
        """What is kept of each answer."""
        return self._study.outputs

    @property
    def paths(self) -> list[str]:
        """The files of the parts that are there, in order."""
        every = (os.fspath(self._results.path(part)) for part in range(self._study.parts))
        return [path for path in every if os.path.exists(path)]

    @property
    def audited_sample(self) -> tuple[dict[str, Array], dict[str, Array]] | None:
        """The cases that were audited to see whether the errors hold, without and with their audits; ``None`` where every case is audited."""
        return self._audited

    def arrays(self) -> dict[str, Array]:
        """All columns of the parts that are there: ``case``, what varies, each output with its error, ``error_kind``, ``warnings`` and ``reason``."""
        every = (self._read(part) for part in range(self._study.parts))
        return _named(self._study.columns, [columns for columns in every if columns is not None])

    def to_pandas(self) -> pandas.DataFrame:
        """A table with a row for each case; pandas must be installed."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_pandas() needs pandas: pip install 'shtaerman[pandas]'") from error
        return pandas.DataFrame(self.arrays())

    def to_xarray(self) -> xarray.Dataset:
        """A data set: over the keys that vary for a whole grid, else over ``case``; xarray must be installed."""
        try:
            import xarray
        except ImportError as error:
            raise ImportError("to_xarray() needs xarray: pip install 'shtaerman[xarray]'") from error
        arrays, shape, variables = self.arrays(), self._study.shape, self.variables
        if shape is None or len(arrays["case"]) != self.cases:
            case = arrays.pop("case")
            return xarray.Dataset({name: ("case", values) for name, values in arrays.items()}, coords={"case": case})
        # In a grid the last key changes fastest.
        along = {
            name: arrays.pop(name).reshape(shape)[tuple(slice(None) if at == axis else 0 for at in range(len(shape)))]
            for axis, name in enumerate(variables)
        }
        return xarray.Dataset({name: (variables, values.reshape(shape)) for name, values in arrays.items()}, coords=along)

    def summary(self) -> dict[str, dict[str, float]]:
        """For each output the least and the largest value with their cases, the mean and the largest stated error, of the cases that have an answer."""
        arrays = self.arrays()
        told: dict[str, dict[str, float]] = {}
        for name in self.outputs:
            values, errors = arrays[name], arrays[f"{name}_error"]
            if not np.isfinite(values).any():
                continue
            least, largest = int(np.nanargmin(values)), int(np.nanargmax(values))
            stated = errors[~np.isnan(errors)]
            told[name] = {
                "least": float(values[least]),
                "least_case": int(arrays["case"][least]),
                "largest": float(values[largest]),
                "largest_case": int(arrays["case"][largest]),
                "mean": float(np.nanmean(values)),
                "error": float(stated.max()) if stated.size else math.nan,
            }
        return told

    def indices(self) -> dict[str, dict[str, dict[str, float]]]:
        """Sobol's indices, for ``design = "sobol-indices"``: for each output and each key that varies the share of the variance that the key brings about alone (``first``) and together with all
        others (``total``), each with its standard error for independent groups (``first_error``, ``total_error``). Estimates; NaN where nothing varies.

        Raises
        ------
        ValueError
            For other designs.
        """
        arrays = self.arrays()
        answered = np.array([not reason for reason in arrays["reason"]], dtype=bool)
        found = self._study.sobol_indices(arrays["case"], answered, [arrays[name] for name in self.outputs])
        if found is None:
            raise ValueError('indices(): only a study with design = "sobol-indices" has them')
        names = ("first", "first_error", "total", "total_error")
        of_output = (dict(zip(self.variables, (dict(zip(names, four)) for four in output))) for output in found)
        return dict(zip(self.outputs, of_output))

    def __repr__(self) -> str:
        return f"<Sweep: {self.cases} cases in {self._study.parts} parts, {len(self.paths)} there, varied: {', '.join(self.variables)}; {self._folder}>"


def _restored(source: _Source, folder: str, format: str, chosen: int, audited: tuple[dict[str, Array], dict[str, Array]] | None) -> Sweep:
    made = Sweep._of(source, folder, format, source.study().results(source.name, folder, format, True), chosen)
    made._audited = audited
    return made


def _named(names: Sequence[str], parts: Sequence[Sequence[Any]]) -> dict[str, Array]:
    """Columns of parts, one after the other."""

    def column(at: int) -> Array:
        pieces = [np.array(part[at], dtype=object) if isinstance(part[at], list) else part[at] for part in parts]
        return np.concatenate(pieces) if pieces else np.array([])

    return {name: column(at) for at, name in enumerate(names)}
