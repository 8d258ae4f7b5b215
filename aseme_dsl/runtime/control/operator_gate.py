"""The gate for control over a network: only requests that an operator's key proves come through.

The operator asks a robot for a challenge, and uses it for one request:

- `{"version": 1, "control": "challenge"}`
  The answer has system, agent, incarnation and nonce of the robot.
- `{"version": 1, "control": "request", "life": "…", "nonce": "…", "own": "…", "key": "k3f9a2c81",
  "request": "{…}", "proof": "…"}`
  `own` is a nonce of the operator, `request` a request as `control` knows it, as a text. The reply has the
  answer, as a text, and its proof.

A proof is the HMAC-SHA256 of all that it is about: system, agent, incarnation and both nonces, the request,
and for the answer that, too. Its key is what follows from the operator's for this agent. So what is sent
to one agent, in one incarnation, once, is good for nothing else, and the operator knows that the agent has
answered. No clock is asked. A nonce is consumed by the first proven request that names it. The robot knows
its own nonces by a tag in them and keeps none that is not consumed: no client can push an operator's
challenge out by asking for many.
"""

from __future__ import annotations

import hmac
import json
import re
import secrets
import threading
from collections.abc import Callable, Iterable
from pathlib import Path

from aseme_dsl.outside import loads
from aseme_dsl.runtime.control.control import FORMAT, LARGEST, Control
from aseme_dsl.runtime.control.control_log import Origin
from aseme_dsl.runtime.control.operator_key import SECRET_BYTES, Key, KeyFileError, proof, read_keys
from aseme_dsl.runtime.control.replies import Reply, as_reply

_TAG = 16
"""So many bytes of a robot's nonce are random, and as many are their tag."""
_WHOLE = 4 * LARGEST
"""With what proves it, a request has at most so many bytes."""
_ANSWER = 1 << 22
_NONCE = re.compile("[0-9a-f]{32}")
_CHALLENGE = re.compile("[0-9a-f]{64}")
_PROOF = re.compile("[0-9a-f]{64}")
_REQUEST = {"version", "control", "life", "nonce", "own", "key", "request", "proof"}


class GateError(Exception):
    """A robot does not answer, or refuses to listen; the text says why."""


class Gate:
    """Lets through to a robot's control what is proven. May be used from any thread."""

    def __init__(self, control: Control, keys: Path, system: str, life: str) -> None:
        """`keys` is the file of the keys that are accepted; `life` tells this process from earlier ones."""
        self._control = control
        self._keys = keys
        self._system = system
        self._life = life
        self._lock = threading.Lock()
        self._own = secrets.token_bytes(SECRET_BYTES)
        """What the tags of this gate's nonces are made with."""
        self._spent: set[str] = set()
        self._nobody = secrets.token_bytes(SECRET_BYTES)

    def answer(self, agent: str, data: bytes) -> Reply:
        """The answer to what came for an agent over the network. Never raises for what is in it."""
        try:
            said = loads(data, _WHOLE, 4)
            if said == {"version": FORMAT, "control": "challenge"}:
                return self._challenge(agent)
            return self._request(agent, said)
        except (ValueError, RecursionError) as problem:
            return self._control.refuse(Origin("bus", agent=agent), None, f"not a proven request: {problem}")

    def _challenge(self, agent: str) -> Reply:
        chance = secrets.token_bytes(_TAG)
        nonce = (chance + self._tag(agent, chance)).hex()
        self._control.log.note(Origin("bus", agent=agent), "challenge", ())
        return {
            "version": FORMAT,
            "ok": True,
            "system": self._system,
            "agent": agent,
            "life": self._life,
            "nonce": nonce,
        }

    def _tag(self, agent: str, chance: bytes) -> bytes:
        return hmac.digest(self._own, chance + agent.encode(), "sha256")[:_TAG]

    def _is_open(self, agent: str, nonce: str) -> bool:
        """Whether this gate has given a nonce for this agent, and it is not consumed."""
        if not _CHALLENGE.fullmatch(nonce):
            return False
        made = bytes.fromhex(nonce)
        is_ours = hmac.compare_digest(made[_TAG:], self._tag(agent, made[:_TAG]))
        return is_ours and nonce not in self._spent

    def _request(self, agent: str, said: object) -> Reply:
        """Raises ValueError if it is not such a request."""
        origin = Origin("bus", agent=agent)
        if not isinstance(said, dict) or set(said) != _REQUEST or said["control"] != "request":
            raise ValueError("it has other members")
        if said["version"] != FORMAT or not all(isinstance(said[x], str) for x in _REQUEST - {"version"}):
            raise ValueError("a member is not what it should be")
        if not (_NONCE.fullmatch(said["own"]) and _PROOF.fullmatch(said["proof"])):
            raise ValueError("a nonce or the proof is not what it should be")
        request = said["request"].encode()
        about = (self._system, agent, self._life, said["key"], said["nonce"], said["own"])
        closed = "the challenge is not open here: ask for a new one"
        if said["life"] != self._life or not self._is_open(agent, said["nonce"]):
            return self._control.refuse(origin, None, closed)
        try:
            key = read_keys(self._keys).get(said["key"])
            secret = None if key is None else key.of(agent)
        except KeyFileError as problem:  # who asks need not know more
            refusal = self._control.refuse(origin, None, str(problem))
            return {**refusal, "reasons": ["the robot's file of keys cannot be used: its trace says why"]}
        right = proof("request", self._nobody if secret is None else secret, about, request)
        if not hmac.compare_digest(right, said["proof"]) or key is None or secret is None:
            return self._control.refuse(origin, None, "no key of this robot proves the request")
        with self._lock:  # of several at once, one
            is_first = said["nonce"] not in self._spent
            self._spent.add(said["nonce"])
        if not is_first:
            return self._control.refuse(origin, None, closed)
        reply = self._control.read(request, Origin("bus", agent=agent, key=key.name))
        answer = json.dumps(reply)
        return {
            "version": FORMAT,
            "ok": True,
            "answer": answer,
            "proof": proof("answer", secret, about, request, answer.encode()),
        }


def ask(
    send: Callable[[bytes], Iterable[bytes]], system: str, agent: str, key: Key, request: dict[str, object]
) -> Reply:
    """The proven reply of an agent to a request (without its `version`, which is put in).

    `send` brings data to the agent, and gives the answers, which may come from any sender.

    Raises:
        GateError: no answer comes from an agent with the key.
    """
    question = json.dumps({"version": FORMAT, "control": "challenge"}).encode()
    refusals: list[str] = []
    secret = key.of(agent)
    if secret is None:
        raise GateError(f"the key {key.name} is not for {agent}, but for {', '.join(key.robots)}")
    text = json.dumps({"version": FORMAT, **request})
    for challenge in _objects(send(question)):
        life, nonce = challenge.get("life"), challenge.get("nonce")
        if not (isinstance(life, str) and isinstance(nonce, str) and _CHALLENGE.fullmatch(nonce)):
            refusals += _reasons(challenge)
            continue
        own = secrets.token_hex(16)
        about = (system, agent, life, key.name, nonce, own)
        asked = {
            "version": FORMAT,
            "control": "request",
            "life": life,
            "nonce": nonce,
            "own": own,
            "key": key.name,
            "request": text,
            "proof": proof("request", secret, about, text.encode()),
        }
        for found in _objects(send(json.dumps(asked).encode())):
            answer, given = found.get("answer"), found.get("proof")
            if isinstance(answer, str) and isinstance(given, str) and _PROOF.fullmatch(given):
                right = proof("answer", secret, about, text.encode(), answer.encode())
                if hmac.compare_digest(right, given):
                    reply = loads(answer, _ANSWER)
                    assert isinstance(reply, dict)  # a robot of the key has said it
                    return as_reply(reply)
                refusals.append("the answer is not proven by the key")
            refusals += _reasons(found)
    raise GateError(f"{agent} refuses: {refusals[0]}" if refusals else f"{agent} does not answer")


def _objects(answers: Iterable[bytes]) -> Iterable[dict[str, object]]:
    for data in answers:
        try:
            found = loads(data, 2 * _ANSWER)
        except (ValueError, RecursionError):
            continue
        if isinstance(found, dict):
            yield found


def _reasons(answer: dict[str, object]) -> list[str]:
    """The reasons for a refusal, from a sender that has proven nothing: safe to print."""
    given = answer.get("reasons", [answer.get("error")])
    texts = [text for text in given if isinstance(text, str)] if isinstance(given, list) else []
    return ["".join(letter for letter in text[:200] if letter.isprintable()) for text in texts[:3]]
