"""Proofs of epochs: an operator's key proves to each member that an operator has made an epoch.

Members tell each other of epochs. The proof for a member is made with its own part of the key (`Key.of`). So
a member that has no more than its own part cannot invent an epoch for another one.
"""

from __future__ import annotations

import hmac
import json
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

from aseme_dsl.runtime.control.operator_key import Key, KeyFileError, proof, read_keys
from aseme_dsl.runtime.version.epochs import Epoch, Proof

Doubt = Callable[[Epoch], str]
"""Why an epoch is not followed; empty if it is."""


def proven(key: Key, system: str, epoch: Epoch, members: Iterable[str], quorum: int) -> Epoch:
    """An epoch with a proof for each member for which the key is known."""
    known = {name: secret for name in sorted(members) if (secret := key.of(name)) is not None}
    macs = {name: _mac(secret, system, name, epoch, quorum, known) for name, secret in known.items()}
    return replace(epoch, proof=Proof(key.name, quorum, macs))


def doubt_of(keys: Path, system: str, robot: str) -> Doubt:
    """What a robot holds against an epoch if it accepts the keys of a file, which is read each time."""

    def doubt(epoch: Epoch) -> str:
        name = f"epoch {epoch.number}"
        if epoch.proof is None:
            return f"{name} has no proof of an operator's key: use `asemec team swap --key FILE`"
        try:
            key = read_keys(keys).get(epoch.proof.key)
        except KeyFileError as problem:
            return f"{name} cannot be checked: {problem}"
        secret = None if key is None else key.of(robot)
        if secret is None:
            return f"{name} is proven by the key {epoch.proof.key[:40]!r}, which is not accepted here"
        if robot not in epoch.proof.members:
            return f"the proof of {name} is not for {robot}"
        right = _mac(secret, system, robot, epoch, epoch.proof.quorum, epoch.proof.members)
        return (
            "" if hmac.compare_digest(right, epoch.proof.members[robot]) else f"the proof of {name} is wrong"
        )

    return doubt


def no_doubt(epoch: Epoch) -> str:
    """Agents of one machine and user believe each other: they know the secret of the team."""
    return ""


def all_doubt(epoch: Epoch) -> str:
    """Without operators' keys, no epoch of another machine can be proven."""
    return f"epoch {epoch.number} cannot be proven here: no `control` names operators' keys"


def _mac(secret: bytes, system: str, robot: str, epoch: Epoch, quorum: int, members: Iterable[str]) -> str:
    about = [system, robot, epoch.number, epoch.hash, epoch.base, quorum, *sorted(members)]
    return proof("epoch", secret, [json.dumps(part) for part in about])


__all__ = ["Doubt", "all_doubt", "doubt_of", "no_doubt", "proven"]
