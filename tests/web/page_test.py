#!/usr/bin/env python3
"""The page of `taut view`, used as people use it, in Chromium without a window.

usage: page_test.py TAUT DATA CHROMIUM [--pictures FOLDER] [--axe axe.min.js]
"""

import argparse
import http.client
import atexit
import json
import os
import random
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import accessible  # noqa: E402
from chromium import Page  # noqa: E402
from controls import controls  # noqa: E402
from films import films  # noqa: E402

asked = argparse.ArgumentParser()
for needed in ("taut", "data", "chromium"):
    asked.add_argument(needed, type=os.path.abspath)
asked.add_argument("--pictures")
asked.add_argument("--axe", type=argparse.FileType())
asked = asked.parse_args()
TAUT, DATA, CHROMIUM, PICTURES = asked.taut, asked.data, asked.chromium, asked.pictures
AXE = asked.axe and asked.axe.read()
ROOMS = "boundary 0 0 4 2\nstart 1 0.5\ngoal 3 0.5\n0 0 4 0\n4 0 4 2\n4 2 0 2\n0 2 0 0\n2 0 2 1.5\n"


class Server:
    def __init__(self, file, *more):
        self.process = subprocess.Popen([TAUT, "view", "--serve", file, *more], stdout=subprocess.PIPE, text=True)
        atexit.register(self.process.kill)  # where a test fails nobody ends it, and who runs the tests waits for its output
        self.address = self.process.stdout.readline().strip()

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(10)


def solved(file, start, goal):
    out = subprocess.run([TAUT, "solve", file, "--from", "%r,%r" % start, "--to", "%r,%r" % goal, "--json", "-"],
                         capture_output=True, text=True)
    return json.loads(out.stdout)


def picture(page, name):
    if PICTURES:
        page.settle()
        page.picture(os.path.join(PICTURES, name + ".png"))


def text(page, id):
    return page.run(f"document.getElementById('{id}').textContent")


def centre(page, id):
    return page.run(f"(() => {{ const b = document.getElementById('{id}').getBoundingClientRect();"
                    "return [b.x + b.width / 2, b.y + b.height / 2]; })()")


def click(page, selector):
    page.run(f"document.querySelector({json.dumps(selector)}).click()")


def screen(page, x, y):
    return page.run(f"tautApp.sheet.toScreen([{x}, {y}])")


def its_path_is_the_programs(page, server, file):
    page.open(server.address)
    page.settle()
    assert page.run("document.body.dataset.ready") == "server"
    length = solved(file, (1.0, 0.5), (3.0, 0.5))["result"]["length"]
    assert text(page, "length") == "%.6f" % length, text(page, "length")
    assert "Proven shortest" in text(page, "more")


def dragging_the_start_moves_the_path(page, server, file):
    page.drag(centre(page, "start"), screen(page, 0.5, 1.25))
    page.settle()
    start = page.run("tautApp.model.start")
    assert abs(start[0] - 0.5) < 0.02 and abs(start[1] - 1.25) < 0.02, start
    length = solved(file, tuple(start), (3.0, 0.5))["result"]["length"]
    assert text(page, "length") == "%.6f" % length
    assert "s=" + ",".join("%r" % v for v in start).replace(".0,", ",") in page.run("location.hash") or "s=" in page.run("location.hash")
    click(page, "#undo")
    page.wait("tautApp.model.start[0] === 1")
    page.settle()


def a_drawn_wall_closes_the_way_and_undo_opens_it(page, server, file):
    walls = page.run("tautApp.model.wallCount()")
    page.run("document.getElementById('front').focus()")
    page.key("w")
    page.drag(screen(page, 2, 1.5), screen(page, 2, 2))
    page.wait(f"tautApp.model.wallCount() === {walls + 1}")
    page.wait("document.getElementById('length').textContent === 'No path'")
    assert "separate" in text(page, "more"), text(page, "more")
    page.wait("document.getElementById('said').textContent.includes('No path')")
    picture(page, "no-path")
    address = page.run("location.href")
    page.key("z", modifiers=2)
    page.wait(f"tautApp.model.wallCount() === {walls} && document.getElementById('length').textContent !== 'No path'")
    page.key("Z", modifiers=2 | 8)
    page.wait(f"tautApp.model.wallCount() === {walls + 1}")
    page.open(address)
    page.wait("document.getElementById('length').textContent === 'No path'")  # it is all in the address
    page.run("document.getElementById('undo').focus(), tautApp.setWalls(tautApp.model.first.walls)")
    page.wait("document.getElementById('length').textContent !== 'No path'")


def walls_are_moved_and_removed(page, server, file):
    click(page, "[data-tool=move]")
    page.drag(screen(page, 2, 1.5), screen(page, 2, 1))
    page.wait("tautApp.model.walls.slice(20, 25).join() === '2,0,2,1,0'")
    click(page, "[data-tool=erase]")
    page.drag(screen(page, 2, 0.5), screen(page, 2, 0.5))
    page.wait("tautApp.model.wallCount() === 4")
    page.settle()
    assert text(page, "length") == "2.000000", text(page, "length")
    click(page, "#undo")
    page.wait("tautApp.model.wallCount() === 5")
    click(page, "#undo")
    page.wait("tautApp.model.walls.slice(20, 25).join() === '2,0,2,1.5,0'")
    click(page, "[data-tool=look]")


def keys_move_the_start(page, server, file):
    before = page.run("tautApp.model.start")
    page.run("document.getElementById('start').focus()")
    page.key("ArrowRight")
    page.settle()
    after = page.run("tautApp.model.start")
    assert after[0] > before[0] and after[1] == before[1], (before, after)
    assert "arrow keys move it" in page.run("document.getElementById('start').ariaLabel")


def a_disc_is_as_wide_as_the_widest_gate(page, server, file):
    page.wait("document.getElementById('widest').textContent.includes('0.25')")
    page.run("tautApp.setRadius(0.25)")
    page.settle()
    assert "for the disc" in text(page, "more"), text(page, "more")
    picture(page, "disc")
    page.run("tautApp.setRadius(0.2500001)")
    page.settle()
    assert "narrower" in text(page, "more"), text(page, "more")
    page.run("tautApp.setRadius(0)")


def digits_are_as_many_as_asked(page, server, file):
    page.run("tautApp.model.start = [1, 0.5], tautApp.model.goal = [3, 0.5]")
    page.run("document.getElementById('digits').value = 60, tautApp.askPath()")
    page.settle()
    assert text(page, "length") == "2.828427124746190097603377448419396157139343750753896146353359"
    page.run("document.getElementById('digits').value = 6, tautApp.askPath()")


def every_layer_is_drawn(page, server, file):
    for name in ("triangulation", "mesh", "visibility", "voronoi", "region", "gates"):
        click(page, f"[data-layer={name}]")
        page.wait(f"!!tautApp.layers.{name}")
        picture(page, "layer-" + name)
        click(page, f"[data-layer={name}]")
    assert text(page, "layer-note") == ""


def formats_are_saved(page, server, file):
    names = page.run("[...document.getElementById('format').options].map((o) => o.value)")
    assert "geojson" in names and "segments" in names and "maz" not in names, names
    saves = "(tautApp.download = (bytes, ending) => tell(ending + bytes.size), document.getElementById('format').value = '%s', tautApp.save())"
    assert re.fullmatch(r"txt\d\d+", page.run(f"new Promise((tell) => {saves % 'segments'})"))
    assert re.fullmatch(r"png\d{4,}", page.run(f"new Promise((tell) => {saves % 'png'})"))  # what is seen
    page.run("delete tautApp.download, document.getElementById('format').value = 'geojson'")
    saved = page.run("tautApp.planner.ask(tautApp.request('save', {as: 'segments'}))")
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as out:
        out.write(saved["text"])
        out.flush()
        assert subprocess.run([TAUT, "solve", out.name], capture_output=True).returncode == 0


def it_is_dark_in_the_dark(page, server, file):
    light = page.run("getComputedStyle(document.body).backgroundColor")
    page.colours("dark")
    page.settle()
    dark = page.run("getComputedStyle(document.body).backgroundColor")
    assert sum(map(int, re.findall(r"\d+", dark)[:3])) < 150 < sum(map(int, re.findall(r"\d+", light)[:3])), (light, dark)
    assert page.run("tautApp.sheet.colour.wall") == page.run(
        "getComputedStyle(document.documentElement).getPropertyValue('--wall').trim()")
    picture(page, "dark")
    page.colours("light")


def it_fits_a_phone(page, server, file):
    page.size(390, 844, mobile=True)
    page.settle()
    assert page.run("document.documentElement.scrollWidth") <= 390
    box = page.run("document.getElementById('stage').getBoundingClientRect().toJSON()")
    panel = page.run("document.getElementById('panel').getBoundingClientRect().toJSON()")
    assert box["width"] == 390 and panel["width"] == 390 and panel["top"] >= box["bottom"] - 1, (box, panel)
    picture(page, "phone")
    page.colours("dark")
    picture(page, "phone-dark")
    page.colours("light")
    page.size(1280, 800)


def everything_has_a_name(page, server, file):
    """What a screen reader is told: each control has a role and a name."""
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    controls = ("button", "checkbox", "slider", "spinbutton", "combobox", "radio", "link", "image")
    nameless = [n["role"]["value"] for n in nodes
                if not n["ignored"] and n["role"]["value"] in controls and not n.get("name", {}).get("value")]
    assert not nameless, nameless


def a_hundred_lengths_are_those_of_solve(page):
    file = os.path.join(DATA, "maze_25x25.txt")
    server = Server(file)
    page.open(server.address)
    compare_lengths(page, file)
    assert server.end() == 0


def compare_lengths(page, file):
    random.seed(1)
    place = lambda: (round(random.uniform(0.6, 25.4), 2), round(random.uniform(0.6, 25.4), 2))  # noqa: E731
    for _ in range(100):
        start, goal = place(), place()
        page.run(f"tautApp.model.start = {list(start)}, tautApp.model.goal = {list(goal)}, tautApp.askPath()")
        page.settle()
        answer = solved(file, start, goal)
        assert page.run("tautApp.answer.status") == answer["status"], (start, goal, answer)
        if answer["status"] == "found":
            assert page.run("tautApp.answer.length") == answer["result"]["length"], (start, goal)


def strangers_are_refused(server):
    def status(address, **headers):
        try:
            return urllib.request.urlopen(urllib.request.Request(address, headers=headers)).status
        except urllib.error.HTTPError as error:
            return error.code
    root = re.match(r"http://127\.0\.0\.1:\d+/", server.address).group()
    assert status(server.address) == 200
    assert status(root) == 404
    assert status(server.address, Host="evil.example") == 403
    assert status(server.address, Origin="http://evil.example") == 403
    assert status(server.address, Origin="null") == 403


def answers_do_not_wait(server):
    """Not for the acknowledgement of an answer's head, which takes a client 40 ms."""
    host, path = re.match(r"http://([^/]+)(/.*)", server.address).groups()
    line, took = http.client.HTTPConnection(host), []
    for _ in range(21):
        begun = time.perf_counter()
        line.request("POST", path + "ask", '{"do": "path"}')
        assert json.loads(line.getresponse().read())["status"] == "found"
        took.append(time.perf_counter() - begun)
    line.close()
    assert statistics.median(took) < 0.03, took


def a_page_from_disk_asks_nobody(page, folder):
    file = os.path.join(folder, "page.html")
    done = subprocess.run([TAUT, "view", os.path.join(DATA, "maze_61x61_loops.txt"), "-o", file], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    page.requests.clear()
    page.open("file://" + file)
    page.settle()
    own = [r for r in page.requests if r != "file://" + file and not r.startswith(("data:", "blob:"))]
    assert not own, own
    length = float(re.search(r"length ([0-9.]+)", subprocess.run([TAUT, "solve", os.path.join(DATA, "maze_61x61_loops.txt")],
                                                                 capture_output=True, text=True).stdout).group(1))
    assert float(text(page, "length")) == length, text(page, "length")
    ready = page.run("document.body.dataset.ready")
    assert ready in ("still", "wasm")
    assert ("A picture" in text(page, "planner")) == (ready == "still")
    picture(page, "disk-" + ready)
    return ready == "wasm"


def a_page_from_disk_answers_as_solve_does(page, folder):
    maze, file = os.path.join(DATA, "maze_25x25.txt"), os.path.join(folder, "own.html")
    assert subprocess.run([TAUT, "view", maze, "-o", file, "-q"]).returncode == 0
    page.requests.clear()
    page.open("file://" + file)
    page.settle()
    assert "passed its exactness test" in text(page, "planner"), text(page, "planner")
    page.drag(centre(page, "start"), screen(page, 12.5, 12.5))
    page.settle()
    start, goal = page.run("tautApp.model.start"), page.run("tautApp.model.goal")
    assert abs(start[0] - 12.5) < 0.2 and abs(start[1] - 12.5) < 0.2, start
    assert page.run("tautApp.answer.length") == solved(maze, tuple(start), tuple(goal))["result"]["length"]
    compare_lengths(page, maze)
    click(page, "[data-layer=voronoi]")
    page.wait("!!tautApp.layers.voronoi")
    picture(page, "disk-voronoi")
    asked = [r for r in page.requests if r != "file://" + file and not r.startswith(("data:", "blob:"))]
    assert not asked, asked


def a_page_whose_planner_fails_is_a_picture(page, folder):
    with open(os.path.join(folder, "own.html")) as own:
        html = own.read()
    file = os.path.join(folder, "broken.html")
    with open(file, "w") as out:
        out.write(html.replace('id="taut-wasm">H4sI', 'id="taut-wasm">H4sX', 1))
    page.open("file://" + file)
    page.settle()
    assert page.run("document.body.dataset.ready") == "still"
    assert "does not run here" in text(page, "planner"), text(page, "planner")
    assert text(page, "length") != "", text(page, "length")


ON_TWO_ROOMS = (
    its_path_is_the_programs, dragging_the_start_moves_the_path, a_drawn_wall_closes_the_way_and_undo_opens_it,
    walls_are_moved_and_removed, keys_move_the_start, a_disc_is_as_wide_as_the_widest_gate, digits_are_as_many_as_asked,
    every_layer_is_drawn, formats_are_saved, it_is_dark_in_the_dark, it_fits_a_phone, everything_has_a_name,
)


def main():
    page = Page(CHROMIUM)
    try:
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "rooms.txt")
            with open(file, "w") as out:
                out.write(ROOMS)
            server = Server(file)
            strangers_are_refused(server)
            answers_do_not_wait(server)
            for test in ON_TWO_ROOMS:
                test(page, server, file)
                print("passed:", test.__name__.replace("_", " "), flush=True)
            controls(page)
            if AXE:
                accessible.world(page, AXE)
                accessible.a_fault_is_found(page, AXE)
                print("passed: nothing for axe-core to find", flush=True)
            foreign = [r for r in page.requests if not r.startswith((server.address, "data:", "blob:", "about:"))]
            assert not foreign, foreign
            assert server.end() == 0
            a_hundred_lengths_are_those_of_solve(page)
            if a_page_from_disk_asks_nobody(page, folder):
                a_page_from_disk_answers_as_solve_does(page, folder)
                a_page_whose_planner_fails_is_a_picture(page, folder)
                print("passed: all that a page with its own planner has to", flush=True)
            look = (lambda where: accessible.in_all_lights_and_widths(page, AXE, where)) if AXE else lambda where: None
            look("from disk")
            films(page, TAUT, DATA, folder, picture, look)
        assert not page.complaints, page.complaints
        print("passed: all")
    finally:
        page.close()


if __name__ == "__main__":
    main()
