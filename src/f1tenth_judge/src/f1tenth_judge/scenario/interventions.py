"""What a scenario allows others to do to the running simulation."""

import dataclasses
import enum

from f1tenth_judge.yaml_files.schema import Problem, key


class InterventionKind(enum.Enum):
    """What can be allowed; a reset of time cannot, because no verdict could follow it."""

    SET_MODEL_STATE = "set_model_state"
    SPAWN_URDF_MODEL = "spawn_urdf_model"
    SPAWN_SDF_MODEL = "spawn_sdf_model"
    DELETE_MODEL = "delete_model"
    RESET_WORLD = "reset_world"
    PAUSE_PHYSICS = "pause_physics"
    UNPAUSE_PHYSICS = "unpause_physics"
    SET_PHYSICS_PROPERTIES = "set_physics_properties"


DIRECTOR = "scenario"  # the node that does what the scenario wants done
PUSH = InterventionKind.SET_MODEL_STATE  # how it pushes a box


@dataclasses.dataclass(frozen=True)
class Permission:
    """What one node may do."""

    node: str = key("Node that may, as in `robot1/planner`.")
    kinds: tuple[InterventionKind, ...] = key("What it may do, by the names of gazebo_ros's services.")

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        return None if self.kinds else ("kinds", "is empty; leave the permission out")

    def allows(self, caller: str, kind: str) -> bool:
        """Whether a node may do something; `caller` with a leading slash, as ROS names it."""
        return caller.strip("/") == self.node.strip("/") and kind in {each.value for each in self.kinds}
