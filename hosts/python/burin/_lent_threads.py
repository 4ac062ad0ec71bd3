"""Threads that an application lends to the library, which otherwise has its own."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

Run = Callable[[Callable[[int], None], int], object]
"""run(task, count) calls task(number) for each number below count, on any threads, and returns when all calls have."""

UNDONE = "the application has not run all tasks"
"""How the library's error begins that a function causes which leaves tasks."""


class _Tasks:
    """The tasks of one loop, which are over when the library's call returns: each is done at most once, and none later."""

    def __init__(self, task: Any, tasks: int | None, count: int) -> None:
        self._task, self._tasks = task, tasks
        self._open = set(range(count))
        self._running = 0
        self._changed = threading.Condition()

    def __call__(self, number: int) -> None:
        with self._changed:
            if number not in self._open:
                return
            self._open.remove(number)
            self._running += 1
        self._task(self._tasks, number)
        with self._changed:
            self._running -= 1
            self._changed.notify_all()

    def close(self) -> bool:
        """Waits for those that run; returns whether all are done."""
        with self._changed:
            done = not self._open
            self._open.clear()
            self._changed.wait_for(lambda: not self._running)
        return done


class LentThreads:
    """A function for burin_library_options.run."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._fault: BaseException | None = None

    def __call__(self, _user: int | None, task: Any, tasks: int | None, count: int) -> None:
        lent = _Tasks(task, tasks, count)
        try:
            self._run(lent, count)
        except BaseException as fault:  # none may cross C
            if lent.close():
                raise  # to sys.unraisablehook: the library has what it wants
            self._fault = fault
        finally:
            lent.close()

    def take_fault(self, text: str) -> BaseException | None:
        """What the function raised, if the text of an error tells of it."""
        fault, self._fault = self._fault, None
        return fault if UNDONE in text else None
