#!/usr/bin/env -S python3 -B
"""Runs clang-tidy on the sources of src/ and cli/: tests/lint.py BUILD-FOLDER

A source is looked at again when it, a header of ours that it reaches, its compiler's options, .clang-tidy,
clang-tidy or this script changed. Most of the work is what all sources share, the standard library's headers: so a room's sources are
joined and looked at together. Where something is found, or they do not go together, halves are, down to a
source alone: what is printed is about one source.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

CLONE = pathlib.Path(__file__).resolve().parents[1]
MOST_AT_ONCE = 16
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
# What judges: its checks, its version and this script. A change of one of them makes all stamps old.
JUDGE = ((CLONE / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes()
         + subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout)
UNNAMED = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
DECLARED = re.compile(r"^(?:\[\[\w+\]\] )?[A-Za-z].*?(\w+)(?:\(|\{| =|;| \{| :|\[)", re.MULTILINE)
INSTANTIATED = re.compile(r"^ *template [^<]", re.MULTILINE)
MACRO = re.compile(r"^#define (\w+)", re.MULTILINE)


def reached(path, seen):
    """{file: content} of a source and the headers of ours that it reaches."""
    if path not in seen:
        seen[path] = path.read_bytes()
        for name in map(os.fsdecode, INCLUDE.findall(seen[path])):
            for folder in (path.parent, CLONE / "src", CLONE):
                if (folder / name).is_file():
                    reached(pathlib.Path(os.path.normpath(folder / name)), seen)
                    break
    return seen


class Source:
    def __init__(self, path, command, stamps):
        self.path, self.folder = path, path.parent
        words = shlex.split(command["command"])
        self.directory = command["directory"]
        named = {index + skip for index, word in enumerate(words) if word in ("-o", "-c", "-MF", "-MT") for skip in (0, 1)}
        first = next(index for index, word in enumerate(words) if word.startswith("-"))
        self.options = [word for index, word in enumerate(words)
                        if index >= first and index not in named and word != "-MD"]
        texts = reached(path, {})
        # What comes with <filesystem> holds a name of ours, std::quoted: such sources come last.
        self.last = any(b"<filesystem>" in text for text in texts.values())
        own = texts[path].decode()
        self.names = {name for block in UNNAMED.findall(own) for name in DECLARED.findall(block)}
        self.names.update(MACRO.findall(own))
        # What is instantiated by name may not be instantiated by name again.
        if INSTANTIATED.search(own):
            self.names.add("template")
        self.seen = {name for text in texts.values() for name in DECLARED.findall(text.decode())}
        digest = hashlib.sha256(JUDGE + command["command"].encode())
        for name, content in sorted(texts.items()):
            digest.update(f"{name} {len(content)} ".encode() + content)
        self.stamp = stamps / digest.hexdigest()[:32]

    def goes_with(self, other):
        """Whether no name of an unnamed namespace of one is known to the other."""
        return self.names.isdisjoint(other.names | other.seen) and other.names.isdisjoint(self.seen)


def sources(build, stamps):
    # Some sources are also compiled for a fuzzer: the first command is their own room's.
    commands = {os.path.realpath(entry["file"]): entry
                for entry in reversed(json.loads((build / "compile_commands.json").read_text()))}
    paths = [path for folder in ("src", "cli") for path in sorted((CLONE / folder).rglob("*.cpp"))]
    strangers = [path for path in paths if str(path) not in commands]
    if strangers:
        sys.exit(f"lint.py: error: the build does not know {strangers[0]}: build first")
    return [Source(path, commands[str(path)], stamps) for path in paths]


def batches(changed):
    """Sources that go together: compiled alike, no name of an unnamed namespace known to another."""
    found = []
    for source in sorted(changed, key=lambda source: source.last):
        for batch in found:
            if (len(batch) < MOST_AT_ONCE and batch[0].options == source.options
                    and all(map(source.goes_with, batch))):
                batch.append(source)
                break
        else:
            found.append([source])
    return sorted(found, key=len, reverse=True)


def look(path, source):
    ran = subprocess.run(["clang-tidy", "--quiet", f"--config-file={CLONE}/.clang-tidy", path, "--", *source.options],
                         cwd=source.directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return ran.returncode == 0, re.sub(r"^\d+ warnings?( and \d+ errors?)? generated\.\n", "", ran.stdout, flags=re.MULTILINE)


def lint(batch, stamps):
    """What is wrong with these sources; stamps those with which nothing is."""
    if len(batch) == 1:
        good, told = look(batch[0].path, batch[0])
    else:
        joined = stamps / f"{batch[0].stamp.name}.cpp"
        joined.write_text("".join(source.path.read_text() for source in batch))
        good, told = look(joined, batch[0])
        joined.unlink()
    if good:
        for source in batch:
            source.stamp.touch()
        return ""
    if len(batch) == 1:
        return told or f"{batch[0].path}: clang-tidy failed\n"
    half = len(batch) // 2
    return lint(batch[:half], stamps) + lint(batch[half:], stamps)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    stamps = build / "lint"
    stamps.mkdir(parents=True, exist_ok=True)
    changed = [source for source in sources(build, stamps) if not source.stamp.exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        told = list(pool.map(lambda batch: lint(batch, stamps), batches(changed)))
    print("".join(told), end="")
    print(f"{len(changed)} sources looked at, in {len(told)} batches")
    return 1 if any(told) else 0


if __name__ == "__main__":
    sys.exit(main())
