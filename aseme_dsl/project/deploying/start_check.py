"""What must be there before an agent starts on a robot: its whole bundle, and a certificate that is good.

A folder without the list of a bundle is a development machine's, where only the certificate is looked at.
"""

from __future__ import annotations

import re
import ssl
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path, PurePosixPath

from aseme_dsl.project.deploying import install
from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.project.settings.deployment import TlsFiles, file_of

_PINNED = re.compile(r"([A-Za-z0-9][\w.-]*)(?:\[[\w.,-]*\])?==([\w.!+-]+)")


def bundle_of(output: Path) -> Path | None:
    """The folder of the unpacked bundle whose output folder this is; None if it is not of a bundle."""
    is_of_bundle = (output / PurePosixPath(install.LIST).name).exists()
    return output.absolute().parent if is_of_bundle else None


def incomplete(folder: Path, agent: str) -> Iterator[str]:
    """What of an unpacked bundle is missing, altered or does not fit this machine."""
    try:
        found = install.read_list(folder)
    except install.InstallError as problem:
        yield str(problem)
        return
    yield from install.altered(folder, found)
    for name in found.private.get(agent, ()):
        if not (folder / name).is_file():
            yield f"{name} is missing: it is beside the bundle, not in it"
    try:
        text = (folder / "requirements.txt").read_text("utf-8")
    except OSError:
        return  # that it is missing was said
    for line in text.splitlines():
        pinned = _PINNED.match(line.strip())
        if pinned is not None:
            yield from _unmet(pinned[1], pinned[2])


def _unmet(name: str, version: str) -> Iterator[str]:
    try:
        there = metadata.version(name)
    except metadata.PackageNotFoundError:
        yield f"the Python package {name} {version} is not installed"
        return
    if there != version:
        yield f"the Python package {name} has version {there}, not {version}"


def bad_certificate(configuration: Configuration, agent: str) -> str | None:
    """Why the certificate of an agent cannot be used; None if it can, or none is needed.

    The agent shows the certificate to itself, over TLS in memory: what this refuses, the others would refuse.
    """
    deploy = configuration.deploy
    if deploy is None or deploy.tls is None or not (deploy.hosts or deploy.connect or deploy.interface):
        return None
    files = deploy.tls
    paths = [file_of(path, agent) for path in (files.authority, files.certificate, files.key) if path]
    for path in paths:
        if not path.is_file():
            return f"{path} is missing: run `asemec certificates make`, and deploy it"
    return _refused(TlsFiles(*paths), agent)


def _refused(files: TlsFiles, agent: str) -> str | None:
    assert files.authority and files.certificate and files.key
    try:
        server = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        client = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        server.load_cert_chain(files.certificate, files.key)
        client.load_verify_locations(files.authority)
        client.check_hostname = False
    except (ssl.SSLError, OSError) as problem:
        return f"{files.certificate} and {files.key} do not fit: {problem.strerror or problem}"
    to_server, to_client = ssl.MemoryBIO(), ssl.MemoryBIO()
    here = client.wrap_bio(to_client, to_server)
    there = server.wrap_bio(to_server, to_client, server_side=True)
    for side in (here, there, here, there, here):
        try:
            side.do_handshake()
        except ssl.SSLWantReadError:
            pass
        except ssl.SSLCertVerificationError as problem:
            return f"{files.certificate}: {problem.verify_message}"
        except ssl.SSLError as problem:
            return f"{files.certificate}: {problem.reason or problem}"
    subject = (here.getpeercert() or {}).get("subject", ())
    names = [str(pair[1]) for part in subject for pair in part if pair[0] == "commonName"]
    if names != [agent]:
        return f"{files.certificate} is for {', '.join(names) or 'no name'}, not for {agent}"
    return None
