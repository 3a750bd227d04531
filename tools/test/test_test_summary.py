import subprocess
from pathlib import Path

TOOL = Path(__file__).resolve().parents[1] / "test_summary"

SUITE = """<testsuites><testsuite name="s">
<testcase classname="a" name="good"/>
<testcase classname="a" name="bad"><failure message="1 is not 2">trace</failure></testcase>
<testcase classname="a" name="broken"><error>no such file
more</error></testcase>
<testcase classname="a" name="left_out"><skipped message="no data"/></testcase>
<testcase classname="g" name="disabled" status="notrun"/>
</testsuite></testsuites>"""


def run(folder):
    return subprocess.run([TOOL, folder], capture_output=True, text=True, check=False)


def test_counts_every_outcome_and_names_what_did_not_pass(tmp_path):
    (tmp_path / "pkg").mkdir()
    (tmp_path / "pkg" / "suite.xml").write_text(SUITE)
    result = run(tmp_path)
    assert result.returncode == 1
    lines = result.stdout.splitlines()
    assert lines[-1] == "1 passed, 2 failed, 2 skipped"
    assert "failed: pkg: a.bad: 1 is not 2" in lines
    assert "failed: pkg: a.broken: no such file" in lines
    assert "skipped: pkg: a.left_out: no data" in lines


def test_all_passed_exits_with_zero(tmp_path):
    (tmp_path / "suite.xml").write_text('<testsuite><testcase name="good"/></testsuite>')
    result = run(tmp_path)
    assert result.returncode == 0
    assert result.stdout == "1 passed, 0 failed, 0 skipped\n"


def test_a_file_that_was_cut_off_counts_as_failed(tmp_path):
    (tmp_path / "suite.xml").write_text('<testsuite><testcase name="good"/>')
    result = run(tmp_path)
    assert result.returncode == 1
    assert result.stdout.splitlines()[-1] == "0 passed, 1 failed, 0 skipped"


def test_no_test_at_all_is_a_failure(tmp_path):
    result = run(tmp_path)
    assert result.returncode == 1
    assert result.stdout == "0 passed, 0 failed, 0 skipped\n"
