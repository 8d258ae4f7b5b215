"""The file of hosts is read again: an absent agent is looked for where the file says that it is now."""

from __future__ import annotations

import socket
from pathlib import Path
from unittest import mock

import pytest

from aseme_dsl.project.settings.deployment import HostsNow, HostsOfFile, read_hosts
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.support.network import own_name
from tests.support.waiting import wait_until

pytest.importorskip("zenoh")
WIRE = own_name("Wire")


def port() -> int:
    """One that is free."""
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


def test_an_agent_is_found_where_the_file_of_hosts_says_that_it_is_now(tmp_path: Path) -> None:
    file = tmp_path / "hosts.toml"
    mine, place, before = port(), port(), port()
    file.write_text(f'ann = "127.0.0.1:{mine}"\nbob = "127.0.0.1:{before}"\n')
    hosts = HostsNow(HostsOfFile(file, read_hosts(file)), "ann", "tcp")
    team = ("ann", "bob")
    own = (f"tcp/127.0.0.1:{mine}",)
    ann = ZenohLink(WIRE, Network(own, tuple(hosts().values()), robot="ann", team=team, places=hosts))
    bob = ZenohLink(WIRE, Network((f"tcp/127.0.0.1:{place}",), robot="bob", team=team))
    ears = {name: mock.Mock() for name in team}
    try:
        bob.open(("bob",), 2, ears["bob"])
        ann.open(("ann",), 1, ears["ann"])
        file.write_text("bob = [")
        wait_until(lambda: ears["ann"].fault.called)
        name, reason = ears["ann"].fault.call_args.args
        assert name == "ann" and "hosts.toml is not valid TOML" in reason
        assert mock.call("bob", 2) not in ears["ann"].appeared.mock_calls
        assert not ears["ann"].disconnected.called
        file.write_text(f'bob = "127.0.0.1:{place}"\n')
        wait_until(lambda: mock.call("bob", 2) in ears["ann"].appeared.mock_calls)
        wait_until(lambda: mock.call("ann", 1) in ears["bob"].appeared.mock_calls)
        wait_until(lambda: ears["ann"].connected.called)
        assert ears["ann"].disconnected.call_args_list == [mock.call("ann", "other hosts: bob")]
    finally:
        ann.close()
        bob.close()
