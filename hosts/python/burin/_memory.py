"""Arrays of numpy over memory that is the library's."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


class _Memory:
    """What numpy makes an array of, without a copy. The array keeps it alive, and so `owner`."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(
        self,
        address: int,
        shape: tuple[int, ...],
        strides: tuple[int, ...] | None,
        kind: np.dtype[Any],
        writable: bool,
        owner: object,
    ) -> None:
        self.owner = owner
        self.__array_interface__ = {
            "version": 3,
            "data": (address, not writable),
            "shape": shape,
            "strides": strides,
            "typestr": kind.str,
            "descr": kind.descr,
        }


def view(
    address: int,
    shape: tuple[int, ...],
    strides: tuple[int, ...] | None = None,
    kind: np.typing.DTypeLike = np.float32,
    writable: bool = False,
    owner: object = None,
) -> NDArray[Any]:
    """An array at an address. `strides` are in bytes; None: no gaps. `owner` lives as long as the array."""
    if not address:
        return np.empty(shape, kind)
    return np.asarray(_Memory(address, shape, strides, np.dtype(kind), writable, owner))
