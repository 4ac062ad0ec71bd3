"""The add-on as a host of plugins, as the probe of hosts sees it: nothing that the ABI forbids."""

import gc
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

WORK = tempfile.TemporaryDirectory()
REPORT = Path(WORK.name, "probe.txt")
# The library reads both when it is made, at the first use of the add-on.
os.environ["BURIN_PLUGIN_PATH"] = str(Path(os.environ["BURIN_BUILD"], "bin/probe"))
os.environ["BURIN_PROBE_REPORT"] = str(REPORT)

import addon_utils
import bpy

from support import ADDON, hilly_grid, make_object, write_stroke


class Probe(unittest.TestCase):
    def test_finds_nothing_wrong(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        addon_utils.enable(ADDON)
        make_object("Grid", *hilly_grid())
        bpy.ops.ed.undo_push(message="Start")
        stroke = write_stroke(Path(WORK.name, "one.stroke"), brush="org.burin.probe.solid", params={})
        for settings in ("", "solid=separate", "mirror=x", "follow=1"):
            drawn = bpy.ops.burin.replay("EXEC_DEFAULT", True, filepath=str(stroke), settings=settings)
            self.assertEqual(drawn, {"FINISHED"})
        paints = write_stroke(Path(WORK.name, "two.stroke"), brush="org.burin.probe", params={})
        for settings in ("", "mirror=x"):
            drawn = bpy.ops.burin.replay("EXEC_DEFAULT", True, filepath=str(paints), settings=settings)
            self.assertEqual(drawn, {"FINISHED"})
        bpy.ops.ed.undo()
        addon_utils.disable(ADDON)
        sys.modules.pop("burin_brushes.brushes", None)
        gc.collect()
        report = REPORT.read_text()
        kept, broken = map(int, re.search(r"(\d+) rules kept, (\d+) broken", report).groups())
        self.assertEqual(broken, 0, report)
        self.assertGreater(kept, 40, report)
