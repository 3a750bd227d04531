"""A circuit as an SDF world, written as Gazebo writes it."""

from f1tenth_judge.places.centreline import centreline

from f1tenth_gazebo.worlds.openings import blocks, place_openings
from f1tenth_gazebo.worlds.walls import HEIGHT, THICKNESS, road_walls, wall_chain

_WORLD = """<?xml version='1.0'?>
<sdf version='1.7'>
  <world name='default'>
    <include>
      <uri>model://sun</uri>
    </include>
    <include>
      <uri>model://ground_plane</uri>
    </include>
    <gravity>0 0 -9.8</gravity>
    <physics type='ode'>
      <max_step_size>0.001</max_step_size>
      <real_time_factor>1</real_time_factor>
      <real_time_update_rate>1000</real_time_update_rate>
    </physics>
    <scene>
      <ambient>0.4 0.4 0.4 1</ambient>
      <background>0.7 0.7 0.7 1</background>
      <shadows>1</shadows>
    </scene>
    <model name='{name}'>
      <pose>0 0 0 0 -0 0</pose>
{links}      <static>1</static>
    </model>
{props}  </world>
</sdf>
"""

_LINK = """      <link name='{name}'>
{solids}        <pose>{x} {y} 0 0 -0 {yaw}</pose>
      </link>
"""

_SOLID = """        <collision name='{name}_Collision{suffix}'>
          <geometry>
{shape}          </geometry>
          <pose>{pose}</pose>
        </collision>
        <visual name='{name}_Visual{suffix}'>
          <pose>{pose}</pose>
          <geometry>
{shape}          </geometry>
          <material>
            <script>
              <uri>file://media/materials/scripts/gazebo.material</uri>
              <name>{material}</name>
            </script>
            <ambient>1 1 1 1</ambient>
          </material>
          <meta>
            <layer>0</layer>
          </meta>
        </visual>
"""

_BOX = """            <box>
              <size>{size}</size>
            </box>
"""

_CYLINDER = """            <cylinder>
              <radius>{radius}</radius>
              <length>{length}</length>
            </cylinder>
"""

_PROP = """    <include>
      <uri>model://{model}</uri>
      <name>{name}</name>
      <pose>{x} {y} 0 0 -0 {yaw}</pose>
    </include>
"""


def circuit_walls(circuit):
    """All walls of a circuit, those of its rooms last."""
    walls = road_walls(circuit, centreline(circuit))
    for room in circuit.rooms:
        walls += wall_chain(room.points, room.material, closed=room.points[0] == room.points[-1])
    return walls


def world_text(circuit):
    """The world file of a circuit: one static model with a link for each wall, and its props as includes.

    Raises:
        CircuitError: if the walls of the circuit cannot be built.
    """
    walls = circuit_walls(circuit)
    links = wall_links(walls, place_openings(circuit, walls))
    return _WORLD.format(name=circuit.name, links="".join(links), props="".join(_props(circuit)))


def road_world_text(name, walls, cylinders, material):
    """The world file of walls and of cylinders (x, y, radius in m) as high as the walls."""
    links = wall_links(walls, {})
    for i, (x, y, radius) in enumerate(cylinders):
        shape = _CYLINDER.format(radius=_number(radius), length=HEIGHT)
        solid = _solid(f"Island_{i}", "", shape, (0.0, HEIGHT / 2), material)
        links.append(_LINK.format(name=f"Island_{i}", solids=solid, x=_number(x), y=_number(y), yaw=0))
    return _WORLD.format(name=name, links="".join(links), props="")


def wall_links(walls, openings):
    """A link for each wall; `openings` by the index of the wall."""
    return [_link(f"Wall_{i}", wall, openings.get(i, [])) for i, wall in enumerate(walls)]


def _link(name, wall, openings):
    parts = blocks(wall, openings)
    suffixes = [""] if len(parts) == 1 else [f"_{i}" for i in range(len(parts))]
    text = [_block(name, suffix, wall, part) for suffix, part in zip(suffixes, parts)]
    return _LINK.format(
        name=name, solids="".join(text), x=_number(wall.x), y=_number(wall.y), yaw=_number(wall.yaw)
    )


def _block(name, suffix, wall, part):
    size = (part.end - part.start, THICKNESS, part.top - part.bottom)
    place = (part.start + part.end) / 2, (part.bottom + part.top) / 2
    return _solid(name, suffix, _BOX.format(size=" ".join(map(_number, size))), place, wall.material)


def _solid(name, suffix, shape, place, material):
    x, z = map(_number, place)
    return _SOLID.format(name=name, suffix=suffix, shape=shape, pose=f"{x} 0 {z} 0 -0 0", material=material)


def _props(circuit):
    counts: dict = {}
    for prop in circuit.props:
        number = counts.get(prop.model, 0)
        counts[prop.model] = number + 1
        yield _PROP.format(
            model=prop.model,
            name=prop.model if number == 0 else f"{prop.model}_{number}",
            x=_number(prop.at.x),
            y=_number(prop.at.y),
            yaw=_number(prop.at.yaw),
        )


def _number(value):
    """Micrometres are enough; no trailing zeros, and no negative zero."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
