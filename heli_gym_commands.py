"""Entry points of the console scripts: `plan` of `heli-plan`.

Importing the package takes a second, and the modules of a command several. Here Ctrl-C during that ends in one line,
too: before the first import of ours, only this module has run.
"""

import sys
from collections.abc import Callable
from functools import partial


def __getattr__(name: str) -> Callable[[], None]:
    """Return the entry point of a command."""
    if name.startswith("_"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return partial(run, f"heli-{name.replace('_', '-')}")


def run(program: str) -> None:
    """Run a command."""
    try:
        from heli_gym import cli
    except KeyboardInterrupt:
        print(f"{program}: interrupted", file=sys.stderr)
        raise SystemExit(130) from None
    cli.run(program)
