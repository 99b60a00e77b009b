#!/usr/bin/env -S python3 -B
"""Whether a program has the defences that it is built with: hardened.py PROGRAM

It can lie anywhere in memory (PIE), what the loader writes is read-only before the program begins (RELRO with BIND_NOW),
no stack is executable, no segment is both written and executed, functions look after their stack, and the C library's
checks of lengths are called. Reads the file itself, as ELF has it; 77 where it is of another kind than ELF's 64 bits.
"""

import pathlib
import struct
import sys

PT_LOAD, PT_DYNAMIC, PT_GNU_STACK, PT_GNU_RELRO = 1, 2, 0x6474E551, 0x6474E552
DT_NULL, DT_STRTAB, DT_STRSZ, DT_FLAGS, DT_BIND_NOW, DT_FLAGS_1 = 0, 5, 10, 30, 24, 0x6FFFFFFB
EXECUTABLE, WRITABLE = 1, 2
PIE_TYPE, BIND_NOW_FLAG, NOW_FLAG_1, PIE_FLAG_1 = 3, 8, 1, 0x08000000


def segments_of(content):
    at, size, count = struct.unpack_from("<Q", content, 32)[0], *struct.unpack_from("<HH", content, 54)
    names = ("type", "flags", "offset", "address", "physical", "size", "memory", "align")
    return [dict(zip(names, struct.unpack_from("<IIQQQQQQ", content, at + i * size))) for i in range(count)]


def entries_of(content, dynamic):
    """The dynamic section: {tag: value}."""
    entries = {}
    for at in range(dynamic["offset"], dynamic["offset"] + dynamic["size"], 16):
        tag, value = struct.unpack_from("<QQ", content, at)
        if tag == DT_NULL:
            break
        entries[tag] = value
    return entries


def imported_names(content, segments, entries):
    """All names of the dynamic symbols."""
    at = next(s["offset"] + entries[DT_STRTAB] - s["address"] for s in segments
              if s["type"] == PT_LOAD and s["address"] <= entries[DT_STRTAB] < s["address"] + s["size"])
    return set(content[at:at + entries[DT_STRSZ]].decode("ascii", "replace").split("\0"))


def lacking(content):
    segments = segments_of(content)
    kinds = {segment["type"]: segment for segment in segments}
    entries = entries_of(content, kinds[PT_DYNAMIC])
    names = imported_names(content, segments, entries)
    is_pie = struct.unpack_from("<H", content, 16)[0] == PIE_TYPE and entries.get(DT_FLAGS_1, 0) & PIE_FLAG_1
    is_now = DT_BIND_NOW in entries or entries.get(DT_FLAGS, 0) & BIND_NOW_FLAG or entries.get(DT_FLAGS_1, 0) & NOW_FLAG_1
    has_both = any(s["type"] == PT_LOAD and s["flags"] & EXECUTABLE and s["flags"] & WRITABLE for s in segments)
    found = {
        "position-independent code": is_pie,
        "RELRO": PT_GNU_RELRO in kinds,
        "BIND_NOW": is_now,
        "a stack that is not executable": PT_GNU_STACK in kinds and not kinds[PT_GNU_STACK]["flags"] & EXECUTABLE,
        "segments that are written or executed, not both": not has_both,
        "guards of the stack (-fstack-protector-strong)": "__stack_chk_fail" in names,
        "the C library's checks of lengths (-D_FORTIFY_SOURCE)": any(
            name.endswith("_chk") and name.startswith("__") for name in names),
    }
    return [defence for defence, is_there in found.items() if not is_there]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    content = pathlib.Path(sys.argv[1]).read_bytes()
    if content[:6] != b"\x7fELF\x02\x01":
        print("not ELF of 64 bits: not tried")
        return 77
    for defence in lacking(content):
        print(f"{sys.argv[1]} lacks {defence}")
    return 1 if lacking(content) else 0


if __name__ == "__main__":
    sys.exit(main())
