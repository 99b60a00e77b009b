#!/usr/bin/env -S python3 -B
"""Whether every file includes what it names: tests/includes.py

Most sources are compiled joined, where one would not be missed whose include another has. So this looks at each
file alone: what it names of the standard library or of ours must stand in it or in a header of ours that it reaches.
"""

import pathlib
import re
import sys

from batches import CLONE, reached

STANDARD = {  # by header: the names of std:: that it holds
    "algorithm": """adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal fill find
        find_if for_each inplace_merge is_sorted iter_swap lower_bound make_heap max_element min_element minmax
        minmax_element mismatch next_permutation none_of nth_element partition pop_heap push_heap remove_if replace
        reverse rotate sample set_difference set_intersection shuffle sort sort_heap stable_partition stable_sort
        transform unique upper_bound max min""",
    "array": "array", "atomic": "atomic memory_order_relaxed memory_order_acquire memory_order_acq_rel",
    "bit": "bit_cast bit_ceil bit_width countl_zero countr_one countr_zero endian", "charconv": "from_chars to_chars",
    "chrono": "chrono", "clocale": "setlocale", "compare": "strong_ordering", "csignal": "raise signal",
    "cmath": """acos asin asinh atan atan2 atanh cbrt ceil copysign cos exp expm1 floor fmod hypot isfinite isinf isnan
        ldexp llround log log10 log2 lround nan nextafter pow remainder round signbit sin sinh sqrt tan tanh""",
    "cstdint": "uint8_t uint16_t uint32_t uint64_t int32_t int64_t uintptr_t", "cstdlib": "getenv system strtod free malloc",
    "cstdio": "printf snprintf fputc fflush rename", "cstring": "memcpy memmove strerror strlen strspn",
    "cwchar": "mbrtowc mbstate_t", "deque": "deque", "exception": "exception_ptr current_exception rethrow_exception",
    "filesystem": "filesystem", "fstream": "ofstream ifstream", "functional": "function hash", "future": "async launch",
    "iostream": "cout cerr", "initializer_list": "initializer_list",
    "iterator": "back_inserter next prev ssize istreambuf_iterator", "limits": "numeric_limits", "list": "list",
    "map": "map", "memory": "unique_ptr shared_ptr make_unique make_shared make_unique_for_overwrite",
    "mutex": "mutex lock_guard once_flag call_once", "new": "bad_alloc nothrow_t", "numbers": "numbers",
    "numeric": "accumulate iota", "optional": "optional nullopt",
    "random": "mt19937 mt19937_64 random_device uniform_real_distribution uniform_int_distribution normal_distribution",
    "set": "set multiset", "span": "span", "sstream": "istringstream ostringstream",
    "stdexcept": "logic_error runtime_error length_error", "string": "string to_string u32string getline stoi",
    "string_view": "string_view u32string_view", "system_error": "error_code errc system_error generic_category",
    "thread": "thread this_thread", "tuple": "tuple tie apply",
    "type_traits": "integral_constant is_convertible_v conditional_t type_identity", "unordered_map": "unordered_map",
    "unordered_set": "unordered_set", "utility": "move pair exchange swap as_const", "vector": "vector",
}
# A further header that holds the name as well.
ALSO = {"abs": ["cmath", "cstdlib"], "string_view": ["string"], "swap": ["algorithm", "vector", "string", "array"],
        "size_t": ["cstddef", "cstdint", "cstdlib", "cstring", "vector", "string", "string_view", "array", "span"],
        "move": ["algorithm", "memory", "vector", "string"], "pair": ["map", "unordered_map"], "hash": ["string"],
        "initializer_list": ["vector", "string"], "next": ["vector", "string", "map"], "prev": ["vector", "map"],
        "getline": ["iostream", "sstream", "fstream"], "uint32_t": ["charconv"], "bad_alloc": ["memory"],
        "back_inserter": ["vector", "string", "map"], "thread": ["future"], "ssize": ["vector", "span", "string", "array"],
        "errc": ["charconv"], "min": [], "int64_t": ["chrono"]}
HEADERS = {}
for its_header, its_names in STANDARD.items():
    for its_name in its_names.split():
        HEADERS.setdefault(its_name, []).append(its_header)
for its_name, its_headers in ALSO.items():
    HEADERS.setdefault(its_name, []).extend(its_headers)

INCLUDED = re.compile(r"^#include <([\w/.+]+)>", re.MULTILINE)
SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'', re.DOTALL)
SUITE = re.compile(r"^(?:TYPED_)?TEST\w*\([^)]*\)", re.MULTILINE)
STD = re.compile(r"\bstd::(\w+)")
TYPE = re.compile(r"^ *(?:class|struct|enum class|enum|concept|using) (?:\[\[\w+\]\] )?([A-Z]\w+)\b(?! *;)", re.MULTILINE)
KNOWN = re.compile(r"\b(?:class|struct|enum class|enum|typename|concept|using|int|size_t|auto|bool|\w+ \w+|class\.\.\.) (?:\w+::)?([A-Z]\w+)\b")
FUNCTION = re.compile(r"^(?:\[\[\w+\]\] )?[A-Za-z][\w:<>*&, ]* [*&]?([a-z]\w+)\(", re.MULTILINE)
CALLED = re.compile(r"(?<![\w.:>])(?:thiessen::)?([a-z]\w+)\(")
OWN = re.compile(r"\b(?!return|throw|else|case)\w+[>*&]* [*&]?([a-z]\w+)(?=\(|\{| =|;|,|\))")
WORD = re.compile(r"(?<![\w:])(?:thiessen::)?([A-Z]\w+)\b")


def code(path):
    return SUITE.sub("", SKIPPED.sub(lambda found: '""', path.read_text(encoding="utf-8")))


def main():
    files = [path for folder in ("src", "cli", "tests") for path in sorted((CLONE / folder).rglob("*"))
             if path.suffix in (".cpp", ".h")]
    texts = {path: code(path) for path in files}
    declared = {}  # by type of ours: the headers that declare it
    for path in files:
        if path.suffix == ".h":
            for name in TYPE.findall(texts[path]):
                declared.setdefault(name, set()).add(path)
    functions = {}  # by function of ours: the headers that declare it
    for path in files:
        if path.suffix == ".h":
            for name in FUNCTION.findall(texts[path]):
                functions.setdefault(name, set()).add(path)
    faults = []
    for path in files:
        texts_reached = reached(path)
        standard = {name for text in texts_reached.values() for name in INCLUDED.findall(text.decode())}
        for name in sorted(set(STD.findall(texts[path]))):
            if name in HEADERS and not standard.intersection(HEADERS[name]):
                faults.append(f"{path.relative_to(CLONE)}: std::{name} wants <{HEADERS[name][0]}>")
        known = set(KNOWN.findall(texts[path]))
        for name in sorted(set(WORD.findall(texts[path])) - known):
            holders = declared.get(name, set())
            if holders and not holders.intersection(texts_reached):
                faults.append(f"{path.relative_to(CLONE)}: {name} is of {min(holders).relative_to(CLONE)}")
        other = b"".join(text for file, text in texts_reached.items() if file != path).decode()
        for name in sorted(set(CALLED.findall(texts[path])) - set(OWN.findall(texts[path]))):
            holders = functions.get(name, set())
            if holders and not holders.intersection(texts_reached) and not re.search(rf"\b{name}\(", other):
                faults.append(f"{path.relative_to(CLONE)}: {name}() is of {min(holders).relative_to(CLONE)}")
    print("\n".join(faults) if faults else f"{len(files)} files looked at")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
