"""SUC, System Use Cases (P1, section 4.2): goals as use cases of roles, and what they include."""

from __future__ import annotations

from enum import StrEnum

from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class RoleType(StrEnum):
    SYSTEM = "system"
    ABSTRACT = "abstract"
    HUMAN = "human"
    LEGACY = "legacy"
    EXTERNAL = "external"


def folded(name: str) -> str:
    """What use cases, formulas and activities are compared by: case and underscores do not count."""
    return name.replace("_", "").lower()


@dataclass(frozen=True, slots=True)
class Role:
    name: str
    type: RoleType
    span: Span


@dataclass(frozen=True, slots=True)
class UseCase:
    """`participants` are role names; `realises` names the formula or activity that is this use case."""

    name: str
    participants: tuple[str, ...]
    includes: tuple[str, ...]
    requirements: str
    realises: tuple[str, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Suc(Displayed):
    roles: tuple[Role, ...] = ()
    usecases: tuple[UseCase, ...] = ()

    def usecase(self, name: str) -> UseCase | None:
        return next((item for item in self.usecases if item.name == name), None)
