"""The folder in which a page's commands run: a reader's, with the project's files and some of his own."""
import re
import stat

# What a command begins with, and why it is not run here.
LEFT_OUT = {
    r"sbatch |parallel ": "needs a cluster",
    r"mpirun ": "needs a taut with MPI; tests/cli/ranks_test.cpp runs it in the lane `mpi`",
    r"docker ": "needs docker",
    r"(sudo )?apt(-get)? ": "installs",
    r"pip |python3 -m pip ": "installs; tests/python/install_test.py does it",
    r"git clone ": "needs a network",
    r"cmake |cpack |ninja ": "builds; the lanes of `./dev check` do it",
    r"\./dev python": "builds the package; tests/python",
    r"\./dev (test|check [a-z]+|bench|fuzz|oracle|attack|docs|web)\b(?!/)": "builds and runs all of it",
    r"taut matrix .*--join rows\.\*": "joins what the cluster made; tests/cli/shards_test.cpp does it",
    r"PYTHONPATH=\S+ python3$": "waits for what is typed",
    r"source <\(": "is for shells that are typed into; tests/cli/manual_test.cpp does it",
    r"taut mouse serve ": "waits for a robot; tests/cli/mouse does it",
    r"(taut|\./dev) view .*--serve": "waits for a browser",
}

# What a reader has: where a page speaks of maze.txt, it is this.
READERS_FILES = {
    "queries.txt": "1 1 5 1\n1 1 20 20\n3 3 7 9\n2 8 24 24\n",
    "points.csv": "x,y\n1,1\n5,5\n20,20\n",
}


def left_out(command):
    """Why a command is not run, or nothing."""
    return next((why for begin, why in LEFT_OUT.items() if re.match(begin, command)), None)


def furnish(folder, root, taut):
    for name in ("data", "examples", "python", "tests", "docs", "bench"):
        (folder / name).symlink_to(root / name)
    (folder / "maze.txt").write_bytes((root / "data/maze_25x25.txt").read_bytes())
    for name, text in READERS_FILES.items():
        (folder / name).write_text(text)
    (folder / "bin").mkdir()
    (folder / "bin" / "taut").symlink_to(taut)
    # ./dev installs and builds, then runs the program: here it is built already.
    dev = folder / "dev"
    dev.write_text(f'#!/bin/sh\nexec "{taut}" "$@"\n')
    dev.chmod(dev.stat().st_mode | stat.S_IXUSR)
