"""The pages in node and in Chromium. Where these are missing, tests are skipped, unless HELI_BROWSER_TESTS is set."""

import atexit
import json
import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from heli_gym.baselines.evaluation.report import WEB

SOURCES = Path(__file__).parents[2] / "web"
DESKTOP, PHONE = (1400, 900), (390, 844)
# Beginnings of scripts for the live page: no flight starts by itself; pictures, slow to draw without a GPU, are small;
# words and clocks follow with the next frame, which `drawn` waits for.
STILL = 'await page.emulateMedia({reducedMotion: "reduce"}); await page.reload();'
SMALL = 'await page.addStyleTag({content: ".live .view { height: 30px !important }"});'
DRAWN = """
const drawn = () => page.evaluate(() => new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go))));
"""


def lacking(what: str):
    if os.environ.get("HELI_BROWSER_TESTS"):
        pytest.fail(f"HELI_BROWSER_TESTS is set, and there is no {what}")
    pytest.skip(f"there is no {what} here")


def tool(name: str) -> str:
    """The path of a program."""
    return shutil.which(name) or lacking(name)


def installed(name: str) -> str:
    """The path of something in the packages that `npm ci` installs in web/."""
    path = SOURCES / "node_modules" / name
    return str(path) if path.exists() else lacking(f"{name}: run `npm ci` in web/")


def in_node(expression: str, **data):
    """The value of a JavaScript expression, with the shipped program as `heli` and the data by their names."""
    script = (
        "const {readFileSync} = require('fs');"
        f"(0, eval)(readFileSync({json.dumps(str(WEB / 'heli.js'))}, 'utf8') + ';globalThis.heli = heli');"
        f"const {{{', '.join(data)}}} = JSON.parse(readFileSync(0, 'utf8'));"
        f"process.stdout.write(JSON.stringify({expression}))"
    )
    child = subprocess.run([tool("node"), "-e", script], input=json.dumps(data), capture_output=True, text=True)
    assert child.returncode == 0, child.stderr
    return json.loads(child.stdout)


@cache
def driver() -> subprocess.Popen:
    """The node process that drives Chromium for all tests; it ends with its input."""
    installed("playwright-core")
    command = [tool("node"), str(SOURCES / "browser.mjs")]
    child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(child.communicate)
    return child


def in_browser(path: Path, script: str, size: tuple[int, int] = DESKTOP):
    """What a script returns that drives a page, which must neither complain nor ask for anything from a network.

    The script is the body of an async function of Playwright's `page`.
    """
    order = {"url": path.absolute().as_uri(), "width": size[0], "height": size[1], "script": script}
    child = driver()
    child.stdin.write(json.dumps({**order, "executable": tool("chromium")}) + "\n")
    child.stdin.flush()
    answer = json.loads(child.stdout.readline())
    assert "failure" not in answer, answer["failure"]
    # The driver remarks on how slow it is to read pixels back where there is no GPU.
    errors = [error for error in answer["errors"] if "GPU stall due to ReadPixels" not in error]
    assert errors == [], errors
    assert answer["requests"] == [], answer["requests"]
    return answer["result"]


AXE = """
const {readFileSync} = await import("node:fs");
await page.waitForTimeout(500);
await page.evaluate(() => document.querySelectorAll("details").forEach((part) => {
  part.removeAttribute("name");
  part.open = true;
}));
await page.evaluate(readFileSync(PATH, "utf8"));
const found = {};
for (const colorScheme of ["light", "dark"]) {
  await page.emulateMedia({colorScheme});
  const result = await page.evaluate(() => axe.run());
  found[colorScheme] = {
    passed: result.passes.length,
    violations: result.violations.map(({id, nodes}) => [id, nodes.slice(0, 3).map(({html}) => html)]),
  };
}
return found;
"""


def check_accessible(page, size=DESKTOP):
    """axe-core finds nothing on the page, light and dark."""
    found = in_browser(page, AXE.replace("PATH", json.dumps(installed("axe-core/axe.min.js"))), size)
    for scheme, result in found.items():
        assert result["passed"] > 20, scheme
        assert result["violations"] == [], scheme
