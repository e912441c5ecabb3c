"""A robot as the simulator mms has them: `taut mouse serve MAZE --mms --robot "python3 examples/mms_flooding_robot.py"`.

It steps into the neighbour nearest to the middle, unknown walls taken for open, writes the distances into the cells, and
does so again with what it knows when the reset button is pressed."""

import collections
import sys

STEPS = [(0, 1), (1, 0), (0, -1), (-1, 0)]  # north, east, south, west


def tell(*words):
    print(*words, flush=True)


def ask(*words):
    tell(*words)
    return sys.stdin.readline().strip()


def ahead(cell, heading):
    return cell[0] + STEPS[heading][0], cell[1] + STEPS[heading][1]


def see(walls, cell, heading):
    for name, turn in (("wallLeft", 3), ("wallFront", 0), ("wallRight", 1)):
        if ask(name) == "true":
            side = (heading + turn) % 4
            tell("setWall", *cell, "nesw"[side])
            walls |= {(cell, side), (ahead(cell, side), (side + 2) % 4)}


def distances(walls, width, height, goal):
    distance, queue = dict.fromkeys(goal, 0), collections.deque(goal)
    while queue:
        cell = queue.popleft()
        for heading in range(4):
            x, y = other = ahead(cell, heading)
            if 0 <= x < width and 0 <= y < height and other not in distance and (cell, heading) not in walls:
                distance[other] = distance[cell] + 1
                queue.append(other)
    return distance


def go(walls, width, height, goal):
    cell, heading = (0, 0), 0
    while cell not in goal:
        see(walls, cell, heading)
        distance = distances(walls, width, height, goal)
        tell("setText", *cell, distance[cell])
        wanted = min((h for h in range(4) if (cell, h) not in walls), key=lambda h: distance.get(ahead(cell, h), 1e9))
        for _ in range((wanted - heading) % 4 if (wanted - heading) % 4 < 3 else 1):
            ask("turnLeft" if (wanted - heading) % 4 == 3 else "turnRight")
        heading = wanted
        if ask("moveForward") == "ack":
            cell = ahead(cell, heading)
    tell("setColor", *cell, "G")


maze = int(ask("mazeWidth")), int(ask("mazeHeight"))
middle = {(x, y) for x in ((maze[0] - 1) // 2, maze[0] // 2) for y in ((maze[1] - 1) // 2, maze[1] // 2)}
seen = {((0, 0), 2), ((0, -1), 0)}
go(seen, *maze, middle)
if ask("wasReset") == "true":
    ask("ackReset")
    go(seen, *maze, middle)
