"""A page as one file: styles, program and data in its own text."""

import base64
import hashlib
import html
import json
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

# All that a page may do: run its own program, in its own style. It can load nothing, from nowhere.
POLICY = (
    "default-src 'none'; script-src 'sha256-{program}'; style-src 'sha256-{style}'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'"
)
PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<link rel="icon" href="data:image/svg+xml;base64,{icon}">
<style>{style}</style>
</head>
<body class="bm-page">
<div id="bodymeasure"></div>
<noscript>This page shows a body in three dimensions and needs JavaScript.</noscript>
<script type="text/plain" id="licenses">{licenses}</script>
<script type="application/json" id="bodymeasure-data">{data}</script>
<script type="module">{program}</script>
</body>
</html>
"""


def page_of(title: str, data: Mapping[str, Any]) -> bytes:
    """Return the page that shows some data.

    Parameters
    ----------
    title : str
    data : mapping of str to object
        What JSON can hold.

    Returns
    -------
    bytes
        HTML that loads nothing else.
    """
    # What ends the elements must not occur in them.
    program = _static("viewer.js").replace("</script", "<\\/script").replace("<!--", "<\\!--")
    style = _static("viewer.css").replace("</style", "<\\/style")
    policy = POLICY.format(program=_digest(program), style=_digest(style))
    return PAGE.format(
        policy=html.escape(policy),
        title=html.escape(title),
        icon=base64.b64encode(_static("icon.svg").encode()).decode(),
        style=style,
        data=json.dumps(data, ensure_ascii=True).replace("<", "\\u003c"),
        licenses=_static("LICENSES.txt").replace("<", "&lt;"),
        program=program,
    ).encode()


def _static(name: str) -> str:
    return files("bodymeasure.viewer").joinpath("static", name).read_text("utf-8")


def _digest(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
