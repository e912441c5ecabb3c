"""The PRM homework: sample a roadmap among obstacles, find a path, see how far from the shortest it is."""

import numpy as np

import taut

rng = np.random.default_rng(4)
corners = rng.uniform(1, 8, (12, 2))
squares = [[(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)] for x, y in corners]
world = taut.World(areas=[[(0, 0), (10, 0), (10, 10), (0, 10)]], solids=squares, start=(0.5, 0.5), goal=(9.5, 9.5))
space = taut.FreeSpace(world)
roadmap = taut.roadmap(space, "prm", samples=2000, connection="nearest:10", seed=1)
path = roadmap.find()
shortest = taut.shortest_path(space)
print(f"{len(roadmap)} milestones, {len(roadmap.edges)} edges")
print(f"length {path.length:.3f}, {path.length / shortest.length:.3f} times the shortest")
print(f"clearance {path.clearance:.3f}")
assert path.verify()
