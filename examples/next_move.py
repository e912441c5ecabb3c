"""Lets a robot that is a Python class run in `taut mouse serve`: it has `next_move(sensors)`, which gives a rotation
(-90, 0 or 90 degrees) and a movement (-3 to 3 cells), or ("Reset", "Reset").

usage: taut mouse serve MAZE --hello --robot "python3 examples/next_move.py FILE.py [CLASS]"

The class (Robot, where none is named) is made with the maze's width. What it prints goes to standard error.
"""

import runpy
import sys


def lines():
    while line := sys.stdin.readline():
        yield line.split()


def serve(robot_class, answer):
    robot = None
    for word, *rest in lines():
        if word == "maze":
            robot = robot_class(int(rest[0]))
        elif word in ("score", "failed"):
            return
        elif word != "goal":
            rotation, movement = robot.next_move([int(word), *map(int, rest)])
            reset = "reset" in (str(rotation).lower(), str(movement).lower())
            print("reset" if reset else f"{int(rotation)} {int(movement)}", file=answer, flush=True)


if __name__ == "__main__":
    answers, sys.stdout = sys.stdout, sys.stderr
    serve(runpy.run_path(sys.argv[1])[sys.argv[2] if len(sys.argv) > 2 else "Robot"], answers)
