"""Writing: what cannot be written, and what is not (E009, W002, W003), in the order of their codes."""

from __future__ import annotations

from enum import Enum

from aseme_dsl.diagnostics.problem import Problem


class Obstacle(Enum):
    """What keeps a file from being written."""

    EXISTS = "exists already"
    READ_ONLY = "is read-only"
    FOLDER = "is a folder, and a file must go there"
    NO_FOLDER = "is not a folder"
    DEAD_LINK = "is a link that leads nowhere"
    FILE_ABOVE = "cannot be written: there is a file where its folder should be"
    FILE_INSTEAD = "cannot be written: it is a file"
    READ_ONLY_ABOVE = "cannot be written: its folder is read-only"
    READ_ONLY_ITSELF = "cannot be written: it is read-only"
    NO_PLACE = "is not a place for a generated file"
    TWICE = "would be written twice, with different contents"


class InTheWay(Problem):
    code = "E009"
    path: str
    obstacle: Obstacle

    @property
    def message(self) -> str:
        return f"{self.path} {self.obstacle.value}"


class NotReadBeforeWriting(Problem):
    """`reason`: what the operating system says."""

    code = "E009"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} cannot be read: {self.reason}"


class CannotBeWritten(Problem):
    """`reason`: what the operating system says."""

    code = "E009"
    path: str
    reason: str
    hint = "nothing was changed"

    @property
    def message(self) -> str:
        return f"{self.path} cannot be written: {self.reason}"


class KeyNotWritten(Problem):
    """`reason`: what the runtime says of the file."""

    code = "E009"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


class ChangedMeanwhile(Problem):
    code = "E009"
    path: str
    hint = "nothing was changed; try again"

    @property
    def message(self) -> str:
        return f"{self.path} has changed since it was read"


class DamagedList(Problem):
    """Of generated files; `reason`: what is wrong with it."""

    code = "E009"
    path: str
    reason: str
    hint = "build into another folder, or use --force: what is in the way is then overwritten"

    @property
    def message(self) -> str:
        return f"{self.path} should say which files are generated, but {self.reason}"


class NotGenerated(Problem):
    code = "E009"
    path: str
    hint = "move it away, or use --force to overwrite it"

    @property
    def message(self) -> str:
        return f"{self.path} exists, and asemec did not write it"


class EditedSinceGenerated(Problem):
    code = "E009"
    path: str
    hint = "keep your changes elsewhere, or use --force to overwrite them"

    @property
    def message(self) -> str:
        return f"{self.path} was edited since it was generated"


class OtherBuild(Problem):
    """`source`: what it was built from, if that is known."""

    code = "E009"
    folder: str
    system: str
    source: str | None

    @property
    def message(self) -> str:
        where = f" (from {self.source})" if self.source is not None else ""
        return f"{self.folder} holds the build of {self.system}{where}"

    @property
    def hint(self) -> str:
        return f"choose another folder with --output, or use --force to replace {self.system}"


class EditedButObsolete(Problem):
    code = "W002"
    path: str

    @property
    def message(self) -> str:
        return f"{self.path} is no longer generated; it was edited, so it stays"


class NotDrawn(Problem):
    """`reason`: what the drawing program says; `drawing`: its name."""

    code = "W003"
    reason: str
    drawing: str

    @property
    def message(self) -> str:
        return self.reason

    @property
    def hint(self) -> str:
        return f"{self.drawing}.dot has its text"


class GraphvizNotThere(NotDrawn):
    hint = "the .dot files have their texts; `asemec doctor` says what is there"
