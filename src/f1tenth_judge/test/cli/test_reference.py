"""The command `scenario reference`."""

import numpy as np
import pytest
from f1tenth_judge.reference import fastest_lap

from f1tenth_judge import cli


def test_a_centreline_is_read_and_its_race_line_written(tmp_path):
    pytest.importorskip("trajectory_planning_helpers")
    path = tmp_path / "ring_centerline.csv"
    angle = np.arange(120) * 2 * np.pi / 120
    ring = np.column_stack([5 * np.cos(angle), 5 * np.sin(angle), np.full((120, 2), 0.5)])
    np.savetxt(path, ring, delimiter=",", header="x_m, y_m, w_tr_right_m, w_tr_left_m")
    assert cli.main(["reference", str(path), "--output", str(tmp_path)]) == 0
    written = np.loadtxt(tmp_path / "ring_raceline.csv", delimiter=";")
    assert written.shape[1] == 7
    assert np.hypot(written[:, 1], written[:, 2]) == pytest.approx(4.705, abs=0.05)
    lines = (tmp_path / "ring_raceline.csv").read_text().splitlines()
    assert lines[2] == "# s_m; x_m; y_m; psi_rad; kappa_radpm; vx_mps; ax_mps2"


def test_a_missing_centreline_is_one_line_and_bad_input(capsys):
    assert cli.main(["reference", "/nowhere/x_centerline.csv"]) == 2
    error = capsys.readouterr().err
    assert error == "f1tenth: no such file: /nowhere/x_centerline.csv\n"


def test_a_missing_folder_for_race_lines_is_told_before_anything_is_computed(capsys, monkeypatch):
    monkeypatch.setattr(fastest_lap, "compute_fastest_lap", lambda *_: pytest.fail("was computed"))
    assert cli.main(["reference", "circuit1", "--output", "/nowhere"]) == 2
    assert capsys.readouterr().err == "f1tenth: --output: there is no folder /nowhere\n"
