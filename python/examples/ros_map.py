"""A map as ROS has it, from memory: where may a round robot go, how wide is the narrowest door, and the way."""

import numpy as np

import taut

cells = np.zeros((60, 80), np.int8)  # nav_msgs/OccupancyGrid: row 0 at the bottom, 100 occupied, -1 unknown
cells[:, 40] = 100
cells[20:28, 40] = 0  # a door, 8 cells of 5 cm
cells[50:, :10] = -1
world = taut.ros_world(cells, resolution=0.05, origin=(-1.0, -1.0)).with_ends((-0.5, -0.5), (2.5, 1.5))
point = taut.FreeSpace(world)
print(f"the largest robot has radius {taut.Gates(point).passage().radius} m")
path = taut.shortest_path(world, footprint=taut.Footprint.disc(0.15))
print(f"a robot of 15 cm drives {path.length:.3f} m:")
print(np.round(path.points, 3)[:: max(1, len(path) // 5)])
assert path.verify() and taut.shortest_path(world, footprint=taut.Footprint.disc(0.25)) is None
