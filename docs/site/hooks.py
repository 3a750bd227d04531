"""Shows README, package READMEs and generated pages at the paths that they have in the repository.

So links between documents are the same in the site and in the repository, and mkdocs checks all of them.
"""

import logging
import re
import sys
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = (
    "*.md",
    "data/README.md",
    "docs/*.md",
    "src/*/README.md",
    "src/*/docs/*.md",
    "src/*/fuzz/README.md",
    "src/standins/*/docs/*.md",
    "src/standins/*/README.md",
    "templates/*/README.md",
)
ASSETS = ("docs/site/*.js", "docs/site/*.css")
WORDS_MAX = 1500  # of a page: what is longer is two pages
LINK = re.compile(r"\]\(([^)\s#]+)")

log = logging.getLogger("mkdocs.hooks.site")


def on_files(files, config):
    """Replace what mkdocs found in docs/ by all documents of the repository."""
    for file in list(files.documentation_pages()) + list(files.static_pages()):
        if file.src_dir == config.docs_dir:
            files.remove(file)
    documents = [path for pattern in DOCUMENTS for path in sorted(ROOT.glob(pattern))]
    assets = [path for pattern in ASSETS for path in sorted(ROOT.glob(pattern))]
    for path in [*documents, *assets, *sorted(_linked(documents))]:
        uri = path.relative_to(ROOT).as_posix()
        files.append(File(uri, str(ROOT), config.site_dir, use_directory_urls=False))
    for uri, text in _generated().items():
        files.append(File.generated(config, uri, content=text))
    return files


def on_page_markdown(markdown, page, **_):
    """Refuse a page that is too long to be read."""
    words = len(markdown.replace("|", " ").split())
    if words > WORDS_MAX:
        log.warning("%s: %d words, allowed: %d", page.file.src_uri, words, WORDS_MAX)


def _linked(documents):
    """Pictures, programs and other files that documents link to."""
    for document in documents:
        for target in LINK.findall(document.read_text(encoding="utf-8")):
            path = (document.parent / target).resolve()
            if path.suffix != ".md" and path.is_file() and ROOT in path.parents:
                yield path


def _generated():
    """Pages made from the schema of scenario files, by their paths."""
    sys.path.insert(0, str(ROOT / "src" / "f1tenth_judge" / "src"))
    from f1tenth_judge.scenario.describe import describe_keys
    from f1tenth_judge.scenario.scenario import Scenario

    head, rule, *rows = describe_keys(Scenario).splitlines()
    of_cars = [row for row in rows if row.startswith("| `cars[]")]
    parts = {"cars": of_cars, "runs": [row for row in rows if row not in of_cars]}
    titles = {"cars": "Keys of cars", "runs": "Keys of runs"}
    return {
        f"docs/keys_of_{name}.md": "\n".join([f"# {titles[name]}", "", head, rule, *part, ""])
        for name, part in parts.items()
    }
