"""The library's messages name settings and inputs by setting("...") and input("..."), never by an option or an
argument of the command line; and the program has an option or an argument for each of them.
"""

import pathlib
import re
import unittest

from thiessen import ProgramTest

SOURCES = pathlib.Path(__file__).resolve().parents[2] / "src"
COMMANDS = re.compile(r"^  ([a-z]+)  ", re.MULTILINE)
# A comment, a separator of digits, a raw literal, a literal, a character: what begins first is it.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|(?<=[0-9a-fA-F])\'(?=[0-9a-fA-F])|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'
                   r'|(?P<literal>"(?:\\.|[^"\\\n])*")|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
SETTING = re.compile(r'(?:\bsetting\(\s*|_setting = )"(\w+)"')
INPUT = re.compile(r'\binput\(\s*"(\w+)"')


def literals(text):
    """(line, literal) of every string literal."""
    for token in TOKEN.finditer(text):
        if token["literal"] or token["mark"] is not None:
            yield text.count("\n", 0, token.start()) + 1, token[0]


def sources():
    """The library's. The module for Python stands above the program's options, whose names it turns into keywords."""
    return {path: path.read_text(encoding="utf-8") for path in sorted(SOURCES.rglob("*.*"))
            if path.suffix in (".h", ".cpp") and path.relative_to(SOURCES).parts[0] != "python"}


class NamesInMessages(ProgramTest):
    def help_of_all(self):
        commands = COMMANDS.findall(self.output("--help"))
        self.assertIn("weights", commands)
        return "\n".join(self.output(command, "--help") for command in commands)

    def test_literals_are_told_from_all_else(self):
        text = "a = 1'000; // \"--x\"\nb = '\"'; c = \"--d \\\"\"; /* \"\n\" */ e = R\"(--f \")\";"
        self.assertEqual(list(literals(text)), [(2, '"--d \\""'), (3, 'R"(--f ")"')])

    def test_no_literal_of_the_library_holds_an_option_or_an_argument(self):
        arguments = re.findall(r"^  ([A-Z]+) ", self.help_of_all(), re.MULTILINE)
        self.assertIn("STATIONS", arguments)
        forbidden = re.compile(OPTION.pattern + "|" + "|".join(rf"\b{name}\b" for name in set(arguments)))
        found = [f"{path.relative_to(SOURCES)}:{line}: {literal}" for path, text in sources().items()
                 for line, literal in literals(text) if forbidden.search(literal)]
        self.assertEqual(found, [], "a message names a setting by setting(\"time_field\"), a file by input(\"stations\")")

    def test_the_program_has_what_the_library_names(self):
        text, shown = "\n".join(sources().values()), self.help_of_all()
        settings, inputs = set(SETTING.findall(text)), set(INPUT.findall(text))
        self.assertGreater(len(settings), 15)
        options = set(re.findall(r"(?<![\w-])--([a-z][a-z-]*)", shown))
        self.assertEqual({name for name in settings if name.replace("_", "-") not in options}, set())
        self.assertEqual({name for name in inputs if not re.search(rf"^  {name.upper()} ", shown, re.MULTILINE)}, set())


if __name__ == "__main__":
    unittest.main()
