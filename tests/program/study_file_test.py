"""A study as a file: `--config`, and the study.toml that `run` writes."""

import tomllib
import unittest

from thiessen import SAMPLES, ProgramTest

TEXTBOOK = [SAMPLES / "textbook" / f"{name}.csv" for name in ("stations", "basin", "rainfall")]
HOSTILE = ["Storm #5", 'say "rain"', "it's", "a\\b", "two\nlines", "雨, [x] = y", '"""', "tab\there", "# no comment"]


class StudyFile(ProgramTest):
    def run_into(self, folder, *words):
        self.output("run", *words, "-o", folder, "-q")
        return self.folder / folder / "study.toml"

    def test_another_reader_of_toml_reads_it(self):
        file = self.run_into("out", *TEXTBOOK, "--metric", "planar", "--decimals", 2, "--mend", "--missing", "x", "--missing", "-1")
        with file.open("rb") as text:
            study = tomllib.load(text)
        self.assertEqual({name: study[name] for name in ("metric", "decimals", "mend", "missing")},
                         {"metric": "planar", "decimals": 2, "mend": True, "missing": ["x", "-1"]})
        self.assertEqual(sorted(study), ["basins", "decimals", "mend", "metric", "missing", "rainfall", "stations"])

    def test_it_repeats_the_run_to_the_byte_whatever_a_text_holds(self):
        for number, title in enumerate(HOSTILE):
            with self.subTest(title=title):
                file = self.run_into(f"a{number}", *TEXTBOOK, "--metric", "planar", "--title", title, "--size", "300")
                self.assertEqual(tomllib.loads(file.read_text(encoding="utf-8"))["title"], title)
                again = self.run_into(f"b{number}", "--config", file).parent
                for name in ("cells.geojson", "weights.csv", "rain.csv", "map.png", "report.html", "summary.csv", "study.gpkg",
                             "study.toml"):
                    self.assertEqual((again / name).read_bytes(), (file.parent / name).read_bytes(), name)

    def test_names_of_files_may_hold_anything_but_bytes_that_are_not_utf8(self):
        for name in ['a "b" #c.csv', "new\nline.csv", "ø 雨.csv", "back\\slash.csv"]:
            with self.subTest(name=name):
                (self.folder / name).write_bytes(TEXTBOOK[0].read_bytes())
                file = self.run_into("out", name, *TEXTBOOK[1:], "--metric", "planar", "--overwrite")
                self.assertEqual(tomllib.loads(file.read_text(encoding="utf-8"))["stations"], f"../{name}")
                self.run_into("again", "--config", file, "--overwrite")
        (self.folder / "\udcff.csv").write_bytes(TEXTBOOK[0].read_bytes())
        ran = self.run_program("run", "\udcff.csv", *TEXTBOOK[1:], "--metric", "planar", "-o", "bytes")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("STATIONS is not UTF-8", ran.stderr)
        ran = self.run_program("run", "--config", "bytes/study.toml", "-o", "more")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("STATIONS is missing", ran.stderr)

    def test_a_folder_of_results_is_computed_again_in_its_place(self):
        file = self.run_into("out", *TEXTBOOK, "--metric", "planar")
        before = file.read_bytes()
        self.run_into("out", "--config", file, "--overwrite")
        self.assertEqual(file.read_bytes(), before)

    def test_a_run_that_fails_leaves_the_old_file(self):
        file = self.run_into("out", *TEXTBOOK, "--metric", "planar")
        before = file.read_bytes()
        self.write("broken.csv", "time,1,2\nstorm,x,2\n")
        ran = self.run_program("run", *TEXTBOOK[:2], "broken.csv", "-o", "out", "--overwrite")
        self.assertEqual(ran.returncode, 1)
        self.assertEqual(file.read_bytes(), before)

    def test_every_command_takes_one(self):
        self.write("study.toml", f'stations = "{TEXTBOOK[0]}"\nbasins = "{TEXTBOOK[1]}"\nmetric = "planar"\n')
        self.assertEqual(self.output("weights", "--config", "study.toml"),
                         self.output("weights", *TEXTBOOK[:2], "--metric", "planar"))
        self.output("cells", "--config", "study.toml", "-o", "cells.geojson")
        self.output("check", "--config", "study.toml")
        self.output("map", "--config", "study.toml", "-o", "map.png")
        self.output("rain", "--config", "study.toml", "--rainfall", TEXTBOOK[2])


if __name__ == "__main__":
    unittest.main()
