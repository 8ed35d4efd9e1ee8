"""The manual's Python code and notebooks run, its links lead to pages, and the files it names exist."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGES = sorted((ROOT / "docs").glob("*.md"))
NOTEBOOKS = sorted((ROOT / "docs" / "tutorials").glob("*.ipynb"))


def blocks(page: Path) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.S | re.M)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page)], ids=lambda page: page.stem)
def test_the_code_of_a_page_runs_from_the_first_block_to_the_last(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict = {"__name__": "manual"}
    for block in blocks(page):
        exec(compile(block, page.name, "exec"), names)


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_a_tutorial_runs_from_the_first_cell_to_the_last(notebook, tmp_path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    cells = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(cells, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md", ROOT / "CONTRIBUTING.md"], ids=lambda page: page.stem)
def test_every_file_that_a_page_names_exists(page):
    folders = "heli_gym|baselines|train|tests|docs|benchmarks|examples|web|results"
    for name in re.findall(rf"`((?:{folders})/[\w/.-]+)`", page.read_text()):
        assert (ROOT / name).exists(), name


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_the_links_of_a_tutorial_lead_to_built_pages(notebook):
    """mkdocs-jupyter leaves links as they are: they name the page that is built."""
    links = re.findall(r"\]\(((?!https?:)[^)#]+)", notebook.read_text(encoding="utf-8"))
    assert links
    for link in links:
        assert link.endswith(".html"), link
        page = (notebook.parent / link).resolve()
        assert page.with_suffix(".md") in PAGES or page.with_suffix(".ipynb") in NOTEBOOKS, link
