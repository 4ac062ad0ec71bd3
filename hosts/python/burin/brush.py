"""Brushes that are written in Python, for prototypes.

    class Ripple(burin.Brush):
        id = "org.example.ripple"
        inputs = ("t", "d", "radius")
        height = burin.FloatParam(0.1, hard=(0, 1), unit="radius", dynamic=True)

        def evaluate(self, batch):
            rim = burin.smooth_step(1 - batch.distance() / batch.radius)
            batch.up = batch[self.height] * batch.radius * rim * np.sin(2 * np.pi * batch.t / batch.radius)

    library.add(Ripple)

The rules of burin/abi/brush.h hold. `evaluate` takes a batch of 1 to about a thousand nodes as arrays and computes each
node by itself; it may be called again for the same nodes, in any batches and any order. The library calls it on its own
threads, several at once, each holding the interpreter's lock: what it writes besides the outputs it must lock itself.
It must not call a session. Results have the same bits on every machine only if the functions of numpy that it uses do.
"""

from __future__ import annotations

from typing import Any, ClassVar, Generic, Sequence, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._evaluation import Batch, Start
from .errors import InvalidArgument

Floats = NDArray[np.float32]
V = TypeVar("V")
B = TypeVar("B", bound="Brush")


class Param(Generic[V]):
    """A parameter of a brush: an attribute of its class. `batch[self.NAME]` is its value."""

    kind: ClassVar[int]
    id: str = ""

    def __init__(self, default: Any, name: str | None = None, help: str = "", dynamic: bool = False) -> None:
        self.default = default
        self.name = name
        self.help = help
        self.dynamic = dynamic

    def __set_name__(self, owner: type, name: str) -> None:
        self.id = name
        self.name = self.name or name.replace("_", " ").capitalize()


class FloatParam(Param[Floats]):
    """A number. `hard`: the values that are taken; `soft`: the range of a slider, by default the hard one. `unit`: "none",
    "radius" (multiples of the stroke's radius), "length" (object units), "angle" (radians) or "time" (seconds). `dynamic`:
    it may vary along the stroke with the pen. Its value in a batch is an array of shape (n,)."""

    kind = 1

    def __init__(
        self,
        default: float,
        *,
        hard: tuple[float, float],
        soft: tuple[float, float] | None = None,
        unit: str = "none",
        name: str | None = None,
        help: str = "",
        dynamic: bool = False,
    ) -> None:
        super().__init__(default, name, help, dynamic)
        self.hard, self.soft, self.unit = hard, soft or hard, unit


class IntParam(FloatParam):
    """A whole number, as FloatParam; its value is an array of floats."""

    kind = 2


class BoolParam(Param[Floats]):
    """True or False. Its value in a batch is an array of shape (n,), 0 or 1."""

    kind = 3

    def __init__(self, default: bool, *, name: str | None = None, help: str = "", dynamic: bool = False) -> None:
        super().__init__(default, name, help, dynamic)


class ChoiceParam(Param[Floats]):
    """One of several ids. Its value in a batch is an array of shape (n,), the number of the choice from 0."""

    kind = 4

    def __init__(
        self,
        choices: Sequence[str],
        default: str | None = None,
        *,
        name: str | None = None,
        help: str = "",
        dynamic: bool = False,
    ) -> None:
        super().__init__(default if default is not None else choices[0], name, help, dynamic)
        if self.default not in choices:
            raise InvalidArgument(f"the default {self.default!r} is none of the choices {', '.join(choices)}")
        self.choices = tuple(choices)


class ColourParam(Param[Floats]):
    """Linear red, green and blue and coverage, 0..1. Its value in a batch is an array of shape (n, 4)."""

    kind = 5

    def __init__(
        self, default: tuple[float, float, float, float], *, name: str | None = None, help: str = "", dynamic: bool = False
    ) -> None:
        super().__init__(default, name, help, dynamic)


class FileParam(Param[str]):
    """A path. `default`: "" when none is needed, None when the user must choose one. Its value is a text."""

    kind = 6

    def __init__(self, default: str | None = None, *, name: str | None = None, help: str = "") -> None:
        super().__init__(default, name, help)


class CurveParam(Param[Floats]):
    """Knots (x, y), x increasing, linear between them and constant beyond the ends. Its value has the shape (knots, 2);
    np.interp(x, *value.T) evaluates it."""

    kind = 7

    def __init__(self, default: Sequence[tuple[float, float]], *, name: str | None = None, help: str = "") -> None:
        super().__init__(default, name, help)


class TextParam(Param[str]):
    """A line of text. Its value is the text."""

    kind = 8

    def __init__(self, default: str = "", *, name: str | None = None, help: str = "") -> None:
        super().__init__(default, name, help)


class Brush:
    """The base of brushes that are written in Python: see the module's text. An object is made for each session that
    draws with the brush."""

    id: ClassVar[str]
    """In reverse DNS, "org.example.ripple": unique among all brushes."""
    name: ClassVar[str] = ""
    """For people; by default the name of the class."""
    vendor: ClassVar[str] = "Python"
    version: ClassVar[str] = "1.0.0"
    help: ClassVar[str] = ""
    """One or two sentences."""
    inputs: ClassVar[Sequence[str]] = ("t", "d", "radius")
    """What evaluate() reads, of burin.INPUTS."""
    outputs: ClassVar[Sequence[str]] = ("displacement",)
    """What evaluate() writes: "displacement", "mask", "colour"."""
    overlap: ClassVar[str] = "strongest"
    """How visits to one place are combined: "strongest", "latest", "max", "min", "add" or "average"."""
    features: ClassVar[Sequence[str]] = ()
    """Tags for people and hosts, see burin/abi/brush.h."""

    def begin(self, start: Start) -> Any:
        """Begins a stroke: may refuse it with an exception, ask for more than one pass (`start.passes`), and return what
        evaluate() finds as `batch.state`."""
        return None

    def evaluate(self, batch: Batch) -> None:
        """Writes the outputs of every node of the batch, which are zero, for colours and masks those before the stroke."""
        raise NotImplementedError(f"{type(self).__qualname__} has no evaluate()")

    def end(self, state: Any) -> None:
        """Ends a stroke."""

    @classmethod
    def params(cls) -> list[Param[Any]]:
        """The parameters, in the order in which classes declare them, bases first."""
        found: dict[str, Param[Any]] = {}
        for base in reversed(cls.__mro__):
            found.update({name: value for name, value in vars(base).items() if isinstance(value, Param)})
        return list(found.values())


def smooth_step(x: Any) -> Any:
    """0 below 0, 1 above 1, and between them 3x² - 2x³, which has no slope at both.

    >>> smooth_step(np.array([-1, 0.5, 2]))
    array([0. , 0.5, 1. ])
    """
    x = np.clip(x, 0, 1)
    return x * x * (3 - 2 * x)
