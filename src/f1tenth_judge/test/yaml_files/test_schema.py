"""What a schema reads and refuses, of each type of key."""

import dataclasses
import enum
from typing import Optional

import pytest
from f1tenth_judge.errors import FileError
from f1tenth_judge.yaml_files import schema
from f1tenth_judge.yaml_files.schema import key
from f1tenth_judge.yaml_files.yaml_source import compose


class Colour(enum.Enum):
    RED = "red"
    DARK_BLUE = "dark blue"


@dataclasses.dataclass(frozen=True)
class Wheel:
    radius: float = key("How large.", unit="m", above=0)

    @staticmethod
    def short_forms():
        return {"small": Wheel(0.05), "large": Wheel(0.1)}


@dataclasses.dataclass(frozen=True)
class Model:
    open: bool = key("Whether it has no roof.", default=False)
    mass: Optional[float] = key("How heavy.", unit="kg", at_least=0, default=None)
    colour: Colour = key("Of the body.", default=Colour.RED)
    words: dict[str, str] = key("What else is known.", default={})
    wheel: Wheel = key("All of them.", default=Wheel(0.2))
    spare: Optional[Wheel] = key("One more.", default=None)


def read(folder, text):
    path = folder / "model.yaml"
    path.write_text(text, encoding="utf-8")
    return schema.read(Model, compose(path))


def test_what_is_not_given_has_its_default(tmp_path):
    assert read(tmp_path, "{}") == Model(False, None, Colour.RED, {}, Wheel(0.2), None)


@pytest.mark.parametrize(
    ("text", "model"),
    [
        ("open: true", Model(open=True)),
        *((f"mass: {text}", Model(mass=3.0)) for text in ("3", "3.0", "3.", "+3", "0.3e1", "3E0", "30e-1")),
        *((f"mass: {text}", Model(mass=0.5)) for text in (".5", "0.5", "5e-1")),
        ("colour: dark blue", Model(colour=Colour.DARK_BLUE)),
        ("words: {maker: us, 1: 2.50}", Model(words={"maker": "us", "1": "2.50"})),
        ("wheel: small", Model(wheel=Wheel(0.05))),
        ("wheel: {radius: 0.3}", Model(wheel=Wheel(0.3))),
        ("spare: large", Model(spare=Wheel(0.1))),
    ],
)
def test_reads(tmp_path, text, model):
    assert read(tmp_path, text) == model


def test_all_faults_of_a_file_are_told_at_once(tmp_path):
    text = (
        "open: 1\ncolour: blue\nwheel: {radius: 0, width: 1}\nspare: {}\nwords: {maker: [us], maker: x}\n"
        "mass: 1\nmass: 2\nname: x\n"
    )
    with pytest.raises(FileError) as error:
        read(tmp_path, text)
    file = tmp_path / "model.yaml"
    assert str(error.value).splitlines() == [
        f"{file}:1: open must be true or false, found '1'",
        f"{file}:2: colour is 'blue'; allowed: red, dark blue",
        f"{file}:3: wheel.radius is 0, must be above 0 m",
        f"{file}:3: unknown key 'width' in wheel; allowed: radius",
        f"{file}:4: missing key 'radius' in spare; allowed: radius",
        f"{file}:5: words.maker must be a single value, found a list",
        f"{file}:5: key 'maker' is given twice, first in line 5",
        f"{file}:7: key 'mass' is given twice, first in line 6",
        f"{file}:8: unknown key 'name'; allowed: open, mass, colour, words, wheel, spare",
    ]


@pytest.mark.parametrize("form", ["[", "{a: ", "- "])
def test_file_that_is_nested_too_deeply_is_refused(tmp_path, form):
    with pytest.raises(FileError) as error:
        read(tmp_path, f"words: {3000 * form}")
    said = str(error.value)
    assert said.startswith(f"{tmp_path / 'model.yaml'}:")
    assert "\n" not in said


def test_file_that_nobody_has_written_by_hand_is_refused_at_once(tmp_path):
    with pytest.raises(FileError, match="model.yaml: has 50.0 MB, must have at most 1.0$"):
        read(tmp_path, "a: b\n" * 10_000_000)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("open: 1", "open must be true or false, found '1'"),
        ("mass: heavy", "mass must be a number (kg), found 'heavy'"),
        ("mass: -1", "mass is -1, must be at least 0 kg"),
        *(
            (f"mass: {text}", f"mass must be a number (kg), found '{text}'")
            for text in ("010", "1_000", "1:30", "0x10", ".inf", ".", "3 kg", "e3")
        ),
        ("mass: '3'", "mass must be a number (kg), found '3'"),
        ("{[open, mass]: 1}", "a key must be a text, found a list"),
        ("{? {open: 1} : 1}", "a key must be a text, found a mapping"),
        ("colour: blue", "colour is 'blue'; allowed: red, dark blue"),
        ("colour: [red]", "colour is a list; allowed: red, dark blue"),
        ("words: here", "words must be a mapping of names to values, found 'here'"),
        ("words: {maker: [us]}", "words.maker must be a single value, found a list"),
        ("wheel: huge", "wheel must be small, large, or a mapping with the keys radius, found 'huge'"),
        ("wheel: {radius: 0}", "wheel.radius is 0, must be above 0 m"),
        ("spare: {}", "missing key 'radius' in spare; allowed: radius"),
    ],
)
def test_refuses_with_file_and_line(tmp_path, text, message):
    with pytest.raises(FileError) as error:
        read(tmp_path, text)
    assert str(error.value) == f"{tmp_path / 'model.yaml'}:1: {message}"
