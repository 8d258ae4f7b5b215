"""System: several foreign models as one `.aseme` file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from pathlib import PurePath

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.files import ForeignNotRead
from aseme_dsl.interop.emf.charts import ForeignChart, is_chart, read_chart
from aseme_dsl.interop.emf.documents import Documents
from aseme_dsl.interop.emf.formulas import NoFormula
from aseme_dsl.interop.emf.identifiers import Names, system_name
from aseme_dsl.interop.emf.markup import Unreadable, read_markup
from aseme_dsl.interop.emf.meaning import Known, Meaning
from aseme_dsl.interop.emf.protocols import ProtocolPlan, plan_protocol, protocol_text
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.interop.emf.requirements import (
    ForeignProtocol,
    Requirements,
    is_requirements,
    read_requirements,
)
from aseme_dsl.interop.emf.roles import (
    RolePlan,
    plan_role,
    read_expressions,
    role_text,
    scalar_variables,
)
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

CHARTS = (".eac", ".iac", ".model", ".sct", ".stct")
"""The endings of files with a statechart."""
ROBOT = "robot"
"""The role that gets the modules where no model says one."""
_NOTHING = "OnlyModules"
MODELS = (*CHARTS, ".aip", ".sag", ".srm", ".suc")
"""The endings of all models."""


@dataclass(frozen=True, slots=True)
class Threads:
    """What `agents.xml` files say: the lines of `modules` blocks, what became of each part, the files."""

    lines: tuple[str, ...] = ()
    rows: tuple[Row, ...] = ()
    files: tuple[str, ...] = ()


NO_THREADS = Threads()


@dataclass(slots=True)
class ForeignSystem:
    """All models of an import. `problems` of its plans grow with what the compiler says."""

    name: str
    files: tuple[str, ...]
    plans: list[RolePlan]
    meaning: Meaning
    protos: tuple[str, ...] = ()
    threads: Threads = NO_THREADS
    documents: Documents = field(default_factory=lambda: Documents(Requirements()))
    protocols: list[ProtocolPlan] = field(default_factory=list)

    @property
    def module(self) -> str:
        """The Python module with the functions of conditions."""
        return f"{self.name.lower()}_functions"

    def gather(self) -> None:
        """Read all expressions, but for those that are problems: what only these use is not declared."""
        self.meaning = Meaning(self.meaning.known)
        problems = self.documents.problems
        for protocol in [item for item in self.protocols if _key(item) in problems]:
            self.protocols.remove(protocol)
            plan = plan_role(protocol.chart, f"{protocol.name}_chart" if protocol.said else protocol.name)
            plan.why_not = plan.why_not or problems[_key(protocol)]
            self.plans.append(plan)
        for protocol in self.protocols:
            for number, part in enumerate(protocol.parts):
                for at in range(len(part.chart.transitions)):
                    if (key := f"{_key(protocol)}.{number}.{at}") in problems:
                        part.problems[at] = problems[key]
                read_expressions(part, self.meaning)
        for plan in self.plans:
            read_expressions(plan, self.meaning)
        self.meaning.settle()


def _key(protocol: ProtocolPlan) -> str:
    """The key of every line of a protocol that has a statechart."""
    return f"eac.{protocol.name}"


@dataclass(frozen=True, slots=True)
class SystemText:
    """The text, before its layout. A line of a role has its plan's number, and its transition's if any."""

    text: str
    lines: Mapping[int, tuple[int, int | None] | str]
    rows: tuple[Row, ...]
    functions: str = ""
    roles: Sequence[str] = field(default=())


def read_system(
    sources: Sequence[Source], known: Known, protos: tuple[str, ...] = (), threads: Threads = NO_THREADS
) -> tuple[ForeignSystem | None, tuple[Diagnostic, ...]]:
    """The models of XMI files, and a diagnostic for each that is not read."""
    found: list[Diagnostic] = []
    plans: list[RolePlan] = []
    names = Names()
    variables = dict(known.variables)
    charts: list[ForeignChart] = []
    requirements = Requirements()
    for source in sources:
        try:
            document = read_markup(source)
            if is_requirements(document):
                requirements += read_requirements(document)
            elif is_chart(document):
                charts.append(read_chart(document))
            else:
                said = f"`<{document.tag[:40]}>` is not a model of the ASEME IDE or KSE"
                raise Unreadable(said, document.place)
        except Unreadable as problem:
            found.append(Diagnostic(ForeignNotRead(source.path, str(problem)), problem.place))
    if not charts and requirements == Requirements() and not threads.lines:
        return None, tuple(found)
    documents = Documents(requirements)
    roles = {name.lower(): name for name in documents.roles()}
    protocols: list[ProtocolPlan] = []
    described = {item.name.lower(): item for item in requirements.protocols}
    for chart in charts:
        variables |= scalar_variables(chart)
        protocol = _protocol(chart, described, documents)
        if protocol is not None:
            names.taken.add(protocol.name)
            protocols.append(protocol)
            continue
        own = [name for name in (chart.name, chart.states[0].name) if name.lower() in roles]
        title = roles.pop(own[0].lower()) if own else chart.name or chart.states[0].name
        plan = plan_role(chart, names.new(title, "role"))
        if own and plan.reconstructed is None:
            plan.name = names.new(f"{plan.name}_chart")
        plans.append(plan)
    names_known = [*(plan.name for plan in plans), *(protocol.name for protocol in protocols)]
    if requirements != Requirements():
        names_known.append(PurePath(sources[0].path).stem)
    first = (*names_known, ROBOT)[0]
    meaning = Meaning(Known(known.messages, known.enums, known.constants, variables))
    files = (*(source.path for source in sources), *threads.files)
    system = ForeignSystem(system_name(first), files, plans, meaning, protos, threads, documents, protocols)
    system.gather()
    return system, tuple(found)


def _protocol(
    chart: ForeignChart, said: Mapping[str, ForeignProtocol], documents: Documents
) -> ProtocolPlan | None:
    """A chart as that of a protocol: of an .eac file, or of a protocol that an .aip describes."""
    known = said.get(chart.name.lower()) or said.get(chart.states[0].name.lower())
    if known is None and not chart.place.source.path.lower().endswith(".eac"):
        return None
    name = documents.name(known.name if known is not None else chart.name or chart.states[0].name)
    try:
        found = plan_protocol(chart, name)
    except NoFormula:
        return None
    found.said = known
    return found


def system_text(system: ForeignSystem, *, with_holes: bool = True) -> SystemText:
    """The text of a system; without holes it is for comparison only."""
    roles = [role_text(plan, system.meaning, with_holes=with_holes) for plan in system.plans]
    lines = [f"system {system.name}", "", *(f'import "{name}"' for name in system.protos), ""]
    lines += system.meaning.declarations(system.module)
    rows = list(_declared(system))
    places: dict[int, tuple[int, int | None] | str] = {}
    charts = {role.name for role in roles if role.is_formula} | {item.name for item in system.protocols}
    modules = system.threads.lines
    system.documents.modules = () if roles else modules
    documents = system.documents.written(frozenset(charts))
    places |= {len(lines) + index + 1: key for index, key in documents.keys.items()}
    lines += [line if with_holes else line.replace(" ? ", " . ") for line in documents.lines]
    rows += documents.rows
    for protocol in system.protocols:
        made = protocol_text(protocol, system.meaning, with_holes=with_holes)
        for index in range(len(made.lines)):
            at = made.transitions.get(index)
            key = _key(protocol)
            places[len(lines) + index + 1] = key if at is None else f"{key}.{at[0]}.{at[1]}"
        lines += made.lines
        rows += made.rows
    for number, role in enumerate(roles):
        lines.append("")
        text = list(role.lines)
        if number == 0:
            text[-1:-1] = [f"  {line}" for line in modules]
        places |= {len(lines) + i + 1: (number, role.transitions.get(i)) for i in range(len(text))}
        more, keys = documents.inside.get(role.name, ((), {}))
        places |= {len(lines) + len(text) + i: key for i, key in keys.items()}
        text[-1:-1] = more
        lines += text
        rows += role.rows
    if modules and not roles and not documents.has_modules:
        name = system.documents.name(ROBOT)
        now = f"no model says what it does: write it instead of {_NOTHING}"
        rows.append(Row(Fate.ADDED, f"role {name}", None, now))
        lines += [f"srm {name} {{", f"  liveness {{ {name} = {_NOTHING} }}"]
        lines += [f"  activities {{ {_NOTHING} waits }}", *(f"  {line}" for line in modules), "}"]
    rows += system.threads.rows
    return SystemText(
        "\n".join([*lines, ""]), places, tuple(rows), _functions(system), [role.name for role in roles]
    )


def _declared(system: ForeignSystem) -> Iterator[Row]:
    meaning = system.meaning
    for name, constants in meaning.enums.items():
        now = f"its numbers are not in the model: {', '.join(constants)}"
        yield Row(Fate.ADDED, f"enum {name}", None, now)
    for name in dict.fromkeys(key[2] for key in meaning.channels):
        if name in meaning.known.messages:
            continue
        fields = ", ".join(key[1] for key in meaning.fields if key[0] == name) or "no field is compared"
        yield Row(Fate.ADDED, f"message {name}", None, f"no .proto file has it; from its uses: {fields}")
    for topic in dict.fromkeys(key[0] for key in meaning.channels):
        yield Row(Fate.ADDED, f"topic {topic}", None, "from its uses")
    for name in meaning.functions:
        yield Row(Fate.ADDED, f"function {name}", None, f"to be written in {system.module}.py")
    for name in system.protos:
        yield Row(Fate.ADDED, f"import {name}", None, "")


def _functions(system: ForeignSystem) -> str:
    """The Python module in which the functions are to be written; "" if there are none."""
    if not system.meaning.functions:
        return ""
    parts = [f'"""Functions of the conditions of {system.name}: write what each answers."""\n']
    for name, (types, _) in system.meaning.functions.items():
        given = ", ".join(f"value{number}" for number, _ in enumerate(types, 1))
        parts.append(f'\n\ndef {name}({given}):\n    raise NotImplementedError("{name}")\n')
    return "".join(parts)


__all__ = ["CHARTS", "MODELS", "ForeignSystem", "SystemText", "read_system", "system_text"]
