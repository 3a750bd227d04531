"""What a scan costs."""

import numpy as np

import f1tenth_sim2d
from f1tenth_bench.simulator.cars import bare_lidar
from f1tenth_bench.timing import processor_seconds

REPEATS = 5


class Scanner:
    """A lidar without a car, which can be put anywhere in a world."""

    def __init__(self, world, lidar):
        """Take a World and a Lidar."""
        self._simulation = f1tenth_sim2d.Simulation(world)
        self._simulation.add_car(bare_lidar(lidar))
        self.ranges = np.empty(lidar.beams, np.float32)

    def scan(self, pose):
        """Write the exact scan from pose (x, y, yaw), m and rad, into ranges."""
        self._simulation.place_car(0, *pose)
        self._simulation.scan(0, 0, self.ranges, True)

    def microseconds(self, poses):
        """Processor time of a scan, us, mean over the poses; putting the lidar there does not count."""
        rows = [tuple(map(float, pose)) for pose in poses]

        def place_all():
            for row in rows:
                self._simulation.place_car(0, *row)

        def scan_all():
            for row in rows:
                self.scan(row)

        placing = processor_seconds(place_all, REPEATS)
        return (processor_seconds(scan_all, REPEATS) - placing) / len(rows) * 1e6
