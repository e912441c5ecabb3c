"""A robot for next_move.py: it goes down the gradient of its own map, unknown walls taken for open, and resets at the
goal."""

import collections

STEPS = [(0, 1), (1, 0), (0, -1), (-1, 0)]  # north, east, south, west


def ahead(cell, heading):
    return cell[0] + STEPS[heading][0], cell[1] + STEPS[heading][1]


class Robot:
    def __init__(self, maze_dim):
        self.side = maze_dim
        middle = (maze_dim // 2 - 1, maze_dim // 2)
        self.goal = {(x, y) for x in middle for y in middle}
        self.walls = set()
        self.cell, self.heading, self.racing = (0, 0), 0, False

    def is_inside(self, cell):
        return all(0 <= c < self.side for c in cell)

    def see(self, sensors):
        for turn, free in zip((-1, 0, 1), sensors):
            cell, heading = self.cell, (self.heading + turn) % 4
            for _ in range(free):
                cell = ahead(cell, heading)
            self.walls |= {(cell, heading), (ahead(cell, heading), (heading + 2) % 4)}

    def distances(self):
        distance, queue = dict.fromkeys(self.goal, 0), collections.deque(self.goal)
        while queue:
            cell = queue.popleft()
            for heading in range(4):
                other = ahead(cell, heading)
                if self.is_inside(other) and other not in distance and (cell, heading) not in self.walls:
                    distance[other] = distance[cell] + 1
                    queue.append(other)
        return distance

    def next_move(self, sensors):
        self.see(sensors)
        if self.cell in self.goal and not self.racing:
            self.cell, self.heading, self.racing = (0, 0), 0, True
            return "Reset", "Reset"
        distance = self.distances()
        turns = [turn for turn, free in zip((-1, 0, 1), sensors) if free > 0]
        if not turns:  # a dead end: around in two steps
            self.heading = (self.heading + 1) % 4
            return 90, 0
        turn = min(turns, key=lambda t: (distance[ahead(self.cell, (self.heading + t) % 4)], abs(t)))
        self.heading = (self.heading + turn) % 4
        self.cell = ahead(self.cell, self.heading)
        return 90 * turn, 1
