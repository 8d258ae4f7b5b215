"""Epochs: how many times a whole team has changed its version, which each agent keeps across restarts.

An epoch is a number and the hash of its version. Of two epochs the newer one has the larger number. Two of
one number, which two operators can make at the two sides of a partition, are ordered by hash. So all agents
that hear of both agree.

An operator who reaches the team over its network proves an epoch to each member. The members pass the proofs
on with the epoch, so that those that did not answer believe it, too.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.versions import HASH

LARGEST = 1 << 16
"""A file of an epoch, and what an agent says of it, has at most so many bytes."""
MOST = 1 << 53
"""Numbers of epochs are smaller."""


class EpochError(Exception):
    """A file of an epoch cannot be used; the text says why."""


@dataclass(frozen=True, slots=True)
class Proof:
    """Proves an epoch to members: by which key, how many of them have to change, and the proof for each."""

    key: str
    quorum: int
    members: Mapping[str, str]

    def as_data(self) -> dict[str, object]:
        """The proof as JSON."""
        return {"key": self.key, "quorum": self.quorum, "members": dict(self.members)}


@dataclass(frozen=True, slots=True, order=True)
class Epoch:
    """The number of an epoch, the hash of its version (empty: the build), and the model of the build."""

    number: int = 0
    hash: str = ""
    base: str = ""
    proof: Proof | None = field(default=None, compare=False)

    def is_newer(self, other: Epoch) -> bool:
        """Whether a team that has followed the other one follows this one; epochs of two builds are not."""
        return self.base == other.base and (self.number, self.hash) > (other.number, other.hash)

    def as_data(self) -> dict[str, object]:
        """The epoch as JSON."""
        proof = None if self.proof is None else self.proof.as_data()
        return {"number": self.number, "hash": self.hash, "base": self.base, "proof": proof}


def epoch_of(data: object) -> Epoch | None:
    """The epoch that `as_data` gave, possibly elsewhere; None if it is none."""
    if not isinstance(data, dict):
        return None
    number, name, base = data.get("number"), data.get("hash"), data.get("base")
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < MOST:
        return None
    if not isinstance(name, str) or not isinstance(base, str) or len(base) > 64:
        return None
    if not (HASH.fullmatch(name) if number else name == ""):
        return None
    return Epoch(number, name, base, proof_of(data.get("proof")))


def proof_of(data: object) -> Proof | None:
    """The proof that `as_data` gave, possibly elsewhere; None if it is none."""
    if not isinstance(data, dict):
        return None
    key, quorum, members = data.get("key"), data.get("quorum"), data.get("members")
    if not isinstance(key, str) or not isinstance(members, dict) or not all(map(_is_mac, members.values())):
        return None
    if isinstance(quorum, bool) or not isinstance(quorum, int) or not 0 < quorum <= len(members):
        return None
    return Proof(key, quorum, members)


def _is_mac(value: object) -> bool:
    return isinstance(value, str) and _MAC.fullmatch(value) is not None


_MAC = re.compile("[0-9a-f]{64}")


class EpochFile:
    """Where an agent keeps its epoch: a file in the folder of versions."""

    def __init__(self, store: Path, agent: str) -> None:
        self.path = store / f"epoch.{agent}.json"

    def read(self, base: str) -> Epoch:
        """What is kept, if it is of this build; else the first epoch of it.

        Raises:
            EpochError: the file is damaged, or cannot be read.
        """
        try:
            found = outside.loads(outside.read_bytes(self.path, LARGEST), LARGEST)
        except FileNotFoundError:
            return Epoch(base=base)
        except (OSError, ValueError) as problem:
            raise EpochError(f"{self.path} cannot be read: {problem}; remove it to begin anew") from problem
        epoch = epoch_of(found)
        if epoch is None:
            raise EpochError(f"{self.path} is damaged; remove it to begin anew")
        return epoch if epoch.base == base else Epoch(base=base)

    def write(self, epoch: Epoch) -> None:
        """Keep an epoch; the file has the old one or this one, also after a crash. Raises OSError."""
        self.path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        part = self.path.with_suffix(".part")
        with open(part, "wb", opener=lambda path, flags: os.open(path, flags, 0o600)) as file:
            file.write(json.dumps(epoch.as_data()).encode())
            file.flush()
            os.fsync(file.fileno())
        part.replace(self.path)

    def forget(self) -> None:
        """Begin anew. Raises OSError."""
        self.path.unlink(missing_ok=True)


__all__ = ["Epoch", "EpochError", "EpochFile", "Proof", "epoch_of", "proof_of"]
