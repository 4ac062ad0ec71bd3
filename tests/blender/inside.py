"""What Blender runs: the tests of one file."""

import importlib
import sys
import traceback
import unittest
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
part = sys.argv[sys.argv.index("--") + 1]
result = unittest.main(f"test_{part}", argv=["inside"], verbosity=2, exit=False).result
if not result.wasSuccessful() or not result.testsRun:
    raise SystemExit(1)
