"""Installs the build that THIESSEN_BUILD names into a folder of the test's own, and takes it away again."""

import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ.get("THIESSEN_BUILD", "build-tests")).resolve()
CMAKE = os.environ.get("CMAKE", "cmake")
CXX = os.environ.get("CXX", "c++")
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
TEXTBOOK = SAMPLES / "library" / "textbook.cpp"
ANSWER = "rainfall: 69.8364 mm"
RECORDS = ("install_manifest.txt", "install_folders.txt")  # what the build folder remembers of an installation


class InstallationTest(unittest.TestCase):
    """A test that installs below self.root, as DESTDIR, with self.prefix in it. What the build folder remembered of a
    user's own installation is put back."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="thiessen-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.root = self.folder / "root"
        self.prefix = self.root / "usr"
        for name in RECORDS:
            self.addCleanup(self.put_back, name, (BUILD / name).read_bytes() if (BUILD / name).exists() else None)
            (BUILD / name).unlink(missing_ok=True)

    @staticmethod
    def put_back(name, content):
        if content is None:
            (BUILD / name).unlink(missing_ok=True)
        else:
            (BUILD / name).write_bytes(content)

    def run_command(self, *command, **settings):
        environment = os.environ | {"DESTDIR": str(self.root)} | settings.pop("environment", {})
        ran = subprocess.run([str(word) for word in command], cwd=self.folder, env=environment, timeout=300, text=True,
                             capture_output=True, stdin=subprocess.DEVNULL, **settings)
        self.assertEqual(ran.returncode, 0, f"{' '.join(map(str, command))}: {ran.stdout}{ran.stderr}")
        return ran.stdout

    def install(self):
        self.run_command(CMAKE, "--install", BUILD, "--prefix", "/usr")

    def uninstall(self):
        self.run_command(CMAKE, "--build", BUILD, "--target", "uninstall")

    def files(self):
        return sorted(str(path.relative_to(self.root)) for path in self.root.rglob("*") if not path.is_dir())
