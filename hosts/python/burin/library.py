"""Libraries of brushes."""

from __future__ import annotations

import ctypes
import logging
import os
import weakref
from collections.abc import Callable, Iterator

from . import _c
from ._application_brushes import Factory
from ._lent_threads import LentThreads, Run
from .brush import Brush
from .brushinfo import BrushInfo, brush_info
from .errors import NotFound

Log = Callable[[int, str], None]

_LEVELS = {1: logging.DEBUG, 2: logging.INFO, 3: logging.WARNING, 4: logging.ERROR}


def _log_function(log: Log | None) -> Callable[[int | None, int, bytes], None]:
    """Lines of brushes and of the library, from any thread."""
    logger = logging.getLogger("burin")

    def write(_user: int | None, severity: int, line: bytes) -> None:
        level, text = _LEVELS.get(severity, logging.INFO), line.decode(errors="replace")
        if log:
            log(level, text)
        else:
            logger.log(level, "%s", text)

    return write


class Library:
    """Brushes that sessions draw with.

    A library is for one thread, on which brushes are loaded, created and destroyed: the main thread, if brushes are to
    find what the plugin ABI promises.

    >>> library = Library()
    >>> library["org.burin.groove"].name
    'Groove'
    """

    def __init__(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        stock: bool = True,
        log: Log | None = None,
        isolate: bool = False,
        run: Run | None = None,
        threads: int | None = None,
    ) -> None:
        """Loads brushes from `path` as load() does; without a path the stock brushes, unless `stock` is False.

        `log` receives the level of the module logging and a line, on any thread, also on several at once; it must not
        call this module. Without it lines go to the logger "burin". With `isolate` the brushes of modules run in processes
        of their own, so that one that crashes or hangs costs its stroke only; those written in Python do not.

        `run` lends threads: run(task, count) calls task(number) for each number below count, on about `threads` threads of
        the application's, by default one for each processor, and returns when all calls have. The library then starts none. What `run` raises makes the call fail.

        >>> from concurrent.futures import ThreadPoolExecutor
        >>> pool = ThreadPoolExecutor(2)
        >>> library = Library(run=lambda task, count: list(pool.map(task, range(count))), threads=2)
        """
        _c.version()
        self._log = _c.LogFunction(_log_function(log))
        handle = ctypes.c_void_p()
        self._lent = LentThreads(run) if run else None
        self._run = _c.RunFunction(self._lent or 0)
        options = _c.LibraryOptions(isolate, self._log, None, run=self._run, run_threads=threads or os.cpu_count() or 1)
        _c.call("burin_library_create", options, handle)
        self._handle = handle
        self._factories: list[Factory] = []
        # The brushes and the log are called until the last session is destroyed, which keeps the library.
        self._finalizer = weakref.finalize(self, _destroy, handle, (self._log, self._run), self._factories)
        if path is not None or stock:
            self.load(path)

    def load(self, path: str | os.PathLike[str] | None = None) -> None:
        """Loads a module NAME.burin or all of a folder; None: from the folders of the environment variable
        BURIN_PLUGIN_PATH, and the stock brushes beside the library. A module of a folder that cannot be loaded is passed
        over, see `refused`; a module by itself raises Error."""
        _c.call("burin_library_load", self._handle, None if path is None else os.fsencode(path))

    def reload(self, path: str | os.PathLike[str]) -> None:
        """Loads a module anew, from its file as it is now. The next stroke of every session draws with it."""
        _c.call("burin_library_reload", self._handle, os.fsencode(path))

    def add(self, *brushes: type[Brush], name: str | None = None) -> None:
        """Adds brushes that are written in Python. Those of the same `name`, by default that of the first class, are
        replaced: a cell of a notebook may be run again. Raises Error for what the plugin ABI does not allow, such as
        parameters whose default is out of range."""
        name = name or f"{brushes[0].__module__}.{brushes[0].__qualname__}"
        factory = Factory(brushes)
        self._factories.append(factory)  # also a refused one: the library may look at it until the call returns
        _c.call("burin_library_add", self._handle, name.encode(), factory.address)

    @property
    def brushes(self) -> tuple[BrushInfo, ...]:
        """All brushes, in the order of loading."""
        return tuple(self)

    def __iter__(self) -> Iterator[BrushInfo]:
        for index in range(len(self)):
            yield brush_info(_c.lib.burin_library_brush(self._handle, index).contents)

    def __len__(self) -> int:
        return int(_c.lib.burin_library_brush_count(self._handle))

    def __getitem__(self, id: str) -> BrushInfo:
        """The brush with this id. Raises NotFound if there is none."""
        for brush in self:
            if brush.id == id:
                return brush
        raise NotFound(f"no brush {id!r}; there are: {', '.join(brush.id for brush in self) or 'none'}")

    def __contains__(self, id: object) -> bool:
        return any(brush.id == id for brush in self)

    @property
    def refused(self) -> tuple[str, ...]:
        """Why modules of folders were passed over, a line each."""
        count = _c.lib.burin_library_refused_count(self._handle)
        return tuple(_c.lib.burin_library_refused(self._handle, index).decode() for index in range(count))

    def _take_fault(self, text: str) -> BaseException | None:
        """The exception of Python that a text of the library tells of: that of a brush, or of lent threads."""
        faults = [factory.take_fault(text) for factory in self._factories]
        if self._lent:
            faults.append(self._lent.take_fault(text))
        return next((fault for fault in faults if fault), None)


def _destroy(handle: ctypes.c_void_p, _functions: object, factories: list[Factory]) -> None:
    _c.lib.burin_library_destroy(handle)
    for factory in factories:
        factory.release()
