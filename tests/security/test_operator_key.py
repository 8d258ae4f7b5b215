"""Control over the bus: off, unless an operator's key proves each request."""

from __future__ import annotations

import json
import os
import random
import stat
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import jsonschema
import pytest

from aseme_dsl.project.operating import swapping
from aseme_dsl.project.operating.whole_team import whole_team
from aseme_dsl.project.playing import operate
from aseme_dsl.project.playing.operable import operable
from aseme_dsl.project.playing.remote import RemoteError, Robot, robots_of
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.settings.deployment import Deployment
from aseme_dsl.runtime.control import operator_gate
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.control.operator_gate import Gate, GateError, ask
from aseme_dsl.runtime.control.operator_key import Key, KeyFileError, newest_key, read_keys, write_key
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.trace.trace import Record
from aseme_dsl.runtime.trace.trace_schema import schema
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport.access import OPERATOR, access_rules
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.version.loading import Loaded
from tests.cli import support as cli
from tests.faults.team import NAME, project, started
from tests.faults.test_network import WIRE, Mouth, certificates, mouth, port, secured, wire
from tests.faults.test_operate import Running
from tests.runtime.transport.net import Part, part
from tests.security.lines import line
from tests.support.generated import Generated
from tests.support.waiting import LONG, wait_until

__all__ = ["certificates", "mouth", "port", "wire"]

SYSTEM = "S"
STATUS = {"request": "status"}
STOP = {"request": "stop"}


class Guarded:
    """A team whose agents take requests that a key proves, without a network: it is `send`."""

    def __init__(self, team: Team, records: list[Record], keys: Path) -> None:
        self.team, self.records, self.keys = team, records, keys
        self.control = Control(team)
        self.gate = Gate(self.control, keys, SYSTEM, "life-")
        self.sent: list[bytes] = []

    def send(self, agent: str = "a") -> Callable[[bytes], list[bytes]]:
        def send(data: bytes) -> list[bytes]:
            self.sent.append(data)
            return [json.dumps(self.gate.answer(agent, data)).encode()]

        return send

    def ask(self, request: dict[str, Any], key: Key | None = None, agent: str = "a") -> dict[str, Any]:
        return ask(self.send(agent), SYSTEM, agent, key or newest_key(self.keys), request)

    def proven(self, request: dict[str, Any] = STOP, agent: str = "a") -> bytes:
        """A request with its proof as it would be sent, which the robot has not seen."""

        def send(data: bytes) -> list[bytes]:
            self.sent.append(data)
            challenge = b"challenge" in data
            return [json.dumps(self.gate.answer(agent, data)).encode()] if challenge else []

        with pytest.raises(GateError, match="does not answer"):
            ask(send, SYSTEM, agent, newest_key(self.keys), request)
        return self.sent[-1]

    def traced(self, *what: str) -> list[Record]:
        self.control.log.flush()
        return [r for r in list(self.records) if r["kind"] == "control" and r["what"] in what]

    def refused(self, data: bytes, agent: str = "a") -> str:
        """That something is refused, traced as nobody's, and changes nothing; gives the reason."""
        before = sum(record.get("count", 1) for record in self.traced("refused"))
        reply = self.gate.answer(agent, data)
        assert reply["ok"] is False and "proof" not in reply
        refusals = self.traced("refused")
        assert sum(record.get("count", 1) for record in refusals) == before + 1
        assert not any("key" in record for record in refusals)
        assert not any(one.over for one in self.team.agents)
        return str(reply["reasons"][0])


@pytest.fixture
def keys(tmp_path: Path) -> Path:
    write_key(tmp_path / "keys.toml")
    return tmp_path / "keys.toml"


@pytest.fixture
def guarded(keys: Path) -> Iterator[Guarded]:
    with Running() as (team, records):
        yield Guarded(team, records, keys)


# ---- files ---------------------------------------------------------------------------------------------


def test_a_key_is_made_and_never_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "operator.toml"
    made = cli.Here(capsys)("key", str(path))
    (name,) = read_keys(path)
    assert made.code == 0 and name in made.out
    assert read_keys(path)[name].secret.hex() not in made.out
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    before = path.read_bytes()
    again = cli.Here(capsys)("key", str(path))
    assert again.code == 1 and "is there already" in again.err
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


GOOD = f'one = "{"a" * 64}"\n'


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"\xff", "not valid TOML"),
        (b"one", "not valid TOML"),
        (b"a=" + b"[" * 9000, "not valid TOML"),
        (b'one = "abc"', "is not 64 hexadecimal digits"),
        (b"one = 1", "is not 64 hexadecimal digits"),
        (f'"o e" = "{"a" * 64}"'.encode(), "the name of a key"),
        (b"#" * 20_000, "larger than"),
    ],
)
def test_a_file_that_has_no_keys_is_refused(keys: Path, content: bytes, reason: str) -> None:
    keys.write_bytes(content)
    with pytest.raises(KeyFileError, match=reason):
        read_keys(keys)


@pytest.mark.parametrize("how", ["others", "group", "link", "pipe", "folder", "place", "missing", "owner"])
def test_a_file_that_others_can_read_or_replace_is_refused(keys: Path, how: str) -> None:
    read_keys(keys)
    match how:
        case "others":
            keys.chmod(0o604)
        case "group":
            keys.chmod(0o640)
        case "place":
            keys.parent.chmod(0o777)
        case "owner":
            if os.geteuid() != 0:
                pytest.skip("NOT TESTED: keys that belong to another user need tests that run as root")
            os.chown(keys, 65534, 65534)
        case _:
            keys.rename(keys.with_name("other"))
            if how == "link":
                keys.symlink_to(keys.with_name("other"))
            elif how == "pipe":
                os.mkfifo(keys, 0o600)
            elif how == "folder":
                keys.mkdir(0o700)
    with pytest.raises(KeyFileError):
        read_keys(keys)


# ---- the gate ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("on", [False, True])
def test_control_over_the_bus_is_off_unless_there_are_keys(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, keys: Path, on: bool
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", "")
    loaded = cast("Loaded", SimpleNamespace(name=SYSTEM, folder=tmp_path / "out" / "monas" / SYSTEM))
    with Running() as (team, _):
        answers: list[Any] = []
        transport = SimpleNamespace(
            answer=answers.append, life="", go=lambda: None, close=lambda: None, peers=dict
        )
        monkeypatch.setattr(team, "transport", transport)
        with operable(team, loaded, tmp_path, keys=keys if on else None):

            def send(data: bytes) -> list[bytes]:
                return [json.dumps(answers[0]("a", data)).encode()]

            if on:
                assert ask(send, SYSTEM, "a", newest_key(keys), STATUS)["ok"]
            else:
                with pytest.raises(GateError, match="a refuses: control over the bus is off"):
                    ask(send, SYSTEM, "a", newest_key(keys), STATUS)
        monkeypatch.undo()


def test_a_proven_request_is_answered_and_traced_with_the_key(guarded: Guarded) -> None:
    reply = guarded.ask(STATUS)
    assert [agent["name"] for agent in reply["agents"]] == ["a", "b"]
    assert guarded.ask({"request": "select", "agent": "x", "plan": "y"})["ok"] is False
    key = newest_key(guarded.keys).name
    assert [(r["what"], r["request"], r.get("key")) for r in guarded.traced("accepted", "refused")] == [
        ("accepted", "challenge", None),
        ("accepted", "status", key),
        ("accepted", "challenge", None),
        ("refused", "select", key),
    ]
    jsonschema.validate(guarded.traced("accepted")[1], schema())
    assert newest_key(guarded.keys).secret.hex().encode() not in b"".join(guarded.sent)


FORGERIES: dict[str, Callable[[dict[str, Any]], object]] = {
    "another request": lambda said: said.update(request='{"version": 1, "request": "stop"} '),
    "another nonce of its own": lambda said: said.update(own="0" * 32),
    "another life": lambda said: said.update(life="earlier-"),
    "another proof": lambda said: said.update(proof="0" * 64),
    "a short proof": lambda said: said.update(proof=said["proof"][:-1]),
    "no proof": lambda said: said.pop("proof"),
    "an empty proof": lambda said: said.update(proof=""),
    "an unknown key": lambda said: said.update(key="somebody"),
    "one more member": lambda said: said.update(force=True),
    "a number": lambda said: said.update(request=1),
    "half a character": lambda said: said.update(request="\ud800"),
    "another nonce": lambda said: said.update(nonce="0" * 32),
}


@pytest.mark.parametrize("how", FORGERIES)
@line("a robot with a certificate", "forge, replay or redirect an operator's request")
def test_what_is_forged_is_refused(guarded: Guarded, how: str) -> None:
    good = guarded.proven(STATUS)
    said = json.loads(good)
    FORGERIES[how](said)
    guarded.refused(json.dumps(said).encode())
    assert guarded.gate.answer("a", good)["ok"]  # a wrong request takes nothing from the right one
    assert "not open" in guarded.refused(good)


def test_what_is_replayed_is_refused(guarded: Guarded) -> None:
    assert guarded.ask(STATUS)["ok"]
    assert "not open" in guarded.refused(guarded.sent[-1])
    later = Gate(guarded.control, guarded.keys, SYSTEM, "later-")  # the same robot, started again
    assert later.answer("a", guarded.proven())["ok"] is False


def test_what_is_for_another_agent_life_or_system_is_refused(guarded: Guarded) -> None:
    assert "not open" in guarded.refused(guarded.proven(agent="a"), agent="b")
    for system, life in (("T", "life-"), (SYSTEM, "later-")):
        other = Gate(guarded.control, guarded.keys, system, life)
        data = guarded.proven()
        other._own = guarded.gate._own  # even if it had given the same nonce
        assert other.answer("a", data)["ok"] is False
    assert not any(agent.over for agent in guarded.team.agents)


@pytest.mark.parametrize(("system", "agent"), [(SYSTEM, "b"), ("T", "a")])
@line("a robot with a certificate", "forge, replay or redirect an operator's request")
def test_who_passes_on_the_challenge_of_another_has_nothing_done_by_it(
    guarded: Guarded, system: str, agent: str
) -> None:
    """The operator asks a robot, or a team, that answers with what robot a of this team says."""
    with pytest.raises(GateError, match="no key of this robot proves the request"):
        ask(guarded.send("a"), system, agent, newest_key(guarded.keys), STOP)
    assert not any(one.over for one in guarded.team.agents)
    assert [r["request"] for r in guarded.traced("accepted")] == ["challenge"]


def test_a_request_of_an_earlier_life_proves_nothing_in_a_later_one(guarded: Guarded) -> None:
    later = Gate(guarded.control, guarded.keys, SYSTEM, "later-")
    later._own = guarded.gate._own  # even if it had given the same nonce
    said = {**json.loads(guarded.proven()), "life": "later-"}
    reply = later.answer("a", json.dumps(said).encode())
    assert reply["reasons"] == ["no key of this robot proves the request"]
    assert not any(one.over for one in guarded.team.agents)


def test_proofs_cannot_be_exchanged_and_order_does_not_matter(guarded: Guarded) -> None:
    first, second = json.loads(guarded.proven()), json.loads(guarded.proven(STATUS))
    exchanged = {**second, "proof": first["proof"]}
    guarded.refused(json.dumps(exchanged).encode())
    guarded.refused(json.dumps({**first, "nonce": second["nonce"]}).encode())
    third, fourth = guarded.proven(STATUS), guarded.proven(STATUS)
    assert guarded.gate.answer("a", fourth)["ok"] and guarded.gate.answer("a", third)["ok"]


def test_what_is_truncated_is_refused(guarded: Guarded) -> None:
    data = guarded.proven()
    for length in range(0, len(data), 7):
        guarded.refused(data[:length])
    assert guarded.gate.answer("a", guarded.proven(STATUS))["ok"]


def test_a_wrong_key_is_refused_whatever_its_name(guarded: Guarded) -> None:
    right = newest_key(guarded.keys)
    for wrong in (Key(right.name, b"w" * 32), Key("other", right.secret), Key("other", b"w" * 32)):
        with pytest.raises(GateError, match="no key of this robot proves the request"):
            guarded.ask(STOP, wrong)
        guarded.refused(guarded.sent[-1])


@line("an operator", "control robots after the key was removed")
def test_keys_are_exchanged_while_the_team_runs(guarded: Guarded, tmp_path: Path) -> None:
    old = newest_key(guarded.keys)
    new = write_key(tmp_path / "new.toml")
    with guarded.keys.open("a") as file:
        file.write((tmp_path / "new.toml").read_text())
    assert guarded.ask(STATUS, old)["ok"] and guarded.ask(STATUS, new)["ok"]
    waiting = guarded.proven()
    (tmp_path / "new.toml").replace(guarded.keys)
    with pytest.raises(GateError, match="no key"):
        guarded.ask(STOP, old)
    assert guarded.ask(STATUS, new)["ok"]
    guarded.keys.chmod(0o644)
    assert guarded.refused(waiting) == "the robot's file of keys cannot be used: its trace says why"
    assert "run `chmod 600`" in guarded.traced("refused")[-1]["reasons"][0]


def test_who_asks_for_many_challenges_pushes_none_out_and_fills_nothing(guarded: Guarded) -> None:
    oldest = guarded.proven(STATUS)
    for number in range(1000):
        guarded.gate.answer("a", b'{"version": 1, "control": "challenge"}')
        if number % 10 == 0:
            guarded.refused(guarded.proven(STATUS).replace(b'"proof": "', b'"proof": "0', 1))
    assert not guarded.gate._spent
    assert guarded.gate.answer("a", oldest)["ok"]
    assert guarded.ask(STATUS)["ok"]


def test_of_one_proven_request_that_comes_many_times_at_once_one_counts(guarded: Guarded) -> None:
    good = guarded.proven(STATUS)
    with ThreadPoolExecutor(8) as threads:
        answers = list(threads.map(lambda _: guarded.gate.answer("a", good)["ok"], range(64)))
    assert answers.count(True) == 1


def test_two_requests_of_one_nonce_that_are_both_looked_at_before_one_counts(
    guarded: Guarded, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Keys are read after the first look at the nonce: there, each waits for the other one."""
    both = threading.Barrier(2)

    def read_together(path: Path) -> dict[str, Key]:
        both.wait(LONG)
        return read_keys(path)

    class Slow(set[str]):
        """Between a look at it and what follows from that, others have time."""

        def __contains__(self, nonce: object) -> bool:
            found = super().__contains__(nonce)
            time.sleep(0.1)
            return found

    monkeypatch.setattr(operator_gate, "read_keys", read_together)
    guarded.gate._spent = Slow()
    good = guarded.proven(STATUS)
    with ThreadPoolExecutor(2) as threads:
        answers = list(threads.map(lambda _: guarded.gate.answer("a", good), range(2)))
    (refused,) = (answer for answer in answers if not answer["ok"])
    assert "not open" in refused["reasons"][0]
    assert [r["request"] for r in guarded.traced("accepted")] == ["challenge", "status"]


def changed(good: bytes, chance: random.Random) -> bytes:
    """The same with a few changes."""
    data = bytearray(good)
    for _ in range(chance.randint(1, 4)):
        place = chance.randrange(len(data) + 1)
        match chance.randrange(4):
            case 0:
                data[place : place + 1] = chance.randbytes(1)
            case 1:
                del data[place : place + chance.randint(1, 40)]
            case 2:
                data[place:place] = bytes(chance.choices(b'{}[]",:0e\\u\x00\xff ', k=3))
            case _:
                data[place:place] = data[: chance.randint(0, len(data))]
    return bytes(data)


def says(data: bytes) -> Any:
    """What a piece of JSON says; what is none is itself."""
    try:
        return json.loads(data)
    except ValueError:
        return data


@line("a robot with a certificate", "send 1 000 requests without an operator's key")
def test_a_thousand_generated_requests_change_nothing_and_are_traced(guarded: Guarded) -> None:
    chance = random.Random(1)
    for number in range(1000):
        good = guarded.proven() if number % 4 else b'{"version": 1, "control": "x"}'
        data = changed(good, chance)
        while says(data) == says(good):  # a space more is no forgery
            data = changed(data, chance)
        assert guarded.gate.answer("a", data)["ok"] is False, data
    assert sum(record.get("count", 1) for record in guarded.traced("refused")) == 1000
    assert sum(record.get("count", 1) for record in guarded.traced("accepted")) == 750  # challenges
    assert len(guarded.traced("refused", "accepted")) < 200
    assert not any(agent.over for agent in guarded.team.agents)


def test_an_answer_is_taken_from_the_robot_only(guarded: Guarded) -> None:
    key = newest_key(guarded.keys)

    def liar(change: Callable[[dict[str, Any]], object]) -> Callable[[bytes], list[bytes]]:
        def send(data: bytes) -> list[bytes]:
            reply = guarded.gate.answer("a", data)
            if "proof" in reply:
                change(reply)
            return [json.dumps(reply).encode()]

        return send

    for change in (
        lambda reply: reply.update(answer='{"ok": true}'),
        lambda reply: reply.update(proof="0" * 64),
        lambda reply: reply.update(proof=json.loads(guarded.sent[-1])["proof"]),
        lambda reply: reply.pop("proof"),
    ):
        guarded.proven()
        with pytest.raises(GateError):
            ask(liar(change), SYSTEM, "a", key, STATUS)
    with pytest.raises(GateError, match=r"a refuses: red$"):
        ask(lambda data: [b"\xff", b"[]", b'{"reasons": ["\\u001bred"]}'], SYSTEM, "a", key, STATUS)


# ---- the network ---------------------------------------------------------------------------------------


def controlled(one: Part, keys: Path) -> Part:
    """A part whose agents can be controlled over its network."""
    one.team.transport.answer(Gate(Control(one.team), keys, WIRE, one.team.transport.life).answer)
    return one


@line("an operator", "control robots over their network")
def test_the_right_key_controls_robots_over_their_bus(wire: Generated, mouth: Mouth, keys: Path) -> None:
    pytest.importorskip("zenoh")
    parts = [part(wire, [name], mouth.activities, ZenohLink(WIRE, Network())) for name in ("ann", "bob")]
    ann, bob = (controlled(one, keys).start() for one in parts)
    configuration = Configuration(keys.parent)
    wait_until(lambda: bob.team.transport.is_there("ann"))
    with robots_of(WIRE, ("ann", "bob"), configuration, keys) as robots:
        found = operate.nodes(keys.parent, robots)
        assert [node.agents for node in found] == [("ann",), ("bob",)]
        assert operate.select(keys.parent, "bob", "Speaker", robots)["plan"] == "Wire.Speaker"
    wrong = write_key(keys.with_name("wrong.toml"))
    with (
        robots_of(WIRE, ("bob",), configuration, keys.with_name("wrong.toml")) as robots,
        pytest.raises(operate.OperateError, match="bob refuses: no key of this robot"),
    ):
        operate.select(keys.parent, "bob", "Ear", robots)
    ann.stop()
    bob.stop()
    assert [r["plan"] for r in bob.of("select")] == ["Wire.Speaker"]
    assert {r.get("key") for r in bob.of("control")} == {None, newest_key(keys).name}
    assert wrong.name not in {r.get("key") for r in bob.of("control")}
    assert bob.news("untrusted") == []  # the operator is not of the team


@line("an operator", "speak for a robot, or hear what robots say")
def test_an_operator_s_certificate_is_good_for_control_only(
    wire: Generated, mouth: Mouth, certificates: Path, port: int, keys: Path
) -> None:
    zenoh = pytest.importorskip("zenoh")
    own = secured(
        certificates,
        "bob",
        listen=(f"tls/127.0.0.1:{port}",),
        robot="bob",
        team=("ann", "bob"),
        controlled=True,
    )
    bob = controlled(part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, own)), keys).start()
    mine = secured(
        certificates,
        OPERATOR,
        listen=(),
        connect=(f"tls/127.0.0.1:{port}",),
        robot=OPERATOR,
        team=("ann", "bob"),
        controlled=True,
    )
    link = ZenohLink(WIRE, mine)
    link.visit(OPERATOR)
    key = newest_key(keys)
    assert Robot("bob", WIRE, key, link).ask({"version": 1, **STATUS}, 10.0)["ok"]
    link.close()
    config = zenoh.Config()
    free = secured(certificates, OPERATOR, listen=(), connect=(f"tls/127.0.0.1:{port}",))  # no own rules
    for name, value in free.settings():
        config.insert_json5(name, value)
    session = zenoh.open(config)
    heard: list[str] = []

    def spy(sample: Any) -> None:
        if sample.payload.to_bytes():  # what is sent from here is empty
            heard.append(str(sample.key_expr))

    kept = [session.declare_subscriber("**", spy)]
    kept += [session.liveliness().declare_token(f"asemec/{WIRE}/here/ann/1")]
    wait_until(lambda: list(session.info.peers_zid()))
    session.put(f"asemec/{WIRE}/to/bob/ann/team/signal/M", b"", attachment=b"\xff")
    for asked in (f"asemec/{WIRE}/history/bob", f"asemec/{WIRE}/*/bob", "asemec/**"):
        assert list(session.get(asked, payload=b"{}", timeout=1.0)) == []
    with_control = list(session.get(f"asemec/{WIRE}/control/bob", payload=b"{}", timeout=5.0))
    session.close()
    bob.stop()
    assert len(with_control) == 1  # what is allowed comes after the rest, by the same connection
    assert heard == [] and bob.of("peer") == []


def test_a_robot_that_does_not_answer_is_said(wire: Generated, keys: Path) -> None:
    pytest.importorskip("zenoh")
    with (
        robots_of(WIRE, ("ann",), Configuration(keys.parent), keys) as (ann,),
        pytest.raises(RemoteError, match="ann does not answer"),
    ):
        ann.ask(STATUS, 0.2)


def test_commands_reach_a_team_with_the_key_of_its_project(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("zenoh")
    write_key(tmp_path / "operator.toml")
    (tmp_path / "team").mkdir(mode=0o700)
    folder = project(tmp_path / "team" / "talk", configuration='control = "../../operator.toml"\n')
    asemec = cli.Here(capsys)
    with started(folder) as run:
        run.wait_for_talk()
        monkeypatch.chdir(folder)
        key = str(tmp_path / "operator.toml")
        done = asemec("team", "status", "--key", key, "--json")
        assert done.code == 0, done.err
        assert {process["agents"][0]["name"] for process in done.json["processes"]} == {
            "robot1",
            "robot2",
            "robot3",
        }
        text = (folder / "talk.aseme").read_text()
        (folder / "new.aseme").write_text(text.replace("Hear every 20ms", "Hear every 30ms"))
        swapped = asemec("team", "swap", "new.aseme", "--key", key)
        assert swapped.code == 0, swapped.err
        assert f"{NAME} swapped to model" in swapped.out
        (folder / "newer.aseme").write_text(text.replace("Hear every 20ms", "Hear every 40ms"))
        monkeypatch.setattr(operate, "write_version", lambda *given: ("0" * 64, "none"))
        refused = asemec("team", "swap", "newer.aseme", "--key", key)
        assert refused.code == 1
        assert "copy it there first" in refused.err
        write_key(tmp_path / "wrong.toml")
        assert asemec("team", "status", "--key", str(tmp_path / "wrong.toml")).code == 1
        run.wait_for(lambda: [r for r in run.trace("robot1") if r["kind"] == "swap"])
        assert run.end() == 130
    assert {r["origin"] for r in run.trace("robot1") if r["kind"] == "control"} == {"bus"}


class Half:
    """A robot that confirms, and is not heard of any more from a phase on."""

    def __init__(self, name: str, lost: str = "") -> None:
        self.name, self.lost, self.gone, self.done = name, lost, False, False
        self.waited: dict[str, float] = {}
        self.system, self.key = "S", Key("k", bytes(32))

    def __str__(self) -> str:
        return self.name

    def ask(self, request: dict[str, Any], timeout: float) -> dict[str, Any]:
        phase = str(request.get("phase", ""))
        self.waited[phase] = timeout
        self.gone |= phase != "" and phase == self.lost
        if self.gone:
            raise RemoteError(f"{self.name} does not answer")
        if phase == "finish":
            self.done = True
        agent = {"name": self.name, "model": "new"}
        epoch = {"number": int(self.done), "hash": "0" * 64 if self.done else "", "base": "m"}
        status = {"agents": [agent], "swap": None, "epoch": epoch, "held": None}
        return {"ok": True, "state": "prepared", "id": 1, "reasons": [], "notes": [], **status}


@pytest.mark.parametrize("phase", ["commit", "finish"])
def test_robots_that_have_not_changed_are_named(
    phase: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(swapping, "HOLD", 0.0)
    monkeypatch.setattr(operate, "Robot", Half)
    robots = [Half("ann"), Half("bob", lost=phase)]
    done = swapping.swap(whole_team(tmp_path, cast("list[Robot]", robots)), "0" * 64)
    assert done.changed == (("ann",) if phase == "finish" else ())
    assert done.unchanged["bob"] == "bob does not answer: it may have changed"
    assert done.unknown == ("bob",) and not done.is_whole


def test_robots_hear_what_follows_before_they_decide_alone(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(operate, "Robot", Half)
    robots = [Half("ann"), Half("bob"), Half("cat", lost="prepare")]
    done = swapping.swap(whole_team(tmp_path, cast("list[Robot]", robots)), "0" * 64, quorum="2")
    assert done.changed == ("ann", "bob") and set(done.unchanged) == {"cat"} and not done.unknown
    assert robots[2].waited["prepare"] + 1.0 < swapping.HOLD
    assert robots[0].waited["commit"] + 1.0 < swapping.HOLD


def test_a_project_says_where_the_keys_are() -> None:
    from aseme_dsl.project.settings.deployment import keys_of

    assert keys_of(None, "ann") is None and keys_of(Deployment(), "ann") is None
    assert keys_of(Deployment(control=Path("keys/ROBOT.toml")), "ann") == Path("keys/ann.toml")


def test_an_operator_connects_to_all_hosts_and_listens_nowhere(tmp_path: Path) -> None:
    from aseme_dsl.project.settings.configuration import configuration_of
    from aseme_dsl.project.settings.deployment import network_of
    from aseme_dsl.source import Source

    text = """\
[tool.asemec.deploy]
hosts = { ann = "10.0.0.1", bob = "10.0.0.2:7448" }
interface = "lo"
control = "ROBOT.toml"
[tool.asemec.deploy.tls]
authority = "authority.pem"
certificate = "ROBOT.pem"
key = "ROBOT.key"
"""
    configuration, problems = configuration_of(Source("pyproject.toml", text))
    network = network_of(configuration.deploy, OPERATOR, ("ann", "bob"))
    assert problems == ()
    assert network.listen == ()
    assert network.connect == ("tls/10.0.0.1:7447", "tls/10.0.0.2:7448")
    assert network.tls is not None and network.tls.certificate == Path("asemec-operator.pem")
    rules = access_rules(network.robot, network.team, network.controlled)["rules"]
    assert {key for rule in rules for key in rule["key_exprs"]} == {
        *(f"asemec/*/control/{name}" for name in ("ann", "bob")),
        *(f"asemec/*/*/{name}" for name in ("ann", "bob")),
    }
    own = access_rules("bob", network.team, controlled=False)["subjects"]
    assert OPERATOR not in {subject["id"] for subject in own}
