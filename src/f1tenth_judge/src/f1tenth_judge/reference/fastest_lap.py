"""The lap to compare with: the minimum-curvature line and the fastest speed along it.

By trajectory-planning-helpers of the Technical University of Munich; see Heilmeier et al., "Minimum curvature
trajectory planning and control for an autonomous race car", Vehicle System Dynamics 58 (2020).
"""

import dataclasses
from pathlib import Path

import numpy as np

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.reference.car_limits import GRAVITY, Limits
from f1tenth_judge.reference.track import resampled

try:
    import trajectory_planning_helpers as tph
except ImportError:  # races go without it
    tph = None

_LINE_SPACING = 0.05  # m, between points of the race line
_ROUNDS = 5  # each takes the line before as its reference, because curvature is linearised around that
_FRICTION_ELLIPSE = 2.0  # exponent of calc_vel_profile: (ax / ax_max)^2 + (ay / ay_max)^2 <= 1
_RACELINE_HEADER = """# {time:.3f} s per lap
# {limits}
# s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2
"""


@dataclasses.dataclass(frozen=True)
class FastestLap:
    """A closed lap; arrays of equal length, a point every few centimetres, the first one not repeated."""

    s: np.ndarray  # m along the line
    x: np.ndarray  # m
    y: np.ndarray  # m
    yaw: np.ndarray  # rad, 0 along x
    curvature: np.ndarray  # 1/m, positive to the left
    speed: np.ndarray  # m/s
    acceleration: np.ndarray  # m/s^2, along the line
    lap_time: float  # s


def compute_fastest_lap(track: np.ndarray, limits: Limits) -> FastestLap:
    """The minimum-curvature lap on a track of load_track.

    Raises:
        ScenarioError: the road is too narrow for the car and its clearance, or the package is not installed.
    """
    if tph is None:
        raise ScenarioError(
            "the fastest lap needs the Python package trajectory-planning-helpers (make setup installs it)"
        )
    track = np.array(track, dtype=float)
    for _ in range(_ROUNDS - 1):
        track = _shifted(track, limits)
    _, _, matrix, normals = _splines(track)
    shift = _optimal_shift(track, limits, matrix, normals)
    line, _, coeffs_x, coeffs_y, splines, parts, s, _, steps = tph.create_raceline.create_raceline(
        refline=track[:, :2], normvectors=normals, alpha=shift, stepsize_interp=_LINE_SPACING
    )
    yaw, curvature = tph.calc_head_curv_an.calc_head_curv_an(coeffs_x, coeffs_y, splines, parts)
    speed, acceleration, lap_time = _driven(curvature, steps, limits)
    x, y = line.T
    return FastestLap(s, x, y, yaw + np.pi / 2, curvature, speed, acceleration, lap_time)


def _driven(curvature, steps, limits):
    """Speed, acceleration, and time of a lap."""
    speed = _speed(curvature, steps, limits)
    acceleration = tph.calc_ax_profile.calc_ax_profile(np.append(speed, speed[0]), steps)
    times = tph.calc_t_profile.calc_t_profile(speed, steps, ax_profile=acceleration)
    return speed, acceleration, float(times[-1])


def _splines(track):
    return tph.calc_splines.calc_splines(np.vstack([track[:, :2], track[:1, :2]]))


def _optimal_shift(track, limits, matrix, normals):
    try:
        shift, _ = tph.opt_min_curv.opt_min_curv(
            reftrack=track,
            normvectors=normals,
            A=matrix,
            kappa_bound=limits.max_curvature,
            w_veh=limits.width + 2 * limits.clearance,
        )
    except (RuntimeError, ValueError) as error:
        raise ScenarioError(
            f"no line keeps {limits.clearance:g} m beside a car of {limits.width:g} m: {error}"
        ) from error
    return shift


def _shifted(track, limits):
    """The track around its own race line."""
    _, _, matrix, normals = _splines(track)
    shift = _optimal_shift(track, limits, matrix, normals)
    line = track[:, :2] + shift[:, None] * normals
    return resampled(np.column_stack([line, track[:, 2] - shift, track[:, 3] + shift]))


def _speed(curvature, steps, limits):
    speeds = np.linspace(0.0, limits.max_speed, 41)
    grip = limits.friction * GRAVITY
    traction = np.minimum(limits.max_acceleration, grip)
    ggv = np.column_stack([speeds, np.full_like(speeds, traction), np.full_like(speeds, grip)])
    with np.errstate(divide="ignore"):
        motor = limits.max_acceleration * np.minimum(1.0, limits.switch_speed / speeds)
    return tph.calc_vel_profile.calc_vel_profile(
        ax_max_machines=np.column_stack([speeds, motor]),
        kappa=curvature,
        el_lengths=steps,
        closed=True,
        drag_coeff=0.0,
        m_veh=limits.mass,
        ggv=ggv,
        v_max=limits.max_speed,
        dyn_model_exp=_FRICTION_ELLIPSE,
    )


def write_raceline(path: Path, lap: FastestLap, limits: Limits) -> None:
    """Write `X_raceline.csv` as the F1TENTH community reads it."""
    columns = [getattr(lap, name) for name in ("s", "x", "y", "yaw", "curvature", "speed", "acceleration")]
    with writing(path), replacing(path) as temporary, open(temporary, "w", encoding="utf-8") as stream:
        stream.write(_RACELINE_HEADER.format(time=lap.lap_time, limits=limits.describe()))
        np.savetxt(stream, np.column_stack(columns), fmt="%.7f", delimiter=";")
