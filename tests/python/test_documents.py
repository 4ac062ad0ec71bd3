"""The documents' programs: docs/python.md, the docstrings and the notebooks run."""

import doctest
import importlib
import importlib.util
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from support import BUILD, ROOT, folder

DOCUMENT = ROOT / "docs/python.md"
NOTEBOOKS = ROOT / "samples/python"


class Snippets(unittest.TestCase):
    def test_of_the_document_run(self):
        blocks = re.findall(r"```python3\n(.*?)```", DOCUMENT.read_text(), re.DOTALL)
        self.assertGreaterEqual(len(blocks), 3)
        names = {}
        with folder() as work:
            os.symlink(ROOT / "samples", Path(work, "samples"))
            before = os.getcwd()
            os.chdir(work)
            try:
                for block in blocks:
                    exec(compile(block, str(DOCUMENT), "exec"), names)
            finally:
                os.chdir(before)
            self.assertTrue(Path(work, "ewer.ply").exists())
        self.assertGreater(len(names["changed"]), 0)

    def test_of_the_installation_runs(self):
        if not all(importlib.util.find_spec(name) for name in ("pip", "setuptools", "wheel")):
            self.skipTest("python3-pip, python3-setuptools or python3-wheel is not installed")
        (script,) = re.findall(r"```sh\n(.*?)```", DOCUMENT.read_text(), re.DOTALL)
        with folder() as work:
            shutil.copytree(ROOT / "hosts/python", Path(work, "hosts/python"))
            os.symlink(BUILD.parent, Path(work, "build"))
            done = subprocess.run(
                ["sh", "-e"],
                input=script.replace("build/release", f"build/{BUILD.name}"),
                cwd=work,
                env={"PATH": f"/usr/bin:{os.environ['PATH']}", "HOME": work},
                capture_output=True,
                text=True,
                check=False,
            )
        self.assertRegex(done.stdout.split("\n")[-2], r"^0\.1\.0 \d\d brushes$", done.stderr)

    def test_of_docstrings_run(self):
        ran = 0
        for name in ("brush", "library", "mesh", "samples", "session"):
            module = importlib.import_module(f"burin.{name}")
            names = {**vars(importlib.import_module("burin")), "np": importlib.import_module("numpy")}
            result = doctest.testmod(module, globs=names)
            self.assertEqual(result.failed, 0)
            ran += result.attempted
        self.assertGreaterEqual(ran, 5)


@unittest.skipUnless(
    all(importlib.util.find_spec(name) for name in ("nbconvert", "ipykernel", "matplotlib")),
    "python3-nbconvert, python3-ipykernel or python3-matplotlib is not installed",
)
class Notebooks(unittest.TestCase):
    def run_notebook(self, name, pictures):
        import nbformat
        from nbconvert import HTMLExporter
        from nbconvert.preprocessors import ExecutePreprocessor

        notebook = nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4)
        self.assertFalse([cell for cell in notebook.cells if cell.get("outputs")], "committed with outputs")
        os.environ["PYTHONPATH"] = str(ROOT / "hosts/python")
        ExecutePreprocessor(timeout=60, kernel_name="python3").preprocess(notebook, {"metadata": {"path": ROOT / "samples"}})
        kinds = [kind for cell in notebook.cells for output in cell.get("outputs", []) for kind in output.get("data", {})]
        self.assertEqual(kinds.count("image/png"), pictures)
        page, _ = HTMLExporter().from_notebook_node(notebook)
        (BUILD / "notebooks").mkdir(exist_ok=True)
        (BUILD / "notebooks" / f"{name}.html").write_text(page)

    def test_of_strokes_runs(self):
        self.run_notebook("strokes", 3)

    def test_of_a_brush_runs(self):
        self.run_notebook("brush", 2)


if __name__ == "__main__":
    unittest.main()
