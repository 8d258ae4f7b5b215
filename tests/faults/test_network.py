"""The network itself: peers that send nonsense, links that break, strangers without a certificate."""

from __future__ import annotations

import contextlib
import json
import shutil
import socket
import subprocess
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.transport import Access, Network, Tls, TransportError
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.access import OPERATOR, access_rules
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.transport.settings import LARGEST
from tests.runtime.transport.net import Part, part
from tests.support.generated import Generated, generate
from tests.support.network import own_name, own_port
from tests.support.waiting import wait_until

zenoh = pytest.importorskip("zenoh")

TEAM = """
system Wire
message M { int n }
topic team { signal M queued  state M  data M }
srm Speaker { liveness { Speaker = Say }  activities { Say writes team.signal.M, team.state.M, team.data.M } }
srm Ear { liveness { Ear = Hear } activities { Hear reads team.signal.M, team.state.M, team.data.M } }
team T { ann : Speaker  bob : Ear }
"""
WIRE = own_name("Wire")
"""What the team is called on the network."""


@pytest.fixture
def port() -> Iterator[int]:
    with own_port() as found:
        yield found


@pytest.fixture(scope="module")
def wire() -> Generated:
    return generate(TEAM)


class Mouth:
    """What ann says is put here."""

    def __init__(self, generated: Generated) -> None:
        self.say: list[tuple[str, int]] = []
        self.over = threading.Event()
        mouth = self

        class Say:
            def execute(self, context: Context) -> None:
                while not mouth.over.is_set():
                    while mouth.say:
                        channel, n = mouth.say.pop(0)
                        context.publish(channel, generated.message("M", n=n))
                    context.wait(0.002)

        class Hear:
            def execute(self, context: Context) -> None:
                while not mouth.over.is_set():
                    context.wait(0.02)

        self.activities: dict[str, type[Any]] = {"Say": Say, "Hear": Hear}


@pytest.fixture
def mouth(wire: Generated) -> Iterator[Mouth]:
    found = Mouth(wire)
    yield found
    found.over.set()


def is_listened_on(port: int) -> bool:
    try:
        socket.create_connection(("127.0.0.1", port)).close()
    except OSError:
        return False
    return True


def heard(bob: Part, channel: str = "team.signal.M") -> list[int]:
    return [r["message"]["n"] for r in bob.of("arrived", channel=channel)]


# ---- a peer that sends nonsense ----------------------------------------------------------------


class Hostile:
    """A Zenoh session that says it is ann, or anybody, and sends what it likes."""

    def __init__(self, generated: Generated, name: str = "ann") -> None:
        self.link = ZenohLink(WIRE, Network())
        self.session = self.link.connected(name)
        self.generated = generated
        self.name = name
        self.life = time.time_ns()
        self.answers = self.session.declare_subscriber(f"asemec/{WIRE}/to/{name}/bob/ping", self.answer)
        self.token = self.session.liveliness().declare_token(self.link.token(name, self.life))

    def send(self, attachment: bytes | None, payload: bytes, way: str = "team/signal/M") -> None:
        secret = self.link._secret
        if attachment is not None and secret is not None:
            attachment = envelopes.proven(attachment, payload, secret, f"asemec/{WIRE} bob {self.name}")
        self.session.put(f"asemec/{WIRE}/to/bob/{self.name}/{way}", payload, attachment=attachment)

    def answer(self, sample: Any) -> None:
        """Say that one is there, as robots do."""
        ping = envelopes.read(sample.attachment.to_bytes(), b"")
        now = time.monotonic_ns()
        pong = Envelope(envelopes.PONG, ping.contract, self.life, time=now, asked=ping.time, heard=now)
        self.send(envelopes.written(pong, b"", addressee=ping.incarnation), b"", "pong")

    def message(self, bob: Part, n: int, place: int, **members: Any) -> None:
        payload = members.pop("payload", None) or self.generated.messages.SCHEMA.encode(
            self.generated.message("M", n=n)
        )
        given = {
            "contract": bob.post.contract,
            "incarnation": self.life,
            "channel": "team.signal.M",
            "sequence": n,
            **members,
        }
        envelope = Envelope(envelopes.MESSAGE, **given)
        addressee = given.pop("addressee", bob.post.incarnation)
        self.send(envelopes.written(envelope, payload, place=place, addressee=addressee), payload)

    def close(self) -> None:
        self.session.close()


def test_nonsense_is_counted_told_and_harmless(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = Hostile(wire)
    stranger = Hostile(wire, "mallory")
    wait_until(lambda: bob.team.transport.is_there("ann"))
    ann.message(bob, 1, 1)
    ann.send(None, b"")  # no envelope at all
    ann.send(b"\xff\xff\xff", b"no envelope")
    good = envelopes.written(Envelope(envelopes.MESSAGE, incarnation=ann.life), b"abc")
    ann.send(good, b"abd")  # damaged on its way
    ann.message(bob, 2, 2, payload=b"\x0a\xff\xff")  # no message
    ann.message(bob, 3, 3, contract=12345)
    ann.message(bob, 4, 4, contract=12345)
    ann.message(bob, 5, 5, channel="team.signal.Secret")
    ann.message(bob, 1, 1)  # doubled
    ann.message(bob, 7, 7)  # before its predecessor
    ann.message(bob, 6, 6)
    ann.message(bob, 8, 8, incarnation=ann.life - 1)  # of an earlier life
    ann.message(bob, 9, 10**12)  # far too early
    ann.send(b"", b"", "ping/without/sense/at/all")
    stranger.message(bob, 10, 1)
    ann.message(bob, 11, 8)
    wait_until(lambda: 11 in heard(bob))
    wait_until(lambda: "mallory unknown" in bob.news())
    peer = bob.team.peers()["ann"]
    ann.close()
    stranger.close()
    bob.stop()
    assert heard(bob) == [1, 6, 7, 11]
    assert (peer.refused, peer.duplicated, peer.late, peer.reordered) == (3, 2, 1, 2)
    assert peer.unreadable == 5
    told = [r["what"] for r in bob.of("peer", peer="ann")]
    assert told.count("refused") == 2  # once for each kind of message
    assert {"unreadable", "duplicated", "late", "reordered", "count"} <= set(told)
    assert bob.result is not None and not bob.result.failed


def test_keys_without_sense_are_harmless(
    wire: Generated, mouth: Mouth, capfd: pytest.CaptureFixture[str]
) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = Hostile(wire)
    wait_until(lambda: bob.team.transport.is_there("ann"))
    token = ann.session.liveliness().declare_token(f"asemec/{WIRE}/here/ann/whenever")
    ann.session.put(f"asemec/{WIRE}/to/bob", b"", attachment=b"")
    for keys in ("**", f"{WIRE}/*/bob", f"{WIRE}/nothing/bob", f"{WIRE}/history/bob"):
        for reply in ann.session.get(f"asemec/{keys}", payload=b"[", timeout=2.0):
            assert reply.ok is None or b"error" in reply.ok.payload.to_bytes()
    ann.message(bob, 1, 1)
    wait_until(lambda: heard(bob) == [1])
    # Its token or its message comes first, and a stranger is told of once.
    wait_until(lambda: not {"? untrusted", "? unknown"}.isdisjoint(bob.news()))
    token.undeclare()
    ann.close()
    bob.stop()
    assert "Traceback" not in capfd.readouterr().err


def test_what_is_not_for_it_is_refused(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = Hostile(wire)
    wait_until(lambda: bob.team.transport.is_there("ann"))
    ann.message(bob, 1, 1, host="cat")
    ann.message(bob, 2, 2)
    wait_until(lambda: heard(bob) == [2])
    ann.close()
    bob.stop()
    (refused,) = bob.of("peer", what="refused")
    assert refused["reason"] == "team.signal.M of ann is for cat"


# ---- a link that breaks ------------------------------------------------------------------------


def sever(*ends: socket.socket) -> None:
    """Shut both ends of a connection, which wakes the threads that read from them; they close them."""
    for end in ends:
        with contextlib.suppress(OSError):  # shut, or closed, already
            end.shutdown(socket.SHUT_RDWR)


class Proxy:
    """A wire between two ports that can be cut, or kept so that nothing comes through."""

    def __init__(self, to: int) -> None:
        self.to = to
        self.deaf = False
        self.cut_off = False
        self.pairs: list[tuple[socket.socket, socket.socket]] = []
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            try:
                here, _ = self.server.accept()
            except OSError:
                return
            try:
                there = socket.create_connection(("127.0.0.1", self.to))
            except OSError:
                here.close()
                continue
            # Noted before it is asked whether the wire is cut; a cut is said before looking at what is noted.
            # So one of the two sees a connection that is made meanwhile.
            self.pairs.append((here, there))
            if self.cut_off:
                sever(here, there)
            for a, b in ((here, there), (there, here)):
                threading.Thread(target=self._pass, args=(a, b), daemon=True).start()

    def _pass(self, a: socket.socket, b: socket.socket) -> None:
        try:
            while data := a.recv(65536):
                while self.deaf:
                    time.sleep(0.01)
                b.sendall(data)
        except OSError:
            pass
        sever(a, b)
        a.close()

    def cut(self) -> None:
        self.cut_off = True
        for pair in self.pairs:
            sever(*pair)

    def mend(self) -> None:
        self.cut_off = False

    def close(self) -> None:
        self.cut()
        self.server.close()


@pytest.mark.parametrize("how", ["cut", "deaf"])
def test_a_partition_loses_no_signal(wire: Generated, mouth: Mouth, port: int, how: str) -> None:
    proxy = Proxy(port)
    alone = {"lease_ms": 500}
    bob = part(
        wire,
        ["bob"],
        mouth.activities,
        ZenohLink(WIRE, Network(listen=(f"tcp/127.0.0.1:{port}",), **alone)),  # type: ignore[arg-type]
    ).start()
    ann = part(
        wire,
        ["ann"],
        mouth.activities,
        ZenohLink(WIRE, Network(connect=(f"tcp/127.0.0.1:{proxy.port}",), **alone)),  # type: ignore[arg-type]
    ).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    mouth.say += [("team.signal.M", n) for n in range(100)]
    wait_until(lambda: len(heard(bob)) > 10)
    if how == "cut":
        proxy.cut()
    else:
        proxy.deaf = True
    mouth.say += [("team.signal.M", n) for n in range(100, 200)]
    mouth.say += [("team.state.M", n) for n in range(100)]
    wait_until(lambda: "bob gone" in ann.news())
    proxy.deaf = False
    proxy.mend()
    wait_until(lambda: len(heard(bob)) >= 200)
    wait_until(lambda: heard(bob, "team.state.M")[-1:] == [99])
    ann.stop()
    bob.stop()
    proxy.close()
    assert heard(bob) == list(range(200))
    assert ann.news("gone", "reconnected")[:2] == ["bob gone", "bob reconnected"]
    assert ann.of("lost") == []


def test_a_flood_holds_up_nobody(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    for n in range(800):
        mouth.say += [("team.signal.M", n), ("team.state.M", n), ("team.data.M", n)]
    wait_until(lambda: len(heard(bob)) == 800)
    wait_until(lambda: heard(bob, "team.state.M")[-1] == 799)
    wait_until(lambda: heard(bob, "team.data.M"))
    ann.stop()
    bob.stop()
    assert heard(bob) == list(range(800))
    states = heard(bob, "team.state.M")
    assert states == sorted(set(states))
    data = heard(bob, "team.data.M")
    assert len(data) == len(set(data))
    (count,) = bob.of("peer", peer="ann", what="count")
    assert count["counts"].get("dropped", 0) + len(data) <= 800


# ---- certificates and permissions --------------------------------------------------------------


def openssl(folder: Path, *arguments: str) -> None:
    subprocess.run(["openssl", *arguments], cwd=folder, check=True, capture_output=True)


@pytest.fixture(scope="module")
def certificates(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An authority with certificates for a team and its operator, and another authority's for a stranger."""
    folder = tmp_path_factory.mktemp("certificates")
    certify(folder, {"team": ("ann", "bob", "mallory", OPERATOR), "other": ("stranger",)}, "127.0.0.1")
    return folder


def certify(folder: Path, authorities: Mapping[str, Sequence[str]], *addresses: str) -> None:
    """Make certificates in a folder: of each authority for these names, good for these addresses."""
    if shutil.which("openssl") is None:
        pytest.skip("openssl is not installed: certificates are not tested")
    (folder / "host.ext").write_text(f"subjectAltName={','.join(f'IP:{one}' for one in addresses)}\n")
    for authority, names in authorities.items():
        new = ["req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", f"/CN={authority}"]
        openssl(folder, *new, "-keyout", f"{authority}.key", "-out", f"{authority}.pem")
        for name in names:
            request = ["req", "-newkey", "rsa:2048", "-nodes", "-subj", f"/CN={name}"]
            openssl(folder, *request, "-keyout", f"{name}.key", "-out", f"{name}.csr")
            sign = [
                "x509",
                "-req",
                "-in",
                f"{name}.csr",
                "-CA",
                f"{authority}.pem",
                "-CAkey",
                f"{authority}.key",
            ]
            openssl(folder, *sign, "-days", "2", "-out", f"{name}.pem", "-extfile", "host.ext")


def secured(certificates: Path, name: str, **options: Any) -> Network:
    tls = Tls(certificates / "team.pem", certificates / f"{name}.pem", certificates / f"{name}.key")
    return Network(tls=tls, **{"listen": ("tls/127.0.0.1:0",), **options})


def test_robots_with_certificates_talk(wire: Generated, mouth: Mouth, certificates: Path, port: int) -> None:
    listening = secured(certificates, "bob", listen=(f"tls/127.0.0.1:{port}",))
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, listening)).start()
    connecting = secured(certificates, "ann", connect=(f"tls/127.0.0.1:{port}",))
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, connecting)).start()
    mouth.say += [("team.signal.M", 1)]
    wait_until(lambda: heard(bob) == [1])
    ann.stop()
    bob.stop()


def test_much_at_once_comes_at_the_first_attempt(
    wire: Generated, mouth: Mouth, certificates: Path, port: int
) -> None:
    listening = secured(certificates, "bob", listen=(f"tls/127.0.0.1:{port}",))
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, listening)).start()
    connecting = secured(certificates, "ann", connect=(f"tls/127.0.0.1:{port}",))
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, connecting)).start()
    mouth.say += [("team.signal.M", n) for n in range(600)]
    wait_until(lambda: heard(bob) == list(range(600)))
    ann.stop()
    bob.stop()
    assert not bob.of("peer", what="reordered")  # what the link drops is overtaken


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="NOT TESTED: only Linux tells of its sockets")
def test_a_connection_can_be_renewed(wire: Generated, mouth: Mouth, certificates: Path, port: int) -> None:
    listening = secured(certificates, "bob", listen=(f"tls/127.0.0.1:{port}",))
    link = ZenohLink(WIRE, listening)
    bob = part(wire, ["bob"], mouth.activities, link).start()
    connecting = secured(certificates, "ann", connect=(f"tls/127.0.0.1:{port}",))
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, connecting)).start()
    mouth.say += [("team.signal.M", 1)]
    wait_until(lambda: heard(bob) == [1])

    def places() -> set[str]:
        return {str(one.dst) for one in link._session.info.links()}

    before = places()
    link.renew("mallory")
    time.sleep(0.2)
    assert places() == before
    link.renew("ann")
    wait_until(lambda: places() and not places() & before)
    mouth.say += [("team.signal.M", 2)]
    wait_until(lambda: heard(bob) == [1, 2])
    session = link._session
    link.renew("ann", again=True)  # that did not help: bob begins with a new session
    wait_until(lambda: link._session not in (None, session) and places())
    mouth.say += [("team.signal.M", 3)]
    wait_until(lambda: heard(bob) == [1, 2, 3])
    ann.stop()
    bob.stop()
    assert [record["reason"] for record in bob.of("peer", what="disconnected")] == ["ann brings nothing"]
    assert not ann.of("peer", what="restarted")


@pytest.mark.parametrize("how", ["another authority", "no certificate", "no tls"])
def test_who_has_no_certificate_is_not_let_in(
    wire: Generated, mouth: Mouth, certificates: Path, port: int, how: str
) -> None:
    listening = secured(certificates, "bob", listen=(f"tls/127.0.0.1:{port}",))
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, listening)).start()
    wait_until(lambda: is_listened_on(port))
    config = zenoh.Config()
    settings = dict(secured(certificates, "stranger", connect=(f"tls/127.0.0.1:{port}",)).settings())
    if how == "no certificate":
        settings = {k: v for k, v in settings.items() if "connect_" not in k and "mtls" not in k}
    elif how == "no tls":
        settings = dict(Network(connect=(f"tcp/127.0.0.1:{port}",)).settings())
    for key, value in settings.items():
        config.insert_json5(key, value)
    config.insert_json5("connect/timeout_ms", "0")
    stranger = zenoh.open(config)
    stranger.liveliness().declare_token(f"asemec/{WIRE}/here/ann/{time.time_ns():x}")
    for _ in range(20):
        stranger.put(f"asemec/{WIRE}/to/bob/ann/team/signal/M", b"")
        time.sleep(0.02)
    assert list(stranger.info.peers_zid()) == []
    stranger.close()
    bob.stop()
    assert bob.of("peer") == []


@pytest.mark.parametrize("guarded", [True, False])
def test_a_robot_speaks_only_for_itself(
    wire: Generated, mouth: Mouth, certificates: Path, tmp_path: Path, port: int, guarded: bool
) -> None:
    file = tmp_path / "access.json"
    team = ("ann", "bob", "mallory")
    file.write_text(json.dumps(access_rules("bob", team) | {"enabled": guarded}))
    listening = secured(certificates, "bob", listen=(f"tls/127.0.0.1:{port}",), access=Access(file))
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, listening)).start()
    own: dict[str, Any] = {"robot": "ann", "team": team} if guarded else {}
    connecting = secured(certificates, "ann", connect=(f"tls/127.0.0.1:{port}",), **own)
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, connecting)).start()
    config = zenoh.Config()
    for key, value in secured(certificates, "mallory", connect=(f"tls/127.0.0.1:{port}",)).settings():
        config.insert_json5(key, value)
    mallory = zenoh.open(config)
    wait_until(lambda: list(mallory.info.peers_zid()))

    def is_heard() -> bool:
        """Say something for ann; whether bob has heard anything of the kind."""
        mallory.put(f"asemec/{WIRE}/to/bob/ann/team/signal/M", b"", attachment=b"\xff")
        return bob.team.peers()["ann"].unreadable > 0

    if not guarded:
        wait_until(is_heard)
    assert any(is_heard() for _ in range(5)) is not guarded
    mouth.say += [("team.signal.M", 1), ("team.state.M", 2)]
    wait_until(lambda: heard(bob) == [1] and heard(bob, "team.state.M") == [2])
    wait_until(lambda: not ann.team.peers()["bob"].unacknowledged)
    mallory.close()
    peer = bob.team.peers()["ann"]
    ann.stop()
    bob.stop()
    assert (peer.unreadable == 0) is guarded  # whether what mallory said for ann has come


def test_wrong_settings_are_said(tmp_path: Path) -> None:
    (tmp_path / "access.json").write_text("{")
    with pytest.raises(TransportError, match=r"access\.json is not JSON"):
        ZenohLink(WIRE, Network(access=Access(tmp_path / "access.json")))
    (tmp_path / "access.json").write_text('{"enabled": "maybe"}')
    with pytest.raises(TransportError, match="zenoh does not take access_control"):
        ZenohLink(WIRE, Network(access=Access(tmp_path / "access.json")))
    with pytest.raises(TransportError, match="zenoh does not take listen/endpoints"):
        ZenohLink(WIRE, Network(listen=("nonsense",)))


def test_a_port_that_is_taken_is_said(wire: Generated, mouth: Mouth) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        network = Network(listen=(f"tcp/127.0.0.1:{taken.getsockname()[1]}",), interface=None)
        bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, network)).start()
        with pytest.raises(Exception, match="the network cannot be used"):
            bob.join()


def test_a_message_that_is_too_large_is_not_put_together(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann"))
    hostile = Hostile(wire, "carol")
    hostile.name = "ann"
    for size in (LARGEST + (2 << 20), 10):  # one after the other, and neither is an envelope's
        key = f"asemec/{WIRE}/to/bob/ann/team/signal/M"
        hostile.session.put(key, bytes(size), congestion_control=zenoh.CongestionControl.BLOCK)
    wait_until(lambda: bob.team.peers()["ann"].unreadable >= 1)
    mouth.say += [("team.signal.M", 1)]
    wait_until(lambda: heard(bob) == [1])
    hostile.close()
    bob.stop()
    ann.stop()
    assert bob.team.peers()["ann"].unreadable == 1
