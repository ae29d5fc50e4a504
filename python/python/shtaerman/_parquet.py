"""The parts of a study as Parquet, by pyarrow."""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from . import _shtaerman as engine


def pyarrow_of() -> Any:
    try:
        # It has no types of its own.
        import_module("pyarrow.parquet")
        return import_module("pyarrow")
    except ImportError as error:
        raise ImportError("format='parquet' needs pyarrow: pip install 'shtaerman[parquet]'") from error


def write(names: Sequence[str], columns: Sequence[Any], path: str) -> None:
    """Whole or not at all: beside its place first."""
    pyarrow = pyarrow_of()
    fields = [pyarrow.field(name, _type(pyarrow, column), nullable=False) for name, column in zip(names, columns, strict=True)]
    table = pyarrow.table(list(columns), schema=pyarrow.schema(fields))
    beside = Path(path).with_name(f".shtaerman-{os.getpid()}-{Path(path).name}")
    try:
        pyarrow.parquet.write_table(table, beside, compression="none", write_page_checksum=True)
        os.replace(beside, path)
    except OSError as error:
        raise OSError(f"{path} cannot be written: {error}") from error
    finally:
        beside.unlink(missing_ok=True)


def _type(pyarrow: Any, column: Any) -> Any:
    if isinstance(column, list):
        return pyarrow.string()
    return pyarrow.int64() if column.dtype.kind == "i" else pyarrow.float64()


def read(study: engine.Study, part: int, path: str) -> list[Any] | None:
    """The columns of a part that is there and whole."""
    if not os.path.exists(path):
        return None
    pyarrow = pyarrow_of()
    try:
        table = pyarrow.parquet.read_table(path, page_checksum_verification=True)
    except (pyarrow.ArrowException, OSError):
        return None
    if table.column_names != list(study.columns):
        return None
    columns = [column.to_pylist() if pyarrow.types.is_string(column.type) else column.to_numpy() for column in table.columns]
    return columns if study.is_part(part, columns[0]) else None
