"""Modules: what runs at its own frequency beside an agent's statechart (P2, section 2: Monas modules).

A module is one object for as long as its agent plays; its `execute` is called every period, from the agent's
first step on. It sees the agent's own blackboard, that of the root, and publishes as activities do. Releases
lie on a grid that begins with the first: one that comes while the last has not returned is missed, counted
and never made up for. One that raises is recorded in the trace. A new object takes its place: after the first
failure at the next release, after further ones later. The agent continues.
"""

from __future__ import annotations

import importlib
from collections.abc import Generator
from contextlib import suppress
from functools import partial

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.activities import ActivityError, ActivityFinder, Executable, has_code, kind_of
from aseme_dsl.runtime.activity.execution import Execution, Host
from aseme_dsl.runtime.activity.executions import Executions
from aseme_dsl.runtime.activity.returning import frames_of, is_cancellation, reason_of
from aseme_dsl.runtime.chart.inputs import Start
from aseme_dsl.runtime.chart.plan import ModuleInfo
from aseme_dsl.runtime.time.clock import SECOND, shown
from aseme_dsl.runtime.time.timers import Timer

LONGEST_PAUSE = SECOND
"""How long a module that fails again and again pauses, if its period is not longer."""
LONG = 2 * SECOND
"""A release that has not returned after this time is reported."""


def code_of(info: ModuleInfo, find: ActivityFinder) -> type[Executable] | None:
    """The class of a module; None where there is none, or nothing in it.

    Raises:
        ActivityError: it cannot be imported, or does not run as the document says.
    """
    if info.target:
        module, _, name = info.target.partition(":")
        try:
            found = getattr(importlib.import_module(module), name)
        except Exception as error:
            raise ActivityError(f"module {info.name}: {info.target} cannot be imported: {error}") from error
        if not isinstance(found, type):
            raise ActivityError(f"module {info.name}: {info.target} is not a class")
    else:
        found = find(info.name)
    kind: type[Executable] | None = found
    if kind is None or not has_code(kind):
        return None
    kind_of(kind, info.kind)
    return kind


class _Code:
    """Makes the object of a module once, and gives it each time; a worker process makes its own."""

    def __init__(self, kind: type[Executable]) -> None:
        self.kind = kind
        self.made: Executable | None = None
        self.__module__ = kind.__module__
        self.__qualname__ = kind.__qualname__

    def __call__(self) -> Executable:
        if self.made is None:
            self.made = self.kind()
        return self.made


@dataclass(slots=True)
class _Module:
    info: ModuleInfo
    code: _Code
    kind: str
    origin: int = 0
    """The moment of the first release."""
    beats: int = 0
    missed: int = 0
    failures: int = 0
    """In a row."""
    resumes: int = 0
    """Until this moment it pauses, because it has failed."""
    current: Execution | None = None
    generator: Generator[object, None, object] | None = None
    timer: Timer | None = None
    was_reported: bool = False

    @property
    def every(self) -> int:
        assert self.info.every is not None  # the compiler sees to it
        return self.info.every


class Modules:
    """The modules of one agent. Called only while the agent is guarded, but for `check`."""

    def __init__(self, agent: Host, executions: Executions, find: ActivityFinder) -> None:
        self.agent = agent
        self._executions = executions
        self.has_begun = False
        self._find = find
        self._modules: dict[str, _Module] = {}
        self._generation = 1

    def begin(self) -> None:
        """Run every module for the first time; the root's blackboard is there."""
        self.has_begun = True
        now = self.agent.driver.clock.now()
        for info in self.agent.plan.modules:
            try:
                found = code_of(info, self._find)
            except ActivityError as error:
                self.agent.trace.fault(now, self.agent.name, str(error), activity=info.name)
                continue
            if found is None:
                text = f"module {info.name} has no code: it does not run"
                self.agent.trace.remark(now, self.agent.name, text, activity=info.name)
                continue
            module = _Module(info, _Code(found), kind_of(found, info.kind), origin=now)
            self._modules[info.name] = module
            self._trace(module, "begin", every=module.every)
        for module in self._modules.values():
            self._beat(module)

    def stop(self) -> None:
        """Cancel what runs, and run nothing more."""
        modules, self._modules = self._modules, {}
        for module in modules.values():
            if module.timer is not None:
                module.timer.cancel()
            if module.generator is not None:
                self._close(module)
            execution = module.current
            if execution is not None:
                execution.cancelled = True
                if execution.timer is not None:
                    execution.timer.cancel()
                if not execution.has_returned:
                    self.agent.driver.cancel(execution)
            self._trace(module, "end", beats=module.beats)

    def in_threads(self) -> int:
        """How many of the plan's modules run in threads."""
        count = 0
        for info in self.agent.plan.modules:
            with suppress(ActivityError):  # told when it begins
                code = code_of(info, self._find)
                count += code is not None and kind_of(code, info.kind) == "thread"
        return count

    def renew(self, find: ActivityFinder) -> None:
        """Continue under the agent's new plan, with new objects."""
        begun = self.has_begun
        self.forget(find)
        if begun:
            self.begin()

    def forget(self, find: ActivityFinder) -> None:
        """Stop; what the agent's new plan has begins with its first step."""
        self.stop()
        self.has_begun = False
        self._find = find
        self._generation += 1

    # ---- releases ----------------------------------------------------------------------------

    def _beat(self, module: _Module) -> None:
        """It is time for a module: run it, unless it still runs or pauses; then plan the next release."""
        if module.info.name not in self._modules or self.agent.over:
            return
        now = self.agent.driver.clock.now()
        if module.current is not None:
            module.missed += 1
            self._report_long(module, module.current, now)
        elif now >= module.resumes:
            self._run(module, now)
        passed = (now - module.origin) // module.every
        due = module.origin + (passed + 1) * module.every
        module.timer = self.agent.driver.at(due, partial(self._ring, module, due))

    def _ring(self, module: _Module, due: int) -> None:
        late = (self.agent.driver.clock.now() - due) // module.every  # who was late has missed some
        self.agent.errand(partial(self._come, module, late))

    def _come(self, module: _Module, late: int) -> None:
        module.missed += late
        self._beat(module)

    def _run(self, module: _Module, now: int) -> None:
        if module.missed:
            self._trace(module, "missed", beats=module.missed)
            module.missed = 0
        module.beats += 1
        module.was_reported = False
        agent = self.agent
        board = agent.chart.boards()[0]
        if board is None:  # the root is left: the agent is about to end
            return
        start = Start(agent.plan.states[0].label, module.info.name, module.beats)
        info, code = module.info, module.code
        execution = Execution(self, start, info, code, module.kind, module.beats, None, board, now)
        module.current = execution
        if module.kind == "process":
            execution.keeps = f"{agent.name}/{module.info.name}#{self._generation}"
        if module.info.takes is not None and agent.driver.clock.virtual:
            execution.opens = now + module.info.takes
            execution.timer = agent.driver.at(execution.opens, lambda: self._open(module, execution))
        if module.kind == "step":
            self._advance(module, execution)
        else:
            agent.driver.launch(execution)

    def _advance(self, module: _Module, execution: Execution) -> None:
        """Run a `step` module here: a generator continues to where it yields next."""
        error: BaseException | None = None
        try:
            if module.generator is None:
                made = module.code().execute(execution.context)
                module.generator = made if isinstance(made, Generator) else None
            if module.generator is not None:
                next(module.generator)
        except StopIteration:
            module.generator = None
        except BaseException as raised:
            module.generator = None
            error = raised
        self.returned(execution, error)

    def _close(self, module: _Module) -> None:
        generator, module.generator = module.generator, None
        try:
            assert generator is not None
            generator.close()
        except BaseException as error:
            self._trace(module, "crash", reason=reason_of(error), traceback=frames_of(error))

    def _report_long(self, module: _Module, execution: Execution, now: int) -> None:
        if now - execution.started >= LONG and not module.was_reported and not execution.has_returned:
            module.was_reported = True
            text = f"module {module.info.name} has not returned for {shown(LONG)}: it misses its releases"
            self.agent.trace.fault(now, self.agent.name, text, activity=module.info.name)

    # ---- what executions ask of their owner ----------------------------------------------------

    def check(self, execution: Execution, doing: c.Doing) -> None:
        """Refuse at once what means nothing; see `Executions.check`."""
        self._executions.check(execution, doing)

    def frozen(self, execution: Execution) -> c.Port:
        """The port of a context that keeps what its module sees just now."""
        return self._executions.frozen(execution)

    def returned(self, execution: Execution, error: BaseException | None) -> None:
        """A release has ended."""
        if execution.has_returned:
            return
        execution.has_returned = True
        execution.error = error
        module = self._modules.get(execution.activity)
        if module is None or module.current is not execution:  # the agent has stopped
            if error is not None and not is_cancellation(error):
                name = execution.activity
                self.agent.trace.write(
                    "module",
                    self.agent.driver.clock.now(),
                    agent=self.agent.name,
                    what="crash",
                    module=name,
                    reason=reason_of(error),
                    traceback=frames_of(error),
                )
        elif error is not None:
            self._failed(module, execution, error)
        elif execution.opens is None:
            self._ended(module, execution)

    def _failed(self, module: _Module, execution: Execution, error: BaseException) -> None:
        now = self.agent.driver.clock.now()
        pause = min(module.every * (2**module.failures - 1), max(LONGEST_PAUSE, module.every))
        module.failures = min(module.failures + 1, 32)
        module.resumes = now + pause
        module.code.made = None
        if execution.timer is not None:
            execution.timer.cancel()
        self._trace(
            module,
            "crash",
            reason=reason_of(error),
            traceback=frames_of(error),
            pause=pause or None,
            dropped=len(execution.held) or None,
        )
        module.current = None

    def _open(self, module: _Module, execution: Execution) -> None:
        """In virtual time, a release has lasted what it takes: what it did counts."""
        if execution.cancelled:
            return
        execution.opens = None
        held, execution.held = execution.held, []
        for doing in held:
            self.agent.requests.perform(execution, doing)
        if execution.has_returned:
            self.agent.errand(lambda: self._ended(module, execution))

    def _ended(self, module: _Module, execution: Execution) -> None:
        if module.current is not execution:
            return
        module.current = None
        module.failures = 0
        lasted = self.agent.driver.clock.now() - execution.started
        takes = module.info.takes
        if takes is not None and lasted > takes:
            self._trace(module, "overrun", takes=takes, lasted=lasted)

    def _trace(self, module: _Module, what: str, **members: object) -> None:
        agent = self.agent
        now = agent.driver.clock.now()
        agent.trace.write("module", now, agent=agent.name, what=what, module=module.info.name, **members)
