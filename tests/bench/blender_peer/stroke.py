"""The stroke that both draw, on the unit sphere: where its samples lie and how burin is told of it."""

import json
import math

RADIUS = 0.05
SAMPLES = 200
SAMPLES_PER_SECOND = 240
ROUNDS = 5

# What burin shows. Blender's operator shows the stroke when it has drawn all of it.
SHOWN = {"at the end": 0, "every 4th": 4, "each sample": 1}


def sample_places():
    """Points of the unit sphere on a wave across the side that faces +z."""
    for i in range(SAMPLES):
        angle = -0.7 + 1.4 * i / (SAMPLES - 1)
        x, y, z = math.sin(angle), 0.12 * math.sin(4 * angle), math.cos(angle)
        length = math.hypot(x, y, z)
        yield x / length, y / length, z / length


def write_stroke(path):
    with open(path, "w", encoding="utf-8") as file:
        file.write('{"burin_stroke": 1, "space": "object"}\n')
        begin = {"brush": "org.burin.scales", "radius": RADIUS}
        file.write(json.dumps({"begin": begin, "fields": ["time", "x", "y", "z"]}) + "\n")
        for i, place in enumerate(sample_places()):
            file.write(json.dumps([i / SAMPLES_PER_SECOND, *place]) + "\n")
        file.write('{"end": true}\n')


def write_suite(path, stamp):
    """A suite for `burin bench` beside mesh.ply and wave.stroke."""
    cases = [{
        "name": name,
        "mesh": "mesh.ply",
        "strokes": ["wave.stroke"],
        "params": {"stamp": stamp},
        "show_every": show_every,
        "repeat": ROUNDS,
    } for name, show_every in SHOWN.items()]
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"burin_suite": 1, "name": "blender_peer", "cases": cases}, file)
