"""A micromouse of one's own beside those of taut: it floods its map and goes down the gradient.

usage: micromouse.py [MAZE]
"""

import collections
import sys

import taut

NORTH_FIRST = [(0, 1), (1, 0), (0, -1), (-1, 0)]  # headings 0 to 3


class Flooder:
    def __init__(self, maze_dim):
        self.n = maze_dim
        middle = (maze_dim // 2 - 1, maze_dim // 2)
        self.goal = {(x, y) for x in middle for y in middle}
        self.walls = set()  # (cell, heading)
        self.at, self.heading, self.run = (0, 0), 0, 1

    def step(self, cell, heading):
        dx, dy = NORTH_FIRST[heading]
        return cell[0] + dx, cell[1] + dy

    def see(self, sensors):
        for turn, free in zip((-1, 0, 1), sensors):
            cell, heading = self.at, (self.heading + turn) % 4
            for _ in range(free):
                cell = self.step(cell, heading)
            self.walls |= {(cell, heading), (self.step(cell, heading), (heading + 2) % 4)}

    def flood(self):
        distance, queue = {cell: 0 for cell in self.goal}, collections.deque(self.goal)
        while queue:
            cell = queue.popleft()
            for heading in range(4):
                other = self.step(cell, heading)
                inside = 0 <= other[0] < self.n and 0 <= other[1] < self.n
                if inside and other not in distance and (cell, heading) not in self.walls:
                    distance[other] = distance[cell] + 1
                    queue.append(other)
        return distance

    def next_move(self, sensors):
        if self.at in self.goal and self.run == 1:
            self.at, self.heading, self.run = (0, 0), 0, 2
            return "Reset", "Reset"
        self.see(sensors)
        distance = self.flood()
        open_turns = [t for t in (0, -1, 1) if (self.at, (self.heading + t) % 4) not in self.walls]
        turn = min(open_turns, key=lambda t: distance[self.step(self.at, (self.heading + t) % 4)], default=None)
        if turn is None:  # a dead end: turn around in two steps
            self.heading = (self.heading + 1) % 4
            return 90, 0
        self.heading = (self.heading + turn) % 4
        self.at = self.step(self.at, self.heading)
        return 90 * turn, 1


maze = taut.read_world_file(sys.argv[1] if len(sys.argv) > 1 else "data/mouse_16.maz")
for robot in Flooder, "flood", "prove", "score":
    print(taut.run_mouse(maze, robot))
