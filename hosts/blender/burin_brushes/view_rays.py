"""Rays of a view through its pixels. Nothing here imports Blender."""

from __future__ import annotations

from typing import Any

import burin
import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


def drawing_camera(view: Any, projection: Any, size: tuple[int, int], corners: Any) -> burin.Camera:
    """The camera of a region of Blender, whose matrices these are, with other depths: rays depend on those only by rounding.

    A perspective view gets no far plane, and a parallel one reaches from the nearest to the farthest of `corners`, those of a
    box in the world around what is drawn on. So the product of the matrices can be inverted without loss, and the rays have
    the bits here and in `burin replay`, which inverts it by other means.
    """
    view, projection = np.array(view, np.float64), np.array(projection, np.float64)
    if projection[3, 2] != 0:
        near = projection[2, 3] / (projection[2, 2] - 1)
        projection[2] = 0, 0, -1, -2 * near
    else:
        depths = -(np.asarray(corners, np.float64) @ view[2, :3] + view[2, 3])
        margin = 0.01 * (depths.max() - depths.min()) + 1e-6
        near, far = depths.min() - margin, depths.max() + margin
        projection[2] = 0, 0, -2 / (far - near), -(far + near) / (far - near)
    return burin.Camera(view, projection, *size)


def pixel_ray(camera: burin.Camera, x: float, y: float) -> tuple[Vector, Vector]:
    """Origin and direction of the ray through a place in pixels from the top left corner, with pixel centres at .5, as
    stroke/camera.h of Burin has it."""
    to_world = np.linalg.inv(camera.projection @ camera.view)
    across, up = 2 * x / camera.width - 1, 1 - 2 * y / camera.height
    near, far = to_world @ (across, up, -1, 1), to_world @ (across, up, 1, 1)
    origin = near[:3] / near[3]
    direction = far[:3] - far[3] * origin
    direction /= np.linalg.norm(direction)
    return origin.astype(np.float32).astype(np.float64), direction.astype(np.float32).astype(np.float64)
