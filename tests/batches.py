#!/usr/bin/env -S python3 -B
"""Parts sources into batches that may be compiled as one file: what all of them share, the standard library's
headers, is most of the work, and is then done once.

    batches.py SIZE SOURCE...     prints the batches, a line each, their sources parted by semicolons

No name of an unnamed namespace of one source is known to another of its batch. Order: that of the sources
given, but those that reach <filesystem> come last.
"""

import os
import pathlib
import re
import sys

CLONE = pathlib.Path(__file__).resolve().parents[1]
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
DECLARED = re.compile(r"^(?:\[\[\w+\]\] )?[A-Za-z].*?(\w+)(?:\(|\{| =|;| \{| :|\[)", re.MULTILINE)
INSTANTIATED = re.compile(r"^ *template [^<]", re.MULTILINE)
MACRO = re.compile(r"^#define (\w+)", re.MULTILINE)

contents = {}  # by file: its bytes, the files of ours that it includes, the names that it declares


def read(path):
    if path not in contents:
        text = path.read_bytes()
        included = []
        for name in map(os.fsdecode, INCLUDE.findall(text)):
            for folder in (path.parent, CLONE / "src", CLONE, CLONE / "tests"):
                if (folder / name).is_file():
                    included.append(pathlib.Path(os.path.normpath(folder / name)))
                    break
        contents[path] = text, included, set(DECLARED.findall(text.decode()))
    return contents[path]


def reached(path, seen=None):
    """{file: content} of a source and the headers of ours that it reaches."""
    seen = {} if seen is None else seen
    if path not in seen:
        seen[path], included, _ = read(path)
        for header in included:
            reached(header, seen)
    return seen


class Source:
    def __init__(self, path):
        self.path = path
        self.texts = reached(path)
        # What comes with <filesystem> holds a name of ours, std::quoted.
        self.last = any(b"<filesystem>" in text for text in self.texts.values())
        # What reaches the drawing by OpenCV stays apart: tests link what does not, without OpenCV.
        self.draws = any("map/opencv/" in str(file) for file in self.texts)
        own = self.texts[path].decode()
        self.names = {name for block in UNNAMED.findall(own) for name in DECLARED.findall(block)}
        self.names.update(MACRO.findall(own))
        # What is instantiated by name, be it a member of what another source does, may not be so again.
        if INSTANTIATED.search(own):
            self.names.add("template")
        self.seen = set().union(*(read(reached_path)[2] for reached_path in self.texts))

    def goes_with(self, other):
        """Whether no name of an unnamed namespace of one is known to the other, and both or neither draw."""
        return self.draws == other.draws and self.names.isdisjoint(other.names | other.seen) and other.names.isdisjoint(self.seen)


def batches(sources, size):
    """Lists of sources that go together, the longest first."""
    found = []
    for source in sorted(sources, key=lambda source: source.last):
        for batch in found:
            if len(batch) < size and all(map(source.goes_with, batch)):
                batch.append(source)
                break
        else:
            found.append([source])
    return sorted(found, key=len, reverse=True)


if __name__ == "__main__":
    for parts in batches([Source(pathlib.Path(name)) for name in sys.argv[2:]], int(sys.argv[1])):
        print(";".join(str(source.path) for source in parts))
