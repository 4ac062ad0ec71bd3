"""Runs the tests of one file, test_NAME.py, in Blender; ends with 77 where what they need is not installed."""

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[1]
SKIPPED = 77
PASSED = "passed"
"""A file that tests leave which passed: what a timer raises does not end Blender."""
SIZE = os.environ.get("BURIN_WINDOW", "640x480").split("x")
"""Of the window, pixels: what is drawn is drawn by the processor."""
WINDOW = ("draw", "preview")
"""Parts that want a window."""


def skip(what):
    print(f"skipped: {what}")
    sys.exit(SKIPPED)


def command(part):
    blender = ["blender", "--factory-startup", "--python-exit-code", "1"]
    script = ["--python", str(FOLDER / "inside.py"), "--", part]
    if part not in WINDOW:
        return [*blender, "--background", *script]
    if not shutil.which("xvfb-run"):
        skip("Xvfb is not installed (xvfb, xauth)")
    screen = ["xvfb-run", "--auto-servernum", f"--server-args=-screen 0 {SIZE[0]}x{SIZE[1]}x24"]
    return [*screen, *blender, "--enable-event-simulate", "--window-geometry", "0", "0", *SIZE, *script]


def main(part):
    if not shutil.which("blender"):
        skip("Blender is not installed (blender)")
    if not importlib.util.find_spec("numpy"):
        skip("numpy is not installed (python3-numpy)")
    with tempfile.TemporaryDirectory(prefix="burin-blender-") as work:
        addons = Path(work, "scripts/addons")
        addons.mkdir(parents=True)
        shutil.copytree(ROOT / "hosts/blender/burin_brushes", addons / "burin_brushes")
        environment = {
            **os.environ,
            "BLENDER_USER_SCRIPTS": str(addons.parent),
            "BLENDER_USER_CONFIG": work,
            "PYTHONPATH": str(ROOT / "hosts/python"),
            "HOME": work,
            "TMPDIR": work,
            "LIBGL_ALWAYS_SOFTWARE": "1",
        }
        done = subprocess.run(command(part), env=environment, cwd=work, check=False)
        return 0 if done.returncode == 0 and Path(work, PASSED).exists() else 1


sys.exit(main(sys.argv[1]))
