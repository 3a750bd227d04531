"""The types of the module in C++ name all that is in it."""

import ast
from pathlib import Path

from f1tenth_sim2d import _f1tenth_sim2d as module

TYPES = Path(__file__).parents[2] / "src/f1tenth_sim2d/_f1tenth_sim2d.pyi"


def named(body):
    """Names that a body of statements defines."""
    names = {each.name for each in body if isinstance(each, (ast.FunctionDef, ast.ClassDef))}
    return names | {each.target.id for each in body if isinstance(each, ast.AnnAssign)}


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_they_name_what_is_there():
    body = ast.parse(TYPES.read_text(encoding="utf-8")).body
    assert named(body) == public(module)
    for each in body:
        if isinstance(each, ast.ClassDef):
            assert {name for name in named(each.body) if not name.startswith("_")} == public(
                getattr(module, each.name)
            ), each.name
