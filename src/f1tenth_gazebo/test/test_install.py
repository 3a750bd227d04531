"""Everything that is shipped must be installed and complete."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent
MODELS = sorted(path.parent for path in (PACKAGE / "models").glob("*/model.config"))
NOT_INSTALLED = {"docs", "scripts", "src", "test"}


def test_every_folder_is_installed():
    cmake = (PACKAGE / "CMakeLists.txt").read_text()
    installed = cmake[cmake.index("install(DIRECTORY ") :].split("DESTINATION")[0].split()
    folders = {path.name for path in PACKAGE.iterdir() if path.is_dir() and not path.name.startswith(".")}
    assert folders - NOT_INSTALLED <= set(installed)


def test_every_script_is_installed():
    cmake = (PACKAGE / "CMakeLists.txt").read_text()
    assert all(f"scripts/{path.name}" in cmake for path in (PACKAGE / "scripts").iterdir() if not path.suffix)


@pytest.mark.parametrize("world", sorted((PACKAGE / "worlds").glob("*.world")), ids=lambda path: path.name)
def test_every_world_has_its_circuit_map_goals_and_centreline(world):
    files = ("circuits/{}.yaml", "maps/{}.pgm", "goals/{}.txt", "worlds/{}_centerline.csv")
    for file in (each.format(world.stem) for each in files):
        assert (PACKAGE / file).is_file()
    assert f"image: {world.stem}.pgm\n" in (PACKAGE / f"maps/{world.stem}.yaml").read_text()


@pytest.mark.parametrize("model", MODELS, ids=lambda path: path.name)
def test_every_model_is_complete(model):
    config = ElementTree.parse(model / "model.config").getroot()
    assert config.findtext("description").strip()
    sdf = ElementTree.parse(model / config.findtext("sdf")).getroot()
    names = [element.get("name") for kind in ("model", "light") for element in sdf.findall(kind)]
    assert names == [model.name]


def test_every_folder_of_models_is_a_model():
    assert [path.name for path in MODELS] == sorted(path.name for path in (PACKAGE / "models").iterdir())
