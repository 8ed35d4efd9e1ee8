"""Writes the live page next to the manual, which embeds it."""

import tempfile
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from heli_gym.baselines.commands import demo


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add live.html, as `heli-demo` writes it."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "live.html"
        demo.main(demo.Args(out=page, open=False))
        files.append(File.generated(config, "live.html", content=page.read_text()))
    return files
