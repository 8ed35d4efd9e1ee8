"""The manual's Python code and notebooks run; its links, files, commands and options exist."""

import contextlib
import importlib
import io
import re
import shlex
from dataclasses import fields
from pathlib import Path

import pytest

from heli_gym.cli import COMMANDS

ROOT = Path(__file__).parents[1]
PAGES = sorted((ROOT / "docs").glob("*.md"))
TEXTS = [*PAGES, ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
NOTEBOOKS = sorted((ROOT / "docs" / "tutorials").glob("*.ipynb"))


def blocks(page: Path) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.S | re.M)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page)], ids=lambda page: page.stem)
def test_the_code_of_a_page_runs_from_the_first_block_to_the_last(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict = {"__name__": "manual"}
    for block in blocks(page):
        exec(compile(block, page.name, "exec"), names)


def orders(text: str) -> list[list[str]]:
    """The commands of the package in a text's lines, as words."""
    lines = (line.strip().removeprefix("$ ") for line in text.replace("\\\n", " ").splitlines())
    return [shlex.split(line, comments=True) for line in lines if re.match(r"heli-[a-z-]+( |$)", line)]


def code(text: str) -> str:
    """The lines of a text's fenced and indented blocks, with 0 for each variable of the shell."""
    fenced = re.findall(r"^```\w*\n(.*?)^```", text, re.S | re.M)
    rest = re.sub(r"^```\w*\n.*?^```", "", text, flags=re.S | re.M)
    return re.sub(r"\$\w+", "0", "\n".join((*fenced, *re.findall(r"^ {4}.*", rest, re.M))))


def options_of(program: str) -> set[str]:
    """The options of a command."""
    module = importlib.import_module(COMMANDS[program])
    if hasattr(module, "Args"):
        names = {field.name.replace("_", "-") for field in fields(module.Args)} | {"help", "version"}
        return {f"--{no}{name}" for name in names for no in ("", "no-")}
    with contextlib.redirect_stdout(io.StringIO()) as text, contextlib.suppress(SystemExit):
        module.main(["--help"])
    return set(re.findall(r"--[\w-]+", text.getvalue()))


@pytest.mark.parametrize("page", TEXTS, ids=lambda page: page.stem)
def test_the_commands_of_a_page_are_understood(page):
    """Parsed, not run; and what stands within a sentence may leave values out, but names only options that exist."""
    tyro = pytest.importorskip("tyro")
    text = page.read_text(encoding="utf-8")
    commands = orders(code(text))
    assert len(commands) == len(re.findall(r"^ *(?:\$ )?heli-[a-z-]+(?= |$)", text, re.M))
    assert commands or page.stem != "learning"
    for program, *arguments in commands:
        complaint = io.StringIO()
        with contextlib.redirect_stderr(complaint), contextlib.suppress(SystemExit):
            args = [argument for argument in arguments if argument != "..."]
            tyro.cli(importlib.import_module(COMMANDS[program]).Args, args=args)
        assert not complaint.getvalue(), (program, arguments)
    for program, *arguments in orders("\n".join(re.findall(r"`(heli-[^`\n]+)`", text))):
        assert {word for word in arguments if word.startswith("--")} <= options_of(program), program


@pytest.mark.slow
@pytest.mark.filterwarnings("default")
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_a_tutorial_runs_from_the_first_cell_to_the_last(notebook, tmp_path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    cells = nbformat.read(notebook, as_version=4)
    nbclient.NotebookClient(cells, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()


@pytest.mark.parametrize("page", TEXTS, ids=lambda page: page.stem)
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
