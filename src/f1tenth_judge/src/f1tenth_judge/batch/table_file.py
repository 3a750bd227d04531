"""The table of a sweep as a file: CSV or Apache Parquet, by the ending of its name."""

import csv
import importlib.util
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing

CSV, PARQUET = ".csv", ".parquet"
_ENGINE = "fastparquet"


def check_table_file(path: Path) -> None:
    """Find out whether a table could be written there, before anything runs.

    Raises:
        ScenarioError: another ending, no such folder or a read-only one, or what writes Parquet is missing.
    """
    if path.suffix not in (CSV, PARQUET):
        raise ScenarioError(f"{path}: a table's name must end with {CSV} or {PARQUET}")
    if not path.parent.is_dir():
        raise ScenarioError(f"{path}: there is no folder {path.parent}")
    if path.suffix == PARQUET and importlib.util.find_spec(_ENGINE) is None:
        raise ScenarioError(f"{path}: Parquet needs the Python package {_ENGINE} (make setup installs it)")
    with writing(path), tempfile.TemporaryFile(dir=path.parent):
        pass


def write_table(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Write a row per run. Parquet keeps types: varied values that are numbers become numbers."""
    with replacing(path) as temporary:
        if path.suffix == PARQUET:
            _write_parquet(temporary, rows)
        else:
            _write_csv(temporary, rows)


def _write_csv(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def _write_parquet(path, rows):
    # Imported late: only needed for Parquet.
    import pandas

    columns = {name: _typed([row[name] for row in rows]) for name in rows[0]}
    pandas.DataFrame(columns).to_parquet(path, engine=_ENGINE, index=False)


def _typed(values: Sequence[Any]) -> Sequence[Any]:
    """Texts as whole numbers or numbers, if all of them are; missing numbers as nan."""
    for kind in (int, float):
        try:
            return [kind(value) if isinstance(value, str) else value for value in values]
        except ValueError:
            continue
    return values
