"""What the user sets: the brush and its parameters, made from the brushes' descriptors, and how strokes are drawn."""

from __future__ import annotations

import re
from typing import Any

import bpy
import burin

from . import brushes

FEEL = ("radius", "strength", "follow", "pressure_strength", "pressure_radius")
"""Settings of how strokes are drawn that belong to a brush, as its parameters do."""
_INT_MAX = 2**31 - 1
_classes: list[type] = []


def group_of(brush_id: str) -> str:
    """The name in a scene's settings of the group that has the parameters of a brush."""
    return "brush_" + re.sub(r"\W", "_", brush_id)


def param_of(param_id: str) -> str:
    """The name of a parameter in its group, which has names of its own."""
    return f"param_{param_id}"


def _number(param: burin.ParamInfo) -> Any:
    ranges = dict(zip(("min", "max", "soft_min", "soft_max"), (*param.hard, *param.soft)))
    if param.type == "int":
        ranges = {name: int(max(-_INT_MAX, min(value, _INT_MAX))) for name, value in ranges.items()}
        return bpy.props.IntProperty, {"default": param.default, **ranges}
    return bpy.props.FloatProperty, {"default": param.default, "precision": 3, "step": 1, **ranges}


def _property(param: burin.ParamInfo) -> Any:
    """The property of Blender for a parameter: what slider, menu or field the panel has."""
    if param.type in ("float", "int"):
        make, kind = _number(param)
    elif param.type == "bool":
        make, kind = bpy.props.BoolProperty, {"default": param.default}
    elif param.type == "choice":
        items = [(choice, choice.replace("-", " ").capitalize(), "") for choice in param.choices]
        make, kind = bpy.props.EnumProperty, {"default": param.default, "items": items}
    elif param.type == "colour":
        make = bpy.props.FloatVectorProperty
        kind = {"default": param.default, "size": 4, "min": 0, "max": 1, "subtype": "COLOR"}
    elif param.type == "file":
        make, kind = bpy.props.StringProperty, {"default": param.default or "", "subtype": "FILE_PATH"}
    elif param.type == "curve":
        knots = ",".join(f"{number:g}" for knot in param.default for number in knot)
        make, kind = bpy.props.StringProperty, {"default": knots}
    else:
        make, kind = bpy.props.StringProperty, {"default": param.default}
    unit = {"radius": " (radii)", "angle": " (radians)", "time": " (seconds)"}.get(param.unit, "")
    return make(name=param.name, description=(param.help + unit).rstrip("."), **kind)


def _group(brush: burin.BrushInfo) -> type:
    properties = {param_of(param.id): _property(param) for param in brush.params}
    name = "BURIN_PG_" + group_of(brush.id)
    return type(name, (bpy.types.PropertyGroup,), {"__annotations__": properties})


def _settings_group(shown: list[burin.BrushInfo], groups: list[type]) -> type:
    items = [(brush.id, brush.name, brush.help.rstrip(".")) for brush in shown]
    default = "org.burin.groove" if any(brush.id == "org.burin.groove" for brush in shown) else None
    properties = {
        "brush": bpy.props.EnumProperty(name="Brush", items=items, default=default),
        "radius": bpy.props.FloatProperty(
            name="Radius", description="Half the width of strokes, in the world", default=0.1, min=1e-6, subtype="DISTANCE"
        ),
        "strength": bpy.props.FloatProperty(
            name="Strength", description="Factor on what the brush does", default=1, soft_min=-1, soft_max=2
        ),
        "follow": bpy.props.FloatProperty(
            name="Follow", description="How much of the relief strokes feel", default=0, min=0, max=1
        ),
        "pressure_strength": bpy.props.BoolProperty(name="Strength by Pressure", default=True),
        "pressure_radius": bpy.props.BoolProperty(name="Radius by Pressure", default=False),
        "mirror": bpy.props.BoolVectorProperty(
            name="Mirror", description="Mirror strokes along axes of the world, at the object's origin", size=3
        ),
        "record": bpy.props.StringProperty(
            name="Record to", description="Folder of .stroke files, one for each stroke; empty: none", subtype="DIR_PATH"
        ),
        **{
            group_of(brush.id): bpy.props.PointerProperty(type=group) for brush, group in zip(shown, groups)
        },
    }
    return type("BURIN_PG_settings", (bpy.types.PropertyGroup,), {"__annotations__": properties})


def chosen(settings: Any) -> burin.BrushInfo:
    """The brush that a scene's settings name."""
    return brushes.library()[settings.brush]


def _param_value(value: Any, param: burin.ParamInfo) -> Any:
    if param.type == "file":
        return bpy.path.abspath(value)
    return tuple(value) if param.type == "colour" else value


def stroke_settings(settings: Any, pressure: bool) -> dict[str, Any]:
    """Keyword arguments of burin.Session.begin(), and what recordings have. Files that the user has not chosen are left out."""
    brush = chosen(settings)
    group = getattr(settings, group_of(brush.id))
    values = {param.id: _param_value(getattr(group, param_of(param.id)), param) for param in brush.params}
    files = {param.id for param in brush.params if param.type == "file"}
    driven = {"strength": settings.pressure_strength, "radius": settings.pressure_radius}
    return {
        "brush": brush.id,
        "radius": settings.radius,
        "strength": settings.strength,
        "follow": settings.follow,
        "params": {name: value for name, value in values.items() if value or name not in files},
        "dynamics": {target: ("pressure", [0, 0, 1, 1]) for target, drives in driven.items() if pressure and drives},
    }


def symmetry(settings: Any, origin: Any) -> dict[str, Any]:
    """The symmetry of strokes, which recordings do not have."""
    axes = "".join(axis for axis, on in zip("xyz", settings.mirror) if on)
    return {"mirror": axes, "symmetry_centre": tuple(origin)} if axes else {}


def register() -> None:
    shown = list(brushes.library())
    groups = [_group(brush) for brush in shown]
    _classes[:] = [*groups, _settings_group(shown, groups)]
    for made in _classes:
        bpy.utils.register_class(made)
    bpy.types.Scene.burin = bpy.props.PointerProperty(type=_classes[-1])


def unregister() -> None:
    del bpy.types.Scene.burin
    for made in reversed(_classes):
        bpy.utils.unregister_class(made)


def rebuild() -> None:
    """Shows brushes that scripts have added since."""
    unregister()
    register()
