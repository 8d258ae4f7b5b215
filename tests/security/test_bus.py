"""Who speaks on the bus: nobody ends, delays or impersonates a robot without being it."""

from __future__ import annotations

import random
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.faults.test_network import WIRE, Hostile, Mouth, certificates, heard, mouth, port, secured, wire
from tests.runtime.transport.net import Part, part
from tests.security.lines import line
from tests.support.generated import Generated
from tests.support.waiting import LONG, wait_until

zenoh = pytest.importorskip("zenoh")

__all__ = ["certificates", "mouth", "port", "wire"]

A_DAY = 24 * 3600.0
"""In seconds: longer than a test waits for anything."""
LAST = 2**64 - 1
"""The highest incarnation that there can be."""


def talks_on(mouth: Mouth, ann: Part, bob: Part, n: int) -> None:
    """Ann is heard by bob, and nobody has ended, begun anew or been late."""
    mouth.say += [("team.signal.M", n)]
    wait_until(lambda: heard(bob)[-1:] == [n])
    for one in (ann, bob):
        assert one.result is None
        assert one.news("gone", "restarted", "replaced", "late") == []


def forgeries(bob: Part, n: int) -> list[tuple[str, bytes]]:
    """Keys below the root, with attachments, by which somebody says to be ann, or to know her."""
    chance = random.Random(n)
    found: list[tuple[str, bytes]] = []
    for number in range(n):
        life = chance.choice((0, 1, LAST, chance.getrandbits(64), bob.post.incarnation))
        kind = chance.randrange(5)
        envelope = Envelope(kind, bob.post.contract, life, channel="team.signal.M", upto=number, time=number)
        data = envelopes.written(
            envelope, b"", addressee=chance.choice((0, bob.post.incarnation)), place=chance.randrange(3)
        )
        if chance.random() < 0.2:
            data = data[: chance.randrange(len(data))]
        if chance.random() < 0.5:
            data = envelopes.proven(data, b"", chance.randbytes(32), f"asemec/{WIRE} bob ann")
        found.append(
            (chance.choice(("to/bob/ann/ping", "to/bob/ann/team/signal/M", "to/bob/bob/ping")), data)
        )
    return found


@line("a process without the secret", "end, impersonate or delay a robot")
def test_forged_tokens_and_envelopes_change_nothing(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann") and ann.team.transport.is_there("bob"))
    session = ZenohLink(WIRE, Network()).connected("mallory")
    tokens = [
        session.liveliness().declare_token(f"asemec/{WIRE}/here/{name}/{life:x}{proof}")
        for name in ("ann", "bob")
        for life in (LAST, 1, ann.post.incarnation)
        for proof in ("", "-", "-" + "0" * 64)
    ]
    for key, data in forgeries(bob, 1000):
        session.put(f"asemec/{WIRE}/{key}", b"", attachment=data)
    wait_until(lambda: bob.team.peers()["ann"].unreadable > 300)
    talks_on(mouth, ann, bob, 1)
    for token in tokens:
        token.undeclare()
    session.close()
    talks_on(mouth, ann, bob, 2)
    told = bob.of("peer", peer="ann", what="unreadable")
    ann.stop()
    bob.stop()
    assert heard(bob) == [1, 2]
    assert told and "does not prove" in told[0]["reason"]
    (count,) = bob.of("peer", peer="ann", what="count")
    assert count["counts"]["unreadable"] > 300
    assert bob.news("untrusted")  # a token that says to be bob himself


@line("a process without the secret", "answer a question for a robot")
def test_forged_answers_are_not_taken(wire: Generated, mouth: Mouth) -> None:
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann"))
    session = ZenohLink(WIRE, Network()).connected("mallory")
    payload = wire.messages.SCHEMA.encode(wire.message("M", n=13))
    envelope = Envelope(envelopes.MESSAGE, ann.post.contract, ann.post.incarnation, channel="team.data.M")
    key = f"asemec/{WIRE}/history/ann"
    forged = envelopes.written(envelope, payload)
    queryable = session.declare_queryable(key, lambda query: query.reply(key, payload, attachment=forged))
    mouth.say += [("team.data.M", 1)]
    wait_until(lambda: heard(bob, "team.data.M") == [1])
    found = [bob.team.history("ann", "team.data.M", 0, 2**62) for _ in range(5)]
    queryable.undeclare()
    session.close()
    ann.stop()
    bob.stop()
    assert [[message.n for _, message in one] for one in found] == [[1]] * 5


def answered_before_the_time_is_up(bob: Part) -> list[int]:
    """What ann has said, asked by bob, who would wait for a day."""
    found: list[list[int]] = []

    def ask() -> None:
        said = bob.team.transport.history("ann", "team.data.M", 0, 2**62, A_DAY)
        found.append([message.n for _, message in said])

    asking = threading.Thread(target=ask, daemon=True)
    asking.start()
    wait_until(lambda: not asking.is_alive())
    return found[0]


@line("a process without the secret", "hold up or silence an answer")
def test_who_takes_questions_neither_delays_nor_silences_the_answer(wire: Generated, mouth: Mouth) -> None:
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann"))
    mouth.say += [("team.data.M", 1)]
    wait_until(lambda: heard(bob, "team.data.M") == [1])
    session = ZenohLink(WIRE, Network()).connected("mallory")
    held: list[Any] = []
    found = []
    for complete in (False, True):  # who claims to know all would be asked alone
        queryable = session.declare_queryable(f"asemec/{WIRE}/**", held.append, complete=complete)

        def ask() -> bool:
            found.append(answered_before_the_time_is_up(bob))
            return bool(held)

        wait_until(ask)
        held.clear()
        queryable.undeclare()
    session.close()
    ann.stop()
    bob.stop()
    assert found == [[1]] * len(found)


def test_a_question_is_the_team_s_and_counts_once(wire: Generated, mouth: Mouth) -> None:
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann"))
    session = ZenohLink(WIRE, Network()).connected("mallory")
    recorded: list[tuple[bytes, bytes]] = []
    spy = session.declare_queryable(
        f"asemec/{WIRE}/history/ann",
        lambda query: recorded.append((query.payload.to_bytes(), query.attachment.to_bytes())),
    )

    def ask() -> bool:
        bob.team.transport.history("ann", "team.data.M", 0, 2**62, LONG)
        return bool(recorded)

    wait_until(ask)
    spy.undeclare()
    question, mark = recorded[0]
    chance = random.Random(1)
    asked = [(question, mark), (question, None), (b"", mark), (question[:-1], mark), (question, mark[:-1])]
    asked += [(question, mark[:15] + bytes((mark[15] ^ 1,)) + mark[16:])]
    asked += [(chance.randbytes(chance.randrange(99)), chance.randbytes(48)) for _ in range(94)]
    answers = [
        reply
        for payload, attachment in asked
        for reply in session.get(
            f"asemec/{WIRE}/history/ann", payload=payload, attachment=attachment, timeout=LONG
        )
    ]
    for key in ("**", "asemec/**", f"asemec/{WIRE}/*/ann", f"asemec/{WIRE}/here/ann"):
        answers += session.get(key, payload=question, attachment=mark, timeout=LONG)
    session.close()
    ann.stop()
    bob.stop()
    assert answers == []
    (count,) = ann.of("peer", peer="?", what="count")
    assert count["counts"]["refused"] == 100 + 4


def test_an_answer_is_good_for_one_question(wire: Generated, mouth: Mouth) -> None:
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    bob = ZenohLink(WIRE, Network())
    bob.visit("bob")
    wait_until(lambda: bob.ask("ann", "history", b"{}", LONG))
    key, nonce = f"asemec/{WIRE}/history/ann", bytes(16)
    mark = nonce + bob._question_proof("history", "ann", b"{}", nonce)
    session = ZenohLink(WIRE, Network()).connected("mallory")
    replies = wait_until(lambda: list(session.get(key, payload=b"{}", attachment=mark, timeout=LONG)))
    recorded = [(reply.ok.payload.to_bytes(), reply.ok.attachment.to_bytes()) for reply in replies]
    ann.stop()
    asked: list[bool] = []

    def replay(query: Any) -> None:
        asked.append(True)
        for payload, attachment in recorded:
            query.reply(key, payload, attachment=attachment)

    queryable = session.declare_queryable(key, replay)
    answers: list[Any] = []

    def is_asked() -> bool:
        """Ask once more; whether mallory has been asked."""
        answers.extend(bob.ask("ann", "history", b"{}", 1.0))
        return bool(asked)

    wait_until(is_asked)
    queryable.undeclare()
    session.close()
    bob.close()
    assert recorded and answers == []


def test_a_copied_token_is_nobody(wire: Generated, mouth: Mouth) -> None:
    """Neither of a robot that has ended, to one that comes later, nor of a newer life of one's own."""
    keeper = ZenohLink(WIRE, Network())
    session = keeper.connected("mallory")  # the secret stays the same, and so do proofs
    ended = keeper.token("ann", time.time_ns())
    kept = [session.liveliness().declare_token(ended)]
    kept += [session.liveliness().declare_token(keeper.token("bob", LAST))]
    kept += [session.liveliness().declare_token(keeper.token("ann", life)) for life in range(1, 9)]
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: "ann" in bob.post.state.others and len(bob.post.state.others["ann"].present) == 9)
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, Network())).start()
    wait_until(lambda: bob.team.transport.is_there("ann"))
    talks_on(mouth, ann, bob, 1)
    session.close()
    talks_on(mouth, ann, bob, 2)
    assert bob.news() == ["ann connected"]
    ann.stop()
    bob.stop()


def test_what_an_earlier_run_was_told_ends_nobody(wire: Generated, mouth: Mouth) -> None:
    """A recorded message of a life with a higher number, as one has whose clock was set back."""
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = Hostile(wire)  # knows the secret
    wait_until(lambda: bob.team.transport.is_there("ann"))
    for addressee in (0, bob.post.incarnation - 1):
        ann.message(bob, 1, 1, incarnation=LAST, addressee=addressee)
    ann.message(bob, 1, 1)
    wait_until(lambda: heard(bob) == [1])
    peer = bob.team.peers()["ann"]
    ann.close()
    bob.stop()
    assert peer.late == 2
    assert bob.news("restarted") == []


@line(
    "a process without the secret",
    "replay what a robot has sent, or hide its end",
)
def test_a_recording_counts_for_nothing_and_a_copied_token_hides_no_end(
    wire: Generated, mouth: Mouth
) -> None:
    session = ZenohLink(WIRE, Network()).connected("mallory")
    recorded: list[tuple[str, bytes, bytes]] = []
    tokens: list[str] = []

    def record(sample: Any) -> None:
        recorded.append((str(sample.key_expr), sample.payload.to_bytes(), sample.attachment.to_bytes()))

    session.declare_subscriber(f"asemec/{WIRE}/to/bob/ann/**", record)
    session.liveliness().declare_subscriber(
        f"asemec/{WIRE}/here/ann/*", lambda sample: tokens.append(str(sample.key_expr)), history=True
    )
    quick = Network(lease_ms=1000)
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, quick)).start()
    ann = part(wire, ["ann"], mouth.activities, ZenohLink(WIRE, quick)).start()
    talks_on(mouth, ann, bob, 1)
    wanted = {"ping", "pong", "team"}
    wait_until(lambda: {key.split("/")[5] for key, *_ in list(recorded)} >= wanted and tokens)
    tape = [one for one in list(recorded) if one[0].split("/")[5] in wanted]
    for key, payload, data in tape:
        session.put(key, payload, attachment=data)
    wait_until(lambda: bob.team.peers()["ann"].duplicated >= len(tape))
    talks_on(mouth, ann, bob, 2)
    copy = session.liveliness().declare_token(tokens[0])
    talks_on(mouth, ann, bob, 3)
    ann.stop()
    wait_until(lambda: "ann gone" in bob.news())
    for _ in range(3):
        copy.undeclare()
        copy = session.liveliness().declare_token(tokens[0])
    doubled = bob.team.peers()["ann"].duplicated
    for key, payload, data in tape:
        session.put(key, payload, attachment=data)
    wait_until(lambda: bob.team.peers()["ann"].duplicated >= doubled + len(tape))
    there = bob.team.transport.is_there("ann")
    session.close()
    bob.stop()
    assert heard(bob) == [1, 2, 3] and not there
    assert bob.news("reconnected", "restarted") == []


def test_what_is_replayed_reordered_or_truncated_counts_once(wire: Generated, mouth: Mouth) -> None:
    bob = part(wire, ["bob"], mouth.activities, ZenohLink(WIRE, Network())).start()
    ann = Hostile(wire)  # knows the secret
    wait_until(lambda: bob.team.transport.is_there("ann"))
    for place in (2, 1, 1, 2, 3, 2):
        ann.message(bob, place, place)
    ann.message(bob, 4, 4, addressee=bob.post.incarnation - 1)  # of an earlier run
    ann.message(bob, 4, 4)
    wait_until(lambda: heard(bob) == [1, 2, 3, 4])
    peer = bob.team.peers()["ann"]
    ann.close()
    bob.stop()
    assert (peer.duplicated, peer.late) == (3, 1)


@pytest.mark.parametrize("how", ["forged", "truncated", "other way", "wrong key", "other payload", "none"])
def test_a_proof_is_of_one_envelope_payload_way_and_secret(how: str) -> None:
    data = envelopes.written(Envelope(envelopes.MESSAGE, 7, 5), b"abc")
    good = envelopes.proven(data, b"abc", b"s" * 32, "asemec/T bob ann")
    assert envelopes.unproven(good, b"abc", b"s" * 32, "asemec/T bob ann") == data
    assert envelopes.read(good, b"abc").incarnation == 5  # others may read it without the secret
    given = {
        "forged": (bytes((good[0], good[1] ^ 1)) + good[2:], b"abc", b"s" * 32, "asemec/T bob ann"),
        "truncated": (good[:-1], b"abc", b"s" * 32, "asemec/T bob ann"),
        "other way": (good, b"abc", b"s" * 32, "asemec/T bob cat"),
        "wrong key": (good, b"abc", b"t" * 32, "asemec/T bob ann"),
        "other payload": (good, b"abd", b"s" * 32, "asemec/T bob ann"),
        "none": (data, b"abc", b"s" * 32, "asemec/T bob ann"),
    }
    with pytest.raises(envelopes.EnvelopeError, match="does not prove"):
        envelopes.unproven(*given[how])


@line("a robot with a certificate", "speak, come, go or answer for another robot")
@line("a robot with a certificate", "hear what robots say to others, or control them")
def test_a_certificate_is_good_for_its_own_name_only(
    wire: Generated, mouth: Mouth, certificates: Path, port: int
) -> None:
    team = ("ann", "bob", "mallory")
    end = (f"tls/127.0.0.1:{port}",)
    bob = part(
        wire,
        ["bob"],
        mouth.activities,
        ZenohLink(WIRE, secured(certificates, "bob", listen=end, robot="bob", team=team)),
    ).start()
    ann = part(
        wire,
        ["ann"],
        mouth.activities,
        ZenohLink(WIRE, secured(certificates, "ann", connect=end, robot="ann", team=team)),
    ).start()
    wait_until(lambda: bob.team.transport.is_there("ann") and ann.team.transport.is_there("bob"))
    config = zenoh.Config()
    for key, value in secured(certificates, "mallory", connect=end).settings():  # no rules of her own
        config.insert_json5(key, value)
    session = zenoh.open(config)
    wait_until(lambda: list(session.info.peers_zid()))
    spied: list[str] = []

    def spy(sample: Any) -> None:
        if sample.payload.to_bytes():  # what mallory sends herself is empty
            spied.append(str(sample.key_expr))

    kept = [
        session.liveliness().declare_token(f"asemec/{WIRE}/here/{name}/{life:x}")
        for name in ("ann", "bob")
        for life in (LAST, ann.post.incarnation)
    ]
    kept += [
        session.declare_subscriber(key, spy)
        for key in ("**", f"asemec/{WIRE}/to/**", f"asemec/{WIRE}/to/bob/**")
    ]
    for key, data in forgeries(bob, 300):
        session.put(f"asemec/{WIRE}/{key}", b"", attachment=data)
    asked = [f"asemec/{WIRE}/control/bob", f"asemec/{WIRE}/*/bob", "asemec/**"]
    answers = [
        list(session.get(key, payload=b'{"version":1,"request":"status"}', timeout=1.0)) for key in asked
    ]
    # What mallory says for herself comes after all that, by the same connection.
    session.liveliness().declare_token(f"asemec/{WIRE}/here/mallory/1")
    session.put(f"asemec/{WIRE}/to/bob/mallory/ping", b"", attachment=b"")
    wait_until(lambda: {"mallory untrusted", "mallory unknown"} & set(bob.news()))
    talks_on(mouth, ann, bob, 1)
    peer = bob.team.peers()["ann"]
    session.close()
    talks_on(mouth, ann, bob, 2)
    ann.stop()
    bob.stop()
    assert answers == [[], [], []] and spied == []
    assert (peer.unreadable, peer.late) == (0, 0)
    assert heard(bob) == [1, 2]
