#!/usr/bin/env python3
"""A second judge of certificates, with nothing but Python's integers: docs/certificates.md, "What makes it a proof".

usage: certificate.py WORLD CERTIFICATE      WORLD is what `taut convert --as integers` writes
       exit codes: 0 proven, 1 not proven, 3 a file that cannot be read
"""

import json
import math
import sys
from fractions import Fraction


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def cross(d, e):
    return d[0] * e[1] - d[1] * e[0]


def dot(d, e):
    return d[0] * e[0] + d[1] * e[1]


def side(p, q, r):
    """> 0 where r lies to the left of p -> q."""
    return cross(minus(q, p), minus(r, p))


def holds(a, b, p):
    return side(a, b, p) == 0 and dot(minus(a, p), minus(b, p)) <= 0


class World:
    """Edges (a, b, is_side), solid on the left of sides; corners."""

    def __init__(self, text, scale):
        self.edges, self.unit, self.has_area, area = [], None, False, False
        for line in text.splitlines():
            word, *numbers = line.split()
            if word == "unit":
                self.unit = Fraction(numbers[0]) / scale
            if word not in ("area", "solid", "hole", "wall"):
                continue
            n = [int(x) * scale for x in numbers]
            ring = list(zip(n[::2], n[1::2]))
            if word == "wall":
                self.edges.append((*ring, False))
                continue
            low = ring.index(min(ring))
            if (side(ring[low - 1], ring[low], ring[(low + 1) % len(ring)]) > 0) == (word == "hole"):
                raise ValueError("a ring goes the wrong way round")
            area = word == "area" or (area and word == "hole")
            self.has_area |= area
            ring = ring[::-1] if area else ring
            self.edges += [(p, q, True) for p, q in zip(ring, ring[1:] + ring[:1])]
        places = {p for edge in self.edges for p in edge[:2]}
        self.corners = {p: corner for p in places if (corner := self.corner_at(p))}

    def leaving(self, p):
        """What stands at p: directions, and whether a solid is to their left."""
        for a, b, is_side in self.edges:
            if (a[0] <= p[0] <= b[0] or b[0] <= p[0] <= a[0]) and holds(a, b, p):
                yield from ((minus(q, p), solid) for q, solid in ((b, is_side), (a, False)) if q != p)

    def corner_at(self, p):
        """What leaves p farthest clockwise and counter-clockwise, all of it within less than half a turn."""
        out = list(self.leaving(p))
        for right, _ in out:
            for left, _ in out:
                if all(cross(right, d) >= 0 <= cross(d, left) and (cross(right, left) > 0 or dot(right, d) > 0) and
                       not (solid and cross(d, left) == 0) for d, solid in out):
                    return right, left
        return None

    def is_solid(self, p, d):
        """Is where p is moved along d by next to nothing no place, neither to the left of d nor to the right?"""
        n = 2**200
        return all(self.around((p[0] * n * n + d[0] * n - s * d[1], p[1] * n * n + d[1] * n + s * d[0]), n * n) > 0
                   for s in (1, -1))

    def around(self, q, n):
        """How many solids are around q / n; areas, which do not overlap, count for what is outside."""
        total = int(self.has_area)
        for a, b, is_side in self.edges:
            a, b = (a[0] * n, a[1] * n), (b[0] * n, b[1] * n)
            if is_side and (a[0] > q[0]) != (b[0] > q[0]) and (side(a, b, q) > 0) == (a[0] > b[0]):
                total += 1 if a[0] > b[0] else -1
        return total

    def joins(self, p, q):
        return any(holds(a, b, p) and holds(a, b, q) for a, b, _ in self.edges)


def leg(world, edges, u, v, u_ends, v_ends, at_u=(False, False), at_v=(False, False)):
    """The edge that crosses it; True where it is closed, None where it is open. At the ends left and right may be."""
    d, touch = minus(v, u), []
    length = dot(d, d)
    if u_ends and world.is_solid(u, d):
        return True
    for a, b, is_side in edges:
        s, t = side(u, v, a), side(u, v, b)
        if (s > 0 and t > 0) or (s < 0 and t < 0):
            continue
        at_a, at_b = dot(d, minus(a, u)), dot(d, minus(b, u))
        if s == t == 0:
            low, high = max(min(at_a, at_b), 0), min(max(at_a, at_b), length)
            solid = is_side and low < high
            touch.append((low, high, solid and at_a < at_b, solid and at_a > at_b))
        elif s == 0 or t == 0:
            touch.append((at_a if s == 0 else at_b,) * 2 + (s + t > 0, s + t < 0))
        else:
            side_u, side_v = side(a, b, u), side(a, b, v)
            if side_u * side_v < 0:
                return a, b
            touch += [(end, end, True, True) for end, on in ((0, side_u), (length, side_v)) if on == 0]
    aside = ([(0, 0)] if u_ends else []) + ([(length, length)] if v_ends else [])
    touch = [c for c in touch if 0 <= c[0] <= c[1] <= length and c[:2] not in aside]
    touch += [(0, 0, *at_u), (length, length, *at_v)]
    reach, left, right = -1, False, False
    for low, high, closes_left, closes_right in sorted(touch):
        left, right = (left or closes_left, right or closes_right) if low <= reach else (closes_left, closes_right)
        reach = max(reach, high)
        if left and right:
            return True
    return None


class Goal:
    """A room, its least and its greatest corner; a point is one, too."""

    def __init__(self, world, places):
        self.world, self.min, self.max = world, *(tuple(map(f, zip(*places))) for f in (min, max))

    def away(self, p):
        return tuple(max(self.min[i] - p[i], p[i] - self.max[i], 0) for i in (0, 1))

    def barred(self, u, v):
        """Around the left, around the right: does something stop a path from u, to the border at v, on its way in?"""
        def between(p, d, q):  # d, on the turn to the left from p to q
            from_p, to_q = cross(p, d) > 0, cross(d, q) > 0
            return (from_p and to_q) if cross(p, q) > 0 else (from_p or to_q)
        back, inside = minus(u, v), minus(minus(self.min, v), minus(v, self.max))
        near = tuple(min(max(u[i], self.min[i]), self.max[i]) for i in (0, 1))
        turn = cross(back, inside) if near != v and side(v, near, u) == 0 else 0  # along the border it comes outside
        aside = [d for d, _ in self.world.leaving(v) if not all(
            (v[i] > self.min[i] or d[i] > 0) and (v[i] < self.max[i] or d[i] < 0) for i in (0, 1))]
        if self.min == self.max:
            return False, False
        return (turn < 0 or any(between(inside, d, back) for d in aside),
                turn > 0 or any(between(back, d, inside) for d in aside))

    def ends(self, start):
        """Its corners, feet of perpendiculars, and where edges meet the border."""
        found = set()
        for a, b, _ in [*self.world.edges, (start, start, False), (self.min, self.max, False)]:
            for i, line in ((0, self.min[0]), (0, self.max[0]), (1, self.min[1]), (1, self.max[1])):
                across = [a[1 - i], b[1 - i]]
                if (a[i] - line) * (b[i] - line) < 0:
                    across.append(a[1 - i] + Fraction((b[1 - i] - a[1 - i]) * (line - a[i]), b[i] - a[i]))
                found |= {(line, y) if i == 0 else (y, line) for y in across}
        found = {p for p in found if self.away(p) == (0, 0)}
        if any(Fraction(x).denominator > 1 for p in found for x in p):
            raise ValueError("an edge meets the border between multiples of the unit")
        return [tuple(map(int, p)) for p in found]


def refutation(world, goal, nodes, bits):
    """An open leg from a listed place that is shorter than the numbers of its ends differ. Nodes: place, corner, low
    and high number, whether they are listed, whether they are ends of paths."""
    for u, corner, low, high, is_listed, _ in nodes:
        def away(e, u=u):
            return sum(max(min(a, b) - c, c - max(a, b), 0) for a, b, c in zip(e[0], e[1], u))
        edges, blockers = sorted(world.edges, key=away) if is_listed else [], []
        for v, other, other_low, other_high, _, is_goal in sorted(nodes, key=lambda n: away((n[0], n[0]))):
            differ, d = max(high - other_low, other_high - low), minus(v, u)
            if not is_listed or differ <= 0 or differ * differ <= dot(d, d) << (2 * bits):
                continue
            if any(c and cross(c[0], d) * cross(c[1], d) < 0 for c in (corner, other)) or u == v:
                continue
            if any(side(a, b, v) < 0 < side(u, a, v) and side(u, b, v) < 0 for a, b in reversed(blockers)):
                continue
            barred = goal.barred(u, v) if is_goal else (False, False)
            found = leg(world, edges, u, v, corner is None, other is None, at_v=barred)
            if found is None:
                return u, v
            if found not in (None, True):
                blockers.append(found if side(*found, u) > 0 else found[::-1])
    return None


def fault(world, goal, path):
    turns = [0, *(side(*path[i - 1:i + 2]) for i in range(1, len(path) - 1)), 0]
    for i, (u, v) in enumerate(zip(path, path[1:])):
        ends = i + 2 == len(path)
        if not ends and not (turns[i + 1] != 0 and v in world.corners) and world.joins(v, v):
            return f"the path bends at {v}, on a wall"
        at_u, at_v = ((turn > 0, turn < 0) for turn in turns[i:i + 2])
        if u == v or leg(world, world.edges, u, v, i == 0, ends, at_u, goal.barred(u, v) if ends else at_v):
            return f"the path does not get from {u} to {v}"
    return None if goal.away(path[-1]) == (0, 0) else f"the path ends at {path[-1]}, not in the goal"


def squared(p, a, b):
    """Of the distance of p from the segment a b, as a fraction."""
    d = minus(b, a)
    if dot(d, minus(p, a)) <= 0 or dot(d, minus(p, b)) >= 0:
        return min(dot(minus(p, q), minus(p, q)) for q in (a, b))
    return Fraction(side(a, b, p) ** 2, dot(d, d))


def passage(world, chain, ends, wide):
    """Why no closed chain of pieces and gates, links with squares up to wide, is between both ends."""
    between = False
    for p, q in zip(chain, chain[1:] + chain[:1]):
        gate = squared(p, q, q) <= wide and world.joins(p, p) and world.joins(q, q)
        if not gate and not world.joins(p, q):
            return f"the chain is open from {p} to {q}"
        for end in ends:
            if holds(p, q, end):
                return f"the chain passes through {end}"
            between ^= (p[1] > end[1]) != (q[1] > end[1]) and (side(p, q, end) > 0) == (q[1] > p[1])
            between |= len(chain) == 1 and 4 * squared(end, p, p) <= wide
    return None if between else "the chain separates nothing"


def nearness(world, path, r):
    for u, v in zip(path, path[1:] + path[-1:]):
        for a, b, _ in world.edges:
            if min(squared(u, a, b), squared(v, a, b), squared(a, u, v), squared(b, u, v)) < r * r:
                return f"the path comes too near to a wall from {u} to {v}"
    return None


def judge_disc(world, claim, path, wrong):
    width, keeps = claim["width"], claim["keeps"] if claim["kind"] == "widest" else 0
    if width < 0 or keeps < 0:
        raise ValueError("out of range")
    none = claim["kind"] == "none"
    wrong = wrong or passage(world, [tuple(p) for p in claim["chain"]], (path[0], path[-1]), width**2 - none)
    wrong = wrong or nearness(world, path, keeps)
    radius, keeps = float(world.unit * width / 2), float(world.unit * keeps)
    proven = f"no disc of radius {radius!r} gets through" + ("" if none else f" if larger; the path keeps {keeps!r}")
    return (None, wrong) if wrong else (proven, None)


def fingerprint(text):
    value = 0xCBF29CE484222325
    for line in text.splitlines():
        if not line.startswith(("start ", "goal ")):
            for byte in (line + "\n").encode():
                value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def judge(text, claim):
    """What is proven and None, or None and what is wrong."""
    kind, none = claim["kind"], claim["kind"] == "none"
    if claim["format"] != "taut certificate 1" or kind not in ("none", "shortest", "widest") or claim["scale"] < 1:
        raise ValueError("another format")
    if claim["world"] != fingerprint(text):
        return None, "the certificate is of another world"
    world, path = World(text, claim["scale"]), [tuple(p) for p in claim["path"]]
    goal, start = Goal(world, claim["goal"]), path[0]
    wrong = None if none else fault(world, goal, path)
    if kind == "widest" or "chain" in claim:
        return judge_disc(world, claim, path, wrong)
    bits, infinite = claim["fraction_bits"], 2**200
    horizon, reach = (infinite, infinite) if none else (claim["horizon"], claim["reach"])
    listed = {(x, y): n for x, y, n in claim["potentials"]}
    if wrong or start not in listed or (goal.away(start) == (0, 0) and reach > listed[start]):
        return None, wrong or "the start is not listed, or in the goal"
    is_line = (goal.min[0] == goal.max[0]) != (goal.min[1] == goal.max[1])
    if is_line or (not none and reach >= horizon):
        raise ValueError("out of range")
    nodes = [(p, None, infinite, reach, False, True) for p in goal.ends(start)]  # nothing leads away from there
    for p, corner in {**world.corners, start: None}.items():
        d = goal.away(p)
        least = horizon - (0 if none else math.isqrt(dot(d, d) << (2 * bits)) + 1)
        low, high = (listed[p], listed[p]) if p in listed else (least, least + (not none))
        nodes.append((p, corner, low, high, p in listed, False))
    if found := refutation(world, goal, nodes, bits):
        return None, f"nothing stops the leg {found[0]}-{found[1]}"
    bound = 0 if none else (reach - listed[start]) * world.unit / 2**bits
    return ("there is no path" if none else f"no path is shorter than {float(bound)!r}"), None


def main():
    try:
        with open(sys.argv[1], encoding="utf-8") as world, open(sys.argv[2], encoding="utf-8") as claim:
            proven, wrong = judge(world.read(), json.load(claim))
    except (OSError, ValueError, KeyError, TypeError, IndexError) as error:
        print(f"cannot be read: {error!r}", file=sys.stderr)
        return 3
    print(f"proven: {proven}" if proven else f"not proven: {wrong}")
    return 0 if proven else 1


if __name__ == "__main__":
    sys.exit(main())
