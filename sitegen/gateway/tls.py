"""Encrypt connections: with the operator's certificate, or with one made here."""

from __future__ import annotations

import datetime
import ipaddress
import os
import ssl
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from sitegen.errors import SiteError
from sitegen.gateway.addresses import own_names

SELF_SIGNED = "self-signed"
# Browsers take no certificates that are good for much longer (days), and it is made again when
# fewer are left.
DAYS, RENEW = 397, 30


@dataclass(frozen=True)
class Tls:
    """What the server needs, and lines about what to do; in them, PORT stands for the port."""

    context: ssl.SSLContext
    advice: tuple[str, ...] = ()


def context(given: Sequence[str], bind: str) -> Tls:
    """Return what `--tls` asks for: a certificate and its key, or "self-signed".

    Raises: SiteError for files that are not a certificate and its key.
    """
    found = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    found.minimum_version = ssl.TLSVersion.TLSv1_2
    if list(given) == [SELF_SIGNED]:
        folder = _folder()
        names = own_names(bind)
        certificate, key = _self_signed(folder, names)
        found.load_cert_chain(certificate, key)
        return Tls(found, _advice(certificate, names))
    if len(given) != 2:
        raise SiteError(["--tls: give a certificate and its key, or: --tls self-signed"])
    for file in given:
        if not Path(file).is_file():
            raise SiteError([f"{file}: no such file; --tls needs a certificate and its key"])
    try:
        found.load_cert_chain(given[0], given[1], password=lambda: b"")
    except (ssl.SSLError, OSError, ValueError) as error:
        why = getattr(error, "reason", None) or error
        text = f"{given[0]}, {given[1]}: not a PEM certificate and its key without a password"
        raise SiteError([f"{text}: {why}"]) from None
    return Tls(found)


def _folder() -> Path:
    own = os.environ.get("XDG_DATA_HOME")
    return (Path(own) if own else Path.home() / ".local" / "share") / "sitegen" / "gateway"


def _advice(certificate: Path, names: list[str]) -> tuple[str, ...]:
    place = names[-1]
    return (
        f"certificate: {certificate} (made on this computer; browsers do not know it)",
        f"in each browser, once: open https://{place}:PORT/ and accept the certificate;"
        f" then pages can connect to wss://{place}:PORT/",
    )


def _self_signed(folder: Path, names: list[str]) -> tuple[Path, Path]:
    """Return the certificate and the key in `folder`; both are made if they do not fit."""
    certificate, key = folder / "certificate.pem", folder / "key.pem"
    if certificate.is_file() and key.is_file() and _fits(certificate, names):
        return certificate, key
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    private = ec.generate_private_key(ec.SECP256R1())
    subject = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "sitegen gateway")])
    now = datetime.datetime.now(datetime.UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(subject)
        .public_key(private.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - datetime.timedelta(days=1))
        .not_valid_after(now + datetime.timedelta(days=DAYS))
        .add_extension(x509.SubjectAlternativeName([_general(n) for n in names]), critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
        .sign(private, hashes.SHA256())
    )
    text = private.private_bytes(
        serialization.Encoding.PEM,
        serialization.PrivateFormat.PKCS8,
        serialization.NoEncryption(),
    )
    key.unlink(missing_ok=True)
    with os.fdopen(os.open(key, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as out:
        out.write(text)
    certificate.write_bytes(made.public_bytes(serialization.Encoding.PEM))
    return certificate, key


def _general(name: str) -> x509.GeneralName:
    try:
        return x509.IPAddress(ipaddress.ip_address(name))
    except ValueError:
        return x509.DNSName(name)


def _fits(certificate: Path, names: list[str]) -> bool:
    try:
        found = x509.load_pem_x509_certificate(certificate.read_bytes())
        given = found.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except (ValueError, x509.ExtensionNotFound):
        return False
    left = found.not_valid_after_utc - datetime.datetime.now(datetime.UTC)
    return left.days >= RENEW and all(_general(name) in given for name in names)
