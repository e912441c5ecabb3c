#!/usr/bin/env python3
"""Seed corpora for the fuzz targets, made from the project's own examples.

usage: seeds.py DATA FOLDER

FOLDER/TARGET holds the inputs to begin with: files with the bytes in front or behind that say how the target reads them.
"""
import random
import sys
from pathlib import Path

LARGEST = 20000

# The place of a reader in files_fuzz.cpp, with inputs of its own where data/ has none.
FILES = [
    (0, ["0 0\n1 1\n2 3\n", '{"type":"LineString","coordinates":[[0,0],[1,1]]}', "x,y\n0,0\n1,1\n",
         "header:\n  frame_id: map\nposes:\n- pose:\n    position: {x: 1, y: 2}\n", "LINESTRING(0 0, 1 1)\n"]),
    (1, ["0 0\n1 1\n", "x,y\n0.5,1\n"]),
    (2, ["0 0 1 1\n0 0 1 1 1.414214\n0 0 9 9 none\n# remark\n", "version 1\n0\ta.map\t4\t3\t0\t0\t3\t2\t5\n"]),
    (3, ["version 1\n0\ta.map\t4\t3\t0\t0\t3\t2\t5\n"]),
    (4, ["type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n"]),
    (5, ["N\n3,3\nC\n100\nR\n0,0\nT\n2,2\n2,1\nM\n1,1,1\n1,1,1\n1,1,1\n"]),
    (6, []),
    (7, []),
    (8, ['{"acceleration": 2.5, "deceleration": 3}']),
    (9, []),
]
# What robots plan, with how audits_fuzz.cpp takes it; lines of a batch.
PLANS = [
    (0, "1 4\n2 2\n4 5\n7 5\n"), (0, "1 4\n4 5\n\n1 4\n7 5\n"), (1, '{"type":"LineString","coordinates":[[1,4],[1,1],[3,1]]}'),
    (2, "LINESTRING(1 4, 1 1, 3 1)\n"), (3, "a 0 1 1\na 5 6 1\nb 0 6 1\nb 5 1 1\n"), (3, "id,t,x,y\na,0,1,1\nb,0,1,2\n"),
    (4, "a 0 1 1 0.5\na 2 3 1 0.5\nb 1 2 2 0.25\nb 4 2 0 0.25\nc 3 5 5 1\n"),
]
BATCHES = ["1 4 7 5\n+wall 4 5 4 8\n1 4 7 5\n-wall 4 6 4 8\n1 4 7 5 none\n", "1,4 7,5\n-wall 2 2 2 8\n0 0 8 8\n",
           "-wall 5 6 8 6\n+wall 4 5 8 5\n3 3 6 7.5\n"]
# Targets that make something of any bytes, with how many they take.
RANDOM = {"saved": 60, "commands": 60, "geometry": 60, "certificates": 40, "predicates": 60, "lengths": 60, "snaps": 60}
READ_BY = {".chase": 5, ".map": 4, ".scen": 3, ".json": 8}


def write(folder, name, bytes_):
    folder.mkdir(parents=True, exist_ok=True)
    if len(bytes_) <= LARGEST:
        (folder / name).write_bytes(bytes_)


def main():
    data, folder = Path(sys.argv[1]), Path(sys.argv[2])
    numbers = random.Random(1)
    for path in sorted(data.rglob("*")):
        if not path.is_file() or path.suffix == ".md":
            continue
        text = path.read_bytes()
        # FuzzedDataProvider takes what it is asked for from the end: flags, then the format (31: by content).
        write(folder / "worlds_fuzz", path.name, text + bytes([0, 31]))
        write(folder / "worlds_fuzz", "mended_" + path.name, text + bytes([4 | 16, 31]))
        reader = 6 if path.parent.name == "car" else READ_BY.get(path.suffix)
        if reader is not None:
            write(folder / "files_fuzz", path.name, bytes([reader]) + text)
    for reader, texts in FILES:
        for i, text in enumerate(texts):
            write(folder / "files_fuzz", f"{reader}_{i}", bytes([reader]) + text.encode())
    for i, (how, text) in enumerate(PLANS):
        write(folder / "audits_fuzz", str(i), bytes([how]) + text.encode())
    for i, text in enumerate(BATCHES):
        for how in (0, 1):
            write(folder / "batch_fuzz", f"{how}_{i}", bytes([how]) + text.encode())
    for i in range(50):
        for target, most in RANDOM.items():
            write(folder / f"{target}_fuzz", str(i), numbers.randbytes(numbers.randrange(4, most)))


if __name__ == "__main__":
    main()
