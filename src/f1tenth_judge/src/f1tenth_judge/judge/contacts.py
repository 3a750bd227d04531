"""Who touched what, and how hard: each contact once, also when two cars report it."""

import dataclasses

import numpy as np

from f1tenth_judge.record.record import CarTrack, Contact, Record


def find_contacts(record: Record) -> list[Contact]:
    """All contacts in the order of time.

    Between two cars, `car` is the one that drove into the other.
    """
    found = [contact for track in record.tracks.values() for contact in track.contact_list()]
    once = [each for each in found if not _is_told_better(record, each, found)]
    return sorted(once, key=lambda each: (each.start, each.car))


def _is_told_better(record: Record, contact: Contact, all_contacts: list[Contact]) -> bool:
    """Whether the other car's report of the same contact is the one to keep."""
    if len(contact.touched) != 1 or contact.touched[0] not in record.tracks:
        return False
    other = contact.touched[0]
    return any(
        each.car == other and each.touched == (contact.car,) and each.start == contact.start
        for each in all_contacts
    ) and _approach(record, contact) < _approach(
        record, dataclasses.replace(contact, car=other, touched=(contact.car,))
    )


def _approach(record: Record, contact: Contact) -> tuple[float, str]:
    """How fast the car came towards the other, m/s; its name decides between equals."""
    own, other = record.tracks[contact.car], record.tracks[contact.touched[0]]
    between = _place(other, contact) - _place(own, contact)
    return float(_velocity(own, contact) @ between) / max(float(np.linalg.norm(between)), 1e-9), contact.car


def _before(track: CarTrack, contact: Contact) -> int:
    """The period before the contact."""
    return max(int(np.searchsorted(track.time, contact.start)) - 1, 0)


def _place(track, contact):
    index = _before(track, contact)
    return np.array([track.x[index], track.y[index]])


def _velocity(track, contact):
    """In the map frame, m/s."""
    index = _before(track, contact)
    cosine, sine = np.cos(track.yaw[index]), np.sin(track.yaw[index])
    v_x, v_y = track.v_x[index], track.v_y[index]
    return np.array([cosine * v_x - sine * v_y, sine * v_x + cosine * v_y])
