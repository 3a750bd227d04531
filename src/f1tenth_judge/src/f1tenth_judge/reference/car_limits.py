"""What the car can do."""

import dataclasses
import math

import f1tenth_sim2d

CAR_WIDTH = 0.31  # m, of f1tenth_description
GRAVITY = 9.81  # m/s^2, with which the tyre parameters were identified
CLEARANCE = 0.05  # m beside the car, the least that a race lap may leave


@dataclasses.dataclass(frozen=True)
class Limits:
    """Limits of a lap."""

    friction: float
    max_acceleration: float  # m/s^2, of motor and brakes
    switch_speed: float  # m/s, above it the motor's acceleration falls with 1/v
    max_speed: float  # m/s
    max_curvature: float  # 1/m, at the steering limit
    mass: float  # kg
    width: float = CAR_WIDTH  # m
    clearance: float = CLEARANCE  # m, to each side

    def describe(self) -> str:
        """The limits in a line."""
        return (
            f"friction {self.friction:g}, acceleration {self.max_acceleration:g} m/s^2,"
            f" speed {self.max_speed:g} m/s, curvature {self.max_curvature:.3f} 1/m,"
            f" car {self.width:g} m wide with {self.clearance:g} m to each side"
        )


def read_limits(clearance: float = CLEARANCE) -> Limits:
    """The limits of the simulator's car."""
    car = f1tenth_sim2d.VehicleParameters()
    return Limits(
        friction=car.mu,
        max_acceleration=car.a_max,
        switch_speed=car.v_switch,
        max_speed=car.v_max,
        max_curvature=math.tan(car.steering_max) / (car.l_f + car.l_r),
        mass=car.m,
        clearance=clearance,
    )
