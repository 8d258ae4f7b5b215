"""Operable: what a run opens for its operators, and which plans besides its own it can be told to follow."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.settings.configuration import Configuration

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.control import Changed
    from aseme_dsl.runtime.control.recent import Recent
    from aseme_dsl.runtime.team.swap import Version
    from aseme_dsl.runtime.team.team import Team
    from aseme_dsl.runtime.version.epochs import Epoch, EpochFile
    from aseme_dsl.runtime.version.loading import Loaded


def output_of(loaded: Loaded) -> Path:
    """The output folder of the build that a system was loaded from."""
    assert loaded.folder is not None
    return loaded.folder.parent.parent


@contextmanager
def operable(
    team: Team,
    loaded: Loaded,
    activities: Path,
    changed: Callable[[Changed], None] | None = None,
    keys: Path | None = None,
    recent: Recent | None = None,
    epochs: EpochFile | None = None,
    epoch: Epoch | None = None,
    is_apart: bool = False,
) -> Iterator[None]:
    """Inside, operators reach the team over a socket, and over its transport if there is a file of `keys`.

    `changed` is called with each swap that is done; `recent`, a listener of the team's trace, has its logs.
    `epochs` keeps the epoch of the agents here, which is `epoch` now. If the others are on other machines
    (`is_apart`), or there are keys, epochs need a proof.

    A run to which no socket can be opened continues without one, with a line in its trace.
    """
    from aseme_dsl.runtime.control.catching_up import CatchingUp
    from aseme_dsl.runtime.control.control import Control
    from aseme_dsl.runtime.control.control_socket import ControlError, listening
    from aseme_dsl.runtime.control.epoch_proof import Doubt, all_doubt, doubt_of, no_doubt
    from aseme_dsl.runtime.control.operator_gate import Gate
    from aseme_dsl.runtime.version.versions import VERSIONS

    agents = team.agents
    name = agents[0].name if len(agents) == 1 else "team"
    doubt: Doubt = all_doubt if is_apart else no_doubt
    if keys is not None:
        doubt = doubt_of(keys, loaded.name, name)
    store = output_of(loaded) / VERSIONS
    control = Control(team, activities, changed, store, recent, epochs, epoch, doubt)
    if keys is None:
        team.transport.answer(control.not_over_the_bus)
    else:
        team.transport.answer(Gate(control, keys, loaded.name, team.transport.life).answer)
    catching_up = CatchingUp(team, control) if epoch is not None and team.transport.networked else None
    if catching_up is not None:
        catching_up.begin()
        team.at_end.append(catching_up.close)
    socket = listening(control, output_of(loaded), name)
    try:
        socket.__enter__()
    except ControlError as problem:
        team.trace.remark(0, "", f"operators cannot reach this run: {problem}")
        yield
        return
    try:
        yield
    finally:
        socket.__exit__(None, None, None)


def others(loaded: Loaded, activities: Path, configuration: Configuration) -> Sequence[Version]:
    """The other systems whose packages are in the same output folder, loaded beside this one.

    Raises:
        LoadError: one cannot be imported.
    """
    from aseme_dsl.runtime.team.swap import version_of
    from aseme_dsl.runtime.version.loading import RoleBackends, activities_in, load_beside

    assert loaded.folder is not None
    found = sorted(path.parent for path in loaded.folder.parent.glob("*/messages.py"))
    project = [configuration.folder.resolve()]
    names = RoleBackends(names=loaded.mixture.names)
    return [
        version_of(load_beside(folder, {}, project, names), activities_in(activities))
        for folder in found
        if folder.name != loaded.folder.name and (folder / "__init__.py").is_file()
    ]
