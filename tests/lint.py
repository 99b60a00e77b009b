#!/usr/bin/env -S python3 -B
"""Runs clang-tidy on the sources of src/ and cli/: tests/lint.py BUILD-FOLDER

A source is looked at again when it, a header of ours that it reaches, its compiler's options, .clang-tidy,
clang-tidy or this script changed. Most of the work is what all sources share, the standard library's headers: so
sources are joined and looked at together. Where they do not go together, or a header is at fault, halves are.
"""

import bisect
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from batches import CLONE, Source, batches

MOST_AT_ONCE = 32
# What judges: its checks, its version and this script. A change of one of them makes all stamps old.
JUDGE = ((CLONE / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes()
         + (CLONE / "tests/batches.py").read_bytes()
         + subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout)


class CompiledSource(Source):
    def __init__(self, path, command, stamps):
        super().__init__(path)
        words = shlex.split(command["command"])
        self.directory = command["directory"]
        named = {index + skip for index, word in enumerate(words) if word in ("-o", "-c", "-MF", "-MT") for skip in (0, 1)}
        first = next(index for index, word in enumerate(words) if word.startswith("-"))
        kept = [word.replace("-Wno-shadow", "-Wshadow") for index, word in enumerate(words)
                if index >= first and index not in named and word != "-MD"]
        # What follows -isystem is one option with it.
        self.options = "\0".join(kept).replace("-isystem\0", "-isystem").split("\0")
        digest = hashlib.sha256(JUDGE + command["command"].encode())
        for name, content in sorted(self.texts.items()):
            digest.update(f"{name} {len(content)} ".encode() + content)
        self.stamp = stamps / digest.hexdigest()[:32]


def sources(build, stamps):
    entries = json.loads((build / "compile_commands.json").read_text())
    # Some sources are also compiled for a fuzzer: the first command is their own room's.
    alone = {os.path.realpath(entry["file"]): entry for entry in reversed(entries)}
    # A source that is compiled joined is looked at with its room's options.
    joined = {found[1]: entry for entry in entries
              if (found := re.search(r"/thiessen_(\w+)\.dir/Unity/", entry["command"]))}
    paths = [path for folder in ("src", "cli") for path in sorted((CLONE / folder).rglob("*.cpp"))]
    # The module for Python is looked at where it is built.
    if not any("/src/python/" in path for path in alone):
        paths = [path for path in paths if path.relative_to(CLONE).parts[1] != "python"]

    def command(path):
        if str(path) in alone:
            return alone[str(path)]
        parts = path.relative_to(CLONE).parts[:-1]
        names = ["cli"] if parts[0] == "cli" else ["_".join(parts[1:count]) for count in range(len(parts), 1, -1)]
        for name in names:
            if name in joined:
                return joined[name]
        return sys.exit(f"lint.py: error: the build does not know {path}: build first")

    return [CompiledSource(path, command(path), stamps) for path in paths]


def look(path, batch):
    options = list(dict.fromkeys(option for source in batch for option in source.options))
    ran = subprocess.run(["clang-tidy", "--quiet", f"--config-file={CLONE}/.clang-tidy", path, "--", *options],
                         cwd=batch[0].directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return ran.returncode == 0, re.sub(r"^\d+ warnings?( and \d+ errors?)? generated\.\n", "", ran.stdout, flags=re.MULTILINE)


def joined_text(batch):
    """The sources as one text, and the first line of each in it."""
    text, firsts = "", []
    for source in batch:
        firsts.append(text.count("\n") + 1)
        text += source.path.read_text()
    return text, firsts


def at_fault(batch, told):
    """The sources that hold all of what is wrong; none where a header does, or where the compiler complains: that
    may be of names of sources that do not go together."""
    errors = [line for line in told.splitlines() if ": error: " in line]
    named = [source for source in batch if any(line.startswith(f"{source.path}:") for line in errors)]
    known = all(any(line.startswith(f"{source.path}:") for source in named) for line in errors)
    return named if known and "clang-diagnostic-" not in told else []


def lint(batch, stamps):
    """What is wrong with these sources; stamps those with which nothing is."""
    joined = stamps / f"{batch[0].stamp.name}.cpp"
    text, firsts = joined_text(batch)
    joined.write_text(text)
    good, told = look(joined, batch)
    joined.unlink()

    def place(found):
        index = bisect.bisect(firsts, int(found[1])) - 1
        return f"{batch[index].path}:{int(found[1]) - firsts[index] + 1}:"

    told = re.sub(rf"{re.escape(str(joined))}:(\d+):", place, told)
    faulty = [] if good else at_fault(batch, told) or batch
    if len(faulty) == len(batch) > 1:
        half = len(batch) // 2
        return lint(batch[:half], stamps) + lint(batch[half:], stamps)
    for source in batch:
        if source not in faulty:
            source.stamp.touch()
    return "" if good else told or f"{batch[0].path}: clang-tidy failed\n"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    stamps = build / "lint"
    stamps.mkdir(parents=True, exist_ok=True)
    changed = [source for source in sources(build, stamps) if not source.stamp.exists()]
    together = batches(changed, MOST_AT_ONCE)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        told = list(pool.map(lambda batch: lint(batch, stamps), together))
    print("".join(told), end="")
    print(f"{len(changed)} sources looked at, in {len(told)} batches")
    return 1 if any(told) else 0


if __name__ == "__main__":
    sys.exit(main())
