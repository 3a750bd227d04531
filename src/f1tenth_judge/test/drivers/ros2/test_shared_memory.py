"""Which files of Fast DDS are removed."""

import fcntl
import os

from f1tenth_judge.drivers.ros2.shared_memory import remove_what_is_left

NAMES = ("fastrtps_1a9b", "fastrtps_1a9b_el", "fastrtps_port7661", "fastrtps_port7661_el")
SEMAPHORE = "sem.fastrtps_port7661_mutex"


def files(folder):
    return sorted(each.name for each in folder.iterdir())


def test_what_nobody_holds_is_removed_and_no_others(tmp_path):
    for name in (*NAMES, SEMAPHORE, "fastrtps_2c3d", "fastrtps_2c3d_sl", "sem.mine"):
        (tmp_path / name).touch()
    with (tmp_path / "fastrtps_2c3d_sl").open() as held:
        fcntl.flock(held, fcntl.LOCK_SH)
        remove_what_is_left(0.0, tmp_path)
        assert files(tmp_path) == ["fastrtps_2c3d", "fastrtps_2c3d_sl", "sem.mine"]
    remove_what_is_left(0.0, tmp_path)
    assert files(tmp_path) == ["sem.mine"]


def test_what_was_there_before_is_left(tmp_path):
    for name in NAMES:
        (tmp_path / name).touch()
        os.utime(tmp_path / name, (1000.0, 1000.0))
    remove_what_is_left(1001.0, tmp_path)
    assert files(tmp_path) == sorted(NAMES)
