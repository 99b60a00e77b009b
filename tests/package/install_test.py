"""`cmake --install`: what is there, whether the program and the library can be used from there, and what is left
when it is uninstalled."""

import re
import shutil
import unittest

from installation import ANSWER, BUILD, CXX, CMAKE, RECORDS, SAMPLES, TEXTBOOK, InstallationTest

PROJECT = """cmake_minimum_required(VERSION 3.22)
project(storm LANGUAGES CXX)
find_package(thiessen REQUIRED)
add_executable(storm textbook.cpp)
target_link_libraries(storm PRIVATE thiessen::thiessen)
"""

# A project that can do without, and says why it has to.
PERHAPS = """cmake_minimum_required(VERSION 3.22)
project(storm LANGUAGES CXX)
%s
find_package(thiessen QUIET CONFIG %s)
message(STATUS "found: ${thiessen_FOUND}, for ${thiessen_NOT_FOUND_MESSAGE}")
"""

# What the module for Python stands on: its sources, and no headers, come with a clone.
PROGRAM = """cmake_minimum_required(VERSION 3.22)
project(gauges LANGUAGES CXX)
find_package(thiessen REQUIRED COMPONENTS program)
add_executable(gauges gauges.cpp)
target_include_directories(gauges PRIVATE ${CLONE}/src ${CLONE})
target_link_libraries(gauges PRIVATE thiessen::program)
"""
GAUGES = """#include <iostream>

#include "cli/options/arguments.h"
#include "cli/options/reading.h"
#include "cli/options/blocks/study_options.h"

int main(int, char** words) {
  using namespace thiessen;
  cli::OptionList list;
  cli::StudyOptions study;
  study.declare(list, cli::Need::optional);
  cli::Arguments said;
  said.options.push_back({"STATIONS", "STATIONS", {words[1]}});
  Warnings warnings;
  cli::read_options(list, said, warnings);
  std::cout << read_stations(study.request().stations, warnings).stations.size() << " gauges\\n";
}
"""


class Install(InstallationTest):
    def test_all_lies_where_it_is_looked_for(self):
        self.install()
        files = self.files()
        for name in ("usr/bin/thiessen", "usr/include/thiessen.h", "usr/lib/libthiessen.a",
                     "usr/lib/thiessen/libthiessen-program.a", "usr/lib/pkgconfig/thiessen.pc", "usr/lib/cmake/thiessen/thiessen-config.cmake",
                     "usr/share/man/man1/thiessen.1", "usr/share/bash-completion/completions/thiessen",
                     "usr/share/zsh/site-functions/_thiessen", "usr/share/fish/vendor_completions.d/thiessen.fish",
                     "usr/share/doc/thiessen/copyright", "usr/share/doc/thiessen/samples/textbook/stations.csv"):
            self.assertIn(name, files)

    def test_the_program_runs_and_bash_completes_it(self):
        self.install()
        program = self.prefix / "bin" / "thiessen"
        sample = [SAMPLES / "textbook" / f"{name}.csv" for name in ("stations", "basin", "rainfall")]
        self.assertIn("69.836", self.run_command(program, "rain", *sample, "--metric", "planar"))
        script = self.prefix / "share/bash-completion/completions/thiessen"
        self.assertIn("thiessen", self.run_command("bash", "-c", f"source '{script}' && complete -p thiessen"))

    def test_the_headers_name_none_outside_the_installation(self):
        self.install()
        headers = self.prefix / "include"
        each = "".join(f"#include <{header.relative_to(headers)}>\n" for header in sorted(headers.rglob("*.h")))
        self.assertIn("#include <thiessen/study/thiessen.h>", each)
        for header in headers.rglob("*.h"):
            self.assertNotIn('#include "', header.read_text(encoding="utf-8"), header)
        (self.folder / "each.cpp").write_text(each, encoding="utf-8")
        self.run_command(CXX, "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only",
                         f"-I{headers}", "each.cpp")

    def test_nothing_tells_where_it_was_built(self):
        self.install()
        for name in ("lib/pkgconfig", "lib/cmake/thiessen", "include"):
            for file in (self.prefix / name).rglob("*.*"):
                if not file.is_file():
                    continue
                text = file.read_text(encoding="utf-8")
                self.assertNotIn(str(SAMPLES.parent), text, file)
                self.assertNotIn(str(self.root), text, file)

    def test_a_program_finds_the_library_by_cmake(self):
        self.install()
        project = self.folder / "project"
        project.mkdir()
        shutil.copy(TEXTBOOK, project)
        (project / "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
        built = self.folder / "built"
        self.run_command(CMAKE, "-S", project, "-B", built, f"-DCMAKE_PREFIX_PATH={self.prefix}",
                         f"-DCMAKE_CXX_COMPILER={CXX}")
        self.run_command(CMAKE, "--build", built)
        self.assertIn(ANSWER, self.run_command(built / "storm"))
        # What the program needs is not looked for.
        self.assertNotIn("GDAL", (built / "CMakeCache.txt").read_text(encoding="utf-8"))

    def test_the_program_s_inputs_are_found_by_cmake_without_pictures(self):
        self.install()
        project = self.folder / "project"
        project.mkdir()
        (project / "gauges.cpp").write_text(GAUGES, encoding="utf-8")
        (project / "CMakeLists.txt").write_text(PROGRAM, encoding="utf-8")
        built = self.folder / "built"
        self.run_command(CMAKE, "-S", project, "-B", built, f"-DCMAKE_PREFIX_PATH={self.prefix}",
                         f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCLONE={SAMPLES.parent}")
        self.run_command(CMAKE, "--build", built)
        self.assertEqual("9 gauges\n", self.run_command(built / "gauges", SAMPLES / "textbook" / "stations.csv"))
        self.assertNotIn("OpenCV", (built / "CMakeCache.txt").read_text(encoding="utf-8"))

    def configured(self, before, components):
        project = self.folder / "perhaps"
        shutil.rmtree(project, ignore_errors=True)
        project.mkdir()
        (project / "CMakeLists.txt").write_text(PERHAPS % (before, components), encoding="utf-8")
        return self.run_command(CMAKE, "-S", project, "-B", project / "built", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                                f"-DCMAKE_CXX_COMPILER={CXX}")

    def test_what_is_missing_is_said_and_no_end(self):
        self.install()
        self.assertIn("found: 1, for \n", self.configured("", ""))
        nowhere = "set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)\nset(CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH OFF)"
        self.assertRegex(self.configured(nowhere, ""), "found: (0|OFF|FALSE), for GeographicLib is not found: install ")
        self.assertRegex(self.configured("", "COMPONENTS pictures"),
                         "found: (0|OFF|FALSE), for thiessen has no component pictures: ")
        self.assertIn("found: 1, for \n", self.configured("", "OPTIONAL_COMPONENTS pictures"))

    def test_headers_are_found_where_they_are_installed(self):
        built = self.folder / "elsewhere"
        for folder, named in (("include/foo", "${_IMPORT_PREFIX}/include/foo"), ("/all/include", "/all/include")):
            self.run_command(CMAKE, "-S", SAMPLES.parent, "-B", built, "-DTHIESSEN_PROGRAM=OFF",
                             f"-DCMAKE_INSTALL_INCLUDEDIR={folder}", f"-DCMAKE_CXX_COMPILER={CXX}")
            [targets] = built.glob("src/package/CMakeFiles/Export/**/thiessen-targets.cmake")
            self.assertIn(f'INTERFACE_INCLUDE_DIRECTORIES "{named}"', targets.read_text(encoding="utf-8"))
            [pc] = built.rglob("thiessen.pc")
            self.assertIn("includedir=" + named.replace("_IMPORT_PREFIX", "prefix") + "\n", pc.read_text(encoding="utf-8"))

    @unittest.skipUnless(shutil.which("nm"), "nm is not installed")
    def test_the_library_takes_no_name_of_a_user_s(self):
        self.install()
        names = self.run_command("nm", "--extern-only", "--defined-only", "--format=posix",
                                 self.prefix / "lib" / "libthiessen.a")
        # What is in the namespace, or shared by all who use it, as an instance of a template is (V, W, u).
        strange = [line for line in names.splitlines()
                   if re.match(r"\S+ [A-TX-Z] ", line) and not re.match(r"_Z\S*8thiessen", line)]
        self.assertEqual(strange, [])

    @unittest.skipUnless(shutil.which("pkg-config"), "pkg-config is not installed")
    def test_a_program_finds_the_library_by_pkg_config(self):
        self.install()
        environment = {"PKG_CONFIG_PATH": str(self.prefix / "lib" / "pkgconfig")}
        flags = self.run_command("pkg-config", "--cflags", "--libs", "thiessen", environment=environment).split()
        self.run_command(CXX, "-std=c++20", TEXTBOOK, "-o", "storm", *flags)
        self.assertIn(ANSWER, self.run_command(self.folder / "storm"))
        self.assertEqual(self.run_command("pkg-config", "--modversion", "thiessen", environment=environment).strip(),
                         self.run_command(self.prefix / "bin" / "thiessen", "--version").split()[1])


class Uninstall(InstallationTest):
    def test_nothing_is_left(self):
        self.root.mkdir()
        self.install()
        self.uninstall()
        self.assertEqual(list(self.root.iterdir()), [])

    def test_what_others_put_there_is_left(self):
        others = [self.prefix / "bin" / "other", self.prefix / "share" / "man" / "man1" / "other.1"]
        empty = self.prefix / "lib" / "pkgconfig"
        empty.mkdir(parents=True)
        for file in others:
            file.parent.mkdir(parents=True)
            file.touch()
        self.install()
        late = self.prefix / "include" / "thiessen" / "mine.h"
        late.touch()
        self.uninstall()
        self.assertEqual(self.files(), sorted(str(file.relative_to(self.root)) for file in [*others, late]))
        self.assertTrue(empty.is_dir(), "a folder that was there before")
        self.assertFalse((self.prefix / "share" / "doc").exists(), "a folder that the installation made")

    def test_two_installations_are_taken_away_as_one(self):
        self.root.mkdir()
        self.install()
        self.install()
        self.uninstall()
        self.assertEqual(list(self.root.iterdir()), [])

    def test_what_is_not_there_is_asked_for(self):
        self.install()
        before = self.files()
        left = {name: (BUILD / name).read_bytes() for name in RECORDS}
        with self.assertRaises(AssertionError) as caught:
            self.run_command(CMAKE, "--build", BUILD, "--target", "uninstall",
                             environment={"DESTDIR": str(self.folder / "other")})
        self.assertIn("DESTDIR", str(caught.exception))
        self.assertEqual(left, {name: (BUILD / name).read_bytes() for name in RECORDS})
        self.assertEqual(before, self.files())
        self.uninstall()

    def test_folders_of_an_earlier_installation_of_another_build_go(self):
        self.install()
        for name in RECORDS:
            (BUILD / name).unlink()
        self.install()
        self.uninstall()
        self.assertEqual([path for path in self.root.rglob("*") if "thiessen" in path.name], [])
        self.assertTrue((self.prefix / "bin").is_dir(), "which this installation did not make")

    def test_what_it_made_in_a_folder_of_its_name_goes(self):
        doc = self.prefix / "share" / "doc" / "thiessen"
        doc.mkdir(parents=True)
        (doc / "notes").touch()
        self.install()
        self.uninstall()
        self.assertEqual([path.name for path in doc.rglob("*")], ["notes"])

    def test_without_an_installation_it_says_so(self):
        with self.assertRaises(AssertionError) as caught:
            self.uninstall()
        self.assertIn("Nothing is known to be installed", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
