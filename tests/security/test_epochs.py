"""Epochs between machines: a robot follows one only if an operator's key proves it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest

from aseme_dsl.project.operating import swapping
from aseme_dsl.project.operating.whole_team import whole_team
from aseme_dsl.project.playing.operate import OperateError
from aseme_dsl.project.playing.remote import Robot
from aseme_dsl.runtime.control.catching_up import CatchingUp
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.control.epoch_proof import Doubt, all_doubt, doubt_of, no_doubt, proven
from aseme_dsl.runtime.control.operator_gate import Gate
from aseme_dsl.runtime.control.operator_key import (
    KeyFileError,
    newest_key,
    read_keys,
    write_key,
    write_keys_for,
)
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.version.epochs import Epoch, EpochFile, epoch_of
from tests.cli import support as cli
from tests.faults.test_operate import LONGER, Running, package
from tests.security.lines import line

SYSTEM = "S"
MEMBERS = ("a", "b", "c")
EPOCH = Epoch(7, "7" * 64)


class Robots:
    """The files of keys of an operator, and of three robots, each with what it needs only."""

    def __init__(self, folder: Path) -> None:
        self.operator = folder / "operator.toml"
        write_key(self.operator)
        self.own = {name: folder / f"{name}.toml" for name in MEMBERS}
        for name, path in self.own.items():
            write_keys_for(path, self.operator, [name])

    def doubt(self, name: str) -> Doubt:
        return doubt_of(self.own[name], SYSTEM, name)


@pytest.fixture
def robots(tmp_path: Path) -> Robots:
    return Robots(tmp_path)


def passed_on(epoch: Epoch) -> Epoch:
    """As it comes from another member."""
    found = epoch_of(json.loads(json.dumps(epoch.as_data())))
    assert found is not None
    return found


def test_what_an_operator_proves_each_member_believes_whoever_passes_it_on(robots: Robots) -> None:
    epoch = passed_on(proven(newest_key(robots.operator), SYSTEM, EPOCH, MEMBERS, 2))
    assert epoch == EPOCH and epoch.proof is not None and epoch.proof.quorum == 2
    assert [robots.doubt(name)(epoch) for name in MEMBERS] == ["", "", ""]


def forgeries(robots: Robots, folder: Path) -> Iterator[tuple[str, Epoch]]:
    """What a robot with a certificate and its own part of the key can make, with what would be said of it."""
    good = proven(newest_key(robots.operator), SYSTEM, EPOCH, MEMBERS, 2)
    proof = good.proof
    assert proof is not None
    wrong = "the proof of epoch 7 is wrong"
    yield "epoch 7 has no proof", EPOCH
    yield "the proof of epoch 8 is wrong", replace(good, number=8)
    yield wrong, replace(good, hash="8" * 64)
    elsewhere = proven(newest_key(robots.operator), SYSTEM, replace(EPOCH, base="another"), MEMBERS, 2)
    yield wrong, replace(elsewhere, base="")
    yield wrong, replace(good, proof=replace(proof, quorum=1))
    yield wrong, replace(good, proof=replace(proof, members={**proof.members, "b": proof.members["a"]}))
    yield wrong, replace(good, proof=replace(proof, members={"b": proof.members["b"]}, quorum=1))
    yield wrong, proven(newest_key(robots.operator), "Other", EPOCH, MEMBERS, 2)
    own = newest_key(robots.own["a"])  # of a robot that wants to be an operator
    yield "the proof of epoch 7 is not for b", proven(own, SYSTEM, EPOCH, MEMBERS, 1)
    yield wrong, proven(replace(own, robots={"b": own.robots["a"]}), SYSTEM, EPOCH, MEMBERS, 1)
    yield wrong, proven(replace(own, robots={}, secret=own.robots["a"]), SYSTEM, EPOCH, MEMBERS, 2)
    write_key(folder / "mine.toml")
    mine = newest_key(folder / "mine.toml")
    yield "which is not accepted here", proven(mine, SYSTEM, EPOCH, MEMBERS, 2)
    yield wrong, proven(replace(mine, name=own.name), SYSTEM, EPOCH, MEMBERS, 2)


def heard(control: Control, team: Any, epochs: list[object]) -> CatchingUp:
    """What a robot does about the epochs of others, without a network."""
    transport = SimpleNamespace(ask_epoch=lambda name, timeout: epochs[int(name)])
    peers = {str(number): SimpleNamespace(alive=True) for number in range(len(epochs))}
    return CatchingUp(cast("Any", SimpleNamespace(transport=transport, peers=lambda: peers)), control)


@line("a robot with a certificate", "hold or change other robots by an invented epoch")
def test_an_invented_epoch_is_refused_and_reported(robots: Robots, tmp_path: Path) -> None:
    reasons, invented = zip(*forgeries(robots, tmp_path), strict=True)
    with Running() as (team, records):
        control = Control(team, doubt=robots.doubt("b"))
        asking = heard(control, team, [epoch.as_data() for epoch in invented])
        assert asking._newer() is None and asking._newer() is None
        assert control.held is None and control.epoch.number == 0
        doubted = control.handle({"version": 1, "request": "status"})["doubted"]
        control.log.flush()
    for number, reason in enumerate(reasons):
        assert reason in doubted[str(number)]
    refused = [r for r in records if r["kind"] == "control" and r["what"] == "refused"]
    assert len(refused) == len(invented)  # each once, however often it is heard
    assert {r["request"] for r in refused} == {"epoch"}
    assert refused[0]["reasons"][0].startswith("0 says: epoch 7 has no proof")


def test_a_proven_epoch_among_invented_ones_is_followed(robots: Robots, tmp_path: Path) -> None:
    good = proven(newest_key(robots.operator), SYSTEM, EPOCH, MEMBERS, 2)
    said = [replace(good, number=9).as_data(), good.as_data(), Epoch().as_data()]
    with Running() as (team, _):
        control = Control(team, doubt=robots.doubt("b"), store=tmp_path / "versions")
        found = heard(control, team, said)._newer()
        assert found == EPOCH and set(control.doubted) == {"0"}
        said[0] = Epoch().as_data()
        assert heard(control, team, said)._newer() == EPOCH and control.doubted == {}


def test_a_removed_key_proves_nothing_any_more(robots: Robots) -> None:
    epoch = proven(newest_key(robots.operator), SYSTEM, EPOCH, MEMBERS, 2)
    robots.own["b"].write_text("")
    assert "is not accepted here" in robots.doubt("b")(epoch)
    robots.own["b"].unlink()
    assert "cannot be read" in robots.doubt("b")(epoch)
    assert "no `control` names operators' keys" in all_doubt(epoch)
    assert no_doubt(epoch) == ""


@pytest.mark.parametrize("with_key", [True, False])
def test_a_swap_over_the_network_leaves_a_proof_and_one_without_the_key_changes_nothing(
    robots: Robots, tmp_path: Path, with_key: bool
) -> None:
    name, _ = package(tmp_path, LONGER)
    store = tmp_path / "versions"
    with Running() as (team, _):
        control = Control(team, store=store, epochs=EpochFile(store, "a"), doubt=robots.doubt("a"))
        gate = Gate(control, robots.own["a"], SYSTEM, "life-")

        class Link:
            def ask(self, agent: str, what: str, data: bytes, timeout: float) -> list[tuple[None, bytes]]:
                return [(None, json.dumps(gate.answer(agent, data)).encode())]

        if not with_key:  # an operator of this machine, at the socket
            reply = {"id": 0} | control.handle(
                {"version": 1, "request": "swap", "phase": "prepare", "hash": name, "epoch": 1}
            )
            said = {"version": 1, "request": "swap", "phase": "commit", "id": reply["id"]}
            refusal = control.handle(cast("Any", said))
            assert "has no proof of an operator's key: use `asemec team swap --key" in refusal["reasons"][0]
            control.handle(cast("Any", {**said, "phase": "rollback"}))
            assert control.epoch.number == 0 and not EpochFile(store, "a").path.exists()
            return
        key = newest_key(robots.operator)
        done = swapping.swap(whole_team(tmp_path, [Robot("a", SYSTEM, key, cast("ZenohLink", Link()))]), name)
        assert done.epoch == 1 and done.is_whole
        kept = EpochFile(store, "a").read(control.epoch.base)
        assert kept.proof is not None and robots.doubt("a")(passed_on(kept)) == ""
        assert "is not for b" in robots.doubt("b")(passed_on(kept))


def test_a_robot_cannot_exhaust_the_numbers(robots: Robots, tmp_path: Path) -> None:
    node = SimpleNamespace(status={"epoch": {"number": (1 << 53) - 2}, "held": {"number": 4}})
    assert swapping._epoch(cast("Any", node)) == 0
    node.status["epoch"]["number"] = 3
    assert swapping._epoch(cast("Any", node)) == 4


# ---- keys of robots --------------------------------------------------------------------------------


def test_a_robot_s_part_of_a_key_is_good_for_this_robot_only(
    robots: Robots, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    operator, own = newest_key(robots.operator), newest_key(robots.own["a"])
    assert own.secret == b"" and own.of("a") == operator.of("a") and own.of("b") is None
    assert operator.secret.hex() not in robots.own["a"].read_text()
    two = tmp_path / "two.toml"
    asemec = cli.Here(capsys)
    made = asemec("key", str(two), "--of", str(robots.operator), "--for", "a", "--for", "b")
    assert made.code == 0 and two.stat().st_mode & 0o777 == 0o600
    assert set(newest_key(two).robots) == {"a", "b"}
    refused = asemec("key", str(tmp_path / "d.toml"), "--of", str(two), "--for", "c")
    assert refused.code == 1 and "is for other agents" in refused.err
    assert not (tmp_path / "d.toml").exists()
    assert asemec("key", str(tmp_path / "d.toml"), "--for", "c").code == 2
    with pytest.raises(OperateError, match="is not for c, but for a, b"):
        robot = Robot("c", SYSTEM, newest_key(two), cast("ZenohLink", None))
        swapping.swap(whole_team(tmp_path, [robot]), "0" * 64)


@pytest.mark.parametrize("text", ['k = { a = "12" }', "k = { a = 1 }", "k = [1]", 'k = { a = { b = "c" } }'])
def test_a_damaged_part_of_a_key_is_refused(robots: Robots, text: str) -> None:
    robots.own["a"].write_text(text)
    with pytest.raises(KeyFileError, match="hexadecimal digits"):
        read_keys(robots.own["a"])
