"""The code of the activities of one agent, by its plan: what is loaded, how it runs, where there is none."""

from __future__ import annotations

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityError, ActivityFinder, Executable, has_code, kind_of
from aseme_dsl.runtime.activity.execution import Host
from aseme_dsl.runtime.chart.plan import ActivityInfo


@dataclass(frozen=True, slots=True)
class CodeOf:
    """What the plan says of an activity, with its code."""

    info: ActivityInfo
    code: type[Executable] | None
    """None where there is no code."""
    kind: str
    error: ActivityError | None
    """Why the activity cannot run."""

    @property
    def stands_in(self) -> bool:
        """Whether the code only stands in for code that is not there."""
        return getattr(self.code, "stands_in", False)


class PlanCode:
    """Finds the code of the activities of an agent's plan."""

    def __init__(self, agent: Host, find: ActivityFinder) -> None:
        self._agent = agent
        self.find = find
        """Where the code of activities is found."""
        self._infos = {info.name: info for info in agent.plan.activities}
        self._found: dict[str, CodeOf] = {}
        self._coded: dict[tuple[str, bool], bool] = {}
        """Whether an activity of a branch has code, for those that were asked for; with or without
        stand-ins."""

    def renew(self, find: ActivityFinder) -> None:
        """The agent has another plan now."""
        self.find = find
        self._infos = {info.name: info for info in self._agent.plan.activities}
        self._found.clear()
        self._coded.clear()

    def of(self, activity: str) -> CodeOf:
        """The code of an activity, loaded now if it was not; what cannot be loaded is an error in it."""
        found = self._found.get(activity)
        if found is None:
            found = self._load(activity)
            if found.error is None:
                self._found[activity] = found
        return found

    def _load(self, activity: str) -> CodeOf:
        info = self._info(activity)
        code: type[Executable] | None = None
        kind = info.kind
        error: ActivityError | None = None
        try:
            code = None if info.simulated or info.waits else self.find(activity)
            if code is not None:
                code = code if has_code(code) else None
                kind = info.kind if code is None else kind_of(code, info.kind)
        except ActivityError as raised:
            error = raised
        return CodeOf(info, code, kind, error)

    def has_code(self, activity: str) -> bool:
        """Whether there is code for an activity; code that cannot be loaded counts, and fails at its
        start."""
        try:
            info = self._info(activity)
            return not info.simulated and not info.waits and has_code(self.find(activity))
        except ActivityError:
            return True

    def has_code_in(self, branch: str, *, or_stand_in: bool) -> bool:
        """Whether an activity of a protocol branch has code, or else one that stands in for code."""
        key = branch, or_stand_in
        if key not in self._coded:
            self._coded[key] = any(
                (self.has_code(name := item.activity or "") and (or_stand_in or not self.of(name).stands_in))
                or self._agent.callback(item.label) is not None
                for item in self._agent.plan.activities_inside.get(branch, ())
            )
        return self._coded[key]

    def is_simulated(self, branch: str) -> bool:
        """Whether the activities of a protocol branch are declared to have no code."""
        inside = self._agent.plan.activities_inside.get(branch, ())
        return all(self._info(item.activity or "").simulated for item in inside)

    def in_threads(self) -> int:
        """How many of the plan's activities can run in threads at once."""
        threads: dict[str, bool] = {}
        labels: list[str] = []
        for state in self._agent.plan.states:
            name = state.activity
            if name is not None:
                if name not in threads:
                    found = self.of(name)
                    threads[name] = found.code is not None and found.kind == "thread"
                if threads[name]:
                    labels.append(state.label)
        return self._agent.plan.at_once(frozenset(labels))

    def _info(self, activity: str) -> ActivityInfo:
        return self._infos.get(activity) or ActivityInfo(activity)


__all__ = ["CodeOf", "PlanCode"]
