#!/usr/bin/env -S python3 -B
"""Joins the sources of tests into one file, which compiles several times faster than they do one by one.

    joined.py JOINED SOURCE...

Each source's unnamed namespace gets the source's name, so that what is in one does not meet what is in
another; compilers speak of the sources' own lines.
"""

import pathlib
import re
import sys

joined, *sources = map(pathlib.Path, sys.argv[1:])
parts = []
for source in sources:
    name = re.sub(r"\W", "_", f"{source.parent.name}_{source.stem}")
    text = re.sub(r"^namespace \{$", f"namespace {name} {{", source.read_text(encoding="utf-8"), flags=re.MULTILINE)
    parts.append(f'#line 1 "{source}"\n{text}')
joined.write_text("".join(parts), encoding="utf-8")
