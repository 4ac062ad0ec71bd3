"""What vertices of meshes have, as arrays that sessions take: positions, colours and masks. A session's colours are those of
the mesh's active colour attribute, linear red, green, blue and alpha; its masks are what Blender's sculpt mask leaves free."""

from __future__ import annotations

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


def blank(name: str, mesh: Any) -> mesh_io.Floats:
    """What painting begins with where a mesh has no colours or masks: white, and free."""
    shape = (len(mesh.vertices), 4) if name == "colours" else (len(mesh.vertices),)
    return np.ones(shape, np.float32)


def read(name: str, mesh: Any) -> mesh_io.Floats | None:
    """The values of all vertices, or None where the mesh has none. Raises Unfit."""
    if name == "positions":
        return mesh_io.read_positions(mesh)
    return _read_colours(mesh) if name == "colours" else _read_masks(mesh)


def write(name: str, mesh: Any, values: mesh_io.Floats) -> None:
    """Sets the values of all vertices. Where the mesh has no colours or masks it gets them."""
    if name == "positions":
        mesh_io.write_positions(mesh, values)
    elif name == "colours":
        _write_colours(mesh, values)
    else:
        _write_masks(mesh, values)


def stored_colours(mesh: Any) -> mesh_io.Floats | None:
    """The active colours as the mesh has them, to the bit, or None."""
    attribute = mesh.color_attributes.active_color
    return _stored(attribute, mesh) if attribute else None


def restore_colours(mesh: Any, colours: mesh_io.Floats | None) -> None:
    """Sets what stored_colours() has told, and takes an attribute away that write() has added."""
    attribute = mesh.color_attributes.active_color
    if not attribute:
        return
    if colours is None:
        mesh.color_attributes.remove(attribute)
    else:
        attribute.data.foreach_set("color", colours.ravel())
    mesh.update()


def _read_colours(mesh: Any) -> mesh_io.Floats | None:
    attribute = mesh.color_attributes.active_color
    if not attribute:
        return None
    if attribute.domain != "POINT":
        raise Unfit(f"the colour attribute {attribute.name} is of face corners; convert it to vertices to paint on it")
    return np.clip(_stored(attribute, mesh), 0, 1)


def _stored(attribute: Any, mesh: Any) -> mesh_io.Floats:
    """The colours of an attribute, which may be brighter than 1."""
    colours = np.empty(4 * len(mesh.vertices), np.float32)
    attribute.data.foreach_get("color", colours)
    return colours.reshape(-1, 4)


def _write_colours(mesh: Any, colours: mesh_io.Floats) -> None:
    """Colours that are brighter than 1 stay where nobody has painted."""
    attribute = mesh.color_attributes.active_color
    if not attribute:
        attribute = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
        mesh.color_attributes.active_color = attribute
    stored = _stored(attribute, mesh)
    painted = (np.clip(stored, 0, 1) != colours).any(axis=1)
    stored[painted] = colours[painted]
    attribute.data.foreach_set("color", stored.ravel())
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
    return 1 - np.clip(masked, 0, 1)


def _write_masks(mesh: Any, masks: mesh_io.Floats) -> None:
    if _mask_data(mesh) is None:
        _add_mask(mesh)
    _mask_data(mesh).foreach_set("value", np.ascontiguousarray(1 - masks, np.float32))
    mesh.update()
