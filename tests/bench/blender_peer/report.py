"""Runs inside Blender without a window: blender --background --python report.py -- FOLDER

Compares blender.json and burin.json of FOLDER and writes report.txt there. Exit code 0: burin keeps within
the target.
"""

import json
import os
import statistics
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import stroke

TARGET = 1 / 10


def read(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return json.load(file)


def line(name, times, vertices):
    """Milliseconds and microseconds; the median of the rounds, and the first, when caches are cold."""
    median = statistics.median(times)
    return (f"{name:<16}{1e3 * times[0]:>9.1f}{1e3 * median:>9.1f}{1e3 * median / stroke.SAMPLES:>9.3f}"
            f"{1e6 * median / vertices:>12.3f}{vertices:>12}")


def check_drawn(blender, cases):
    for burin in cases:
        if blender["triangles"] != burin["counters"]["triangles"]:
            raise RuntimeError("the two drew on different spheres")
        if burin["counters"]["events"] != stroke.SAMPLES or burin["counters"]["moved"] == 0:
            raise RuntimeError("burin did not draw the stroke")
        if burin["hash"] != cases[0]["hash"]:
            raise RuntimeError("burin drew another stroke where it showed more of it")
    if any(drawn["moved"] == 0 for drawn in blender["rounds"]):
        raise RuntimeError("Blender's stroke moved nothing")


def report(blender, cases):
    """The text, and whether the target is met: by the case that shows as much as Blender does."""
    check_drawn(blender, cases)
    drawn = blender["rounds"][0]
    theirs = [each["seconds"] for each in blender["rounds"]]
    ratios = [statistics.median(burin["stroke_s"]) / statistics.median(theirs) for burin in cases]
    met = ratios[0] <= TARGET
    text = "\n".join([
        "",
        f"{stroke.SAMPLES} samples, radius {stroke.RADIUS}, unit sphere of {blender['triangles']} triangles, "
        f"{len(theirs)} rounds",
        f"Blender's stroke moved {drawn['moved']} vertices, by {drawn['furthest']:.4f} at most",
        "",
        f"{'shown':<16}{'first ms':>9}{'ms':>9}{'ms/dab':>9}{'us/vertex':>12}{'vertices':>12}",
        line("Blender " + blender["version"], theirs, drawn["moved"]),
        *(line(burin["name"], burin["stroke_s"], burin["counters"]["region"]) for burin in cases),
        "",
        *(f"burin / Blender, shown {burin['name']}: {ratio:.3f}" for burin, ratio in zip(cases, ratios)),
        f"target, shown {cases[0]['name']}: {TARGET:.3f}, {'met' if met else 'missed'}",
    ])
    return text, met


def main():
    folder = sys.argv[sys.argv.index("--") + 1]
    text, met = report(read(folder, "blender.json"), read(folder, "burin.json")["cases"])
    with open(os.path.join(folder, "report.txt"), "w", encoding="utf-8") as file:
        file.write(text + "\n")
    return 0 if met else 1


try:
    status = main()
except Exception:
    traceback.print_exc()
    status = 1
sys.exit(status)
