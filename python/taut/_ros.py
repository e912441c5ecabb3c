"""Maps as ROS publishes them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._taut import World, occupancy_world


def ros_world(
    data: ArrayLike,
    resolution: float,
    origin: tuple[float, float] = (0.0, 0.0),
    yaw: float = 0.0,
    *,
    occupied: int = 65,
    unknown_is_free: bool = False,
    source: str = "",
) -> World:
    """The World of a nav_msgs/OccupancyGrid: data (height, width), row 0 at the bottom, -1 or 0 to 100.

    That is np.reshape(msg.data, (msg.info.height, msg.info.width)). Metres, y up, the lower left corner at origin,
    turned by yaw around it. Cells of at least `occupied` are blocked, unknown ones unless `unknown_is_free`.
    """
    cells = np.asarray(data)
    if cells.ndim != 2:
        raise ValueError("data: an array (height, width)")
    blocked = cells >= occupied
    if not unknown_is_free:
        blocked |= cells < 0
    return occupancy_world(blocked[::-1], resolution=resolution, origin=origin, yaw=yaw, source=source)
