"""Runs the tests of one file, test_NAME.py; ends with 77 where what they need is not installed."""

import importlib.util
import sys
import unittest
from pathlib import Path

FOLDER = Path(__file__).parent
SKIPPED = 77

if not importlib.util.find_spec("numpy"):
    print("skipped: numpy is not installed (python3-numpy)")
    sys.exit(SKIPPED)
sys.path[:0] = [str(FOLDER), str(FOLDER.parents[1] / "hosts/python")]
result = unittest.main(f"test_{sys.argv[1]}", argv=sys.argv[:1], verbosity=2, exit=False).result
if not result.wasSuccessful():
    sys.exit(1)
sys.exit(SKIPPED if result.testsRun and len(result.skipped) == result.testsRun else 0)
