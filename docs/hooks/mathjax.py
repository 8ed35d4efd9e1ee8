"""Copies MathJax out of the installed package `django-static-mathjax` into the manual, so that nothing is fetched."""

from importlib.util import find_spec
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

SETTINGS = r"""window.MathJax = {
  tex: {inlineMath: [["\\(", "\\)"], ["$", "$"]], displayMath: [["\\[", "\\]"], ["$$", "$$"]]},
  options: {ignoreHtmlClass: "jp-CodeCell|md-nav"},
};
"""


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the script, which draws formulas as SVG and so takes no fonts, and its settings."""
    spec = find_spec("mathjax")
    assert spec is not None and spec.origin is not None, "install the extra `docs`"
    script = Path(spec.origin).parent / "static" / "mathjax" / "es5" / "tex-svg.js"
    files.append(File.generated(config, "javascripts/tex-svg.js", content=script.read_bytes()))
    files.append(File.generated(config, "javascripts/mathjax-settings.js", content=SETTINGS))
    return files
