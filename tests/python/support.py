"""What the tests share: places, surfaces and strokes."""

import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import burin

ROOT = Path(__file__).parents[2]
SAMPLES = ROOT / "samples"
COMMAND = os.environ["BURIN_COMMAND"]
BUILD = Path(os.environ["BURIN_BUILD"])
TEST_BRUSHES = BUILD / "bin/test-brushes"

STAMPS = {"org.burin.scales": "scales.exr", "org.burin.tread": "tread.exr", "org.burin.vdm-trail": "thorn.exr"}
"""Of brushes that want one, in samples/stamps."""


def grid(count=60, corners=4):
    """A plane from -1 to 1 of quads, or of triangles: positions and faces."""
    u = np.linspace(-1, 1, count, dtype=np.float32)
    x, y = np.meshgrid(u, u)
    positions = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3)
    i = np.arange(count * count, dtype=np.uint32).reshape(count, count)
    quads = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1).reshape(-1, 4)
    if corners == 4:
        return positions, quads
    return positions, np.ascontiguousarray(quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3))


def wave(count=40):
    """Positions of a curved stroke over the plane."""
    s = np.linspace(0, 1, count)
    return np.stack([1.4 * s - 0.7, 0.4 * np.sin(5 * s), np.zeros(count)], axis=-1)


def replayed(arguments, folder):
    """The hash that `burin replay` prints."""
    done = subprocess.run(
        [COMMAND, "replay", *map(str, arguments), "--json"], capture_output=True, text=True, cwd=folder, check=False
    )
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)["result_hash"]


def hex_hash(session):
    return f"{session.hash():016x}"


def folder():
    return tempfile.TemporaryDirectory(prefix="burin-python-")


LIBRARY = burin.Library()
