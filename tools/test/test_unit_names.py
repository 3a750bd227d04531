"""Several sources of a library may be compiled as one, in which their anonymous namespaces are one, too."""

import re
from collections import defaultdict

import pytest
from package_edges import ROOT, tracked_files

_CONSTANT = re.compile(r"(?:inline )?(?:constexpr|const) .*?\b(k[A-Z]\w*)\b(?:\[|\{| =|;)")
_TYPE = re.compile(r"(?:class|struct|enum class|enum) (\w+)")
_FUNCTION = re.compile(
    r"(?! |constexpr|const |using|namespace|template|class|struct|enum|//)[\w:<>,*& ]+ [&*]?(\w+\(.*)"
)
_NAMESPACE = re.compile(r"^namespace\n\{\n(.*?)^\}  // namespace$", re.DOTALL | re.MULTILINE)


def names_of_its_own(text):
    """What a source defines in anonymous namespaces; functions with their parameters, as those may differ."""
    for block in _NAMESPACE.findall(text):
        for line in block.splitlines():
            match = _CONSTANT.match(line) or _TYPE.match(line) or _FUNCTION.match(line)
            if match:
                yield match[1]


def test_names_are_found():
    text = """
namespace
{
constexpr double kStep = 0.02;  // s
const char * const kNames[] = {"a"};
struct Place
{
  double kInside{1.0};
};

double wayTo(const Place & place, double time)
{
  constexpr double kWithin = 1.0;
}
}  // namespace

constexpr double kShared = 1.0;
"""
    assert list(names_of_its_own(text)) == [
        "kStep",
        "kNames",
        "Place",
        "wayTo(const Place & place, double time)",
    ]


@pytest.mark.parametrize("package", sorted({path.parent for path in (ROOT / "src").rglob("package.xml")}))
def test_units_of_a_library_or_a_test_share_no_name(package):
    where = defaultdict(lambda: defaultdict(set))
    for path in tracked_files(package):
        parts = path.relative_to(package).parts
        if path.suffix == ".cpp" and parts[0] in ("src", "test"):
            for name in names_of_its_own(path.read_text(encoding="utf-8")):
                where[parts[:2]][name].add("/".join(parts))
    every = [(name, sorted(files)) for names in where.values() for name, files in names.items()]
    assert [(name, files) for name, files in every if len(files) > 1] == []
