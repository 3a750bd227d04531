"""The picture of a sweep: success rate and lap time over each varied value."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from f1tenth_judge.atomic import replacing
from f1tenth_judge.results.intervals import Rate, mean_of
from f1tenth_judge.scenario.settings import unit_of

_MOST_TICKS = 8


def write_picture(path: Path, title: str, rows: Sequence[Mapping[str, Any]], varied: Sequence[str]) -> None:
    """Draw success rate and lap time over each varied key, into a PNG file."""
    figure = make_figure(title, rows, varied)
    with replacing(path) as temporary:
        figure.savefig(temporary, dpi=130)


def make_figure(title: str, rows: Sequence[Mapping[str, Any]], varied: Sequence[str]) -> Figure:
    """The drawing; arguments as of write_picture."""
    figure = Figure(figsize=(4.6 * len(varied) + 1.2, 6.4), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(2, len(varied), squeeze=False, sharex="col", sharey="row")
    for column, key in enumerate(varied):
        groups = _grouped(rows, key)
        _draw_rates(axes[0][column], groups)
        _draw_laps(axes[1][column], groups)
        axes[1][column].set_xlabel(f"{key} ({unit_of(key)})" if unit_of(key) else key)
    axes[0][0].set_ylabel("success rate")
    axes[1][0].set_ylabel("lap time (s)")
    figure.suptitle(f"{title}: {len(rows)} runs, with 95 % confidence", x=0.01, ha="left", fontweight="bold")
    return figure


def _grouped(rows, key) -> dict[str, list]:
    groups: dict[str, list] = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return dict(sorted(groups.items(), key=lambda item: _number(item[0])))


def _number(text: str):
    """Numbers in their order, before all other texts."""
    try:
        return 0, float(text), ""
    except ValueError:
        return 1, 0.0, text


def _places(groups) -> tuple[dict[str, float], bool]:
    """Numbers at their value, other texts one after the other; and whether they are numbers."""
    numeric = all(_number(name)[0] == 0 for name in groups)
    return {name: float(name) if numeric else index for index, name in enumerate(groups)}, numeric


def _draw_rates(axes, groups):
    places, _ = _places(groups)
    for name, rows in groups.items():
        rate, low, high = Rate(sum(row["passed"] for row in rows), len(rows)).interval
        axes.plot([places[name]] * 2, [low, high], color="#9db2f5", linewidth=5, solid_capstyle="round")
        axes.plot(places[name], rate, "o", color="#2f5bea")
    axes.set_ylim(-0.04, 1.04)
    _decorate(axes)


def _draw_laps(axes, groups):
    places, numeric = _places(groups)
    for name, rows in groups.items():
        laps = [row["lap_time"] for row in rows if row["lap_time"] is not None]
        if laps:
            mean, low, high = mean_of(laps)
            axes.plot([places[name]] * 2, [low, high], color="#9fd9c3", linewidth=5, solid_capstyle="round")
            axes.plot(places[name], mean, "o", color="#12805c")
    _set_ticks(axes, places, numeric)
    _decorate(axes)


def _set_ticks(axes, places: Mapping[str, float], numeric: bool) -> None:
    """At the values that there were; where these are many, at round ones."""
    if not numeric:
        axes.set_xticks(list(places.values()), list(places), rotation=30, ha="right")
    elif len(places) <= _MOST_TICKS:
        axes.set_xticks(list(places.values()), list(places))
    else:
        whole = all(value.is_integer() for value in places.values())
        axes.xaxis.set_major_locator(MaxNLocator(_MOST_TICKS, integer=whole))


def _decorate(axes):
    axes.grid(color="black", alpha=0.08, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
