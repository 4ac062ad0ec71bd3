"""Burin, strokes on surfaces, for Python.

    library = burin.Library()
    session = burin.Session(library, positions, triangles)
    with session.stroke("org.burin.groove", radius=0.1, params={"depth": 0.2}):
        session.add([[0, 0, 1], [0.1, 0, 1], [0.2, 0, 1]])
    changed = session.update("positions")     # ranges of vertices
    positions = session.values("positions")   # a view of all

docs/python.md of Burin has the rest. Names that do not stand in __all__ are not part of the interface.
"""

from ._c import library_file, version
from ._evaluation import Batch, Context, Start
from .brush import (
    BoolParam,
    Brush,
    ChoiceParam,
    ColourParam,
    CurveParam,
    FileParam,
    FloatParam,
    IntParam,
    Param,
    TextParam,
    smooth_step,
)
from .brushinfo import INPUTS, OUTPUTS, BrushInfo, ParamInfo
from .errors import Error, InvalidArgument, NotFound, OutOfMemory, Unsupported
from .library import Library
from .recorder import Camera, Recorder
from .session import CHART_NODE, SAMPLE, Chart, Event, Session, SessionInfo, samples

__version__ = version()

__all__ = [
    "Batch",
    "BoolParam",
    "Brush",
    "BrushInfo",
    "CHART_NODE",
    "Camera",
    "Chart",
    "ChoiceParam",
    "ColourParam",
    "Context",
    "CurveParam",
    "Error",
    "Event",
    "FileParam",
    "FloatParam",
    "INPUTS",
    "IntParam",
    "InvalidArgument",
    "Library",
    "NotFound",
    "OUTPUTS",
    "OutOfMemory",
    "Param",
    "ParamInfo",
    "Recorder",
    "SAMPLE",
    "Session",
    "SessionInfo",
    "Start",
    "TextParam",
    "Unsupported",
    "library_file",
    "samples",
    "smooth_step",
    "version",
]
