#!/usr/bin/env python3
"""Draws the pictures of the page in docs/view.md and docs/gallery.md: light and dark, on a desk and on a phone.

usage: pictures.py TAUT DATA CHROMIUM FOLDER
"""

import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from chromium import Page  # noqa: E402
from films import made  # noqa: E402

TAUT, DATA, CHROMIUM, FOLDER = map(os.path.abspath, sys.argv[1:])
DESK, PHONE = (1000, 640), (390, 760)
# Name, file, size, colours, what the address says.
WORLDS = (
    ("page-light", "floor_plan.geojson", DESK, "light", "#r=0.2&l=walls.voronoi.region"),
    ("page-dark", "maze_25x25.txt", DESK, "dark", "#l=walls.mesh"),
    ("page-why", "islands.wkt", DESK, "light", "#s=5,8&g=9,4&r=1.05&l=walls.gates"),
    ("page-phone", "floor_plan.geojson", PHONE, "dark", "#l=walls.visibility"),
)
FILMS = (("page-film", "grid", DESK, "light", "#t=6.5"), ("page-film-phone", "mouse", PHONE, "dark", "#t=14"))


def shot(page, name, size, colours, address):
    page.size(*size, mobile=size == PHONE)
    page.colours(colours)
    page.open(address)
    page.wait("!window.tautApp || [...tautApp.shown].every((name) => name === 'walls' || tautApp.layers[name])")
    page.wait("!window.tautApp || document.getElementById('widest').textContent !== ''")
    page.settle()
    page.picture(os.path.join(FOLDER, name + ".png"))


def main():
    page = Page(CHROMIUM)
    try:
        for name, file, size, colours, state in WORLDS:
            server = subprocess.Popen([TAUT, "view", "--serve", file], cwd=DATA, stdout=subprocess.PIPE, text=True)
            shot(page, name, size, colours, server.stdout.readline().strip() + state)
            server.terminate()
            server.wait(10)
        with tempfile.TemporaryDirectory() as folder:
            for name, film, size, colours, state in FILMS:
                shot(page, name, size, colours, made(TAUT, DATA, folder, film) + state)
        assert not page.complaints, page.complaints
    finally:
        page.close()


if __name__ == "__main__":
    main()
