"""What vertices of meshes have, as arrays that sessions take: positions, colours and masks. A session's colours are those of
the mesh's active colour attribute, linear red, green, blue and alpha; its masks are what Blender's sculpt mask leaves free."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import bmesh
import numpy as np

from . import mesh_io

NAMES = ("positions", "colours", "masks")


class Unfit(Exception):
    """A line that tells why a mesh cannot be painted on."""


def of_outputs(outputs: set[str]) -> list[str]:
    """What brushes with these outputs change. Positions are always among it."""
    named = zip(NAMES, ("displacement", "colour", "mask"))
    return [name for name, output in named if name == "positions" or output in outputs]


@dataclass(frozen=True)
class Values:
    """Values of all vertices."""

    stored: mesh_io.Floats | None
    """As the mesh has them, colours brighter than 1 too; None for those that painting would begin with."""
    known: mesh_io.Floats
    """As sessions take them."""


def read(name: str, mesh: Any, blank: bool = False) -> Values | None:
    """The values of a mesh. Where it has none: None, or with `blank` what painting begins with, white and free. Raises
    Unfit."""
    if name == "positions":
        positions = mesh_io.read_positions(mesh)
        return Values(positions, positions)
    stored = _read_colours(mesh) if name == "colours" else _read_masks(mesh)
    if stored is not None:
        clipped = np.clip(stored, 0, 1)
        return Values(stored, clipped if name == "colours" else 1 - clipped)
    shape = (len(mesh.vertices), 4) if name == "colours" else (len(mesh.vertices),)
    return Values(None, np.ones(shape, np.float32)) if blank else None


def write(name: str, mesh: Any, shown: mesh_io.Floats, before: Values) -> None:
    """Sets what is shown. Where that is as before the mesh keeps what it had to the bit. Where it has no colours or masks
    it gets them."""
    if name == "positions":
        mesh_io.write_positions(mesh, shown)
    elif name == "colours":
        _write_colours(mesh, _merged(shown, shown, before))
    else:
        _write_masks(mesh, _merged(1 - shown, shown, before))


def _merged(values: mesh_io.Floats, shown: mesh_io.Floats, before: Values) -> mesh_io.Floats:
    """The values of vertices of which those that are shown differ from before; of others what the mesh had."""
    if before.stored is None:
        return values
    same = shown == before.known
    return np.where(same.all(axis=1, keepdims=True) if same.ndim == 2 else same, before.stored, values)


def restore(name: str, mesh: Any, before: Values) -> None:
    """Sets what the mesh had, and takes an attribute of colours away that write() has added."""
    if before.stored is not None:
        write(name, mesh, before.known, before)
    elif name == "colours" and mesh.color_attributes.active_color:
        mesh.color_attributes.remove(mesh.color_attributes.active_color)
        mesh.update()


def _read_colours(mesh: Any) -> mesh_io.Floats | None:
    attribute = mesh.color_attributes.active_color
    if not attribute:
        return None
    if attribute.domain != "POINT":
        raise Unfit(f"the colour attribute {attribute.name} is of face corners; convert it to vertices to paint on it")
    colours = np.empty(4 * len(mesh.vertices), np.float32)
    attribute.data.foreach_get("color", colours)
    return colours.reshape(-1, 4)


def _write_colours(mesh: Any, colours: mesh_io.Floats) -> None:
    attribute = mesh.color_attributes.active_color
    if not attribute:
        attribute = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
        mesh.color_attributes.active_color = attribute
    attribute.data.foreach_set("color", np.ascontiguousarray(colours, np.float32).ravel())
    mesh.update()


def _mask_data(mesh: Any) -> Any:
    """The sculpt mask, of Blender before 4.1 and after; None where there is none."""
    if hasattr(mesh, "vertex_paint_masks"):
        return mesh.vertex_paint_masks[0].data if len(mesh.vertex_paint_masks) else None
    attribute = mesh.attributes.get(".sculpt_mask")
    return attribute.data if attribute else None


def _add_mask(mesh: Any) -> None:
    if not hasattr(mesh, "vertex_paint_masks"):
        mesh.attributes.new(".sculpt_mask", "FLOAT", "POINT")
        return
    # Blender before 4.1 makes it nowhere else.
    edited = bmesh.new()
    edited.from_mesh(mesh)
    edited.verts.layers.paint_mask.verify()
    edited.to_mesh(mesh)
    edited.free()


def _read_masks(mesh: Any) -> mesh_io.Floats | None:
    data = _mask_data(mesh)
    if data is None:
        return None
    masked = np.empty(len(mesh.vertices), np.float32)
    data.foreach_get("value", masked)
    return masked


def _write_masks(mesh: Any, masked: mesh_io.Floats) -> None:
    if _mask_data(mesh) is None:
        _add_mask(mesh)
    _mask_data(mesh).foreach_set("value", np.ascontiguousarray(masked, np.float32))
    mesh.update()
