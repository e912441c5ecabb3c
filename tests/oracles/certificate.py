#!/usr/bin/env python3
"""A second judge of certificates, with nothing but Python's integers: docs/certificates.md, "What makes it a proof".

usage: certificate.py WORLD CERTIFICATE      WORLD is what `taut convert --as integers` writes
       exit codes: 0 proven, 1 not proven, 3 a file that cannot be read
"""

import json
import math
import sys
from fractions import Fraction


def side(p, q, r):
    """> 0 where r lies to the left of p -> q."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def cross(d, e):
    return d[0] * e[1] - d[1] * e[0]


def dot(p, d, q):
    return d[0] * (q[0] - p[0]) + d[1] * (q[1] - p[1])


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


class World:
    """Edges (a, b, polygon), solid on the left of those of polygons; which polygons are areas; corners."""

    def __init__(self, text, scale):
        self.edges, self.areas, self.unit = [], [], None
        for line in text.splitlines():
            word, *numbers = line.split()
            if word == "unit":
                self.unit = Fraction(numbers[0])
            if word not in ("area", "solid", "hole", "wall"):
                continue
            n = [int(x) * scale for x in numbers]
            ring = list(zip(n[::2], n[1::2]))
            if word == "wall":
                self.edges.append((*ring, None))
                continue
            if word != "hole":
                self.areas.append(word == "area")
            low = ring.index(min(ring))
            turn = side(ring[low - 1], ring[low], ring[(low + 1) % len(ring)])
            if (turn > 0) == (word == "hole"):
                raise ValueError("a ring goes the wrong way round")
            if self.areas[-1]:
                ring.reverse()
            self.edges += [(p, q, len(self.areas) - 1) for p, q in zip(ring, ring[1:] + ring[:1])]
        self.corners = self.find_corners()

    def find_corners(self):
        """By place: what leaves it farthest clockwise and counter-clockwise, within less than half a turn."""
        leaving = {}
        for a, b, polygon in self.edges:
            leaving.setdefault(a, []).append((minus(b, a), polygon))
            leaving.setdefault(b, []).append((minus(a, b), None))
        by_x = sorted(leaving)
        corners = {}
        for p, out in leaving.items():
            for right, _ in out:
                for left, polygon in out:
                    within = all(cross(right, d) >= 0 and cross(d, left) >= 0 and dot((0, 0), d, right) >
                                 (0 if cross(d, right) == 0 else -math.inf) for d, _ in out)
                    if within and (cross(right, left) > 0 or dot((0, 0), right, left) > 0):
                        solid = any(cross(d, left) == 0 and of is not None for d, of in out)
                        if not solid:
                            corners[p] = (right, left)
        for a, b, _ in self.edges:  # where one passes, nothing bends
            for p in by_x if len(by_x) < 50 else self.between(by_x, a, b):
                if p in corners and p != a and p != b and side(a, b, p) == 0 and dot(p, minus(a, p), b) < 0:
                    del corners[p]
        return corners

    @staticmethod
    def between(places, a, b):
        from bisect import bisect_left, bisect_right
        return places[bisect_left(places, min(a, b)):bisect_right(places, max(a, b))]

    def is_solid(self, p, d):
        """Is where p is moved along d by next to nothing no place, to the left of d and to the right of it?"""
        steps = [(d, (-d[1] * s, d[0] * s)) for s in (1, -1)]
        return all(self.is_solid_at(p, step) for step in steps)

    def is_solid_at(self, p, step):
        def at(value):  # the sign of value(p), or of how it grows along the steps
            return next((value(q) for q in [None, *step] if value(q) != 0), 0)
        inside = [False] * len(self.areas)
        for a, b, polygon in self.edges:
            if polygon is None:
                continue
            left = [at(lambda q, e=e: p[0] - e[0] if q is None else q[0]) > 0 for e in (a, b)]
            above = at(lambda q: side(a, b, p) if q is None else cross(minus(b, a), q)) > 0
            if left[0] != left[1] and above != (a[0] < b[0]):
                inside[polygon] = not inside[polygon]
        free = not any(self.areas) or any(i and area for i, area in zip(inside, self.areas))
        return not free or any(i and not area for i, area in zip(inside, self.areas))


def leg(world, edges, u, v, ends, turns=(0, 0)):
    """The edge that crosses it; True where it is closed, None where it is open."""
    d, contacts = minus(v, u), []
    length = dot(u, d, v)
    if u in ends and world.is_solid(u, d):
        return True
    for edge in edges:
        a, b, polygon = edge
        left_a, left_b = side(u, v, a), side(u, v, b)
        if (left_a > 0 and left_b > 0) or (left_a < 0 and left_b < 0):
            continue
        at_a, at_b = dot(u, d, a), dot(u, d, b)
        if left_a == left_b == 0:
            low, high = max(min(at_a, at_b), 0), min(max(at_a, at_b), length)
            solid = polygon is not None and low < high
            contacts.append((low, high, solid and at_a < at_b, solid and at_a > at_b))
        elif left_a == 0 or left_b == 0:
            at = at_a if left_a == 0 else at_b
            contacts.append((at, at, left_a + left_b > 0, left_a + left_b < 0))
        else:
            side_u, side_v = side(a, b, u), side(a, b, v)
            if side_u * side_v < 0:
                return edge
            contacts += [(t, t, True, True) for t, s in ((0, side_u), (length, side_v)) if s == 0]
    touch = [c for c in contacts if 0 <= c[0] <= c[1] <= length and
             not (c[0] == c[1] and ((c[0] == 0 and u in ends) or (c[0] == length and v in ends)))]
    touch += [(t, t, turn > 0, turn < 0) for t, turn in zip((0, length), turns) if turn]
    end, left, right = -1, False, False
    for c in sorted(touch):
        if c[0] > end:
            left = right = False
        end, left, right = max(end, c[1]), left or c[2], right or c[3]
        if left and right:
            return True
    return None


def is_tangent(corner, d):
    return corner is None or not (cross(corner[0], d) * cross(corner[1], d) < 0)


def refutation(world, numbers, listed, ends, bits):
    """An open leg from a listed place that is shorter than the numbers (low, high) of its ends differ."""
    corner = {p: None if p in ends else world.corners[p] for p in numbers}
    for u in listed:
        def away(e):
            return max(min(e[0][0], e[1][0]) - u[0], u[0] - max(e[0][0], e[1][0]), 0) + max(
                min(e[0][1], e[1][1]) - u[1], u[1] - max(e[0][1], e[1][1]), 0)
        edges, blockers = sorted(world.edges, key=away), []
        for v in sorted(numbers, key=lambda v: abs(v[0] - u[0]) + abs(v[1] - u[1])):
            differ = max(numbers[u][1] - numbers[v][0], numbers[v][1] - numbers[u][0])
            d = minus(v, u)
            if differ <= 0 or differ * differ <= (d[0] * d[0] + d[1] * d[1]) << (2 * bits):
                continue
            if not is_tangent(corner[u], d) or not is_tangent(corner[v], d):
                continue
            if any(side(a, b, v) < 0 and side(u, a, v) > 0 and side(u, b, v) < 0 for a, b in reversed(blockers)):
                continue
            found = leg(world, edges, u, v, ends)
            if found is None:
                return u, v
            if found is not True:
                blockers.append(found[:2] if side(found[0], found[1], u) > 0 else (found[1], found[0]))
    return None


def holds(a, b, p):
    return side(a, b, p) == 0 and dot(p, minus(a, p), b) <= 0


def joins(world, p, q):
    return any(holds(a, b, p) and holds(a, b, q) for a, b, _ in world.edges)


def fault(world, path, ends):
    turns = [0, *(side(*path[i - 1:i + 2]) for i in range(1, len(path) - 1)), 0]
    for i in range(len(path) - 1):
        u, v = path[i], path[i + 1]
        bends = (turns[i + 1] != 0 and (v in world.corners or v in ends)) or not joins(world, v, v)
        if u == v or (i + 2 < len(path) and not bends):
            return f"the path bends at {v}, on a wall"
        if leg(world, world.edges, u, v, ends, (turns[i], turns[i + 1])) is not None:
            return f"the path does not get from {u} to {v}"
    return None


def squared(p, a, b=None):
    """Of the distance of p from the place a, or the segment a b, as a fraction."""
    d = minus(b, a) if b else (0, 0)
    along, length = dot(a, d, p), dot((0, 0), d, d)
    if along <= 0 or along >= length:
        q = a if along <= 0 else b
        return Fraction(dot(p, minus(q, p), q))
    return Fraction(side(a, b, p) ** 2, length)


def passage(world, chain, ends, wide):
    """Why no closed chain of pieces and gates, links with squares up to wide, is between both ends."""
    between = False
    for p, q in zip(chain, chain[1:] + chain[:1]):
        gate = squared(p, q) <= wide and joins(world, p, p) and joins(world, q, q)
        if not gate and not joins(world, p, q):
            return f"the chain is open from {p} to {q}"
        for end in ends:
            if holds(p, q, end):
                return f"the chain passes through {end}"
            between ^= (p[1] > end[1]) != (q[1] > end[1]) and (side(p, q, end) > 0) == (q[1] > p[1])
            between |= len(chain) == 1 and 4 * squared(end, p) <= wide
    return None if between else "the chain separates nothing"


def nearness(world, path, r):
    for u, v in zip(path, path[1:] + path[-1:]):
        for a, b, _ in world.edges:
            if min(squared(u, a, b), squared(v, a, b), squared(a, u, v), squared(b, u, v)) < r * r:
                return f"the path comes too near to a wall from {u} to {v}"
    return None


def judge_disc(world, claim, path):
    widest, width, keeps = claim["kind"] == "widest", claim["width"], claim.get("keeps", 0)
    if width < 0 or keeps < 0:
        raise ValueError("out of range")
    wrong = fault(world, path, {path[0], path[-1]}) if widest else None
    wrong = wrong or passage(world, [tuple(p) for p in claim["chain"]], (path[0], path[-1]), width**2 - (not widest))
    wrong = wrong or (nearness(world, path, keeps) if widest else None)
    unit = world.unit / claim["scale"]
    proven = f"no disc of radius {float(unit * width / 2)!r} gets through"
    if widest:
        proven = f"{proven} if it is larger; the path keeps {float(unit * keeps)!r}"
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
    none, bits = claim["kind"] == "none", claim.get("fraction_bits", 0)
    if claim["format"] != "taut certificate 1" or claim["kind"] not in ("none", "shortest", "widest") or claim["scale"] < 1:
        raise ValueError("another format")
    if claim["world"] != fingerprint(text):
        return None, "the certificate is of another world"
    world, path = World(text, claim["scale"]), [tuple(p) for p in claim["path"]]
    if claim["kind"] == "widest" or "chain" in claim:
        return judge_disc(world, claim, path)
    ends = {path[0], path[-1]}
    listed = {(x, y): n for x, y, n in claim["potentials"] if (x, y) in world.corners or (x, y) in ends}
    numbers = {p: (n, n) for p, n in listed.items()}
    for p in (ends | set(world.corners)) - set(listed):
        d = minus(p, path[-1])
        away = math.isqrt((d[0] * d[0] + d[1] * d[1]) << (2 * bits))
        numbers[p] = (2**200, 2**200) if none else (claim["horizon"] - away - 1, claim["horizon"] - away)
    wrong = None if none else fault(world, path, ends)
    if wrong or path[0] not in listed or (path[-1] in listed) == none:
        return None, wrong or "an end is listed, or is not"
    found = refutation(world, numbers, listed, ends, bits)
    if found:
        return None, f"nothing stops the leg {found[0]}-{found[1]}"
    step = world.unit / claim["scale"] / 2**bits
    bound = (listed[path[-1]] - listed[path[0]]) * step if not none else 0
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
