"""Runs the rows of the list: see tests/torture.sh."""

import argparse
import pathlib
import re
import sys
import tempfile
import time

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "faults"))

import harness
import rows_of_points  # noqa: F401 (each notes its rows)
import rows_of_texts  # noqa: F401
import rows_of_files  # noqa: F401
import rows_of_machines  # noqa: F401

LAST = 116
BUILD = pathlib.Path(__file__).resolve().parents[2]


def wanted(names):
    if not names:
        return range(1, LAST + 1)
    found = []
    for name in names:
        numbers = [int(number) for number in re.findall(r"\d+", name)]
        found += range(numbers[0], numbers[-1] + 1)
    return found


def outcome(number, options):
    about, function = harness.ROWS[number]
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="thiessen-torture-") as scratch:
        case = harness.Case(options, pathlib.Path(scratch))
        try:
            function(case)
        except harness.NotTried as lack:
            return "not tried", f"{about}: {lack}", begin
        except Exception as error:  # pylint: disable=broad-except
            case.fault(f"{type(error).__name__}: {error}")
    if case.faults:
        return "FAILS", f"{about}: " + "; ".join(case.faults[:4]), begin
    return "holds", about, begin


def main():
    parser = argparse.ArgumentParser(prog="tests/torture.sh")
    parser.add_argument("--program", default=BUILD / "build/cli/thiessen", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--shim", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--list", action="store_true", help="say what the rows are, and run none")
    parser.add_argument("rows", nargs="*", metavar="ROW")
    options = parser.parse_args()
    if options.list:
        print("\n".join(f"T{number:03} {harness.ROWS[number][0]}" for number in wanted(options.rows)))
        return 0
    if not pathlib.Path(options.program).exists():
        sys.exit(f"{options.program} is not there: build it, or name it by --program")
    count = {"holds": 0, "FAILS": 0, "not tried": 0}
    for number in wanted(options.rows):
        how, text, begin = outcome(number, options)
        count[how] += 1
        print(f"T{number:03} {how:9} {text} ({time.monotonic() - begin:.1f} s)", flush=True)
    print(", ".join(f"{n} {how}" for how, n in count.items()))
    return 1 if count["FAILS"] else 0


if __name__ == "__main__":
    sys.exit(main())
