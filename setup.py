"""`pip install .`: CMake builds the module, as it does for everybody else; setuptools packs it.

The libraries that taut stands on have to be there (cmake/debian-packages.txt, sections program and python).
CMAKE_ARGS are passed on, TAUT_JOBS limits the jobs.
"""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(taut VERSION (\S+)", text, re.M).group(1)


def pybind11_dir():
    """Of a pybind11 that pip brought; CMake finds the system's by itself."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


class ByCMake(build_ext):
    """Into a build tree of its own, or from the one that TAUT_PYTHON_BUILD names, which is not configured anew."""

    def build_extension(self, ext):
        folder = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = pathlib.Path(os.environ.get("TAUT_PYTHON_BUILD", self.build_temp)).resolve()
        if "TAUT_PYTHON_BUILD" not in os.environ:
            self.configure(build)
        jobs = os.environ.get("TAUT_JOBS", str(os.cpu_count() or 1))
        self.cmake("--build", build, "--target", "taut_python", "--parallel", jobs)
        self.cmake("--install", build, "--component", "python", "--prefix", build / "python-wheel")
        modules = list((build / "python-wheel").rglob("_taut*.so"))
        if not modules:
            raise RuntimeError("CMake made no module: it needs Python's headers and pybind11, see its messages")
        folder.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(modules[0]), str(folder))

    def configure(self, build):
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG"]  # the preset release
        options += ["-DTAUT_BUILD_TESTS=OFF", "-DTAUT_BUILD_PROGRAM=OFF"]
        options += [f"-DPython3_EXECUTABLE={sys.executable}", *pybind11_dir()]
        self.cmake("-S", ROOT, "-B", build, *options, *os.environ.get("CMAKE_ARGS", "").split())

    @staticmethod
    def cmake(*arguments):
        subprocess.run(["cmake", *map(str, arguments)], check=True)


setup(
    version=version(),
    packages=["taut"],
    package_dir={"": "python"},
    package_data={"taut": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("taut._taut", sources=[])],
    cmdclass={"build_ext": ByCMake},
    zip_safe=False,
)
