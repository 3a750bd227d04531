"""Reads a circuit from its YAML file."""

import dataclasses
from pathlib import Path

from f1tenth_judge.places.circuit import Circuit
from f1tenth_judge.yaml_files.schema import read
from f1tenth_judge.yaml_files.yaml_source import compose


def load_circuit(path):
    """Read a circuit's YAML file.

    Raises:
        FileError: the file cannot be read or describes no circuit that can be driven.
    """
    path = Path(path)
    return dataclasses.replace(read(Circuit, compose(path)), name=path.stem)
