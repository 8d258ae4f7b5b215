"""Agents that are not of the team, for tests: they say what they are told to, and keep what they hear."""

from __future__ import annotations

import json
from typing import Any

from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage
from aseme_dsl.runtime.team.team import Team
from tests.runtime.playing import MS


class Outside:
    """An agent that is not of the team, and what it hears."""

    def __init__(self, team: Team, name: str = "alice@elsewhere") -> None:
        self.team = team
        self.me = AgentIdentifier(name)
        self.heard: list[FipaMessage] = []
        team.conversations.add_external_agent(name, self.heard.append)

    def say(self, at: int, performative: str, content: Any = None, to: str = "bob", **more: Any) -> None:
        """Say something at a moment, in ms."""
        text = content if isinstance(content, (str, bytes)) or content is None else json.dumps(content)
        message = FipaMessage(performative, self.me, (AgentIdentifier(to),), text, **more)
        self.send(at, message, to)

    def send(self, at: int, message: FipaMessage, to: str = "bob") -> None:
        self.team.driver.at(at * MS, lambda: self.team.conversations.receive_external(to, message))

    def answers(self) -> list[tuple[str, Any]]:
        """What it has heard: performatives and contents."""
        return [(message.performative, json.loads(message.content or "null")) for message in self.heard]
