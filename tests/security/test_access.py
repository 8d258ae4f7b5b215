"""Each certificate against the names, keys and control of the robots of a team: nothing is possible.

Two robots, `ann` and `bob`, with TLS on the loopback interface. The attacker is a process of its own, whose
Zenoh session keeps none of our rules; it has one of the certificates below, and tries everything at once.
"""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from aseme_dsl.runtime.transport import Network, Tls
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.access import OPERATOR
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Answer, Stamp
from tests.security.lines import line
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

pytest.importorskip("zenoh")
pytest.importorskip("cryptography")

SYSTEM = own_name("Guarded")
TEAM = ("ann", "bob", "mallory")
LIFE = {"ann": 0xA1, "bob": 0xB2}
OWN_ANSWER = b"of bob himself"

ATTACK = """
import json, os, sys, time
import zenoh
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope

sys.excepthook = lambda *error: (sys.__excepthook__(*error), os._exit(1))  # zenoh would wait
system, settings = sys.argv[1], json.loads(sys.argv[2])
config = zenoh.Config()
for key, value in settings.items():
    config.insert_json5(key, value)
session = zenoh.open(config)
time.sleep(1.0)
root = f"asemec/{system}"
heard, asked, tokens, kept = [], [], [], []
def note(sample):  # what it says itself comes back to it
    if sample.payload.to_bytes() not in (b"forged", b""):
        heard.append(str(sample.key_expr))
for key in ("to/bob/**", "to/ann/**", "to/*/*/**", "**"):
    kept.append(session.declare_subscriber(f"{root}/{key}", note))
def answer(query):
    if query.payload is not None and query.payload.to_bytes() == b"own":
        asked.append(str(query.key_expr))
    mark = envelopes.written(Envelope(0, incarnation=0xB2), b"forged")
    for what in ("history", "control"):
        for name in ("ann", "bob"):
            try:
                query.reply(f"{root}/{what}/{name}", b"forged", attachment=mark)
            except Exception:
                pass
for key in ("history/ann", "history/bob", "control/ann", "control/bob", "*/ann", "*/bob", "**"):
    kept.append(session.declare_queryable(f"{root}/{key}", answer, complete=True))
for name in ("ann", "bob", "*"):
    for life in ("1", "a1", "b2", "ffffffffffffffff"):
        tokens.append(session.liveliness().declare_token(f"{root}/here/{name}/{life}"))
tokens.append(session.liveliness().declare_token(f"{root}/**"))
print("= ready", flush=True)
sys.stdin.readline()
end = time.monotonic() + 1.0
while time.monotonic() < end:
    mark = envelopes.written(Envelope(0, incarnation=0xA1, channel="team.signal.M"), b"forged")
    for way in ("bob/ann", "ann/bob", "bob/bob", "*/*", "bob/*", "*/ann"):
        to, sender = way.split("/")
        for way in ("team/signal/M", "ping", "mail"):
            session.put(f"{root}/to/{to}/{sender}/{way}", b"forged", attachment=mark)
            session.delete(f"{root}/to/{to}/{sender}/{way}", attachment=mark)
    session.put(f"{root}/**", b"forged", attachment=mark)
    session.put("asemec/**", b"forged", attachment=mark)
    time.sleep(0.05)
answers = 0
end = time.monotonic() + float(sys.argv[3])  # who may be answered may have to wait for that, under load
while True:
    for key in ("control/bob", "control/ann", "*/bob", "**"):
        question = b'{"version":1,"request":"stop"}'
        got = session.get(f"{root}/{key}", payload=question, timeout=2.0, target=zenoh.QueryTarget.ALL)
        oks = [reply.ok for reply in got if reply.ok is not None]
        answers += len([ok for ok in oks if ok.payload.to_bytes() != b"forged"])
    if answers or time.monotonic() >= end:
        break
result = {
    "peers": len(list(session.info.peers_zid())) + len(list(session.info.routers_zid())),
    "heard": heard, "asked": asked, "answers": answers,
}
for token in tokens:
    token.undeclare()
print(f"= {json.dumps(result)}", flush=True)
session.close()
"""


@dataclass
class Ears:
    """Notes what a robot's link reports, and answers questions for it."""

    name: str
    heard: list[tuple[str, bytes]] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    news: list[str] = field(default_factory=list)
    questions: list[str] = field(default_factory=list)

    def arrived(self, to: str, sender: str, envelope: Envelope, payload: bytes) -> None:
        self.heard.append((sender, payload))

    def unreadable(self, to: str, sender: str, reason: str) -> None:
        self.wrong.append(f"{sender}: {reason}")

    def appeared(self, agent: str, incarnation: int) -> None:
        if agent != self.name or incarnation != LIFE.get(agent, 0xC3):  # not our own token
            self.news.append(f"{agent} {incarnation:x} appeared")

    def vanished(self, agent: str, incarnation: int) -> None:
        self.news.append(f"{agent} {incarnation:x} vanished")

    def asked(self, to: str, what: str, question: bytes) -> Iterable[Answer]:
        self.questions.append(f"{what} {question.decode()}")
        yield Envelope(envelopes.ACKNOWLEDGE, incarnation=LIFE[to], upto=1), OWN_ANSWER


@pytest.fixture(scope="module")
def certificates(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The certificates: of the team, of its operator, of another authority, and one that has expired."""
    from aseme_dsl.project.deploying import certificates as made
    from aseme_dsl.project.settings.deployment import TlsFiles

    folder = tmp_path_factory.mktemp("certificates")

    def files(name: str) -> made.Files:
        place = folder / name
        return made.Files(TlsFiles(place / "authority.pem", place / "ROBOT.pem", place / "ROBOT.key"))

    address = ("127.0.0.1",)
    made.make(files("team"), {name: address for name in (*TEAM, "visitor")}, "team")
    made.make(files("other"), {name: address for name in ("ann", "mallory")}, "other")
    team = files("team")
    pair = made._signed(made._issuer(team), "ann", address, 0)
    made._write_pair(team.certificate("expired"), team.key("expired"), *pair)
    time.sleep(1.1)
    return folder


@pytest.fixture
def ports() -> dict[str, int]:
    with socket.socket() as one, socket.socket() as two:
        one.bind(("127.0.0.1", 0))
        two.bind(("127.0.0.1", 0))
        return {"ann": one.getsockname()[1], "bob": two.getsockname()[1]}


@dataclass
class Robots:
    """The two robots, and what they have heard."""

    links: dict[str, object]
    ears: dict[str, Ears]
    ports: dict[str, int]


def tls(certificates: Path, name: str, authority: str = "team") -> Tls:
    place = certificates / authority
    return Tls(place / "authority.pem", place / f"{name}.pem", place / f"{name}.key")


@pytest.fixture
def robots(certificates: Path, ports: dict[str, int]) -> Iterator[Robots]:
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

    found = Robots({}, {}, ports)
    for name, other in (("bob", "ann"), ("ann", "bob")):
        network = Network(
            listen=(f"tls/127.0.0.1:{ports[name]}",),
            connect=(f"tls/127.0.0.1:{ports[other]}",),
            tls=tls(certificates, name),
            robot=name,
            team=TEAM,
            controlled=True,
        )
        link = ZenohLink(SYSTEM, network)
        ears = Ears(name)
        link.open([name], LIFE[name], ears)  # type: ignore[arg-type]
        found.links[name], found.ears[name] = link, ears
    try:
        wait_until(lambda: found.ears["bob"].news == ["ann a1 appeared"] and bool(found.ears["ann"].news))
        yield found
    finally:
        for link in found.links.values():
            link.close()  # type: ignore[attr-defined]


HOW = {
    "robot of the team": ("mallory", "team"),
    "operator": (OPERATOR, "team"),
    "not of the team": ("visitor", "team"),
    "other authority": ("ann", "other"),
    "expired": ("expired", "team"),
    "none": ("mallory", "team"),
    "no tls": ("mallory", "team"),
}
LET_IN = ("robot of the team", "operator", "not of the team")


def settings_of(how: str, certificates: Path, ports: dict[str, int], mode: str) -> dict[str, str]:
    """The Zenoh configuration of an attacker with a certificate; no access rules of ours are in it."""
    name, authority = HOW[how]
    ends = tuple(f"tls/127.0.0.1:{port}" for port in ports.values())
    files = tls(certificates, name, authority)
    if authority != "team":  # it trusts the team's authority and has its own certificate
        files = Tls(certificates / "team" / "authority.pem", files.certificate, files.key)
    settings = dict(Network(connect=ends, tls=files).settings())
    settings["mode"] = json.dumps(mode)
    if how == "none":
        settings = {k: v for k, v in settings.items() if "connect_" not in k and "mtls" not in k}
    if how == "no tls":
        settings["connect/endpoints"] = settings["connect/endpoints"].replace("tls/", "tcp/")
    settings["connect/timeout_ms"] = "0"
    settings["connect/exit_on_failure"] = "false"
    return settings


CASES = [
    *((how, "peer") for how in HOW),
    ("robot of the team", "client"),
    ("robot of the team", "router"),
    ("operator", "router"),
    ("robot of the team", "ann's session"),
]


@line("a machine with an expired certificate, or one of another authority", "reach the team")
@line("a robot with a certificate", "take the session of another robot")
@pytest.mark.parametrize(("how", "mode"), CASES)
def test_nothing_is_possible_with_a_certificate_for_another_name(
    robots: Robots, certificates: Path, how: str, mode: str
) -> None:
    settings = settings_of(how, certificates, robots.ports, mode)
    if mode == "ann's session":  # its number, which all robots of the team know
        zid = str(robots.links["ann"]._session.info.zid())  # type: ignore[attr-defined]
        settings |= {"mode": '"peer"', "id": json.dumps(zid)}
    patience = LONG / 2 if (how, mode) == ("operator", "peer") else 0
    attacker = subprocess.Popen(
        [sys.executable, "-c", ATTACK, SYSTEM, json.dumps(settings), str(patience)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert attacker.stdout is not None
    assert attacker.stdout.readline().strip() == "= ready"
    ann, bob = robots.links["ann"], robots.links["bob"]
    answers: list[bytes] = []
    sent = 0
    over = threading.Event()

    def work() -> None:
        nonlocal sent
        while not over.is_set():
            sent += 1
            for link, to, sender in ((ann, "bob", "ann"), (bob, "ann", "bob")):
                envelope = Envelope(envelopes.MESSAGE, incarnation=LIFE[sender], channel="team.signal.M")
                link.send(to, sender, "team/signal/M", envelope, Stamp(), b"own", True)  # type: ignore[attr-defined]
            for _, payload in ann.ask("bob", "history", b"own", 2.0):  # type: ignore[attr-defined]
                answers.append(payload)
            time.sleep(0.02)

    worker = threading.Thread(target=work)
    worker.start()
    lines = attacker.communicate("\n", LONG)[0].splitlines()
    over.set()
    worker.join()
    assert attacker.returncode == 0
    (said,) = [text for text in lines if text.startswith("= ")]
    found = json.loads(said[2:])
    for name, ears in robots.ears.items():
        other = "ann" if name == "bob" else "bob"
        assert ears.news == [f"{other} {LIFE[other]:x} appeared"]  # no token for another name
        assert set(ears.heard) == {(other, b"own")} and ears.wrong == []  # nothing in its name
        assert set(ears.questions) - {"history own"} <= (ALLOWED if how == "operator" else set())
    assert sent > 10 and len(answers) == sent and set(answers) == {OWN_ANSWER}  # no other answer
    assert found["heard"] == [] and found["asked"] == []  # nothing that is for others
    assert (found["peers"] > 0) is (how in LET_IN and mode != "ann's session")
    if (how, mode) == ("operator", "peer"):
        assert found["answers"] > 0  # a robot answers that the request needs a key
    elif how != "operator":
        assert found["answers"] == 0


ALLOWED = {'control {"version":1,"request":"stop"}'}
"""An operator's certificate may ask for control. The robot then asks for the key (`test_operator_key`)."""


@pytest.mark.parametrize(("authority", "meets"), [("team", True), ("other", False)])
def test_of_agents_that_are_looked_for_the_certificate_counts_not_the_address(
    certificates: Path, authority: str, meets: bool
) -> None:
    """With `interface`, nothing says at which address an agent is: its certificate need not name one."""
    from aseme_dsl.project.deploying import certificates as made
    from aseme_dsl.project.settings.deployment import TlsFiles
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

    place = certificates / authority
    files = made.Files(TlsFiles(place / "authority.pem", place / "ROBOT.pem", place / "ROBOT.key"))
    made.make(files, {"roaming": ()}, "team")
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        port = one.getsockname()[1]
    team = ("ann", "roaming")
    links = []
    ears = {name: Ears(name) for name in team}
    for name, ends in (("roaming", {"listen": (f"tls/127.0.0.1:{port}",)}), ("ann", {})):
        own = authority if name == "roaming" else "team"
        ends = ends or {"connect": (f"tls/127.0.0.1:{port}",)}
        network = Network(interface="lo", tls=tls(certificates, name, own), robot=name, team=team, **ends)  # type: ignore[arg-type]
        links.append(ZenohLink(SYSTEM, network))
        links[-1].open([name], LIFE.get(name, 0xC3), ears[name])  # type: ignore[arg-type]
    try:
        if meets:
            wait_until(lambda: ears["ann"].news == ["roaming c3 appeared"])
        else:
            time.sleep(2.0)
            assert ears["ann"].news == []
    finally:
        for link in links:
            link.close()
