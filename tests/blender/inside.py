"""What Blender runs: the tests of one file. Those that wait for Blender to draw are generators, see windowed.py."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.path.append(str(Path(__file__).parents[1] / "python"))
part = sys.argv[sys.argv.index("--") + 1]
if "--enable-event-simulate" in sys.argv:
    import windowed

    windowed.start(f"test_{part}")
else:
    result = unittest.main(f"test_{part}", argv=["inside"], verbosity=2, exit=False).result
    if not result.wasSuccessful() or not result.testsRun:
        raise SystemExit(1)
    Path("passed").touch()
