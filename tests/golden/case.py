"""The form of a golden case: see README.md in this folder."""

import dataclasses
import pathlib
import re

ANYTHING = object()  # a file that must be written, whatever it holds
LARGEST_KEPT = 20_000  # bytes of an output that a case holds by itself
HEADING = re.compile(r"^-- (?P<part>[a-z]+)(?: (?P<name>[^\s(].*?))?(?: \((?P<form>escaped|any)\))? --$")
ESCAPE = re.compile(r"\\(x[0-9a-f]{2}|[nrt\\])")


@dataclasses.dataclass
class Outcome:
    status: int = 0
    stdout: bytes = b""
    stderr: bytes = b""
    outputs: dict = dataclasses.field(default_factory=dict)
    gone: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Case:
    path: pathlib.Path
    title: str
    question: str  # everything before the expected part, as it stands
    command: str
    make: str
    inputs: dict
    expected: Outcome | None


def unescape(text):
    """Bytes from text in which \\xff, \\n, \\r, \\t and \\\\ stand for one byte; its own line ends count for nothing."""
    def byte(match):
        code = match[1]
        if code[0] != "x":
            return {"n": "\n", "r": "\r", "t": "\t", "\\": "\\"}[code]
        value = int(code[1:], 16)
        return chr(value if value < 128 else 0xDC00 + value)

    return ESCAPE.sub(byte, text.replace("\n", "")).encode("utf-8", "surrogateescape")


def escape(content):
    text = content.decode("utf-8", "surrogateescape").replace("\\", "\\\\")
    text = text.replace("\n", "\\n\n").replace("\r", "\\r").replace("\t", "\\t")
    return "".join(shown(c) for c in text)


def shown(char):
    code = ord(char)
    if 0xDC80 <= code <= 0xDCFF:
        return f"\\x{code - 0xDC00:02x}"
    return f"\\x{code:02x}" if (code < 32 and char != "\n") or code == 127 else char


def plain(content):
    """Whether content can stand in a case as it is."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        return False
    ends_well = not text or text.endswith("\n")
    return ends_well and not re.search(r"[\x00-\x09\x0b-\x1f\x7f]|^-- ", text, re.MULTILINE)


def sections(text):
    """(part, name, form, content, where it begins) of each section."""
    heading, content, start, at = None, [], 0, 0
    for line in text.split("\n"):
        match = HEADING.match(line)
        if match:
            if heading:
                yield *heading, "".join(content), start
            heading, content, start = match.group("part", "name", "form"), [], at
        elif heading:
            content.append(line + "\n")
        at += len(line) + 1
    if heading:
        yield *heading, "".join(content), start


def read(path):
    text = path.read_text(encoding="utf-8").removesuffix("\n")
    case = Case(path, text.splitlines()[0], text, "", "", {}, None)
    for part, name, form, content, start in sections(text):
        data = ANYTHING if form == "any" else unescape(content) if form else content.encode()
        if part == "command":
            case.command = content
        elif part == "make":
            case.make = content
        elif part == "in":
            case.inputs[name] = data
        elif part == "status":
            case.question = text[:start]
            case.expected = Outcome(status=int(content))
        elif part in ("stdout", "stderr") and case.expected:
            setattr(case.expected, part, data)
        elif part == "out" and case.expected:
            case.expected.outputs[name] = data
        else:
            raise SystemExit(f"{path}: no case has a section '{part}' there")
    if not case.command:
        raise SystemExit(f"{path}: no command")
    return case


def section(heading, content):
    if plain(content):
        return f"-- {heading} --\n{content.decode()}"
    return f"-- {heading} (escaped) --\n{escape(content).rstrip(chr(10))}\n"


def written(case, outcome):
    """An outcome as the expected part of a case; outputs too large or binary count for being there."""
    text = f"-- status --\n{outcome.status}\n"
    text += section("stdout", outcome.stdout) + section("stderr", outcome.stderr)
    for name, content in outcome.outputs.items():
        asked = case.expected.outputs.get(name) if case.expected else None
        if asked is ANYTHING or len(content) > LARGEST_KEPT or b"\0" in content:
            text += f"-- out {name} (any) --\n"
        else:
            text += section(f"out {name}", content)
    if outcome.gone:
        raise SystemExit(f"{case.path}: the command removed {', '.join(outcome.gone)}")
    return text


def whole(case, outcome):
    return case.question.rstrip("\n") + "\n" + written(case, outcome)
