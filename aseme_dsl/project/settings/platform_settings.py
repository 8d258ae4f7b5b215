"""Platform settings: the platforms that there are, and what a project says of each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl.records import dataclass

IN_PROCESS, ZENOH, SPADE, MANGO = PLATFORMS = ("in_process", "zenoh", "spade", "mango")


@dataclass(frozen=True, slots=True)
class SpadeConfiguration:
    """What `[tool.asemec.spade]` says of the XMPP server; without a `host` it is the embedded one."""

    host: str | None = None
    port: int | None = None
    domain: str | None = None
    """The part of the addresses after the @, if it is not the host."""
    account: str | None = None
    password: Path | None = None
    """A file with the password in its first line; ROBOT in its name stands for the agent's name."""
    register: bool = False
    verify: bool = True
    authority: Path | None = None


@dataclass(frozen=True, slots=True)
class MangoConfiguration:
    """What `[tool.asemec.mango]` says: where each robot listens."""

    hosts: Mapping[str, str] = field(default_factory=dict)
