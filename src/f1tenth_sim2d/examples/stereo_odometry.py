"""Visual odometry by the stereo camera of the car: a small one, on OpenCV (python3-opencv).

python3 stereo_odometry.py [PLACE] follows the centreline of a place for a lap, and prints the drift.
"""

import sys

import cv2
import numpy as np
from f1tenth_sim2d.environments.car import Lidar, load_cars
from f1tenth_sim2d.environments.place import find_place

import f1tenth_sim2d

CAMERA = "stereo_camera"
STEP = 0.1  # m, between two pictures: 30 Hz at 3 m/s
NEAREST, FARTHEST = 0.4, 8.0  # m, of points that are used: the car sees itself, too
FEATURES = 800


class StereoOdometry:
    """Adds up how the camera has moved from one pair of pictures to the next."""

    def __init__(self, left, right):
        """`left` and `right` are eyes of a camera, see Car.cameras."""
        self._focal, self._middle = left.focal_x, (left.middle_x, left.middle_y)
        self._baseline = left.pose[1] - right.pose[1]
        self._matrix = np.array(
            [[left.focal_x, 0, left.middle_x], [0, left.focal_y, left.middle_y], [0, 0, 1]], float
        )
        self._last = None
        self.pose = np.eye(4)  # of the left eye where it began: z ahead, x to the right

    def take(self, left, right):
        """A pair of pictures, red, green and blue."""
        left, right = (cv2.cvtColor(each, cv2.COLOR_RGB2GRAY) for each in (left, right))
        if self._last is not None:
            pixels, points = self._last
            seen, is_seen = tracked(self._left, left, pixels)
            _, turn, shift, _ = cv2.solvePnPRansac(
                points[is_seen], seen[is_seen], self._matrix, None, reprojectionError=0.7, iterationsCount=200
            )
            change = np.eye(4)
            change[:3, :3], change[:3, 3] = cv2.Rodrigues(turn)[0], shift.ravel()
            self.pose = self.pose @ np.linalg.inv(change)
        self._left, self._last = left, self._points(left, right)

    def _points(self, left, right):
        """Pixels of the left picture, and where in space they are."""
        pixels = cv2.goodFeaturesToTrack(left, FEATURES, 0.001, 6).reshape(-1, 2)
        there, is_there = tracked(left, right, pixels)
        with np.errstate(divide="ignore"):
            depth = self._focal * self._baseline / (pixels - there)[:, 0]
        is_there &= (np.abs(pixels - there)[:, 1] < 0.5) & (depth > NEAREST) & (depth < FARTHEST)
        pixels, depth = pixels[is_there], depth[is_there, None]
        return pixels, np.hstack([(pixels - self._middle) * depth / self._focal, depth])


def tracked(before, after, pixels):
    """Where pixels of a picture are in another, and whether the way back leads to them."""
    options = {"winSize": (15, 15), "criteria": (3, 30, 0.003)}
    there, is_found, _ = cv2.calcOpticalFlowPyrLK(before, after, pixels, None, **options)
    back, is_back, _ = cv2.calcOpticalFlowPyrLK(after, before, there, None, **options)
    is_same = np.hypot(*(back - pixels).T) < 0.2
    return there, is_found.ravel().astype(bool) & is_back.ravel().astype(bool) & is_same


def lap_of(line):
    """Poses (x, y, yaw) along a closed line, STEP apart."""
    ends = np.vstack([line, line[:1]])
    way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(ends, axis=0).T))])
    at = np.arange(0.0, way[-1], STEP)
    x, y = (np.interp(at, way, ends[:, i]) for i in (0, 1))
    ahead = [np.interp((at + 0.3) % way[-1], way, ends[:, i]) for i in (0, 1)]
    return np.column_stack([x, y, np.arctan2(ahead[1] - y, ahead[0] - x)])


def drive(name, most=np.inf):
    """Follow the centreline of a place, at most so far (m).

    Returns:
        How far the car has come, and how far from there the odometry says that it is, m.
    """
    place = find_place(name)
    (car,) = load_cars(["robot1"], Lidar(2, 1.0, 1.0))
    left, right = car.cameras[CAMERA]
    simulation = f1tenth_sim2d.Simulation(place.world)
    poses = lap_of(place.centreline[:, :2])[: int(min(most, 1e6) / STEP)]
    simulation.add_car(car, None, *poses[0])
    odometry = StereoOdometry(left, right)
    for pose in poses:
        simulation.place_car(0, *map(float, pose))
        odometry.take(*(simulation.look(0, CAMERA, eye.name)[0] for eye in (left, right)))
    begin, end = (place_of(left, pose) for pose in (poses[0], poses[-1]))
    yaw, (ahead, to_right) = poses[0][2], odometry.pose[[2, 0], 3]
    found = begin + along(yaw, ahead, -to_right)
    return STEP * (len(poses) - 1), float(np.hypot(*(found - end)))


def place_of(eye, pose):
    """(x, y) of an eye of a car."""
    return pose[:2] + along(pose[2], *eye.pose[:2])


def along(yaw, ahead, left):
    """A vector in the world."""
    return np.array([np.cos(yaw) * ahead - np.sin(yaw) * left, np.sin(yaw) * ahead + np.cos(yaw) * left])


def main():
    """Print the drift after a lap."""
    way, drift = drive((sys.argv[1:] or ["circuit_detailed"])[0])
    print(f"{way:.1f} m, drift {drift:.3f} m, {100 * drift / way:.2f} % of the way")


if __name__ == "__main__":
    main()
