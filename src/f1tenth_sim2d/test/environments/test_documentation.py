"""The blocks of the pages for those who use it without ROS run as they stand."""

import re
from pathlib import Path

import pytest

DOCUMENTS = Path(__file__).parents[4] / "docs"
PAGES = [DOCUMENTS / name for name in ("gym.md", "cameras.md", "coming_from_f1tenth_gym.md", "start.md")]
BLOCKS = [
    block
    for page in PAGES
    for block in re.findall(
        r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
]


def test_there_are_blocks():
    assert len(BLOCKS) >= 5


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block.splitlines()[0])
def test_it_runs(block, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "a page", "exec"), {})


def test_every_setting_is_described():
    import dataclasses

    from f1tenth_sim2d.environments.settings import Settings

    text = (DOCUMENTS / "gym.md").read_text(encoding="utf-8")
    assert [each.name for each in dataclasses.fields(Settings) if f"`{each.name}`" not in text] == []
