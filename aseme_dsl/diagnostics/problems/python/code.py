"""Code: files, modules, classes and functions of Python that the system needs (E54x, W54x, N74x).

`what` is "activity" or "module"; `near` is the name that is spelt alike, None where there is none.
"""

from __future__ import annotations

from typing import Literal

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a, called_now, did_you_mean, how_to_play

# ---- E540: what is used without a declaration --------------------------------------------------------


class AccessNotDeclared(Problem):
    """`block` is where the clause belongs."""

    code = "E540"
    activity: str
    clause: Literal["reads", "writes"]
    name: str
    block: str

    @property
    def message(self) -> str:
        return f"`{self.activity}` {self.clause} `{self.name}` without declaring it"

    @property
    def hint(self) -> str:
        return f"declare it: `{self.block} {{ {self.activity} {self.clause} {self.name} }}`"


class HistoryNotDeclared(Problem):
    """`back` and `declared` are durations as the language writes them, `back` None where it is computed."""

    code = "E540"
    activity: str
    channel: str
    back: str | None
    declared: str | None
    block: str

    @property
    def message(self) -> str:
        how = "reads the history of" if self.back is None else f"looks back {self.back} at"
        said = "declares no history of it" if self.declared is None else f"declares {self.declared}"
        return f"`{self.activity}` {how} `{self.channel}` and {said}"

    @property
    def hint(self) -> str:
        wanted = f"{self.channel} for {self.back or '…'}"
        return f"declare how far it looks back: `{self.block} {{ {self.activity} reads {wanted} }}`"


# ---- E541, E542: functions of the document and of the project ------------------------------------------


class NoPythonModule(Problem):
    """`meant` is a module that there is, `function` the one that is looked for in it."""

    code = "E541"
    module: str
    meant: str | None
    function: str

    @property
    def message(self) -> str:
        return f"there is no Python module `{self.module}`"

    @property
    def hint(self) -> str:
        if self.meant is not None:
            return did_you_mean(f"{self.meant}:{self.function}")
        return f"write the module with `def {self.function}`"


class ModuleNotPython(Problem):
    """`reason` is what Python says."""

    code = "E541"
    module: str
    reason: str
    file: str

    @property
    def message(self) -> str:
        return f"the module `{self.module}` is not Python: {self.reason}"

    @property
    def hint(self) -> str:
        return f"correct {self.file}"


class NoPythonFunction(Problem):
    code = "E541"
    module: str
    name: str
    near: str | None

    @property
    def message(self) -> str:
        return f"the module `{self.module}` has no `{self.name}`"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(f"{self.module}:{self.near}")
        return f"write `def {self.name}` there"


class NotAPythonFunction(Problem):
    code = "E541"
    module: str
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` of the module `{self.module}` is not a function"

    hint = "name a function"


class _CannotBeCalled(Problem):
    """`called_with` are the arguments of a function that asemec calls; None: the document declares it."""

    code = "E542"
    function: str
    called_with: str | None

    @property
    def hint(self) -> str:
        if self.called_with is None:
            return "declare the same parameters on both sides"
        return f"asemec calls it as `{self.function}({self.called_with})`"

    @property
    def _takes(self) -> str:
        return f"the Python function `{self.function}` takes"


class TakesByNameOnly(_CannotBeCalled):
    parameter: str

    @property
    def message(self) -> str:
        return f"{self._takes} `{self.parameter}` by name only"


class TakesOtherNumber(_CannotBeCalled):
    """`most` is None for any number."""

    least: int
    most: int | None
    given: int

    @property
    def message(self) -> str:
        count = str(self.least)
        if self.most is None:
            count += " or more"
        elif self.most != self.least:
            count += f" to {self.most}"
        arguments = "argument" if self.least == self.most == 1 else "arguments"
        return f"{self._takes} {count} {arguments}, and gets {self.given}"


class WorldTakesMore(_CannotBeCalled):
    parameter: str

    @property
    def message(self) -> str:
        return f"{self._takes} `{self.parameter}`, which a world is not given"


class WorldTakesNoSeed(_CannotBeCalled):
    @property
    def message(self) -> str:
        return f"{self._takes} no `seed`"


# ---- E543, E544: files and folders that are not there --------------------------------------------------


class NoCode(Problem):
    """`scaffold` is the file of which `asemec scaffold` starts what is missing.

    `simulated` is the clause without which an activity needs code; None: of a module.
    """

    code = "E543"
    what: str
    name: str
    file: str
    scaffold: str
    simulated: str | None

    @property
    def message(self) -> str:
        return _has_no_code(self.what, self.name, self.file)

    @property
    def hint(self) -> str:
        start = f"`asemec scaffold {self.scaffold}` starts the file"
        return start if self.simulated is None else f"{start}; or let it be simulated: `{self.simulated}`"


class CodeNamedOtherwise(Problem):
    """`there` is the file that is there, `rename` what it has to be called, `class_name` its class."""

    code = "E543"
    what: str
    name: str
    file: str
    there: str
    rename: str
    class_name: str | None

    @property
    def message(self) -> str:
        return _has_no_code(self.what, self.name, self.file)

    @property
    def hint(self) -> str:
        return f"did you mean `{self.there}`? {_rename(self.rename, self.class_name)}"


class NoCodeOfParticipant(Problem):
    """An activity that is named like a participant of protocols, which the role does not play (W202)."""

    code = "E543"
    participant: str
    protocols: tuple[str, ...]
    role: str
    file: str

    @property
    def message(self) -> str:
        return _has_no_code("activity", self.participant, self.file)

    @property
    def hint(self) -> str:
        return how_to_play(self.protocols, self.participant, self.role)


class NoCodeFolder(Problem):
    """`scaffold` is the file of which `asemec scaffold` starts the folder; None: no activity needs code.

    `by_option`: `--activities` names the folder.
    """

    code = "E544"
    folder: str
    near: str | None
    scaffold: str | None
    by_option: bool

    @property
    def message(self) -> str:
        return f"there is no folder `{self.folder}` with the code of the activities"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        other = "say with `--activities` where it is"
        if not self.by_option:
            other = "name another one, here or with `--activities`"
        if self.scaffold is None:
            return f"leave it out: all activities are simulated; or {other}"
        return f"`asemec scaffold {self.scaffold}` starts it, with a file for each activity; or {other}"


# ---- E546: what cannot be loaded or called ---------------------------------------------------------------


class NotPython(Problem):
    """`reason` is what Python says; `imported_by` is the file that needs this one."""

    code = "E546"
    reason: str
    imported_by: str | None = None

    @property
    def message(self) -> str:
        needed = "" if self.imported_by is None else f"; `{self.imported_by}` imports it"
        return f"this is not Python: {self.reason}{needed}"


class NoFileOfModule(Problem):
    """`target` is the Python module that the system names."""

    code = "E546"
    name: str
    target: str

    @property
    def message(self) -> str:
        return f"the code of the module `{self.name}` cannot be found: there is no `{self.target}`"


class NoClass(Problem):
    """`is_near`: the file has a class whose name is spelt alike."""

    code = "E546"
    what: str
    name: str
    class_name: str
    is_near: bool

    @property
    def message(self) -> str:
        return f"the code of the {self.what} `{self.name}` has no class `{self.class_name}`"

    @property
    def hint(self) -> str:
        return did_you_mean(self.class_name) if self.is_near else f"write `class {self.class_name}:`"


class NoExecute(Problem):
    """`only_method` is the one method that the class has."""

    code = "E546"
    what: str
    class_name: str
    only_method: str | None

    @property
    def message(self) -> str:
        return f"the class `{self.class_name}` has no method `execute`, so the {self.what} does nothing"

    @property
    def hint(self) -> str:
        if self.only_method is not None:
            return f"is it `{self.only_method}`?"
        return f"`execute` is what {a(self.what)} does"


class NoGeneratedSystem(Problem):
    """An import of what is generated for a system that is called otherwise (`system`)."""

    code = "E546"
    backend: str
    name: str
    system: str

    @property
    def message(self) -> str:
        module = f"{self.backend}.{self.name}"
        return f"there is no generated module `{module}`: the system is called `{self.system}`"

    @property
    def hint(self) -> str:
        return did_you_mean(f"{self.backend}.{self.system}")


class NoGeneratedModule(Problem):
    """`there` are the modules that the package has."""

    code = "E546"
    module: str
    near: str | None
    there: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"there is no generated module `{self.module}`"

    @property
    def hint(self) -> str:
        if self.near is not None:
            return did_you_mean(self.near)
        return "there is " + ", ".join(f"`{name}`" for name in self.there)


class NoModuleOfPackage(Problem):
    """`now` is the module of this name that is elsewhere in the package."""

    code = "E546"
    module: str
    now: str | None

    @property
    def message(self) -> str:
        return f"there is no module `{self.module}`"

    @property
    def hint(self) -> str | None:
        return None if self.now is None else f"it is `{self.now}` now"


class NoNameOfRuntime(Problem):
    """An import from `aseme_dsl.runtime`; `now` is today's name of what was renamed."""

    code = "E546"
    name: str
    now: str | None
    near: str | None

    @property
    def message(self) -> str:
        return f"there is no `{self.name}` in `aseme_dsl.runtime`"

    @property
    def hint(self) -> str | None:
        if self.now is not None:
            return called_now(self.now)
        return did_you_mean(self.near) if self.near is not None else None


# ---- W54x, N74x: unused files, classes that are still to be written ---------------------------------------


class FileNotUsed(Problem):
    """`rename` is what the file has to be called to be that of an activity, `class_name` its class."""

    code = "W541"
    file: str
    rename: str | None
    class_name: str | None

    @property
    def message(self) -> str:
        return f"no activity uses `{self.file}`"

    @property
    def hint(self) -> str:
        if self.rename is None:
            return "delete it, or import it where it is needed"
        return f"did you mean `{self.rename}`? {_rename(None, self.class_name)}"


class FileOfSimulated(Problem):
    """`word` is the clause with which the activity has no code."""

    code = "W542"
    activity: str
    file: str
    word: Literal["simulated", "waits"]

    @property
    def message(self) -> str:
        what = "is simulated" if self.word == "simulated" else "waits"
        return f"`{self.activity}` {what}, so `{self.file}` is not loaded"

    @property
    def hint(self) -> str:
        return f"leave out `{self.word}`, or delete the file"


class NotWrittenYet(Problem):
    """`simulated` is the clause without which an activity needs code; None: of a module."""

    code = "N740"
    what: str
    name: str
    simulated: str | None

    @property
    def message(self) -> str:
        return f"the {self.what} `{self.name}` is not written yet: its `execute` does nothing"

    @property
    def hint(self) -> str:
        other = "" if self.simulated is None else f"; or delete the file and say `{self.simulated}`"
        return f"write its `execute`{other}"


# ---- what texts have in common ---------------------------------------------------------------------------


def _has_no_code(what: str, name: str, file: str) -> str:
    return f"the {what} `{name}` has no code: there is no `{file}`"


def _rename(file: str | None, class_name: str | None) -> str:
    its_class = "" if class_name is None else f", and its class to `{class_name}`"
    return f"Rename it{'' if file is None else f' to `{file}`'}{its_class}"


__all__ = [
    "AccessNotDeclared",
    "CodeNamedOtherwise",
    "FileNotUsed",
    "FileOfSimulated",
    "HistoryNotDeclared",
    "ModuleNotPython",
    "NoClass",
    "NoCode",
    "NoCodeFolder",
    "NoCodeOfParticipant",
    "NoExecute",
    "NoFileOfModule",
    "NoGeneratedModule",
    "NoGeneratedSystem",
    "NoModuleOfPackage",
    "NoNameOfRuntime",
    "NoPythonFunction",
    "NoPythonModule",
    "NotAPythonFunction",
    "NotPython",
    "NotWrittenYet",
    "TakesByNameOnly",
    "TakesOtherNumber",
    "WorldTakesMore",
    "WorldTakesNoSeed",
]
