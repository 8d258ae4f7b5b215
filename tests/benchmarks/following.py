"""A small interpreter of descriptions, as SCXML reads them: what peers are expected to make of one."""

from __future__ import annotations

from benchmarks.behaviours.description import Behaviour, State, Transition
from benchmarks.peers.adapters.python_code import function, guard_function, statements
from benchmarks.peers.driving import blackboard


class Follower:
    """A running description."""

    def __init__(self, behaviour: Behaviour) -> None:
        self.bb = blackboard(behaviour)
        self.root = behaviour.root
        self.state = {item.name: item for item in behaviour.states}
        self.parent = {child.name: item for item in behaviour.states for child in item.children}
        self.active: dict[str, None] = {}
        self.enter(self.root)
        self.settle()

    def around(self, name: str) -> list[str]:
        """The states around a state, the innermost first."""
        found = []
        while name in self.parent:
            name = self.parent[name].name
            found.append(name)
        return found

    def enter(self, state: State, path: tuple[str, ...] = ()) -> None:
        """Enter a state, and inside it what is on the path, else what is initial."""
        self.active[state.name] = None
        function("", statements(state.entry), self.bb)()
        chosen = [child for child in state.children if child.name in path]
        inside = state.children if state.kind == "and" else chosen or state.children[:1]
        for child in inside:
            self.enter(child, path)

    def take(self, source: State, way: Transition) -> None:
        """Leave, do, enter."""
        of_target = self.around(way.target)
        scope = next(
            name for name in self.around(source.name) if name in of_target and self.state[name].kind == "or"
        )
        for name in reversed(list(self.active)):
            if scope in self.around(name):
                function("", statements(self.state[name].exit), self.bb)()
                del self.active[name]
        function("", statements(way.actions), self.bb)()
        path = (way.target, *of_target[: of_target.index(scope)])
        self.enter(self.state[path[-1]], path)

    def move(self, state: State, event: str) -> bool:
        """One transition in each region at the most, the innermost first."""
        inside = [child for child in state.children if child.name in self.active]
        moved = [self.move(child, event) for child in inside]
        if any(moved):
            return True
        for way in state.transitions:
            if way.event == event and (not way.guard or guard_function("", way.guard, self.bb)()):
                self.take(state, way)
                return True
        return False

    def settle(self) -> None:
        """Go on without an event until nothing moves."""
        while self.move(self.root, ""):
            pass

    def follow(self, behaviour: Behaviour) -> None:
        """Take all steps."""
        for event, change in behaviour.steps:
            function("", [f"bb[{name!r}] = {value}" for name, value in change], self.bb)()
            self.move(self.root, event)
            self.settle()
