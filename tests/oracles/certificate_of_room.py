#!/usr/bin/env python3
"""The judge of certificate.py, of goals that are rooms as well: docs/certificates.md, "Rooms"."""

import sys
from fractions import Fraction

from certificate import Judge, cross, gap, main, minus, side, squared


def is_between(p, d, q):
    """Is d on the turn to the left from p to q?"""
    return (cross(p, d) > 0) + (cross(d, q) > 0) + (cross(p, q) <= 0) >= 2


class RoomJudge(Judge):
    goals = (*Judge.goals, [False, False])

    def __init__(self, text, certificate):
        """Ends are its corners, feet of perpendiculars, and where edges meet the border."""
        super().__init__(text, certificate)
        found, start, lines = set(), self.path[0], [(i, corner[i]) for corner in self.goal for i in (0, 1)]
        for a, b, _ in [*self.edges, (start, start, False), (*self.goal, False)]:
            for i, line in lines:
                across = {a[1 - i], b[1 - i]}
                if (a[i] - line) * (b[i] - line) < 0:
                    across.add(a[1 - i] + Fraction((b[1 - i] - a[1 - i]) * (line - a[i]), b[i] - a[i]))
                found.update((line, y) if i == 0 else (y, line) for y in across)
        self.ends = [p for p in found if gap(*self.goal, p) == (0, 0)]

    def leg(self, edges, u, v, u_ends, v_ends, touches=()):
        return super().leg(edges, u, v, u_ends, v_ends, [*touches, *(self.bars(u, v) if v_ends else [])])

    def bars(self, u, v):
        """Around the left, around the right: what stops a path from u, to the border at v, on its way in."""
        low, high = self.goal
        if low == high or gap(low, high, v) != (0, 0):  # a leg to the start ends at no border
            return []
        back, inside, end = minus(u, v), minus(minus(low, v), minus(v, high)), squared(u, v, v)
        near = tuple(min(max(c, least), most) for c, least, most in zip(u, low, high))
        turn = cross(back, inside) if near != v and side(v, near, u) == 0 else 0  # along the border it comes outside
        aside = [d for d, _ in self.leaving(v) if not all(
            (v[i] > low[i] or d[i] > 0) and (v[i] < high[i] or d[i] < 0) for i in (0, 1))]
        is_left = turn < 0 or any(is_between(inside, d, back) for d in aside)
        is_right = turn > 0 or any(is_between(back, d, inside) for d in aside)
        return [(end, end, {is_left for is_left, is_barred in ((True, is_left), (False, is_right)) if is_barred})]


if __name__ == "__main__":
    sys.exit(main(RoomJudge))
