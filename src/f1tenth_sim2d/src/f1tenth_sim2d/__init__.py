"""A fast and deterministic 2.5-D simulator of F1/10 cars. SI units; x forward, y left, yaw in rad."""

from f1tenth_sim2d._f1tenth_sim2d import *  # noqa: F403
from f1tenth_sim2d.environments import parallel_env  # noqa: F401
