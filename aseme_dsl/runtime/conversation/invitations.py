"""Invitations: the agent messages that wait at an agent for one of its participants to be entered or free."""

from __future__ import annotations

from aseme_dsl.runtime.message.acl import AclMessage

Part = tuple[str, str]
"""A protocol and a participant of it."""


class Invitations:
    """What waits at one agent, by participant and conversation, in the order in which it came.

    A conversation waits for an instance of the participant once a message that opens it has come. What comes
    before that is early, and waits for this message.
    """

    __slots__ = ("_count", "_early", "_waiting", "size")

    def __init__(self) -> None:
        self.size = 0
        """How many messages wait."""
        self._count = 0
        self._waiting: dict[Part, dict[str, list[tuple[int, AclMessage]]]] = {}
        self._early: dict[tuple[Part, str], list[tuple[int, AclMessage]]] = {}

    def has(self, part: Part, conversation: str) -> bool:
        """Whether messages of a conversation wait for a participant."""
        return conversation in self._waiting.get(part, ())

    def add(self, part: Part, acl: AclMessage) -> None:
        """A message waits for a participant; what was early in its conversation waits behind it."""
        waiting = self._waiting.setdefault(part, {}).setdefault(acl.conversation, [])
        waiting.append(self._numbered(acl))
        waiting += self._early.pop((part, acl.conversation), ())

    def add_early(self, part: Part, acl: AclMessage) -> None:
        """A message waits for the one that opens its conversation."""
        self._early.setdefault((part, acl.conversation), []).append(self._numbered(acl))

    def _numbered(self, acl: AclMessage) -> tuple[int, AclMessage]:
        self._count += 1
        self.size += 1
        return self._count, acl

    def take(self, part: Part) -> list[AclMessage]:
        """What waits for a participant in the conversation that waits longest, which it then does no more."""
        waiting = self._waiting.get(part)
        if not waiting:
            return []
        found = waiting.pop(next(iter(waiting)))
        self.size -= len(found)
        return [acl for _, acl in found]

    def take_early(self, conversation: str, part: Part | None = None) -> list[AclMessage]:
        """What came early in a conversation, for one participant or all, which then waits no more."""
        if not self._early:
            return []
        keys = [key for key in self._early if key[1] == conversation and part in (None, key[0])]
        found = [item for key in keys for item in self._early.pop(key)]
        self.size -= len(found)
        return [acl for _, acl in sorted(found, key=lambda item: item[0])]

    def withdraw(self, conversation: str, sender: str) -> list[AclMessage]:
        """What an agent has sent in a conversation, which then waits no more."""
        found: list[AclMessage] = []
        for waiting in self._waiting.values():
            items = waiting.get(conversation, [])
            found += [acl for _, acl in items if acl.sender == sender]
            items[:] = [item for item in items if item[1].sender != sender]
            if conversation in waiting and not items:
                del waiting[conversation]
        for (part, name), items in list(self._early.items()):
            if name == conversation:
                found += [acl for _, acl in items if acl.sender == sender]
                items[:] = [item for item in items if item[1].sender != sender]
                if not items:
                    del self._early[part, name]
        self.size -= len(found)
        return found

    def waiting(self) -> list[AclMessage]:
        """All that waits, in the order in which it came."""
        found = [item for waiting in self._waiting.values() for items in waiting.values() for item in items]
        found += [item for items in self._early.values() for item in items]
        return [acl for _, acl in sorted(found, key=lambda item: item[0])]

    def clear(self) -> list[AclMessage]:
        """All that waits, which it then does no more."""
        found = self.waiting()
        self._waiting.clear()
        self._early.clear()
        self.size = 0
        return found
