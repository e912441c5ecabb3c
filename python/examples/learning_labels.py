"""Labels for learning: of a million states of a maze the exact distance to the goal, and the next direction.

usage: learning_labels.py [SIDE]
"""

import sys
import time

import numpy as np

import taut

side = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
blocked = np.random.default_rng(1).random((side, side)) < 0.3
goal = (side // 2, side // 2)
blocked[goal] = False
begin = time.process_time()
distance, direction = taut.Grid(blocked, moves="octile").distances_to(goal)
seconds = time.process_time() - begin
reached = np.isfinite(distance)
print(f"{blocked.size} states, {reached.sum()} reach the goal, labels in {seconds:.2f} s CPU")
moves = np.array(taut.GRID_MOVES)
rows, columns = np.nonzero(direction >= 0)
following = np.stack([rows, columns]) + moves[direction[rows, columns]].T
step = np.hypot(*moves[direction[rows, columns]].T)
assert np.allclose(distance[rows, columns], distance[tuple(following)] + step)  # every label leads one step nearer

# The same between walls, off any grid: exact distances of random places, without the grid's detours.
finder = taut.Polyanya(taut.FreeSpace(taut.read_world_file("data/maze_45x45.txt")))
states = np.random.default_rng(2).uniform(0.5, 45.5, (side, 2))
begin = time.process_time()
answers = finder.find_many(np.hstack([states, np.broadcast_to(finder.space.world.goal, states.shape)]), paths=True)
second = answers.points[answers.offsets[:-1] + 1] - states  # where each shortest path turns first
heading = np.arctan2(second[:, 1], second[:, 0])
seconds = time.process_time() - begin
print(f"{side} places of a maze in {seconds:.2f} s CPU; the first: {answers.length[0]:.6f}, {heading[0]:.6f} rad")
