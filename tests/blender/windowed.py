"""Tests in Blender's window: generators that yield whenever Blender is to handle the events they have simulated."""

import importlib
import sys
import traceback
from pathlib import Path

import bpy

import support

PAUSE = 0.03
"""Seconds between steps, in which Blender handles events and draws."""


def window():
    return bpy.context.window_manager.windows[0]


def view():
    """The 3D view: its area, and the region with the objects."""
    area = next(area for area in window().screen.areas if area.type == "VIEW_3D")
    return area, next(region for region in area.regions if region.type == "WINDOW")


def in_view():
    area, region = view()
    return bpy.context.temp_override(window=window(), screen=window().screen, area=area, region=region)


def send(type, value, place):
    """Simulates an event at a place of the view, 0..1 from its lower left corner."""
    _, region = view()
    x, y = region.x + int(place[0] * region.width), region.y + int(place[1] * region.height)
    window().event_simulate(type=type, value=value, x=x, y=y)


def _steps(module):
    tests = [(name, test) for name, test in vars(module).items() if name.startswith("test_")]
    for name, test in tests:
        print(name, "...", flush=True)
        work = support.folder()
        yield from test(Path(work.name))
        work.cleanup()
    assert tests
    Path("passed").touch()


def start(name):
    """Runs the tests of a module, and quits."""
    steps = _steps(importlib.import_module(name))

    def step():
        try:
            next(steps)
            return PAUSE
        except StopIteration:
            print("OK")
        except BaseException:
            traceback.print_exc()
        sys.stdout.flush()
        bpy.ops.wm.quit_blender()
        return None

    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.system.viewport_aa = "OFF"
    bpy.app.timers.register(step, first_interval=0.5)
