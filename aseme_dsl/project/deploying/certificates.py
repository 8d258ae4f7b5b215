"""Certificates of a team: its authority, a certificate and key for each agent, and one for the operator.

Where the files are is said in `[tool.asemec.deploy.tls]`. The key of the authority is in a folder of its own,
`private`, beside the certificate of the authority: no robot needs it, and no bundle has it. Needs the library
`cryptography`, from the extra `certificates`.
"""

from __future__ import annotations

import glob
import ipaddress
import os
import secrets
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.project.settings.deployment import ROBOT, TlsFiles, file_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.operator_key import write_new
from aseme_dsl.runtime.transport.access import OPERATOR

if TYPE_CHECKING:
    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey

MISSING = 'certificates need the library cryptography: pip install "aseme-dsl[certificates]"'
AUTHORITY_DAYS = 3650
AGENT_DAYS = 397
SOON_DAYS = 30
"""A certificate that expires within so many days is reported."""
_EARLIER = timedelta(days=1)
"""Certificates are valid from so long ago: the clock of a robot may be late."""
_LARGEST = 1 << 20
_SECRET, _PUBLIC = 0o600, 0o644


class CertificateError(Exception):
    """Certificates cannot be made or read; the text says why."""


@dataclass(frozen=True, slots=True)
class Files:
    """The PEM files of a team."""

    tls: TlsFiles

    @property
    def authority(self) -> Path:
        """The certificate of the authority."""
        assert self.tls.authority is not None
        return self.tls.authority

    @property
    def authority_key(self) -> Path:
        """The private key of the authority, which stays off the robots."""
        return self.authority.parent / "private" / f"{self.authority.stem}.key"

    def certificate(self, name: str) -> Path:
        """The certificate of an agent, or of the operator."""
        assert self.tls.certificate is not None
        return file_of(self.tls.certificate, name)

    def key(self, name: str) -> Path:
        """Its private key."""
        assert self.tls.key is not None
        return file_of(self.tls.key, name)


@dataclass(frozen=True, slots=True)
class Validity:
    """What a certificate file says. `addresses` are the IP addresses and host names it is valid for."""

    name: str
    path: Path
    expires: datetime
    days_left: int
    addresses: tuple[str, ...] = ()
    problem: str | None = None
    """Why it cannot be used, or not for long."""


@dataclass(frozen=True, slots=True)
class Made:
    """The files that were written, and those that were there and stay as they are."""

    written: tuple[Path, ...] = ()
    kept: tuple[Path, ...] = ()


def make(files: Files, addresses: Mapping[str, Iterable[str]], team: str, days: int = AGENT_DAYS) -> Made:
    """Make what is missing of the team's certificates; what is there stays.

    `addresses` has the IP addresses and host names of each agent.

    Raises:
        CertificateError: the library is missing, a file cannot be read or written, or only one of a
            certificate and its key is there.
    """
    _library()
    written: list[Path] = []
    kept: list[Path] = []
    pairs = [(files.certificate(name), files.key(name)) for name in (*addresses, OPERATOR)]
    for certificate, key in [(files.authority, files.authority_key), *pairs]:
        if os.path.lexists(key) and not os.path.lexists(certificate):
            raise CertificateError(
                f"{key} is there without {certificate}: move it away, or restore the other"
            )
    if not os.path.lexists(files.authority):
        if any(os.path.lexists(certificate) for certificate, _ in pairs):
            raise CertificateError(f"there are certificates of agents, but {files.authority} is missing")
        written += _new_authority(files, team)
    else:
        kept.append(files.authority)
    issuer: _Issuer | None = None
    for name, (certificate, key) in zip((*addresses, OPERATOR), pairs, strict=True):
        if os.path.lexists(certificate):
            if not os.path.lexists(key):
                raise CertificateError(f"{certificate} is there without {key}: renew it")
            kept.append(certificate)
            continue
        issuer = issuer or _issuer(files)
        _write_pair(certificate, key, *_signed(issuer, name, addresses.get(name, ()), days))
        written += [certificate, key]
    return Made(tuple(written), tuple(kept))


def renew(files: Files, name: str, addresses: Iterable[str], days: int = AGENT_DAYS) -> Made:
    """A new certificate and a new key for one agent; `kept` are the new names of the files before.

    Without `addresses`, it is valid for the same as before.

    Raises:
        CertificateError: see `make`; or there is nothing to renew.
    """
    _library()
    issuer = _issuer(files)
    certificate, key = files.certificate(name), files.key(name)
    if not os.path.lexists(certificate):
        raise CertificateError(f"{certificate} is missing: there is nothing to renew")
    wanted = tuple(addresses) or _addresses(_read_certificate(certificate))
    contents = _signed(issuer, name, wanted, days)
    kept: list[Path] = []
    mark = f"{datetime.now(UTC):%Y%m%dT%H%M%S}-{secrets.token_hex(2)}"
    try:
        for path in (certificate, key):
            if os.path.lexists(path):
                before = path.with_name(f"{path.stem}.before-{mark}{path.suffix}")
                path.rename(before)
                kept.append(before)
        _write_pair(certificate, key, *contents)
    except OSError as problem:
        raise CertificateError(f"{problem.filename} cannot be renamed: {problem.strerror}") from problem
    return Made((certificate, key), tuple(kept))


def validities(
    files: Files, addresses: Mapping[str, Iterable[str]], now: datetime | None = None
) -> Iterator[Validity]:
    """What the certificates of the authority, of these agents, and others in their folder say.

    Raises:
        CertificateError: the library is missing, or a file is not a certificate.
    """
    _library()
    today = now or datetime.now(UTC)
    authority = _read_certificate(files.authority)
    yield _validity("authority", files.authority, authority, None, (), today)
    for name in dict.fromkeys((*addresses, *_further(files))):
        path = files.certificate(name)
        wanted = tuple(addresses.get(name, ()))
        yield _validity(name, path, _read_certificate(path), authority, wanted, today)


def _further(files: Files) -> Iterator[str]:
    """The names of agents, and of the operator, that have a certificate."""
    pattern = files.certificate(ROBOT)
    start, _, end = pattern.name.partition(ROBOT)
    for path in sorted(pattern.parent.glob(f"{glob.escape(start)}*{glob.escape(end)}")):
        name = path.name[len(start) : len(path.name) - len(end)]
        if path != files.authority and (name.isidentifier() or name == OPERATOR):
            yield name


def _validity(
    name: str,
    path: Path,
    certificate: x509.Certificate,
    authority: x509.Certificate | None,
    wanted: tuple[str, ...],
    today: datetime,
) -> Validity:
    from cryptography import x509

    expires = certificate.not_valid_after_utc
    left = (expires - today) // timedelta(days=1)
    there = _addresses(certificate)
    problem = None
    common = [item.value for item in certificate.subject.get_attributes_for_oid(x509.NameOID.COMMON_NAME)]
    absent = [address for address in wanted if address not in there]
    if authority is not None and common != [name]:
        problem = f"its common name is {', '.join(map(str, common)) or 'missing'}"
    elif authority is not None and not _is_signed(certificate, authority):
        problem = "another authority has signed it"
    elif left < 0:
        problem = "expired"
    elif today < certificate.not_valid_before_utc:
        problem = f"not valid before {certificate.not_valid_before_utc:%Y-%m-%d}"
    elif left < SOON_DAYS:
        problem = "expires soon"
    elif absent:
        problem = f"not valid for {', '.join(absent)}"
    return Validity(name, path, expires, left, there, problem)


def _addresses(certificate: x509.Certificate) -> tuple[str, ...]:
    from cryptography import x509

    try:
        names = certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except x509.ExtensionNotFound:
        return ()
    addresses = names.get_values_for_type(x509.IPAddress)
    return (*map(str, addresses), *names.get_values_for_type(x509.DNSName))


def _is_signed(certificate: x509.Certificate, authority: x509.Certificate) -> bool:
    from cryptography.exceptions import InvalidSignature

    try:
        certificate.verify_directly_issued_by(authority)
    except (InvalidSignature, ValueError, TypeError):
        return False
    return True


# ---- how they are made -------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Issuer:
    certificate: x509.Certificate
    key: EllipticCurvePrivateKey


def _library() -> None:
    try:
        import cryptography.x509  # noqa: F401
    except ImportError as problem:
        raise CertificateError(MISSING) from problem


def _new_authority(files: Files, team: str) -> list[Path]:
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes
    from cryptography.hazmat.primitives.asymmetric import ec

    key = ec.generate_private_key(ec.SECP256R1())
    # Two authorities of one name would be taken for each other in messages about certificates.
    name = _common_name(f"{team[:40]} authority {secrets.token_hex(4)}")
    uses = dict.fromkeys(_USES, False) | {"key_cert_sign": True, "crl_sign": True}
    certificate = (
        _begun(name, name, key, AUTHORITY_DAYS)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(x509.KeyUsage(**uses), critical=True)
        .add_extension(x509.SubjectKeyIdentifier.from_public_key(key.public_key()), critical=False)
        .sign(key, hashes.SHA256())
    )
    _make_folder(files.authority_key.parent, 0o700)
    _write_pair(files.authority, files.authority_key, *_pem(certificate, key))
    return [files.authority, files.authority_key]


def _issuer(files: Files) -> _Issuer:
    from cryptography.hazmat.primitives import serialization
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey

    certificate = _read_certificate(files.authority)
    content = _read(files.authority_key)
    try:
        key = serialization.load_pem_private_key(content, None)
    except (ValueError, TypeError) as problem:
        raise CertificateError(f"{files.authority_key} is not a private key in PEM") from problem
    if not isinstance(key, EllipticCurvePrivateKey):
        raise CertificateError(f"{files.authority_key} was not made by asemec: it is not an EC key")
    if key.public_key() != certificate.public_key():
        raise CertificateError(f"{files.authority_key} is not the key of {files.authority}")
    return _Issuer(certificate, key)


def _signed(issuer: _Issuer, name: str, addresses: Iterable[str], days: int) -> tuple[bytes, bytes]:
    """The certificate and the key of an agent, in PEM."""
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.x509.oid import ExtendedKeyUsageOID

    key = ec.generate_private_key(ec.SECP256R1())
    uses = dict.fromkeys(_USES, False) | {"digital_signature": True}
    both = [ExtendedKeyUsageOID.CLIENT_AUTH]
    if name != OPERATOR:  # an operator connects, and nothing connects to it
        both.append(ExtendedKeyUsageOID.SERVER_AUTH)
    issued = issuer.certificate.public_key()
    assert isinstance(issued, ec.EllipticCurvePublicKey)
    begun = (
        _begun(_common_name(name), issuer.certificate.subject, key, days, issuer.certificate)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(x509.KeyUsage(**uses), critical=True)
        .add_extension(x509.ExtendedKeyUsage(both), critical=False)
        .add_extension(x509.SubjectKeyIdentifier.from_public_key(key.public_key()), critical=False)
        .add_extension(x509.AuthorityKeyIdentifier.from_issuer_public_key(issued), critical=False)
    )
    names = [_general_name(address) for address in addresses]
    if names:
        begun = begun.add_extension(x509.SubjectAlternativeName(names), critical=False)
    return _pem(begun.sign(issuer.key, hashes.SHA256()), key)


_USES = (
    "digital_signature",
    "content_commitment",
    "key_encipherment",
    "data_encipherment",
    "key_agreement",
    "key_cert_sign",
    "crl_sign",
    "encipher_only",
    "decipher_only",
)


def _begun(
    subject: x509.Name,
    issuer: x509.Name,
    key: EllipticCurvePrivateKey,
    days: int,
    authority: x509.Certificate | None = None,
) -> x509.CertificateBuilder:
    from cryptography import x509

    now = datetime.now(UTC).replace(microsecond=0)
    first, last = now - _EARLIER, now + timedelta(days=days)
    if authority is not None:
        first = max(first, authority.not_valid_before_utc)
        last = min(last, authority.not_valid_after_utc)
        if authority.not_valid_after_utc <= now:
            raise CertificateError("the certificate of the authority has expired")
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(first)
        .not_valid_after(last)
    )


def _common_name(name: str) -> x509.Name:
    from cryptography import x509

    try:
        return x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, name)])
    except ValueError as problem:
        raise CertificateError(f"{name} cannot be the name in a certificate: {problem}") from problem


def _general_name(address: str) -> x509.GeneralName:
    from cryptography import x509

    try:
        return x509.IPAddress(ipaddress.ip_address(address))
    except ValueError:
        pass
    try:
        return x509.DNSName(address)
    except ValueError as problem:
        raise CertificateError(f"{address} is neither an address nor the name of a host") from problem


def _pem(certificate: x509.Certificate, key: EllipticCurvePrivateKey) -> tuple[bytes, bytes]:
    from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat

    return (
        certificate.public_bytes(Encoding.PEM),
        key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption()),
    )


# ---- files -------------------------------------------------------------------------------------


def _read(path: Path) -> bytes:
    try:
        return outside.read_bytes(path, _LARGEST)
    except OSError as problem:
        raise CertificateError(f"{path} cannot be read: {problem.strerror or problem}") from problem


def _read_certificate(path: Path) -> x509.Certificate:
    from cryptography import x509

    try:
        return x509.load_pem_x509_certificate(_read(path))
    except ValueError as problem:
        raise CertificateError(f"{path} is not a certificate in PEM") from problem


def _make_folder(path: Path, mode: int = 0o777) -> None:
    try:
        path.mkdir(mode=mode, parents=True, exist_ok=True)
    except OSError as problem:
        raise CertificateError(f"{path} cannot be made: {problem.strerror or problem}") from problem


def _write_pair(certificate: Path, key: Path, public: bytes, secret: bytes) -> None:
    """Write both files, the key first; neither replaces a file."""
    for path, content, mode in ((key, secret, _SECRET), (certificate, public, _PUBLIC)):
        _make_folder(path.parent)
        try:
            write_new(path, content, mode)
        except FileExistsError as problem:
            raise CertificateError(f"{path} is there already") from problem
        except OSError as problem:
            raise CertificateError(f"{path} cannot be written: {problem.strerror or problem}") from problem
