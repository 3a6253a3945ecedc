"""Write the Content-Security-Policy of a page: it allows what the page needs and nothing else."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Sequence

from sitegen.site.engine import ENGINE

# Browsers start no worker in a page opened as a file, so the page says how to open it.
FILE_NOTE = (
    'if (location.protocol === "file:") document.getElementById("file-note").hidden = false;'
)
# Browsers differ in the build of a program that they run, and only a script can tell which. This
# script requests the right one before anything else is loaded, and names its choice for scripts
# that are not modules of the runtime.
CHOICE = (
    f"{{ {ENGINE} document.documentElement.dataset.engine = engine; "
    'for (const each of document.querySelectorAll("template[data-engine]")) '
    "if (each.dataset.engine === engine) each.before(each.content); }"
)


def policy(
    text: str,
    *,
    live: bool,
    fonts: bool,
    offline: bool,
    gltf: bool = False,
    frames: bool = False,
    ros2wasm: bool = False,
    cells: bool = False,
    gateways: Sequence[str] = (),
) -> str:
    """Return the policy of a page whose HTML is `text`.

    A `live` page runs nodes; an `offline` page works without a network; widgets show `frames` of
    the site. A `gltf` file contains its buffers and textures as `data:`, or gives them to the
    browser as `blob:`. `gateways` are the addresses that it may join.

    Workers of nodes are `blob:`, since those obey the policy of the page, and files do not. What
    their scripts import counts as parts of workers, too. Nodes of `ros2wasm` evaluate text, as
    Embind does. The workers of `cells` in JavaScript import these as `blob:`.
    """
    inside = " blob:" if gltf else ""
    rules = ["default-src 'none'", "style-src 'self'", f"img-src 'self' data:{inside}"]
    if live:
        hashes = " ".join(f"'{_hash(script)}'" for script in (FILE_NOTE, CHOICE))
        evaluated = "'unsafe-eval'" if ros2wasm else "'wasm-unsafe-eval'"
        blobs = " blob:" if cells else ""
        rules.append(f"script-src 'self'{blobs} {evaluated} {hashes}")
        connected = " data: blob:" if gltf else ""
        connected += "".join(f" {address}" for address in gateways if address != "self")
        rules.append(f"connect-src 'self'{connected}")
    else:
        # The scripts of the theme: the colour switch, the search and its index.
        rules += ["script-src 'self'", "connect-src 'self'"]
    if live or offline:
        rules.append("worker-src 'self' blob:" if live else "worker-src 'self'")
    if offline:
        rules.append("manifest-src 'self'")
    if fonts:
        rules.append("font-src 'self'")
    if "<video" in text or "<audio" in text:
        rules.append("media-src 'self'")
    if "<iframe" in text or frames:
        rules.append("frame-src 'self'")
    return "; ".join([*rules, "base-uri 'none'", "form-action 'none'"])


def _hash(script: str) -> str:
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest())
    return f"sha256-{digest.decode()}"
