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
from .group import Group, GroupEvent
from .library import Library
from .mesh import Mesh, read_mesh, refine_mesh, write_mesh
from .recorder import Camera, Recorder
from .recording import RecordedStroke, Recording, read_recording
from .samples import SAMPLE, samples
from .session import CHART_NODE, LINES, Chart, Event, Patch, Session, Snapped
from .shown_surface import ATTRIBUTES, SessionInfo, ShownSurface
from .step import Step

__version__ = version()

__all__ = [
    "ATTRIBUTES",
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
    "Group",
    "GroupEvent",
    "INPUTS",
    "IntParam",
    "InvalidArgument",
    "LINES",
    "Library",
    "Mesh",
    "NotFound",
    "OUTPUTS",
    "OutOfMemory",
    "Param",
    "ParamInfo",
    "Patch",
    "RecordedStroke",
    "Recorder",
    "Recording",
    "SAMPLE",
    "Session",
    "SessionInfo",
    "ShownSurface",
    "Snapped",
    "Start",
    "Step",
    "TextParam",
    "Unsupported",
    "library_file",
    "read_mesh",
    "read_recording",
    "refine_mesh",
    "samples",
    "smooth_step",
    "version",
    "write_mesh",
]
