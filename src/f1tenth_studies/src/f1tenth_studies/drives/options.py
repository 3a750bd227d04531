"""What all commands that drive are told."""

import argparse
from pathlib import Path


def add_options(parser: argparse.ArgumentParser, circuits: str) -> None:
    """Add them to a command's parser; `circuits`: default seeds of each circuit."""
    parser.add_argument("--circuits", default=circuits, metavar="SEEDS", help="of each circuit (%(default)s)")
    parser.add_argument(
        "--tracks", default="0:1", metavar="SEEDS", help="of each track, in both directions (%(default)s)"
    )
    parser.add_argument(
        "--table", type=Path, metavar="FILE", help="write the table there, too; what is below it stays"
    )
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results of the workspace")
    parser.add_argument("--jobs", type=int, metavar="N", help="drives at a time; default: one per core")
