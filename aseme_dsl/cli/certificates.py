"""`asemec certificates`: the certificate authority of a team, and the certificates and keys of its agents."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.shared import (
    Refused,
    colour_option,
    json_option,
    print_json,
    target_argument,
)
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.diagnostics.problems.settings import CertificateUnusable, NoCertificateFiles

if TYPE_CHECKING:
    from aseme_dsl.project.deploying.certificates import Files, Validity

_NAME = re.compile(r"[A-Za-z_]\w*")
_AGENT = re.compile(rf"({_NAME.pattern})(?:=([\w.:,-]+))?")


@click.group(
    short_help="Make, renew and list the certificates of a team.",
    help="Make, renew and list the certificates with which the agents of a team authenticate each other."
    " [tool.asemec.deploy] of the pyproject.toml says which agents there are, and where the files are.",
    epilog="Example: asemec certificates make   ·   asemec certificates list",
)
def command() -> None:
    """The group."""


_days_option = click.option(
    "--days",
    type=click.IntRange(1, 3650),
    default=397,
    show_default=True,
    help="Days until a new certificate expires.",
)


def _agents_of(
    context: click.Context, parameter: click.Parameter, values: tuple[str, ...]
) -> dict[str, tuple[str, ...]]:
    """Names of agents, each with its addresses."""
    found: dict[str, tuple[str, ...]] = {}
    for value in values:
        read = _AGENT.fullmatch(value)
        if read is None:
            raise click.BadParameter(f"{value!r} is not NAME or NAME=ADDRESS,ADDRESS.")
        found[read[1]] = tuple(filter(None, (read[2] or "").split(",")))
    return found


@command.command(
    name="make",
    short_help="Make the certificates that are missing.",
    help="Make the certificates and keys that are missing: of the authority, of each agent in `hosts`, and of"
    " the operator. Existing files are kept. The key of the authority is in the folder `private` beside its"
    " certificate. Copy it to no robot.",
    epilog="Example: asemec certificates make   ·   asemec certificates make --agent scout=10.0.0.7",
)
@target_argument
@click.option(
    "--agent",
    "further",
    multiple=True,
    metavar="NAME[=ADDRESS,…]",
    callback=_agents_of,
    help="Agent that `hosts` does not name, or further addresses of one. Repeatable.",
)
@_days_option
@colour_option
def make_command(target: str, further: dict[str, tuple[str, ...]], days: int, colour: str) -> int:
    """Write them; 1 if that fails."""
    from aseme_dsl.project.deploying.certificates import CertificateError, make

    files, addresses, system = _settings(target, further, colour)
    try:
        made = make(files, addresses, system, days)
    except CertificateError as problem:
        raise _refused(problem, target, colour) from problem
    for path in made.written:
        click.echo(f"written  {_shown(path)}")
    for path in made.kept:
        click.echo(f"kept     {_shown(path)}")
    if files.authority_key in made.written:
        click.echo(f"keep {_shown(files.authority_key)} off the robots, and make a backup of it")
    return 0


@command.command(
    name="renew",
    short_help="Renew the certificate and the key of an agent.",
    help="Make a new certificate and a new key for AGENT. The files before are renamed. The old certificate"
    " remains valid until it expires.",
    epilog="Example: asemec certificates renew robot1",
)
@click.argument("agent")
@target_argument
@click.option(
    "--address",
    "further",
    multiple=True,
    metavar="ADDRESS",
    help="Further address or host name of the agent. Repeatable.",
)
@_days_option
@colour_option
def renew_command(agent: str, target: str, further: tuple[str, ...], days: int, colour: str) -> int:
    """Write them; 1 if that fails."""
    from aseme_dsl.project.deploying.certificates import CertificateError, renew
    from aseme_dsl.runtime.transport.access import OPERATOR

    if agent != OPERATOR and not _NAME.fullmatch(agent):
        raise click.BadParameter(f"{agent!r} is not the name of an agent.", param_hint="AGENT")
    files, addresses, _ = _settings(target, {} if agent == OPERATOR else {agent: further}, colour)
    try:
        made = renew(files, agent, addresses.get(agent, ()), days)
    except CertificateError as problem:
        raise _refused(problem, target, colour) from problem
    for path in made.kept:
        click.echo(f"renamed  {_shown(path)}")
    for path in made.written:
        click.echo(f"written  {_shown(path)}")
    return 0


@command.command(
    name="list",
    short_help="List the certificates with their expiry dates.",
    help="List the certificates of a team with their expiry dates. Exit code 1: a certificate cannot be used,"
    " or expires within 30 days.",
    epilog="Example: asemec certificates list",
)
@target_argument
@json_option
@colour_option
def list_command(target: str, as_json: bool, colour: str) -> int:
    """Print them; 1 if one needs attention."""
    from aseme_dsl.project.deploying.certificates import CertificateError, validities

    files, addresses, _ = _settings(target, {}, colour)
    try:
        found = list(validities(files, addresses))
    except CertificateError as problem:
        raise _refused(problem, target, colour) from problem
    if as_json:
        print_json({"result": [_data(item) for item in found]})
    else:
        width = max(len(item.name) for item in found)
        for item in found:
            left = f"{max(item.days_left, 0)} days"
            rest = f"  {', '.join(item.addresses)}" if item.addresses else ""
            note = f"  ({item.problem})" if item.problem else ""
            click.echo(f"{item.name:<{width}}  {item.expires:%Y-%m-%d}  {left:>9}{rest}{note}")
    return 1 if any(item.problem for item in found) else 0


def _data(item: Validity) -> dict[str, object]:
    return {
        "name": item.name,
        "file": str(item.path),
        "expires": item.expires.isoformat(),
        "days_left": item.days_left,
        "addresses": list(item.addresses),
        "problem": item.problem,
    }


def _settings(
    target: str, further: Mapping[str, tuple[str, ...]], colour: str
) -> tuple[Files, dict[str, tuple[str, ...]], str]:
    """The files of the team, the addresses of its agents, and what the team is called."""
    from aseme_dsl.project.deploying.certificates import Files
    from aseme_dsl.project.settings.deployment import host_of
    from aseme_dsl.project.settings.target import configuration_of

    configuration, problems = configuration_of(Path(target))
    if has_errors(problems):
        raise Refused(problems, colour)
    deploy = configuration.deploy
    if deploy is None or deploy.tls is None:
        place = str(configuration.path or target)
        raise Refused([Diagnostic(NoCertificateFiles(), None, path=place)], colour)
    addresses: dict[str, tuple[str, ...]] = {name: (host_of(host),) for name, host in deploy.hosts.items()}
    for name, more in further.items():
        addresses[name] = tuple(dict.fromkeys((*addresses.get(name, ()), *more)))
    return Files(deploy.tls), addresses, configuration.folder.resolve().name or "team"


def _refused(problem: Exception, target: str, colour: str) -> Refused:
    return Refused([Diagnostic(CertificateUnusable(str(problem)), None, path=target)], colour)


def _shown(path: Path) -> str:
    """A path as people would write it here."""
    return click.format_filename(os.path.relpath(path))
