"""Builds the bindings with CMake: against an installed thiessen where CMake finds one, else with this clone."""

import os
import pathlib
import re
import subprocess
import sys

import pybind11
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
CLONE = HERE.parent.parent
# What is made on the way lies where the clone's builds do, and not among its sources.
BUILD = CLONE / "build-python"
BUILD.mkdir(exist_ok=True)


def version():
    text = (CLONE / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(thiessen VERSION ([\d.]+)", text).group(1)


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        folder = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = pathlib.Path(os.environ.get("THIESSEN_PYTHON_BUILD", pathlib.Path(self.build_temp) / "thiessen"))
        build = build.resolve()
        build.mkdir(parents=True, exist_ok=True)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "-S", HERE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                        # Where pip has fetched pybind11 for this build alone, CMake does not look for it by itself.
                        f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
                        f"-DPython3_EXECUTABLE={sys.executable}", f"-DTHIESSEN_PYTHON_FOLDER={folder}",
                        *os.environ.get("CMAKE_ARGS", "").split()], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "thiessen_python", "--parallel", jobs], check=True)


setup(
    name="thiessen",
    version=version(),
    description="Areal rainfall from rain gauges by exact Thiessen polygons",
    packages=["thiessen"],
    package_data={"thiessen": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("thiessen._thiessen", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
    python_requires=">=3.9",
    install_requires=["numpy"],
    zip_safe=False,
)
