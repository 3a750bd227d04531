from f1tenth_gazebo_plugins.collision_monitor import SECOND, CollisionMonitor, Report

MS = SECOND // 1000
WALL = ("robot1::base_footprint::bumper_front_collision", "walls::Wall_0::Wall_0_Collision")
GROUND = ("ground_plane::link::collision", "robot1::base_footprint::bumper_front_collision")


def monitor():
    result = CollisionMonitor(["front", "rear"], ["ground_plane"])
    result.hear("rear", 1 * MS)
    return result


def test_first_word_reports_both():
    assert CollisionMonitor(["front"]).hear("front", 20 * MS) == Report(collision=False, collisions=0)


def test_contact_is_reported_at_once():
    assert monitor().hear("front", 20 * MS, [WALL]) == Report(collision=True, collisions=1)


def test_end_of_contact_is_reported_at_once():
    watched = monitor()
    watched.hear("front", 20 * MS, [WALL])
    assert watched.hear("front", 40 * MS) == Report(collision=False)


def test_one_sensor_that_touches_is_enough():
    watched = monitor()
    watched.hear("front", 20 * MS, [WALL])
    assert watched.hear("rear", 21 * MS) == Report()


def test_second_sensor_does_not_count_twice():
    watched = monitor()
    watched.hear("front", 20 * MS, [WALL])
    assert watched.hear("rear", 20 * MS, [WALL]) == Report()
    watched.hear("front", 40 * MS)
    watched.hear("rear", 40 * MS)
    assert watched.hear("rear", 60 * MS, [WALL]) == Report(collision=True, collisions=2)


def test_ground_does_not_count_whichever_name_comes_first():
    watched = monitor()
    assert watched.hear("front", 20 * MS, [GROUND, GROUND[::-1]]) == Report()
    assert watched.hear("front", 40 * MS, [GROUND, WALL]).collision is True


def test_state_is_reported_at_10_hz():
    watched = monitor()
    reports = [watched.hear("front", stamp * MS) for stamp in range(20, 1001, 20)]
    assert [report.collision for report in reports].count(False) == 10


def test_passing_time_alone_reports_at_10_hz():
    watched = monitor()
    reports = [watched.tick(stamp * MS) for stamp in range(120, 1101, 20)]
    assert [report.collision for report in reports].count(False) == 10


def test_clock_leaves_reporting_to_sensors_that_speak():
    watched = monitor()
    watched.hear("front", 500 * MS)
    assert watched.tick(400 * MS) == Report()
    assert watched.tick(650 * MS) == Report()
    assert watched.hear("front", 600 * MS) == Report(collision=False)


def test_sensor_that_never_spoke_is_silent():
    assert monitor().silent_sensors() == {"front": None}


def test_sensor_is_silent_after_more_than_a_second():
    watched = monitor()
    watched.hear("front", 500 * MS)
    watched.tick(1001 * MS)
    assert watched.silent_sensors() == {}
    watched.tick(1002 * MS)
    assert watched.silent_sensors() == {"rear": 1001 * MS}


def test_stamp_that_goes_back_begins_a_new_run():
    watched = monitor()
    watched.hear("front", 500 * MS, [WALL])
    assert watched.hear("front", 20 * MS) == Report(collision=False, collisions=0)
    assert watched.silent_sensors() == {"rear": None}


def test_old_clock_that_is_read_once_more_does_not_disturb_a_new_run():
    watched = monitor()
    watched.hear("rear", 5 * SECOND)
    watched.tick(5 * SECOND)
    watched.hear("rear", 20 * MS)
    assert watched.tick(5 * SECOND) == Report()
    assert watched.silent_sensors() == {"front": None}
    assert watched.hear("rear", 100 * MS) == Report(collision=False)
    watched.tick(125 * MS)
    watched.tick(2 * SECOND)
    assert watched.silent_sensors() == {"front": None, "rear": 1900 * MS}


def test_clock_is_believed_again_when_the_sensors_have_come_as_far_as_the_old_run():
    watched = monitor()
    watched.tick(5 * SECOND)
    watched.hear("rear", 0)
    watched.hear("rear", 5 * SECOND)
    assert watched.tick(6 * SECOND) == Report(collision=False)


def test_without_any_sensor_time_alone_reports_at_10_hz():
    watched = CollisionMonitor(["front"])
    assert watched.tick(20 * MS) == Report(collision=False, collisions=0)
    reports = [watched.tick(stamp * MS) for stamp in range(40, 1021, 20)]
    assert [report.collision for report in reports].count(False) == 10


def test_contact_in_the_first_word_counts():
    assert CollisionMonitor(["front"]).hear("front", 20 * MS, [WALL]) == Report(collision=True, collisions=1)


def test_word_at_the_very_beginning_is_the_first_report():
    watched = CollisionMonitor(["front"])
    watched.hear("front", 0)
    assert watched.hear("front", 20 * MS) == Report()


def test_word_that_is_repeated_is_no_new_run():
    watched = monitor()
    watched.hear("front", 20 * MS, [WALL])
    assert watched.hear("front", 20 * MS, [WALL]) == Report()
    assert watched.hear("front", 40 * MS) == Report(collision=False)
    assert watched.hear("front", 60 * MS, [WALL]) == Report(collision=True, collisions=2)
