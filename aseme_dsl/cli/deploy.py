"""`asemec deploy`: make the bundle of a team, and copy it to its hosts."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.playing import build_target, lines_without_code
from aseme_dsl.cli.shared import Refused, colour_option, folder_option, gathered
from aseme_dsl.diagnostics import Diagnostic, Problem, has_errors
from aseme_dsl.diagnostics.problems.settings import HostUnknown, NotDeployed
from aseme_dsl.project.deploying.install import KEEP
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.deploying.bundle import Bundle
    from aseme_dsl.project.deploying.remote import Host
    from aseme_dsl.project.settings.configuration import Configuration

_DIRECTORY = re.compile(r"[~/]?[\w./-]*[\w/-]")
"""A folder on a host; the shell there reads it."""


@dataclass(frozen=True, slots=True)
class _Options:
    """What is on the command line."""

    hosts: tuple[str, ...]
    project: str | None
    output: Path | None
    to: str | None
    everywhere: bool
    user: str | None
    wheels: str | None
    python: str
    start: bool
    back: bool
    keep: int
    colour: str

    @property
    def place(self) -> str:
        """What is deployed."""
        from aseme_dsl.project.settings.target import project_here

        return self.project or project_here()


def _python_version(context: click.Context, parameter: click.Parameter, value: str) -> str:
    if not re.fullmatch(r"3\.\d{1,2}", value):
        raise click.BadParameter(f"{value!r} is not a version such as 3.11.")
    return value


def _directory(context: click.Context, parameter: click.Parameter, value: str | None) -> str | None:
    if value is not None and not _DIRECTORY.fullmatch(value):
        raise click.BadParameter("only letters, digits and `_ . / ~ -` are possible.")
    return value


def _default_python() -> str:
    import sys

    return f"{sys.version_info.major}.{sys.version_info.minor}"


@click.command(
    short_help="Make the bundle of a team and copy it to its hosts.",
    help="Build the system of a project, and write a bundle with all that its agents need. The certificates"
    " and keys of the agents are written to files of their own. With a HOST, copy both there with"
    " ssh, unpack the bundle, and activate it. HOST is an agent, an address of `hosts`, or USER@ADDRESS.",
    epilog="Example: asemec deploy   ·   asemec deploy robot1 --start   ·   asemec deploy --all --rollback",
)
@click.argument("hosts", nargs=-1, metavar="[HOST]...")
@click.option("--project", metavar="TARGET", help="File or project.  [default: the project here]")
@folder_option("-o", "--output", text="Directory of the bundle.  [default: deploy in the project]")
@click.option(
    "--to",
    metavar="DIR",
    callback=_directory,
    help="Directory of the team on the hosts.  [default: asemec/SYSTEM in the home directory]",
)
@click.option("--all", "everywhere", is_flag=True, help="All hosts of the team.")
@click.option("--user", metavar="NAME", help="User on the hosts.  [default: that of ssh]")
@click.option(
    "--wheels",
    metavar="ARCH",
    type=click.Choice(["x86_64", "aarch64", "armv7l", "native"]),
    help="Add the Python packages for this architecture: x86_64, aarch64, armv7l, or native.",
)
@click.option(
    "--python",
    metavar="VERSION",
    default=_default_python,
    callback=_python_version,
    help="Python version of the robots, for --wheels.  [default: this Python's]",
)
@click.option("--start", is_flag=True, help="Restart the agents with systemd, as services of the user.")
@click.option(
    "--keep",
    type=click.IntRange(1),
    metavar="N",
    default=KEEP,
    show_default=True,
    help="Versions that remain on a host. The active one and the one before always do.",
)
@click.option("--rollback", "back", is_flag=True, help="Activate the version before, and make no bundle.")
@colour_option
@gathered(_Options)
def command(options: _Options) -> int:
    """Make it and copy it; 1 if that fails."""
    from aseme_dsl.project.deploying.bundle import BundleError

    try:
        return _rolled_back(options) if options.back else _deployed(options)
    except BundleError as problem:
        raise _refused(NotDeployed(str(problem)), options) from problem


def _refused(problem: Problem, options: _Options) -> Refused:
    return Refused([Diagnostic(problem, None, path=options.place)], options.colour)


def _deployed(options: _Options) -> int:
    from aseme_dsl.project.building.build import activities_folder
    from aseme_dsl.project.deploying.bundle import make_bundle
    from aseme_dsl.project.deploying.wheels import this_architecture, wheels_for
    from aseme_dsl.project.settings.deployment import misfits

    built = build_target(options.place, None, None, None, False, False, options.colour)
    if isinstance(built, int):
        return built
    report, compiled, choice, bare = built
    configuration = compiled.configuration
    assert compiled.system is not None
    agents = [agent.name for team in compiled.system.teams for agent in team.agents]
    if not agents:
        raise _refused(NotDeployed("the system has no team, so there are no agents to deploy"), options)
    for misfit in (
        misfits(configuration.deploy, agents, str(configuration.path)) if configuration.deploy else ()
    ):
        raise _refused(misfit, options)
    for line in lines_without_code(bare, options.place, None):
        click.echo(line)
    hosts = _hosts(options, configuration, report.system)
    wheels = None
    if options.wheels is not None:
        architecture = this_architecture() if options.wheels == "native" else options.wheels
        wheels = wheels_for(configuration, architecture, options.python)
    activities = activities_folder(report.folder, choice)
    folder = options.output or configuration.folder / "deploy"
    bundle = make_bundle(report.system, agents, report.folder, activities, configuration, wheels, folder)
    _write(folder, bundle, configuration, bool(hosts))
    return _on_each(hosts, options, configuration, bundle)


def _write(folder: Path, bundle: Bundle, configuration: Configuration, copied: bool) -> None:
    """Write the bundle, and what is beside it unless that is copied over ssh."""
    from aseme_dsl.project.deploying import install
    from aseme_dsl.project.deploying.bundle import BundleError, private_archive

    files = {bundle.name: (bundle.archive, 0o644)}
    if not copied:
        files["install.py"] = (Path(install.__file__).read_bytes(), 0o644)
        for agent in bundle.agents:
            secret = private_archive(configuration, [agent])
            if configuration.deploy is not None and (
                configuration.deploy.tls or configuration.deploy.control
            ):
                files[f"{agent}.private.tar"] = (secret, 0o600)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, (content, mode) in files.items():
            part = folder / f".{name}.part"
            part.unlink(missing_ok=True)
            with os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "wb") as file:
                file.write(content)
            part.replace(folder / name)
            click.echo(f"written  {click.format_filename(folder / name)}  {len(content) / 1000:.0f} kB")
    except OSError as problem:
        raise BundleError(f"{problem.filename} cannot be written: {problem.strerror}") from problem


def _on_each(
    hosts: list[Host], options: _Options, configuration: Configuration, bundle: Bundle | None
) -> int:
    """Deploy to each host, or (without a bundle) roll back; 1 if one fails. The others are still done."""
    from aseme_dsl.project.deploying.bundle import private_archive
    from aseme_dsl.project.deploying.remote import RemoteError

    code = 0
    for host in hosts:
        try:
            if bundle is None:
                said = host.rollback(options.start)
            else:
                said = host.deploy(
                    bundle, private_archive(configuration, host.agents), options.start, options.keep
                )
            text = ", ".join(said.split("\n")).strip(", ")
            click.echo(f"{host.destination} ({', '.join(host.agents)}): {text}")
        except RemoteError as problem:
            _refused(NotDeployed(f"{host.destination}: {problem}"), options).show()
            code = 1
    return code


def _rolled_back(options: _Options) -> int:
    from aseme_dsl.cli.shared import one_system

    compiled = one_system(options.place)
    if compiled.system is None:
        raise Refused([item for item in compiled.diagnostics if has_errors([item])], options.colour)
    hosts = _hosts(options, compiled.configuration, compiled.system.name)
    if not hosts:
        raise click.UsageError("--rollback needs a HOST, or --all.")
    return _on_each(hosts, options, compiled.configuration, None)


def _hosts(options: _Options, configuration: Configuration, system: str) -> list[Host]:
    """The hosts that are meant, each with all its agents."""
    from aseme_dsl.project.deploying.remote import DESTINATION, Host
    from aseme_dsl.project.settings.deployment import host_of

    named = dict(configuration.deploy.hosts) if configuration.deploy is not None else {}
    places = {agent: host_of(host) for agent, host in named.items()}
    asked = [*options.hosts, *(places.values() if options.everywhere else ())]
    if options.everywhere and not places:
        raise _refused(NotDeployed("`hosts` is empty, so --all names no host"), options)
    found: dict[str, Host] = {}
    for name in asked:
        user, _, host = name.rpartition("@")
        address = places.get(host, host)
        agents = tuple(agent for agent, place in places.items() if place == address)
        if not agents:
            raise _refused(HostUnknown(name, (*places, *dict.fromkeys(places.values()))), options)
        user = user or options.user or ""
        destination = f"{user}@{address}" if user else address
        if not DESTINATION.fullmatch(destination):
            raise _refused(NotDeployed(f"`{destination}` is not a destination for ssh"), options)
        found[address] = Host(destination, options.to or f"asemec/{system}", agents)
    return list(found.values())
