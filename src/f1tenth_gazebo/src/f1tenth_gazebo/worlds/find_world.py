"""Finds the world file that a launch argument means."""

import argparse
import sys
from pathlib import Path


class WorldError(Exception):
    """There is no such world, or it cannot be used. The message is one line."""


def find_world(name, worlds_folder, current_folder):
    """Absolute path of a world.

    Args:
        name: name of a world in worlds_folder, without `.world`; or the path of a .world file or of the .yaml
            file of a map, relative to current_folder.
        worlds_folder: where named worlds lie.
        current_folder: where relative paths start.

    Raises:
        WorldError: if there is no such file.
    """
    is_path = "/" in name or name.endswith((".world", ".yaml"))
    path = Path(current_folder) / name if is_path else Path(worlds_folder) / f"{name}.world"
    if not path.is_file():
        known = ", ".join(sorted(world.stem for world in Path(worlds_folder).glob("*.world")))
        wanted = f"there is no world file {path}" if is_path else f"there is no world named '{name}'"
        raise WorldError(f"{wanted}; known names: {known}; a path works, too")
    return path.absolute()


def check_world(path):
    """Raise WorldError unless the simulator can read the world."""
    # Imported here, as nobody needs the simulator where Gazebo takes its place.
    import f1tenth_sim2d

    try:
        f1tenth_sim2d.load_world(str(path))
    except f1tenth_sim2d.LoadError as error:
        raise WorldError(str(error)) from error


def main(package_folder, arguments=None):
    """Print the path of the world that is asked for; return the exit code.

    Args:
        package_folder: where worlds/ lies.
        arguments: those of the command line; default: of this process.
    """
    parser = argparse.ArgumentParser(prog="find_world", description="Print the path of a world.")
    parser.add_argument("world", metavar="NAME|PATH")
    parser.add_argument("--check", action="store_true", help="fail unless the simulator can read it")
    options = parser.parse_args(arguments)
    try:
        path = find_world(options.world, Path(package_folder) / "worlds", Path.cwd())
        if options.check:
            check_world(path)
    except WorldError as error:
        print(f"world_file_name: {error}", file=sys.stderr)
        return 1
    print(path, end="")
    return 0
