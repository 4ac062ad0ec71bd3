"""Samples of the pen."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

SAMPLE = np.dtype(
    [
        ("struct_size", "<u4"),
        ("pressure", "<f4"),
        ("time", "<f8"),
        ("position", "<f8", 3),
        ("direction", "<f8", 3),
        ("tilt", "<f4", 2),
        ("twist", "<f4"),
        ("barrel", "<u4"),
    ]
)
"""A sample of the pen, the bytes of burin_sample; samples() fills it.

pressure 0..1; time in seconds, not falling; position in object units, near the surface or where the sample's ray starts;
direction of the ray, zeros: none; tilt in radians from upright, towards +x and +y; twist in radians;
barrel 1 while a button at the pen's side is held, which a Recorder keeps and a Session does not use."""


def samples(
    position: ArrayLike,
    *,
    direction: ArrayLike | None = None,
    time: ArrayLike | None = None,
    pressure: ArrayLike | None = None,
    tilt: ArrayLike | None = None,
    twist: ArrayLike | None = None,
    barrel: ArrayLike | None = None,
) -> NDArray[np.void]:
    """Samples of the pen, an array of shape (n,) and type SAMPLE.

    position and direction have the shape (n, 3) or (3,), tilt (n, 2) or (2,), the others (n,) or a number. What the pen does
    not report is left out, and not named in the `fields` of the stroke.

    >>> samples([[0, 0, 1], [0.1, 0, 1]], pressure=0.5)["pressure"]
    array([0.5, 0.5], dtype=float32)
    """
    places = np.atleast_2d(np.asarray(position, np.float64))
    made = np.zeros(len(places), SAMPLE)
    made["struct_size"] = SAMPLE.itemsize
    made["position"] = places
    for name, values in (
        ("direction", direction),
        ("time", time),
        ("pressure", pressure),
        ("tilt", tilt),
        ("twist", twist),
        ("barrel", barrel),
    ):
        if values is not None:
            made[name] = values
    return made


def as_samples(position: Any, pen: dict[str, ArrayLike]) -> NDArray[np.void]:
    """Samples one after the other: the array itself if it is of type SAMPLE and has no gaps."""
    given: NDArray[np.void] = position if getattr(position, "dtype", None) == SAMPLE else samples(position, **pen)
    return np.atleast_1d(np.ascontiguousarray(given))
