"""What the cameras of a car see, on the topics of ROS 2; nothing is drawn while nobody hears."""

import math

import numpy as np

from f1tenth_judge.drivers.ros2.connection import Connection
from f1tenth_judge.drivers.ros2.messages.basic import Header, Time
from f1tenth_judge.drivers.ros2.messages.geometry import Quaternion, Transform, TransformStamped, Vector3
from f1tenth_judge.drivers.ros2.messages.sensing import CameraInfo, Image
from f1tenth_judge.drivers.ros2.quality import OFFERED, is_reliable
from f1tenth_judge.drivers.ros2.topics import EGO, base_frame
from f1tenth_judge.planner import Eye
from f1tenth_judge.run.stage import Stage

_PERIODS = 2  # per picture: 20 Hz
_COLOUR, _DEPTH, _INFO = "image_raw", "depth/image_raw", "camera_info"


class Cameras:
    """Of one car."""

    def __init__(self, connection: Connection, stage: Stage, car: str):
        """Offer the topics of all eyes."""
        self._connection, self._stage, self._car = connection, stage, car
        eyes = stage.eyes(car)
        cameras = [eye.camera for eye in eyes]
        self._eyes = {_name(eye, cameras.count(eye.camera)): eye for eye in eyes}
        self._leftmost = {eye.camera: eye for eye in reversed(eyes)}
        self._periods = 0
        self._has_looked = False
        for name in self._eyes:
            for topic, kind in ((_COLOUR, Image), (_DEPTH, Image), (_INFO, CameraInfo)):
                connection.offer(f"{name}/{topic}", kind, OFFERED)

    def transforms(self) -> list[TransformStamped]:
        """Where the eyes are, for /tf_static: z ahead, as cameras have it."""
        return [
            TransformStamped(Header(frame_id=base_frame(EGO)), _frame(name), _pose(eye))
            for name, eye in self._eyes.items()
        ]

    def publish(self) -> bool:
        """Publish what is seen now, if it is time for a picture; whether something was sent."""
        self._periods += 1
        if self._periods % _PERIODS:
            return False
        stamp = Time.of(self._stage.time)
        sent = [self._publish(name, eye, Header(stamp, _frame(name))) for name, eye in self._eyes.items()]
        return any(sent)

    def note(self) -> list[str]:
        """What is not in the pictures, and which may be lost, in words."""
        pictures = {f"{name}/{topic}" for name in self._eyes for topic in (_COLOUR, _DEPTH)}
        found = [
            f"{end.topic} is heard best effort: on a busy machine, pictures are lost; request it reliable"
            for end in self._connection.subscribed()
            if end.topic in pictures and not is_reliable(end.qos)
        ]
        warning = self._stage.look_warning() if self._has_looked else ""
        return [*found, warning] if warning else found

    def _publish(self, name: str, eye: Eye, header: Header) -> bool:
        heard = {topic for topic in (_COLOUR, _DEPTH, _INFO) if self._connection.hearers(f"{name}/{topic}")}
        if _INFO in heard:
            self._connection.publish(f"{name}/{_INFO}", _info(header, eye, self._leftmost[eye.camera]))
        if heard - {_INFO}:
            self._has_looked = True
            colour, depth = self._stage.look(self._car, eye)
            for topic, encoding, pixels in ((_COLOUR, "rgb8", colour), (_DEPTH, "32FC1", depth)):
                if topic in heard:
                    self._connection.publish_whole(f"{name}/{topic}", _image(header, encoding, pixels))
        return bool(heard)


def _name(eye: Eye, eyes: int) -> str:
    """In front of its topics: of the camera, and of the eye if the camera has several."""
    return f"/{eye.camera}/{eye.name}" if eyes > 1 else f"/{eye.camera}"


def _frame(name: str) -> str:
    return f"{EGO}{name}"


def _pose(eye: Eye) -> Transform:
    x, y, z, yaw = eye.pose
    sine, cosine = math.sin(yaw / 2) / 2, math.cos(yaw / 2) / 2
    ahead = Quaternion(-cosine - sine, cosine - sine, sine - cosine, cosine + sine)
    return Transform(Vector3(x, y, z), ahead)


def _image(header: Header, encoding: str, pixels: np.ndarray) -> Image:
    height, width = pixels.shape[:2]
    return Image(header, height, width, encoding, step=pixels.strides[0], data=pixels.tobytes())


def _info(header: Header, eye: Eye, leftmost: Eye) -> CameraInfo:
    baseline = leftmost.pose[1] - eye.pose[1]  # m, between eyes that look ahead
    x, y = [eye.focal_x, 0.0, eye.middle_x], [0.0, eye.focal_y, eye.middle_y]
    return CameraInfo(
        header,
        eye.height,
        eye.width,
        "plumb_bob",
        d=[0.0] * 5,
        k=[*x, *y, 0.0, 0.0, 1.0],
        r=[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        p=[*x, -eye.focal_x * baseline, *y, 0.0, 0.0, 0.0, 1.0, 0.0],
    )
