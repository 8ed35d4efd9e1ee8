"""Write docs/live.png, the live page in headless Chromium: `python web/picture.py` (part of `make pictures`)."""

import base64
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from heli_gym.baselines.commands import demo
from heli_gym.storage import atomic_write

WEB = Path(__file__).parent
SCRIPT = """
    await page.emulateMedia({reducedMotion: "reduce"});  // nothing flies by itself, so the picture is always the same
    await page.reload();
    await page.locator(".plot").first().focus();
    for (let second = 0; second < 4; second++) await page.keyboard.press("Shift+ArrowRight");
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForTimeout(2000);
    return (await page.screenshot()).toString("base64");
"""


def main() -> None:
    """Open the page, let it fly for a while, and take its picture."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "live.html"
        demo.main(demo.Args(out=page, open=False))
        order = {"url": page.as_uri(), "width": 1400, "height": 900, "script": SCRIPT}
        order["executable"] = shutil.which("chromium") or "chromium"
        child = subprocess.run(
            ["node", str(WEB / "browser.mjs")], input=json.dumps(order), stdout=subprocess.PIPE, text=True, check=True
        )
    with atomic_write(WEB.parent / "docs" / "live.png") as file:
        file.write(base64.b64decode(json.loads(child.stdout)["result"]))


if __name__ == "__main__":
    main()
