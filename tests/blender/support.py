"""What the tests share: places, meshes, and what the command makes of them."""

import json
import os
import subprocess
import tempfile
from pathlib import Path

import bpy
import numpy as np

import burin

ROOT = Path(__file__).parents[2]
COMMAND = os.environ["BURIN_COMMAND"]
ADDON = "burin_brushes"


def folder():
    return tempfile.TemporaryDirectory(prefix="burin-blender-")


def hilly_grid(count=60):
    """A hilly square from -1 to 1 of quads, and a row of triangles: positions and faces."""
    u = np.linspace(-1, 1, count, dtype=np.float32)
    x, y = np.meshgrid(u, u)
    positions = np.stack([x, y, 0.1 * np.sin(3 * x) * np.cos(4 * y)], axis=-1).astype(np.float32).reshape(-1, 3)
    i = np.arange(count * count).reshape(count, count)
    quads = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1).reshape(-1, 4).tolist()
    faces = quads[count:] + [[a, b, c] for a, b, c, _ in quads[:count]] + [[a, c, d] for a, _, c, d in quads[:count]]
    return positions, faces


def brush_that_fails(after):
    """A brush that raises beyond this arc length, object units."""

    class Faulty(burin.Brush):
        id = "org.example.faulty"

        def evaluate(self, batch):
            if batch.t.max() > after:
                raise ZeroDivisionError("the pen went too far")
            batch.up = 0.1

    return Faulty


def make_object(name, positions, faces):
    """A mesh object, which becomes the active one."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions.tolist(), [], faces)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(made)
    activate(made)
    return made


def activate(object):
    bpy.context.view_layer.update()
    for other in bpy.context.view_layer.objects:
        other.select_set(other == object)
    bpy.context.view_layer.objects.active = object
    bpy.context.view_layer.update()


def positions_of(object):
    positions = np.empty(3 * len(object.data.vertices), np.float32)
    object.data.vertices.foreach_get("co", positions)
    return positions.reshape(-1, 3)


def write_obj(path, positions, faces):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in positions.astype(float).tolist()]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    Path(path).write_text("\n".join(lines) + "\n")


def write_stroke(path, brush="org.burin.groove", shift=0.0, count=40, **settings):
    """Records a curved stroke over the square from -1 to 1, with pressure."""
    s = np.linspace(0, 1, count)
    places = np.stack([1.4 * s - 0.7, 0.3 * np.sin(5 * s) + shift, 0 * s], axis=-1)
    settings = {"radius": 0.15, "strength": 0.8, "params": {"depth": 0.3}, **settings}
    with burin.Recorder(path) as recorder:
        recorder.begin(brush=brush, fields="time pressure", **settings)
        recorder.add(places, time=s, pressure=0.5 + s / 2)
        recorder.end()
    return path


def replayed(folder, stroke, positions, faces, *options):
    """The positions and the hash that `burin replay` gives a mesh."""
    write_obj(Path(folder, "before.obj"), positions, faces)
    arguments = ["replay", str(stroke), "--mesh", "before.obj", "--save-mesh", "after.ply", "--json", *options]
    done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, cwd=folder, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return np.array(burin.read_mesh(Path(folder, "after.ply")).positions), json.loads(done.stdout)["result_hash"]
