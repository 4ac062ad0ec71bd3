"""The package as users install it: a wheel for every interpreter, typed, whose structs are those of the headers."""

import ctypes
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tomllib
import unittest
import zipfile
from pathlib import Path

import burin
from burin import _application_brushes, _c, _stroke_abi
from support import BUILD, ROOT, folder

PACKAGE = ROOT / "hosts/python"
SDK = ROOT / "sdk"

STRUCTS = {
    _c.Text: "burin_text",
    _c.VersionInfo: "burin_version_info",
    _c.LibraryOptions: "burin_library_options",
    _c.ParamInfo: "burin_param_info",
    _c.BrushDescriptor: "burin_brush_descriptor",
    _c.MeshArrays: "burin_mesh",
    _c.SessionInfo: "burin_session_info",
    _c.Stroke: "burin_stroke",
    _c.Sample: "burin_sample",
    _c.Event: "burin_event",
    _c.Range: "burin_range",
    _c.Array: "burin_target",
    _c.Chart: "burin_chart",
    _c.Snap: "burin_snap",
    _c.Snapped: "burin_snapped",
    _c.StepInfo: "burin_step_info",
    _c.GroupEvent: "burin_group_event",
    _c.RecordingStroke: "burin_recording_stroke",
    _c.Refinement: "burin_refinement",
    _c.MeshValues: "burin_mesh_values",
    _c.RecorderCamera: "burin_recorder_camera",
    _c.RecorderOptions: "burin_recorder_options",
    _c.RecordedStroke: "burin_recorded_stroke",
    _c.RecordedSample: "burin_recorded_sample",
    _application_brushes._BrushStruct: "burin_brush",
    _application_brushes._FactoryStruct: "burin_brush_factory",
    _stroke_abi.FloatArray: "burin_floats",
    _stroke_abi.Vectors: "burin_vectors",
    _stroke_abi.Colours: "burin_colours",
    _stroke_abi.ParamValue: "burin_param_value",
    _stroke_abi.Params: "burin_params",
    _stroke_abi.ContextStruct: "burin_stroke_context",
    _stroke_abi.PlanStruct: "burin_stroke_plan",
    _stroke_abi.BatchStruct: "burin_batch",
    _stroke_abi.OutputsStruct: "burin_outputs",
}


def members(struct):
    return [(field[0], field[0].rstrip("_")) for field in struct._fields_]


class Interface(unittest.TestCase):
    def test_calls_functions_of_the_headers(self):
        declared = set()
        for header in ("burin/host/c/burin.h", "burin/host/recorder.h"):
            declared |= set(re.findall(r"BURIN_API [^;]*?BURIN_CALL\s+(burin_\w+)\(", (SDK / header).read_text()))
        self.assertGreater(len(declared), 30)
        self.assertEqual({*_c._WITH_STATUS, *_c._WITHOUT_STATUS} - declared, set())

    def test_has_the_structs_of_the_headers(self):
        lines = ["#include <burin/host/c/burin.h>", "#include <stdio.h>", "int main(void) {"]
        expected = []
        for struct, name in STRUCTS.items():
            lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for mine, theirs in members(struct):
                lines.append(f'printf("{name}.{theirs} %zu\\n", offsetof({name}, {theirs}));')
                expected.append(f"{name}.{theirs} {getattr(struct, mine).offset}")
        with folder() as work:
            Path(work, "layout.c").write_text("\n".join([*lines, "}"]))
            subprocess.run(["cc", "-I", SDK, "layout.c", "-o", "layout"], cwd=work, check=True)
            told = subprocess.run([Path(work, "layout")], capture_output=True, text=True, check=True).stdout.split("\n")
        self.assertEqual(told[:-1], expected)

    def test_names_the_bits_of_the_headers(self):
        header = (SDK / "burin/abi/stroke.h").read_text()
        for names, kind in ((burin.INPUTS, "INPUT"), (burin.OUTPUTS, "OUTPUT")):
            bits = re.findall(rf"#define BURIN_{kind}_(\w+) \(UINT64_C\(1\) << (\d+)\)", header)
            self.assertEqual([(name.lower(), int(bit)) for name, bit in bits], [(n, i) for i, n in enumerate(names)])


class Packages(unittest.TestCase):
    def test_installs_without_a_network_and_runs_with_the_installed_library(self):
        if not all(importlib.util.find_spec(name) for name in ("pip", "setuptools", "wheel")):
            self.skipTest("python3-pip, python3-setuptools or python3-wheel is not installed")
        with folder() as work:
            source, site = Path(work, "source"), Path(work, "site")
            shutil.copytree(PACKAGE, source, ignore=shutil.ignore_patterns("__pycache__", ".mypy_cache"))
            pip = [sys.executable, "-m", "pip", "--isolated", "--disable-pip-version-check", "--quiet"]
            wheel = [*pip, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", work, source]
            subprocess.run(wheel, check=True)
            (made,) = Path(work).glob("*.whl")
            self.assertEqual(made.name, "burin-0.1.0-py3-none-any.whl")
            with zipfile.ZipFile(made) as archive:
                self.assertIn("burin/py.typed", archive.namelist())
                archive.extractall(site)
            # The system's loader finds the library, as it does where a package has installed it.
            shutil.copy(os.environ["BURIN_LIBRARY"], Path(work, "libburin.so.0"))
            environment = {"PATH": os.environ["PATH"], "PYTHONPATH": str(site), "LD_LIBRARY_PATH": work}
            program = "import burin; print(burin.__file__, burin.version(), burin.library_file(), len(burin.Library()))"
            run = lambda: subprocess.run(
                [sys.executable, "-c", program], env=environment, cwd=work, capture_output=True, text=True, check=False
            )
            self.assertEqual(run().stdout.split(), [f"{site}/burin/__init__.py", "0.1.0", "libburin.so.0", "0"])
            environment["BURIN_LIBRARY"] = "/no/such/libburin.so.0"
            self.assertIn("let BURIN_LIBRARY name the file libburin.so.0", run().stderr)

    def test_tells_of_libraries_that_are_older_or_not_there(self):
        for library, text in (("libm.so.6", "burin_get_version; the library is older than this package"), ("no.so", "no.so: cannot open")):
            done = subprocess.run(
                [sys.executable, "-c", "import burin"],
                env={**os.environ, "BURIN_LIBRARY": library, "PYTHONPATH": ":".join(sys.path)},
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertRegex(done.stderr.splitlines()[-1], f"^ImportError: .*{text}")

    def test_has_the_version_of_the_library(self):
        project = tomllib.loads((PACKAGE / "pyproject.toml").read_text())["project"]
        self.assertEqual(project["version"], burin.version())

    def test_is_typed(self):
        if not shutil.which("mypy", path="/usr/bin"):
            self.skipTest("mypy is not installed")
        done = subprocess.run(
            ["/usr/bin/mypy", "--strict", "--cache-dir", BUILD / "mypy", "burin"],
            cwd=PACKAGE,
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
