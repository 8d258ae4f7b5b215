"""Files that are read and imported (E001–E008, E020, E220, W001, W11x), in the order of their codes."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean
from aseme_dsl.source import STANDARD_INPUT

_TARGET_FORMS = (
    "name a .aseme file, a project's folder or an output folder (or, for commands that read runs, a trace)"
)
"""What a command works on."""
_LONGEST = 40
"""How much of a name of another language is shown."""


class Unread(Problem):
    """A file is not read."""


def _called(path: str) -> str:
    return "standard input" if path == STANDARD_INPUT else path


# ---- E001: what cannot be read -----------------------------------------------------------------


class CannotBeRead(Unread):
    """`reason`: what the operating system says."""

    code = "E001"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{_called(self.path)} cannot be read: {self.reason}"


class FolderCannotBeRead(CannotBeRead):
    @property
    def message(self) -> str:
        return f"the folder {self.path} cannot be read: {self.reason}"


class ManifestCannotBeRead(CannotBeRead):
    """What says which files in an output folder are generated."""

    hint = _TARGET_FORMS


class NotRegularFile(Unread):
    code = "E001"
    path: str
    is_folder: bool

    @property
    def message(self) -> str:
        return f"{self.path} is {'a folder' if self.is_folder else 'not a regular file'}"


class NoFile(Unread):
    """`close`: the file beside it that is spelt alike."""

    code = "E001"
    path: str
    close: str | None

    @property
    def message(self) -> str:
        return f"there is no file {self.path}"

    @property
    def hint(self) -> str:
        return did_you_mean(self.close) if self.close is not None else _TARGET_FORMS


class NoSourceInFolder(Problem):
    code = "E001"
    folder: str
    hint = _TARGET_FORMS

    @property
    def message(self) -> str:
        return f"there is no .aseme file in {self.folder}"


class NothingMatches(Problem):
    code = "E001"
    pattern: str
    hint = _TARGET_FORMS

    @property
    def message(self) -> str:
        return f"no .aseme file matches {self.pattern}"


class TraceAsSource(Problem):
    code = "E001"
    path: str
    hint = _TARGET_FORMS

    @property
    def message(self) -> str:
        return f"{self.path} is a trace, not a .aseme file"


class NoTrace(Problem):
    code = "E001"
    path: str
    hint = "`asemec run` writes it"

    @property
    def message(self) -> str:
        return f"there is no trace {self.path}"


class TraceOfAnother(Problem):
    """What was built into the `folder` is the `source`, not the file that is called `path`."""

    code = "E001"
    path: str
    folder: str
    source: str
    hint = "run it first, or name the trace"

    @property
    def message(self) -> str:
        return f"{self.folder} has the last run of {self.source}, not one of {self.path}"


# ---- E002, E003: files that are not text, or too large -----------------------------------------


class NotText(Unread):
    """`offset`: where the first NUL is."""

    code = "E002"
    path: str
    offset: int

    @property
    def message(self) -> str:
        return f"{_called(self.path)} is not a text: byte {self.offset} is NUL"


class NotUtf8(Unread):
    """`byte`: the first one that is wrong; 0 and line 0 where that is not known."""

    code = "E002"
    path: str
    byte: int = 0
    line: int = 0

    @property
    def message(self) -> str:
        where = f": byte 0x{self.byte:02x} in line {self.line}" if self.line else ""
        return f"{_called(self.path)} is not UTF-8{where}"

    @property
    def hint(self) -> str | None:
        return "save it as UTF-8" if self.line and self.path != STANDARD_INPUT else None


class FileTooLarge(Unread):
    """Sizes in bytes."""

    code = "E003"
    path: str
    size: int
    most: int

    @property
    def message(self) -> str:
        size, most = (f"{number:,}".replace(",", " ") for number in (self.size, self.most))
        return f"{self.path} has {size} bytes; the limit is {most}"


class SourceTooLarge(FileTooLarge):
    hint = "split it, and import the parts"


class InputTooLarge(Unread):
    """`most`: in bytes."""

    code = "E003"
    most: int

    @property
    def message(self) -> str:
        return f"standard input has more than {self.most // 1_000_000} MB"


# ---- E004 to E007: imports ---------------------------------------------------------------------


class ImportedFileMissing(Unread):
    """`close`: the file beside it that is spelt alike."""

    code = "E004"
    path: str
    close: str | None

    @property
    def message(self) -> str:
        return f"there is no file {self.path}"

    @property
    def hint(self) -> str | None:
        return did_you_mean(self.close) if self.close is not None else None


class LibraryByPath(Unread):
    """`import "soccer"`"""

    code = "E004"
    path: str
    library: str

    @property
    def message(self) -> str:
        return f"there is no file {self.path}"

    @property
    def hint(self) -> str:
        return f"the library is written `import {self.library}`"


class NoLibrary(Unread):
    """`close`: the one of `others` that is spelt alike; `is_neighbour`: a file beside it has the name."""

    code = "E004"
    name: str
    close: str | None
    others: tuple[str, ...]
    is_neighbour: bool

    @property
    def message(self) -> str:
        return f"the standard library has no `{self.name}`"

    @property
    def hint(self) -> str:
        if self.is_neighbour:
            return f'a neighbour file is imported by its path: import "{self.name}.aseme"'
        if self.close is not None:
            return did_you_mean(self.close)
        return "the standard library has " + ", ".join(self.others)


class ImportCycle(Problem):
    """`files`: by name, each imports the next one, and the last one the first."""

    code = "E005"
    files: tuple[str, ...]

    @property
    def message(self) -> str:
        if len(self.files) == 1:
            return f"{self.files[0]} imports itself"
        return "these files import each other in a circle: " + " → ".join([*self.files, self.files[0]])

    @property
    def hint(self) -> str | None:
        return "move what both need into a file of its own, and import that" if len(self.files) > 1 else None


class NewerLanguage(Unread):
    code = "E006"
    number: int
    known: int
    hint = "install a newer aseme-dsl"

    @property
    def message(self) -> str:
        return f"the file is written in language {self.number}; this compiler knows language {self.known}"


class NoSuchLanguage(Unread):
    code = "E006"
    number: int
    known: int

    @property
    def message(self) -> str:
        return f"there is no language {self.number}"

    @property
    def hint(self) -> str:
        return f"the first line may be `language {self.known}`"


class GrpcToolsMissing(Unread):
    code = "E007"
    path: str
    hint = 'pip install "aseme-dsl[proto]"'

    @property
    def message(self) -> str:
        return f"{self.path} cannot be imported: grpcio-tools is not installed"


class ProtoNotRead(Unread):
    """`reason`: what protoc says, or why it does not run."""

    code = "E007"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} cannot be imported: {self.reason}"


class ProtocSays(Unread):
    """Of a place in the file."""

    code = "E007"
    said: str

    @property
    def message(self) -> str:
        return f"protoc says: {self.said}"


class TwoProtoFiles(Problem):
    code = "E007"
    file: str

    @property
    def message(self) -> str:
        return f"two different files are called {self.file} by those that import them"


# ---- E020: the source of a build ---------------------------------------------------------------


class NoSystem(Problem):
    code = "E008"
    path: str

    @property
    def message(self) -> str:
        return f"{self.path} declares no system"

    hint = "name it in the first line: `system Kouretes`; if another file imports this one, give that file"


class BuiltFromInput(Problem):
    code = "E020"
    folder: str
    hint = "name a .aseme file"

    @property
    def message(self) -> str:
        return f"{self.folder} was built from standard input"


class SourceGone(Problem):
    code = "E020"
    path: str
    hint = "name a .aseme file, or build again from where it is now"

    @property
    def message(self) -> str:
        return f"the source of this build, {self.path}, cannot be found"


# ---- E220: files of Monas ----------------------------------------------------------------------


class NotOfMonas(Problem):
    code = "E220"
    path: str

    @property
    def message(self) -> str:
        return f"{self.path} is not a configuration of Monas: it has no agent, provider or statechart"


class MonasNotRead(Problem):
    """`reason`: what the reader of the markup says."""

    code = "E220"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} is not read: {self.reason}"


class ForeignNotRead(Problem):
    """A model of the ASEME IDE or of KSE. `reason`: what is wrong with it."""

    code = "E220"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} is not imported: {self.reason}"


# ---- W001 ---------------------------------------------------------------------------------------


class EmptyFile(Problem):
    code = "W001"
    path: str
    hint = "write it, or leave it out"

    @property
    def message(self) -> str:
        return f"{self.path} is empty"


# ---- W110, W111: what is not taken over from Monas ---------------------------------------------


class NoModuleName(Problem):
    code = "W110"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` cannot be the name of a module: it is left out"


class ModuleAgain(Problem):
    code = "W110"
    module: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` is there a second time: it is left out"


class MeaninglessPart(Problem):
    """An attribute of an element, or an element inside of it."""

    code = "W110"
    name: str
    element: str

    @property
    def message(self) -> str:
        return f"`{self.name}` of the {self.element} means nothing here: it is left out"


class MeaninglessElement(Problem):
    code = "W110"
    element: str

    @property
    def message(self) -> str:
        return f"`<{self.element[:_LONGEST]}>` means nothing here: it is left out"


class TextBetweenElements(Problem):
    code = "W110"
    message = "there is text between the elements: it is left out"


class NoFrequency(Problem):
    code = "W111"
    name: str
    hint = "its modules are commented out: give them `every …`"

    @property
    def message(self) -> str:
        return f"`{self.name}` has no frequency"


class WithoutPause(NoFrequency):
    @property
    def message(self) -> str:
        return f"`{self.name}` runs without a pause (frequency 0): a module has a period"


class NotFrequency(NoFrequency):
    """`written`: instead of a number of Hz."""

    written: str

    @property
    def message(self) -> str:
        return f"`{self.written}` is not a frequency in Hz"
