"""Real activities: where their code runs in real time, and what becomes of one that is cancelled."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.driver.run_state import RunState
from aseme_dsl.runtime.ports import Complain
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.time.timers import Timer
from aseme_dsl.runtime.workers.threads import Threads

if TYPE_CHECKING:
    from pathlib import Path

    from aseme_dsl.runtime.activity.execution import Execution
    from aseme_dsl.runtime.driver.real_loop import RealLoop
    from aseme_dsl.runtime.version.versions import VersionFiles
    from aseme_dsl.runtime.workers.processes import Processes


class RealActivities:
    """The activities that run: in threads, in an event loop and in processes of their own."""

    def __init__(
        self,
        options: RealTime,
        path: Sequence[Path],
        names: Mapping[str, str],
        code: VersionFiles | None,
        state: RunState,
        after: Callable[[int, Callable[[], None]], Timer],
        complain: Complain,
    ) -> None:
        """`path`, `names` and `code` are those of the driver; `after` makes a call after so many ns."""
        self._options = options
        self._path = tuple(path)
        self._names = dict(names)
        self._code = code
        self._state = state
        self._after = after
        self._complain = complain
        self._live: dict[Execution, Timer | None] = {}
        self._making = threading.Lock()
        self._threads = Threads(options.threads, self.ended, complain)
        self._loop: RealLoop | None = None
        self._processes: Processes | None = None

    def renew(self, path: Sequence[Path], names: Mapping[str, str], code: VersionFiles | None) -> None:
        """Activities of another version begin now: their processes import what they need from here."""
        with self._making:
            self._path = tuple(path)
            self._names = dict(names)
            self._code = code
            if self._processes is not None:
                self._processes.renew(self._path, self._names, code)

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity where its kind belongs."""
        with self._making:
            self._live[execution] = None
        if execution.kind == "async":
            self._event_loop().launch(execution)
        elif execution.kind == "process":
            self._worker_processes().launch(execution)
        else:
            self._threads.launch(execution)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left, and see to it that it does not stay for ever."""
        self._tell_of_cancellation(execution)
        self._give_time(execution)

    def _give_time(self, execution: Execution) -> None:
        timer = self._after(self._options.cancel_within, lambda: self._overdue(execution))
        with self._making:
            if execution in self._live:
                self._live[execution] = timer
            else:
                timer.cancel()

    def wait(self, execution: Execution, duration: int) -> None:
        """Let time pass in the activity's own thread."""
        self._threads.wait(execution, duration)

    def ended(self, execution: Execution) -> None:
        """The code of an activity has come to its end, and its agent knows."""
        with self._making:
            timer = self._live.pop(execution, None)
        if timer is not None:
            timer.cancel()
        if self._state.ends is not None:
            self._state.tell()

    def _event_loop(self) -> RealLoop:
        from aseme_dsl.runtime.driver.real_loop import RealLoop

        with self._making:
            if self._loop is None:
                self._loop = RealLoop(self.ended, self._complain)
            return self._loop

    def _worker_processes(self) -> Processes:
        from aseme_dsl.runtime.workers.processes import Processes

        with self._making:
            if self._processes is None:
                options = self._options
                self._processes = Processes(
                    self._path,
                    options.processes,
                    options.process_memory,
                    self.ended,
                    self._complain,
                    self._names,
                    self._code,
                )
            return self._processes

    def _tell_of_cancellation(self, execution: Execution) -> None:
        if execution.kind == "async":
            self._event_loop().cancel(execution)
        elif execution.kind == "process":
            self._worker_processes().cancel(execution)
        else:
            self._threads.cancel(execution)

    def _overdue(self, execution: Execution) -> None:
        """A cancelled activity has not returned in time: report it, and get rid of it where that can be."""
        with self._making:
            if execution not in self._live:
                return
        text = f"has not ended {shown(self._options.cancel_within)} after it was cancelled"
        if execution.kind == "process":
            if self._worker_processes().kill(execution, f"it {text}, and was killed"):
                self._report(execution, f"{text}: its process is killed")
            else:
                self._give_time(execution)
            return
        place = ""
        if execution.kind == "async":
            self._tell_of_cancellation(execution)
        else:
            place = self._threads.give_up(execution)
        self._report(execution, f"{text}{place}")

    def _report(self, execution: Execution, text: str) -> None:
        name = execution.activity
        self._complain(f"activity {name} {text}", execution.agent, name)

    # ---- the run -----------------------------------------------------------------------------

    def have_threads(self, most: int) -> None:
        """Have so many threads: none is made in the midst of the run."""
        self._threads.have(most)

    def look_for_stuck(self, patience: int) -> None:
        """Report, once, where nothing has moved for `patience` looks."""
        if self._loop is not None:
            self._loop.look(patience)
        self._threads.look()
        if self._processes is not None:
            self._processes.look()

    def unfinished(self) -> list[Execution]:
        """The activities that have not ended, by agent and label."""
        with self._making:
            return sorted(self._live, key=lambda execution: (execution.agent, execution.label))

    def close(self, rest: Callable[[], float]) -> None:
        """End all threads, processes and the event loop; `rest` gives how long that may still take."""
        pools = [pool for pool in (self._threads, self._processes, self._loop) if pool is not None]
        for pool in pools:
            pool.close()
        for pool in pools:
            pool.join(rest)
