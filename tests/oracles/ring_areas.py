#!/usr/bin/env python3
"""Random broken polygons: the area of what `taut check` reads, against an exact sweep in rationals.

usage: ring_areas.py TAUT [FIRST [LAST]]     seeds, 0 to 100 by default; the standard library is enough

Each polygon is read as integers, as decimals, mirrored with --snap 0, far from the origin, and as thirds, which are
computed numbers; lengths scale, so areas must. Prints what differs; the exit code says whether anything did.
"""

import json
import random
import subprocess
import sys
from fractions import Fraction

# name: what becomes of a coordinate, of an area, and further options
COPIES = {
    "integers": (lambda v: v, 1, []),
    "decimals": (lambda v: round(v * 0.1, 1), 0.01, []),
    "mirrored": (lambda v: -v, 1, ["--snap", "0"]),
    "far": (lambda v: v * 1000 + 500000, 1e6, []),
    "thirds": (lambda v: v / 3, 1 / 9, []),
}


def sides(rings):
    """(ring, left end, right end) of all sides that are not vertical"""
    for k, ring in enumerate(rings):
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if a[0] != b[0]:
                yield k, min(a, b), max(a, b)


def crossing(s, t):
    """Where two sides meet, along x; nothing when they are parallel or do not."""
    (_, a, b), (_, c, d) = s, t
    r, q = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    turn = r[0] * q[1] - r[1] * q[0]
    if turn == 0:
        return None
    along = Fraction((c[0] - a[0]) * q[1] - (c[1] - a[1]) * q[0], turn)
    return a[0] + along * r[0] if 0 <= along <= 1 else None


def area(rings, is_inside):
    """Of the places where is_inside holds of the parities of all rings; exact."""
    all_sides = list(sides(rings))
    xs = {Fraction(p[0]) for ring in rings for p in ring}
    for i, s in enumerate(all_sides):
        xs.update(x for x in (crossing(s, t) for t in all_sides[:i]) if x is not None)
    xs = sorted(xs)
    total = Fraction(0)
    for left, right in zip(xs, xs[1:]):
        middle = (left + right) / 2
        cut = sorted(
            (a[1] + (middle - a[0]) * Fraction(b[1] - a[1], b[0] - a[0]), k)
            for k, a, b in all_sides if a[0] < middle < b[0])
        parities = [0] * len(rings)
        for (low, k), (high, _) in zip(cut, cut[1:]):
            parities[k] ^= 1
            if is_inside(parities):
                total += (high - low) * (right - left)
    return total


def random_ring(rng, corners, size, corner=(0, 0)):
    while True:
        ring = [(rng.randint(0, size) + corner[0], rng.randint(0, size) + corner[1]) for _ in range(corners)]
        ring = [p for i, p in enumerate(ring) if p != ring[i - 1]]
        if len(ring) >= 3:
            return ring


def cases(seed):
    """(kind, rings, polygons as lists of rings, what is inside, options)"""
    rng = random.Random(seed)
    outer = random_ring(rng, rng.randint(4, 8), rng.choice([4, 10, 30]))
    yield "crossing", [outer], [[outer]], lambda p: p[0], []
    holes = [random_ring(rng, rng.randint(3, 5), 8, (rng.randint(-2, 8), rng.randint(-2, 8))) for _ in range(3)]
    yield "holes", [outer, *holes], [[outer, *holes]], lambda p: p[0] and not any(p[1:]), []
    rings = [random_ring(rng, rng.randint(3, 6), 12, (rng.randint(-2, 4), rng.randint(-2, 4))) for _ in range(3)]
    yield "nested", rings, [[r] for r in rings], lambda p: sum(p) % 2, ["--polygons", "nested"]
    yield "united", rings, [[r] for r in rings], any, []


def measured(taut, polygons, place, options):
    """What taut says: an area, or why it refuses."""
    closed = [[[[place(c) for c in p] for p in ring + ring[:1]] for ring in rings] for rings in polygons]
    run = subprocess.run(
        [taut, "check", "-", "--repair", "--json", "-", "-q", *options],
        input=json.dumps({"type": "MultiPolygon", "coordinates": closed}),
        capture_output=True, text=True, timeout=60, check=False)
    if run.returncode != 0:
        return f"exit {run.returncode}: {run.stderr.strip()}"
    return json.loads(run.stdout)["result"]["free_space"]["area"]


def main():
    taut = sys.argv[1]
    first, last = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((2, 0), (3, 100)))
    count = wrong = 0
    for seed in range(first, last):
        for kind, rings, polygons, is_inside, options in cases(seed):
            right = float(area(rings, is_inside))
            for name, (place, scale, more) in COPIES.items():
                got = measured(taut, polygons, place, options + more)
                count += 1
                if isinstance(got, str) and right == 0 and got.startswith("exit 3"):
                    continue  # nothing is left of it
                if isinstance(got, str) or abs(got / scale - right) > 1e-6 * max(1.0, right):
                    wrong += 1
                    print(f"seed {seed}, {kind}, {name}: {got}, right is {right * scale}")
    print(f"{count} polygons, {wrong} wrong")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
