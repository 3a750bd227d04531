"""Contacts are counted once and given to the car that caused them."""

from f1tenth_judge.judge.contacts import find_contacts
from f1tenth_judge.record.row import COLUMNS
from scenario_samples import record, rows


def pair(folder, hunter_speed=2.0, hunted_speed=0.5):
    """robot1 drives into robot2 from behind."""
    touch = {1.0: "robot2", 1.025: "robot2"}
    relative = abs(hunter_speed - hunted_speed)
    hunter = rows(2.0, speed=hunter_speed, contacts=touch, contact_speed=relative)
    theirs = dict.fromkeys(touch, "robot1")
    hunted = [
        [row[0], row[1], float(row[2]) + 3.0, *row[3:]]
        for row in rows(2.0, "robot2", hunted_speed, theirs, contact_speed=relative)
    ]
    return record(folder, hunter, hunted)


def test_contact_of_two_cars_is_one_and_belongs_to_who_drove_into_the_other(tmp_path):
    (contact,) = find_contacts(pair(tmp_path))
    assert (contact.car, contact.touched, contact.start, contact.end) == ("robot1", ("robot2",), 1.0, 1.025)
    assert contact.speed == 1.5


def test_car_that_is_backed_into_is_not_to_blame(tmp_path):
    (contact,) = find_contacts(pair(tmp_path, hunter_speed=0.2, hunted_speed=-1.0))
    assert (contact.car, contact.speed) == ("robot2", 1.2)


def test_contacts_with_things_are_in_the_order_of_time(tmp_path):
    one = rows(2.0, contacts={1.5: "Wall_1", 0.5: "box"})
    two = rows(2.0, car="robot2", contacts={1.0: "Wall_1"})
    found = find_contacts(record(tmp_path, one, two))
    assert [(each.car, each.touched[0], each.start) for each in found] == [
        ("robot1", "box", 0.5), ("robot2", "Wall_1", 1.0), ("robot1", "Wall_1", 1.5),
    ]  # fmt: skip


def test_car_that_is_pushed_into_a_wall_reports_both(tmp_path):
    found = find_contacts(
        record(tmp_path, rows(2.0, contacts={1.0: "Wall_1;robot2"}), rows(2.0, car="robot2"))
    )
    assert [each.touched for each in found] == [("Wall_1", "robot2")]


def test_contact_is_as_hard_as_its_hardest_moment_whoever_moved(tmp_path):
    standing = [*rows(2.0, speed=0.0, contacts={1.0: "box", 1.025: "box"}, contact_speed=0.2)]
    standing[40][COLUMNS.index("contact_speed")] = 5.8
    (contact,) = find_contacts(record(tmp_path, standing))
    assert (contact.start, contact.speed) == (1.0, 5.8)
