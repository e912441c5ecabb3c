#!/usr/bin/env python3
"""A second judge of certificates, with nothing but Python's integers: docs/certificates.md, "What makes it a proof".

usage: certificate.py WORLD CERTIFICATE      WORLD is what `taut convert --as integers` writes
       exit codes: 0 proven, 1 not proven, 3 a file that cannot be read

A goal that is a room is for certificate_of_room.py, which has the same usage.
"""

import json
import math
import sys
from fractions import Fraction

INFINITE = 2**400  # more than any number that a certificate can give
TINY = Fraction(1, 2**1000)  # less than whatever stands apart is apart


class Refused(Exception):
    """What is wrong with a certificate that can be read."""


def require(is_so, words, error=Refused):
    if not is_so:
        raise error(words)


def whole(word):
    require(abs(number := int(word)) < 2**62, f"{word} is out of range", ValueError)
    return number


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
    return (a[0] <= p[0] <= b[0] or b[0] <= p[0] <= a[0]) and side(a, b, p) == 0 >= dot(minus(a, p), minus(b, p))


def passes(a, b, p):
    """How a -> b gets past the ray from p upwards: 1 to the left, -1 to the right, 0 not at all."""
    return ((a[0] > p[0]) - (b[0] > p[0])) * ((side(a, b, p) > 0) == (a[0] > b[0]))


def gap(a, b, p):
    """From p to the box between a and b, in x and in y."""
    return tuple(max(min(s, t) - c, c - max(s, t), 0) for s, t, c in zip(a, b, p))


def squared(p, a, b):
    """Of the distance of p from the segment a b, as a fraction."""
    d, from_a, from_b = minus(b, a), minus(p, a), minus(p, b)
    beside = dot(d, from_a) > 0 > dot(d, from_b)
    return Fraction(cross(d, from_a) ** 2, dot(d, d)) if beside else min(dot(from_a, from_a), dot(from_b, from_b))


def is_corner(out):
    """Is all that stands there within less than half a turn, and no solid in the rest?"""
    return (any(all(cross(d, e) > 0 or cross(d, e) == 0 < dot(d, e) for e, _ in out) for d, _ in out) and
            not any(solid and all(cross(d, e) <= 0 for e, _ in out) for d, solid in out))


def fingerprint(text):
    value = 0xCBF29CE484222325
    lines = (line + "\n" for line in text.splitlines() if not line.startswith(("start ", "goal ")))
    for byte in "".join(lines).encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


class Judge:
    """Of a world: edges (a, b, is_side), solid on the left of sides; at each corner the directions of what stands."""

    goals = ([True, True],)  # is it flat in x, in y: points

    def __init__(self, text, certificate):
        self.claim = claim = json.loads(certificate, parse_int=whole, parse_float=str, parse_constant=str)
        is_known = claim["format"] == "taut certificate 1" and claim["kind"] in ("none", "shortest", "widest")
        require(is_known and claim["scale"] > 0, "another format", ValueError)
        require(claim["world"] == fingerprint(text), "the certificate is of another world")
        self.path = [tuple(p) for p in claim["path"]]
        self.goal = [tuple(map(extreme, zip(*claim["goal"]))) for extreme in (min, max)]
        require([s == t for s, t in zip(*self.goal)] in self.goals, "the goal has no area, or is a room", ValueError)
        self.ends = self.goal[:1]  # where in the goal a shortest path may end
        lines = [line.split() for line in text.splitlines()]
        self.unit = Fraction(dict(words[:2] for words in lines)["unit"]) / claim["scale"]
        self.edges, self.has_area, area = [], False, False
        for word, *numbers in (words for words in lines if words[0] in ("area", "solid", "hole", "wall")):
            numbers, is_side = [whole(number) * claim["scale"] for number in numbers], word != "wall"
            ring = list(zip(numbers[::2], numbers[1::2]))
            sides = list(zip(ring, ring[1:] + ring[:1] * is_side))
            turns_left = sum(cross(p, q) for p, q in sides) > 0
            is_right = turns_left == (word != "hole") if is_side else len(sides) == 1
            require(is_right, f"a {word} has too many places, or goes the wrong way round", ValueError)
            area = word == "area" or (area and word != "solid")
            self.has_area |= area
            self.edges += [(q, p, is_side) if area else (p, q, is_side) for p, q in sides]
        places = {p for edge in self.edges for p in edge[:2]}
        self.corners = {p: [d for d, _ in out] for p in places if is_corner(out := self.leaving(p))}

    def leaving(self, p):
        """What stands at p: directions, and whether a solid is to their left."""
        standing = [edge for edge in self.edges if holds(*edge[:2], p)]
        return [(minus(q, p), solid) for a, b, is_side in standing for q, solid in ((b, is_side), (a, False)) if q != p]

    def joins(self, p, q):
        return any(holds(a, b, p) and holds(a, b, q) for a, b, _ in self.edges)

    def is_solid(self, p):
        """Of a place on no side. Areas, which do not overlap, count for what is outside."""
        return self.has_area + sum(passes(a, b, p) for a, b, is_side in self.edges if is_side) > 0

    def leg(self, edges, u, v, u_ends, v_ends, touches=()):
        """The edge that crosses it; True where it is closed otherwise, None where it is open. Touches: from where to
        where something is, and which sides it closes (True: the left); at an end of the path no edge does."""
        d, touches = minus(v, u), list(touches)
        for a, b, is_side in edges:
            s, t = side(u, v, a), side(u, v, b)
            if s * t > 0:
                continue
            if s * t < 0 and side(a, b, u) * side(a, b, v) < 0:
                return a, b, is_side
            at_a, at_b = dot(d, minus(a, u)), dot(d, minus(b, u))
            if s != t:
                at_a = at_b = Fraction(at_a * t - at_b * s, t - s)
            low, high = max(min(at_a, at_b), 0), min(max(at_a, at_b), dot(d, d))
            if low <= high and not (u_ends and high == 0) and not (v_ends and low == dot(d, d)):
                along = at_b - at_a if is_side and low < high else 0
                touches.append((low, high, {turn > 0 for turn in (s, t, along) if turn}))
        reach, closed = -1, set()
        for low, high, closes in sorted(touches, key=lambda touch: touch[:2]):
            closed = closes | closed if low <= reach else closes
            reach = max(reach, high)
            if closed == {True, False}:
                return True
        beside = ((u[0] + TINY * (d[0] - n * d[1]), u[1] + TINY * (d[1] + n * d[0])) for n in (TINY, -TINY))
        return (u_ends and all(map(self.is_solid, beside))) or None

    def judge_path(self):
        path, turns = self.path, [0, *map(side, self.path, self.path[1:], self.path[2:]), 0]
        for i, (u, v, *bends) in enumerate(zip(path, path[1:], turns, turns[1:]), 2):
            end = i == len(path)
            require(end or (bends[1] and v in self.corners) or not self.joins(v, v), f"the path bends on a wall at {v}")
            touches = [(at, at, {bend > 0}) for at, bend in zip((0, squared(u, v, v)), bends) if bend]
            is_open = u != v and not self.leg(self.edges, u, v, i == 2, end, touches)
            require(is_open, f"the path does not get from {u} to {v}")
        require(gap(*self.goal, path[-1]) == (0, 0), "the path does not end in the goal")

    def judge_numbers(self):
        """No open leg from a listed place is shorter than the numbers of its ends differ."""
        claim, start, bits, none = self.claim, self.path[0], self.claim["fraction_bits"], self.claim["kind"] == "none"
        horizon, reach = (INFINITE, INFINITE - 1) if none else (claim["horizon"], claim["reach"])
        require(reach < horizon and 0 <= bits < 60, "out of range", ValueError)
        listed, corners = {(x, y): n for x, y, n in claim["potentials"]}, {**self.corners, start: []}
        require(start in listed, "the start is not listed")
        require(reach <= listed[start] or gap(*self.goal, start) != (0, 0), "the start is in the goal")
        nodes = [(p, [], INFINITE, reach) for p in self.ends]  # nothing leads away from there
        for p, corner in corners.items():
            least = horizon - math.isqrt(dot(away := gap(*self.goal, p), away) * 4**bits) - 1
            nodes.append((p, corner, listed.get(p, least), listed.get(p, least + 1)))
        for u in corners.keys() & listed.keys():
            edges, crossing = sorted(self.edges, key=lambda edge: sum(gap(*edge[:2], u))), {}
            for v, corner, low, high in sorted(nodes, key=lambda node: sum(gap(node[0], node[0], u))):
                d, differ = minus(v, u), max(listed[u] - low, high - listed[u], 0)
                turns = ([cross(e, d) for e in out] for out in (corners[u], corner) if out)
                if u == v or differ**2 <= dot(d, d) * 4**bits or any(min(t) < 0 < max(t) for t in turns):
                    continue
                found = self.leg([*reversed(crossing), *edges], u, v, u == start, corner == [])
                require(found, f"nothing stops the leg {u}-{v}")
                crossing.update({} if found is True else {found: found})
        bound = float((reach - listed[start]) * self.unit / 2**bits)
        return "there is no path" if none else f"no path is shorter than {bound!r}"

    def judge_disc(self):
        claim, path, none, between = self.claim, self.path, self.claim["kind"] == "none", False
        chain, width, keeps = [tuple(p) for p in claim["chain"]], claim["width"], 0 if none else claim["keeps"]
        require(width >= 0 and keeps >= 0, "out of range", ValueError)
        for p, q in zip(chain, chain[1:] + chain[:1]):
            is_gate = squared(p, q, q) <= width**2 - none and self.joins(p, p) and self.joins(q, q)
            require(is_gate or self.joins(p, q), f"the chain is open from {p} to {q}")
            for end in (path[0], path[-1]):
                require(not holds(p, q, end), f"the chain passes through {end}")
                between ^= passes(p, q, end) != 0
                between |= len(chain) == 1 and 4 * squared(end, p, p) <= width**2 - none
        require(between, "the chain separates nothing")
        for u, v in zip(path, path[1:] + path[-1:]):
            near = min(squared(*c) for a, b, _ in self.edges for c in ((u, a, b), (v, a, b), (a, u, v), (b, u, v)))
            require(near >= keeps**2, f"the path comes too near to a wall from {u} to {v}")
        radius, kept = float(self.unit * width / 2), float(self.unit * keeps)
        return f"no disc of radius {radius!r} gets through" + ("" if none else f" if larger; the path keeps {kept!r}")

    def verdict(self):
        """What is proven."""
        if self.claim["kind"] != "none":
            self.judge_path()
        return self.judge_disc() if self.claim["kind"] == "widest" or "chain" in self.claim else self.judge_numbers()


def main(judge=Judge):
    try:
        with open(sys.argv[1], encoding="utf-8") as world, open(sys.argv[2], encoding="utf-8") as claim:
            code, words = 0, f"proven: {judge(world.read(), claim.read()).verdict()}"
    except Refused as refused:
        code, words = 1, f"not proven: {refused}"
    except (OSError, ValueError, TypeError, LookupError, ArithmeticError) as error:
        code, words = 3, f"cannot be read: {error!r}"
    print(words, file=sys.stderr if code == 3 else sys.stdout)
    return code


if __name__ == "__main__":
    sys.exit(main())
