"""How fast a world wants simulated time to go: its <physics> elements, as Gazebo takes them."""

from xml.etree import ElementTree

from .errors import UsageError

UPDATE_RATE = 1000.0  # Hz, Gazebo's default
STEP = 0.001  # s


def real_time_factor(world_file, profile=None):
    """Return simulated seconds per wall second, 0 for as fast as possible, None if the world does not say.

    The simulator keeps its own step: what counts is how much simulated time the world's steps make.

    Args:
        world_file: path; what is not XML is left to the simulator to complain about.
        profile: name of a <physics> element; else the one that is marked as default counts, else the first.

    Raises:
        UsageError: there is no such profile, or a number in it is not one.
    """
    try:
        world = ElementTree.parse(world_file).getroot().find("world")
    except (ElementTree.ParseError, UnicodeDecodeError):
        return None
    profiles = [] if world is None else world.findall("physics")
    physics = _chosen(profiles, profile, world_file)
    if physics is None:
        return None
    rate = _number(physics, "real_time_update_rate", UPDATE_RATE, world_file)
    return rate * _number(physics, "max_step_size", STEP, world_file)


def _chosen(profiles, name, world_file):
    if name is not None:
        found = next((each for each in profiles if each.get("name") == name), None)
        if found is None:
            names = ", ".join(each.get("name", "without a name") for each in profiles)
            raise UsageError(f"--profile: found {name!r}, {world_file} has {names or 'no <physics>'}")
        return found
    marked = [each for each in profiles if each.get("default", "").strip().lower() in ("1", "true")]
    return next(iter([*marked, *profiles]), None)


def _number(physics, tag, default, world_file):
    text = physics.findtext(tag)
    try:
        value = default if text is None else float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value < float("inf"):
        raise UsageError(f"{world_file}: world/physics/{tag}: found {text!r}, expected a number >= 0")
    return value
