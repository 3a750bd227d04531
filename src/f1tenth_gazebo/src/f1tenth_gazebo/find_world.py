"""Finds the world file that a launch argument means."""

import sys
from pathlib import Path


class WorldNotFoundError(Exception):
    """There is no such world. The message is one line and lists the known names."""


def find_world(name, worlds_folder, current_folder):
    """Absolute path of a world.

    Args:
        name: name of a world in worlds_folder, without `.world`; or the path of a .world file or of the .yaml
            file of a map, relative to current_folder.
        worlds_folder: where named worlds lie.
        current_folder: where relative paths start.

    Raises:
        WorldNotFoundError: if there is no such file.
    """
    is_path = "/" in name or name.endswith((".world", ".yaml"))
    path = Path(current_folder) / name if is_path else Path(worlds_folder) / f"{name}.world"
    if not path.is_file():
        known = ", ".join(sorted(world.stem for world in Path(worlds_folder).glob("*.world")))
        wanted = f"there is no world file {path}" if is_path else f"there is no world named '{name}'"
        raise WorldNotFoundError(f"world_file_name: {wanted}; known names: {known}; a path works, too")
    return path.absolute()


def main(package_folder, arguments=None):
    """Print the path of the world that the only argument means; return the exit code."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if len(arguments) != 1:
        print("usage: find_world NAME|PATH", file=sys.stderr)
        return 2
    try:
        print(find_world(arguments[0], Path(package_folder) / "worlds", Path.cwd()), end="")
    except WorldNotFoundError as error:
        print(error, file=sys.stderr)
        return 1
    return 0
