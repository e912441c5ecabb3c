"""`pip install .` from a checkout makes a package that works elsewhere."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import taut

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(taut._taut.__file__).parents[2]


def test_pip_installs_from_a_checkout_without_a_network(tmp_path):
    pytest.importorskip("pip")
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip("taut does not come from a build tree")
    checkout, target = tmp_path / "checkout", tmp_path / "target"
    checkout.mkdir()
    for name in "pyproject.toml", "setup.py", "CMakeLists.txt", "README.md":
        shutil.copy(ROOT / name, checkout)
    shutil.copytree(ROOT / "python", checkout / "python")
    install = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index"]
    environment = {**os.environ, "TAUT_PYTHON_BUILD": str(BUILD), "PIP_BREAK_SYSTEM_PACKAGES": "1"}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run([*install, "--target", target, checkout], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr + done.stdout
    script = (
        "import taut; print(taut.__file__); "
        "print(taut.shortest_path(taut.World([[0, 0, 1, 0]]), (0, 1), (1, 1)).length)"
    )
    environment["PYTHONPATH"] = str(target)
    ran = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, cwd=tmp_path)
    assert ran.returncode == 0, ran.stderr
    where, length = ran.stdout.split()
    assert pathlib.Path(where).is_relative_to(target) and length == "1.0"
    installed = {p.name for p in (target / "taut").iterdir()}
    assert {"py.typed", "_taut.pyi", "_errors.py"} <= installed
    assert list(target.glob("taut-*.dist-info"))
