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


def check_drawn(blender, burin):
    if blender["triangles"] != burin["counters"]["triangles"]:
        raise RuntimeError("the two drew on different spheres")
    if burin["counters"]["events"] != stroke.SAMPLES or burin["counters"]["moved"] == 0:
        raise RuntimeError("burin did not draw the stroke")
    if any(drawn["moved"] == 0 for drawn in blender["rounds"]):
        raise RuntimeError("Blender's stroke moved nothing")


def report(blender, burin):
    """The text, and whether the target is met."""
    check_drawn(blender, burin)
    drawn = blender["rounds"][0]
    theirs, ours = [each["seconds"] for each in blender["rounds"]], burin["stroke_s"]
    ratio = statistics.median(ours) / statistics.median(theirs)
    met = ratio <= TARGET
    text = "\n".join([
        "",
        f"{stroke.SAMPLES} samples, radius {stroke.RADIUS}, unit sphere of {blender['triangles']} triangles, "
        f"{len(theirs)} rounds",
        f"Blender's stroke moved {drawn['moved']} vertices, by {drawn['furthest']:.4f} at most",
        "",
        f"{'':<16}{'first ms':>9}{'ms':>9}{'ms/dab':>9}{'us/vertex':>12}{'vertices':>12}",
        line("Blender " + blender["version"], theirs, drawn["moved"]),
        line("burin", ours, burin["counters"]["region"]),
        "",
        f"burin / Blender {ratio:.3f}, target {TARGET:.3f}: {'met' if met else 'missed'}",
    ])
    return text, met


def main():
    folder = sys.argv[sys.argv.index("--") + 1]
    text, met = report(read(folder, "blender.json"), read(folder, "burin.json")["cases"][0])
    with open(os.path.join(folder, "report.txt"), "w", encoding="utf-8") as file:
        file.write(text + "\n")
    return 0 if met else 1


try:
    status = main()
except Exception:
    traceback.print_exc()
    status = 1
sys.exit(status)
