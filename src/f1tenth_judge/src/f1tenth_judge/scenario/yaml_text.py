"""YAML that is in no file, as a tree of nodes that remember where it is from."""

import io

import yaml

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.yaml_files.yaml_source import TOO_DEEP


class _NamedText(io.StringIO):
    """A text that YAML takes for a file: all nodes have its name, so that an error can name its place."""

    def __init__(self, text: str, name: str):
        super().__init__(text)
        self.name = name


def compose_text(text: str, name: str) -> yaml.Node:
    """Read a text; `name` says in errors where it is from.

    Raises:
        ScenarioError: it is not YAML, or holds nothing.
    """
    try:
        node = yaml.compose(_NamedText(text, name), Loader=yaml.SafeLoader)
    except RecursionError as error:
        raise ScenarioError(f"{name}: {TOO_DEEP}") from error
    except yaml.YAMLError as error:
        raise ScenarioError(f"{name}: not YAML: {' '.join(str(error).split())}") from error
    if node is None:  # blanks or a comment
        raise ScenarioError(f"{name}: must hold a value, found nothing")
    return node
