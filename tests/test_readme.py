"""The Python code of the README runs; tests/test_manual.py parses its commands."""

import re
from pathlib import Path

README = (Path(__file__).parents[1] / "README.md").read_text()
BLOCKS = re.findall(r"```python\n(.*?)```", README, re.S)


def test_there_is_code_to_run():
    assert len(BLOCKS) == 2
    assert len(BLOCKS[0].strip().splitlines()) <= 10


def test_it_is_short():
    assert len(README.splitlines()) <= 150


def test_the_code_runs_from_the_first_block_to_the_last(capsys):
    names = {}
    for block in BLOCKS:
        exec(block, names)
    final_error = [float(value) for value in re.findall(r"-?\d[\d.e-]*", capsys.readouterr().out)]
    assert len(final_error) == 6
    assert max(map(abs, final_error)) < 0.01
    assert names["observation"] in names["env"].observation_space
