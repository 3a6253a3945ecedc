"""Download files and check their hashes."""

from __future__ import annotations

import hashlib
import ipaddress
import time
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

# HTTP status codes of temporary errors.
PASSING = {408, 425, 429, 500, 502, 503, 504}
REDIRECTS = 5


class FetchError(Exception):
    """The download failed; the message says why and what to do."""


@dataclass(frozen=True)
class Patience:
    """Time limits in seconds: for connecting, for each read, and in total.

    After a temporary failure, the download is tried again, up to `tries` times, after a `pause`
    that doubles each time.
    """

    connection: float = 10
    bytes: float = 30
    total: float = 600
    tries: int = 4
    pause: float = 1


class _PassingError(Exception):
    """A temporary failure: another attempt may succeed."""


def allowed(url: str) -> bool:
    """Return whether `url` is https, or http on this computer."""
    try:
        parts = urlsplit(url)
        host = parts.hostname or ""
        if parts.scheme == "http":
            return host == "localhost" or ipaddress.ip_address(host).is_loopback
        return parts.scheme == "https" and bool(host)
    except ValueError:
        return False


def fetch(
    url: str, sha256: str, to: Path, *, largest: int, patience: Patience | None = None
) -> None:
    """Download the file at `url` to `to`; redirections must be `allowed`, too.

    Raises: FetchError if the download fails, is larger than `largest` bytes, or has another hash.
    """
    patience = patience or Patience()
    end = time.monotonic() + patience.total
    for attempt in range(patience.tries):
        try:
            found = _download(url, to, largest, patience, end)
            break
        except _PassingError as error:
            pause = patience.pause * 2**attempt
            if attempt + 1 == patience.tries or time.monotonic() + pause > end:
                times = f"{attempt + 1} time{'s'[: attempt != 0]}"
                raise FetchError(f"{url}: {error} (tried {times}); try again later") from None
            time.sleep(pause)
    if found != sha256:
        raise FetchError(mismatch(url, found))


def mismatch(name: str, found: str) -> str:
    """Return the message about a file whose hash `found` is not the expected one."""
    return f"{name} does not have the expected hash; if you trust it, write 'sha256: {found}'"


def _download(url: str, to: Path, largest: int, patience: Patience, end: float) -> str:
    # Most builds download nothing, and this import takes longer than the rest of such a build.
    import httpx

    def check(request: httpx.Request) -> None:
        if not allowed(str(request.url)):
            raise FetchError(f"{url} leads to {request.url}; only https addresses are followed")

    limits = httpx.Timeout(patience.bytes, connect=patience.connection)
    own = urlsplit(url).scheme == "http"
    client = httpx.Client(
        timeout=limits,
        follow_redirects=True,
        max_redirects=REDIRECTS,
        event_hooks={"request": [check]},
        headers={"Accept-Encoding": "identity"},
        # A proxy cannot reach this computer's own addresses.
        trust_env=not own,
    )
    too_large = f"{url} has more than {largest:,} bytes; check the address"
    digest, count = hashlib.sha256(), 0
    try:
        with client, client.stream("GET", url) as response, to.open("wb") as file:
            if response.status_code in PASSING:
                raise _PassingError(_status(response.status_code, response.reason_phrase))
            if response.status_code != 200:
                status = _status(response.status_code, response.reason_phrase)
                raise FetchError(f"{url}: {status}; check the address")
            for chunk in response.iter_bytes():
                count += len(chunk)
                if count > largest:
                    raise FetchError(too_large)
                if time.monotonic() > end:
                    raise FetchError(f"{url}: too slow, {count:,} bytes in {patience.total:g} s")
                digest.update(chunk)
                file.write(chunk)
    except httpx.TimeoutException:
        raise _PassingError("the server did not answer in time") from None
    except httpx.TooManyRedirects:
        raise FetchError(
            f"{url} redirects more than {REDIRECTS} times; check the address"
        ) from None
    except httpx.HTTPError as error:
        raise _PassingError(str(error) or type(error).__name__) from None
    except httpx.InvalidURL as error:
        raise FetchError(f"{url}: {error}; check the address") from None
    return digest.hexdigest()


def _status(code: int, phrase: str) -> str:
    return f"the server answered {code} {phrase}".rstrip()
