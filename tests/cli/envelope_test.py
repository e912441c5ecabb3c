#!/usr/bin/env python3
"""Every subcommand, found, none, refused, and stopped at once: its JSON is one envelope, and the exit code says the same.

usage: envelope_test.py TAUT SCHEMA DATA
"""

import json
import os
import subprocess
import sys
import tempfile

import jsonschema

EXIT = {"found": 0, "done": 0, "none": 1, "differs": 1, "invalid": 1, "refused": 3, "stopped": 4, "unproven": 4}

ROOM = "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2 3\n"
SEALED = "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2 4\n"
SLIT = "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2 1.9\n2 2 2 4\n"
SLANTED = "boundary 0 0 4 4\nstart 1 1\ngoal 3 3\n2 0 2.1 3.3\n"
WRONG = "boundary 0 0 4\n"
GRID = "type octile\nheight 3\nwidth 3\nmap\n.@.\n.@.\n...\n"
GRID_SEALED = "type octile\nheight 3\nwidth 3\nmap\n.@.\n.@.\n.@.\n"
SCENARIO = "version 1\n0\tmap\t3\t3\t0\t0\t2\t0\t6.00000000\n"
MOUSE = "o---o---o\n| G     |\no   o   o\n| S |   |\no---o---o\n"
MOUSE_SEALED = "o---o---o\n| G |   |\no---o   o\n| S |   |\no---o---o\n"
CHASE_SEALED = "N\n3,3\nC\n100\nR\n1,1\nT\n3,3\n3,3\nM\n1,200,1\n1,200,1\n1,200,1\n"
ROADS = (
    "start 3 3\ngoal 8 3\ngrid 12 5\n############\n#..........#\n#..........#\n#..........#\n############\n"
    "samples 1\n1\n"
)
QUERIES = "1 1 3 3\n"
DISC_QUERIES = "1 1 3 3 0.2\n1 1 3 3 0.3\n"
PLACES = "x,y\n1,1\n3,3\n"
PROOF = (
    '{"format": "taut certificate 1", "kind": "none", "world": "3c575266e5f47952", "scale": 1, "fraction_bits": 0, '
    '"horizon": 0, "path": [[1, 1], [3, 3]], "goal": [[3, 3], [3, 3]], "potentials": [[1, 1, 0]]}\n'
)
FLEET = "a 0 1 1\na 2 1 3\nb 0 1 3\nb 2 1 1\n"
PATH_THROUGH_WALL = "1 1\n3 3\n"


def cases(data):
    """(words, files by name, the status that is expected, the text on standard input)"""
    world = {"room": ROOM, "sealed": SEALED, "slit": SLIT, "slanted": SLANTED, "wrong": WRONG, "queries": QUERIES}
    world["through"] = PATH_THROUGH_WALL
    world["places"] = PLACES
    world["detour"] = "1 1\n1 3\n"
    world["fleet"] = FLEET
    world["proof"] = PROOF
    world["discs"] = DISC_QUERIES
    yield "solve room", world, "found"
    yield "solve room --roadmap visibility --algorithm dijkstra", world, "found"
    yield "solve room --algorithm bfs", world, "found"
    yield "solve room --heuristic manhattan", world, "found"
    yield "view room -o page.html", world, "done"
    yield "view wrong -o page.html", world, "refused"
    yield "solve room --widest", world, "found"
    yield "solve room --tradeoff", world, "found"
    yield "solve room --clearance 0.3", world, "found"
    yield "solve room --robot disc:0.1 --arcs", world, "found"
    yield "solve room --anytime", world, "found"
    yield "solve room --roadmap prm", world, "found"
    yield "solve slanted --wall-thickness 0.02", world, "found"
    yield "solve slanted --robot square:0.05", world, "found"
    yield "solve sealed", world, "none"
    yield "solve sealed --roadmap visibility", world, "none"
    yield "solve sealed --widest", world, "none"
    yield "solve sealed --clearance 0.1", world, "none"
    yield "solve room --keep 0.1", world, "found"
    yield "solve slit --keep 0.2", world, "none"
    yield "solve sealed --keep 0.1", world, "none"
    yield "solve wrong --keep 0.1", world, "refused"
    yield "solve room --alternatives 3", world, "found"
    yield "solve room --alternatives wider", world, "found"
    yield "solve sealed --alternatives 3", world, "none"
    yield "reach room --robot disc:0.2 --ask 1,1", world, "done"
    yield "solve slit --robot disc:0.2", world, "none"
    yield "solve slit --robot disc:0.2 --arcs", world, "none"
    yield "solve wrong", world, "refused"
    yield "solve room --from 2,1", world, "found"
    yield "solve room --from 9,9", world, "refused"
    yield "batch room queries", world, "done"
    yield "batch wrong queries", world, "refused"
    yield "batch room queries --widest", world, "done"
    yield "batch sealed queries --widest", world, "none"
    yield "batch room discs --arcs", world, "done"
    yield "batch room queries --arcs", world, "refused"
    yield "matrix room places", world, "done"
    yield "matrix room places -o out --as npy", world, "done"
    yield "matrix sealed places", world, "none"
    yield "matrix room through", world, "done"
    yield "matrix room queries", world, "refused"
    yield "matrix wrong places", world, "refused"
    yield "passage room", world, "found"
    yield "passage slit --robot disc:0.2", world, "none"
    yield "passage wrong", world, "refused"
    yield "passage room --matrix places", world, "done"
    yield "passage room --matrix queries", world, "refused"
    yield "passage room --map map.csv", world, "done"
    yield "passage wrong --map map.csv", world, "refused"
    yield "reach room --robot disc:0.2", world, "done"
    yield "reach room --robot disc:1.2", world, "refused"
    yield "reach wrong --robot disc:0.2", world, "refused"
    yield "check room", world, "done"
    yield "check room --path through", world, "invalid"
    yield "check wrong", world, "refused"
    yield "solve room --certificate out", world, "found"
    yield "solve sealed --certificate out", world, "none"
    yield "solve slanted --wall-thickness 0.02 --certificate out", world, "refused"
    yield "verify sealed proof", world, "done"
    yield "verify room proof", world, "invalid"
    yield "verify room wrong", world, "refused"
    yield "verify wrong proof", world, "refused"
    yield "audit room places --no-gap", world, "invalid"
    yield "audit sealed detour", world, "done"
    yield "audit room through", world, "invalid"
    yield "audit room fleet --robot disc:0.1", world, "invalid"
    yield "audit room wrong", world, "refused"
    yield "audit wrong through", world, "refused"
    yield "roadmap room", world, "done"
    yield "roadmap wrong", world, "refused"
    yield "compare room", world, "found"
    yield "compare sealed", world, "none"
    yield "compare wrong", world, "refused"
    yield "convert room out --as geojson", world, "done"
    yield "convert wrong out --as geojson", world, "refused"
    yield "space room --robot disc:0.1 -o out --as wkt", world, "done"
    yield "space wrong -o out --as svg", world, "refused"
    yield "generate --size 5 -o out", world, "done"
    yield "bug room", world, "found"
    yield "bug sealed", world, "none"
    yield "bug wrong", world, "refused"
    yield "bug compare room", world, "found"
    yield "bug compare sealed", world, "none"
    grid = {"map": GRID, "sealed": GRID_SEALED, "wrong": WRONG, "routes": SCENARIO}
    for kind in ("solve", "compare"):
        yield f"grid {kind} map --start 0,0 --goal 0,2", grid, "found"
        yield f"grid {kind} sealed --start 0,0 --goal 0,2", grid, "none"
        yield f"grid {kind} wrong --start 0,0 --goal 0,2", grid, "refused"
    yield "grid heuristics map --goal 0,2", grid, "done"
    yield "grid scen map routes", grid, "done"
    yield "grid generate --size 9x9 -o out", grid, "done"
    mouse = {"maze": MOUSE, "other": MOUSE_SEALED, "wrong": WRONG}
    yield "diff maze maze", mouse, "done"
    yield "diff maze other", mouse, "differs"
    yield "diff maze wrong", mouse, "refused"
    yield "mouse run maze", mouse, "found"
    yield "mouse run other", mouse, "none"
    yield "mouse run wrong", mouse, "refused"
    yield "mouse compare maze", mouse, "done"
    yield "mouse speed maze", mouse, "found"
    chase = {"map": os.path.join(data, "town_60x40.chase"), "sealed": CHASE_SEALED, "wrong": WRONG}
    yield "chase map", chase, "found"
    yield "chase map --online", chase, "found"
    yield "chase sealed", chase, "none"
    yield "chase compare sealed", chase, "none"
    yield "chase wrong", chase, "refused"
    yield "chase compare map", chase, "found"
    yield "chase generate --size 20 -o out", chase, "done"
    plane = {"room": ROOM, "sealed": SEALED, "wrong": WRONG, "walk": "0 1 3\n9 1 1\n", "beyond": "0 3 3\n9 3 2\n"}
    yield "chase plane room --target walk", plane, "found"
    yield "chase plane sealed --target beyond", plane, "none"
    yield "chase plane room --target wrong", plane, "refused"
    drive = {"lane": os.path.join(data, "car", "lane.txt"), "room": ROOM, "sealed": SEALED, "wrong": WRONG}
    car = "--car length=0.4,width=0.2,radius=0.3"
    yield "drive lane", drive, "found"
    yield "drive lane --all", drive, "done"
    yield "drive wrong", drive, "refused"
    yield f"drive room {car}", drive, "found"
    yield f"drive sealed {car}", drive, "none"


def words_of(command, files, folder):
    return [os.path.join(folder, w) if w in files or w in ("out", "map.csv") else w for w in command.split()]


def fill(folder, files):
    for name, text in files.items():
        path = os.path.join(folder, name)
        if os.path.isabs(text):
            os.symlink(text, path)
        else:
            with open(path, "w", encoding="utf-8") as out:
                out.write(text)


def fault_of(validator, taut, command, files, expected, more=()):
    """What is wrong with a run, or nothing."""
    with tempfile.TemporaryDirectory() as folder:
        fill(folder, files)
        answer = os.path.join(folder, "answer.json")
        run = subprocess.run(
            [taut, *words_of(command, files, folder), "--json", answer, "-q", *more],
            capture_output=True, text=True, timeout=120, check=False, stdin=subprocess.DEVNULL)
        if not os.path.exists(answer):
            return f"no JSON, exit {run.returncode}: {run.stderr.strip()}"
        with open(answer, encoding="utf-8") as text:
            envelope = json.load(text)
    faults = [f"{'/'.join(map(str, e.path))}: {e.message}" for e in validator.iter_errors(envelope)]
    status = envelope.get("status")
    if status not in expected:
        faults.append(f"status {status}, not {' or '.join(expected)} ({envelope.get('reason')})")
    if EXIT.get(status) != run.returncode:
        faults.append(f"exit {run.returncode} with status {status}")
    if not command.startswith(envelope.get("command", "?")):
        faults.append(f"command {envelope.get('command')}")
    return "; ".join(faults)


def main():
    taut, schema, data = sys.argv[1:4]
    with open(schema, encoding="utf-8") as text:
        validator = jsonschema.Draft7Validator(json.load(text))
    failed = count = 0
    for command, files, status in cases(os.path.abspath(data)):
        runs = [((), [status]), (("--max-seconds", "0.001"), [status, "stopped"])]
        for more, expected in runs:
            count += 1
            fault = fault_of(validator, taut, command, files, expected, more)
            if fault:
                failed += 1
                print(f"taut {command} {' '.join(more)}: {fault}")
    print(f"{count} runs, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
