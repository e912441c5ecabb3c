"""Films of searches and robots, played in the page that `--animate FILE.html` writes."""

import os
import subprocess

GRID = "rooms_64x48.map --start 2,2 --goal 40,60".split()
FILMS = {
    "grid": ["grid", "solve", *GRID],
    "mouse": ["mouse", "run", "mouse_16.maz"],
    "chase": ["chase", "town_60x40.chase"],
    "bug": ["bug", "rooms_64x48.map", "--from", "3,3", "--to", "50,40"],
    "drive": ["drive", "car/lane.txt"],
    "car": ["drive", "floor_plan.geojson", "--car", "length=0.4,width=0.2,radius=0.3", "--from", "1,1,90", "--to", "5,3,180"],
}


def made(taut, data, folder, name, ending=".html"):
    file = os.path.join(folder, name + ending)
    done = subprocess.run([taut, *FILMS[name], "--animate", file], cwd=data, capture_output=True, text=True)
    assert done.returncode == 0, (name, done.stderr)
    return "file://" + file


# What moves, as it is seen. Pixels would not do: the same scene is drawn in other strips the second time.
STATE = """(() => {
  const seen = [];
  for (const element of new Set([...document.querySelectorAll('#film animate, #film set, #film animateMotion, #film animateTransform')]
      .map((animation) => animation.targetElement))) {
    const {opacity, visibility, strokeDashoffset, d} = getComputedStyle(element), box = element.getBoundingClientRect();
    seen.push([opacity, visibility, strokeDashoffset, d, ...[box.x, box.y, box.width, box.height].map((v) => v.toFixed(2))].join());
  }
  return seen.join(';');
})()"""


def state(page):
    page.run("new Promise((next) => requestAnimationFrame(() => requestAnimationFrame(next)))")
    return page.run(STATE)


def film(page, member):
    return page.run("tautFilm.film." + member)


def it_plays_steps_and_is_scrubbed(page, address):
    """Of any film: every way to move its clock moves the picture, and back again."""
    page.open(address)
    assert page.run("document.body.dataset.ready") == "film"
    page.wait("tautFilm.film.time > 0.1")  # it begins by itself
    assert page.run("[...document.querySelectorAll('#film style')].every((s) => !/@media *\\(prefers-color-scheme/.test(s.textContent))")
    page.key(" ")
    assert not film(page, "playing")
    page.key("Home")
    assert film(page, "time") == 0
    first = state(page)
    page.run("tautFilm.go(tautFilm.film.lasts * 0.6)")
    later = state(page)
    assert first != later
    page.key("ArrowRight")
    after = film(page, "step()")
    page.key("ArrowLeft")
    assert film(page, "step()") == after - 1
    page.key("Home")
    assert state(page) == first, "the same moment looks the same"
    for _ in range(3):
        page.key("ArrowRight")
    assert film(page, "time") == film(page, "moments[3]") > 0
    page.key("End")
    assert film(page, "lasts") - film(page, "time") < 0.002


def the_slider_and_the_buttons_do_the_same(page, address):
    page.open(address)
    page.key(" ")
    box = page.run("document.getElementById('time').getBoundingClientRect().toJSON()")
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.drag((box["x"] + 20, middle[1]), middle)
    assert abs(film(page, "time") / film(page, "lasts") - 0.5) < 0.05, film(page, "time")
    before = film(page, "step()")
    page.run("document.getElementById('back').click()")
    page.run("document.getElementById('back').click()")
    page.run("document.getElementById('forward').click()")
    assert before - 1 <= film(page, "step()") <= before
    assert f"step {film(page, 'step()') + 1} of" in page.run("document.getElementById('time').getAttribute('aria-valuetext')")
    page.wait("document.getElementById('film-said').textContent.includes('step')")
    page.key("ArrowUp")
    assert film(page, "speed") == 2
    assert "x=2" in page.run("location.hash")
    address = page.run("location.href")
    time = film(page, "time")
    page.open(address)
    assert abs(film(page, "time") - time) < 0.001 and film(page, "speed") == 2 and not film(page, "playing")


def speed_is_kept(page, address):
    """At four times the speed it is there in a quarter of the time: the clock of the page tells."""
    page.open(address + "#t=0")
    page.run("tautFilm.setSpeed(4), tautFilm.film.tick(0.5)")
    assert abs(film(page, "time") - 2) < 1e-9
    page.run("tautFilm.play(true)")
    page.wait("tautFilm.film.time >= tautFilm.film.lasts && !tautFilm.film.playing")  # a search ends
    page.run("document.getElementById('play').click()")
    assert film(page, "playing") and film(page, "time") < 1  # and begins anew


def it_is_looked_at_from_near(page, address):
    page.open(address + "#t=1")
    part = page.run("tautFilm.lens.part")
    page.key("+")
    nearer = page.run("tautFilm.lens.part")
    assert nearer[2] < part[2] and abs(nearer[0] + nearer[2] / 2 - part[0] - part[2] / 2) < 1e-6
    page.drag((500, 300), (600, 300))
    assert page.run("tautFilm.lens.part")[0] < nearer[0]
    before = page.run("tautFilm.lens.part")
    page.key("d")
    assert page.run("tautFilm.lens.part")[0] > before[0]
    page.key("0")
    assert page.run("tautFilm.lens.part") == part


def who_wants_no_motion_sees_none(page, address):
    page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
    page.open(address)
    assert not film(page, "playing") and film(page, "time") == 0
    page.key("ArrowRight")
    assert film(page, "time") > 0 and not film(page, "playing")
    page.call("Emulation.setEmulatedMedia", features=[])


def a_picture_alone_has_a_button(page, address):
    """The SVG itself; its drawing is an SVG within."""
    page.call("Page.navigate", url=address)
    page.wait("!!document.querySelector('.pause') && document.readyState === 'complete'")
    place = "document.querySelector('.runner circle').getBoundingClientRect().x.toFixed(3)"
    still = f"new Promise((tell) => {{ const old = {place}; setTimeout(() => tell(old === {place}), 150); }})"
    assert not page.run(still)
    page.run("document.querySelector('.pause').dispatchEvent(new MouseEvent('click', {bubbles: true}))")
    assert page.run(still)


def a_still_picture_has_no_player(page, taut, data, folder, accessible):
    """But is looked at from near, too."""
    file = os.path.join(folder, "still.html")
    assert subprocess.run([taut, "solve", "floor_plan.geojson", "--svg", file], cwd=data, capture_output=True).returncode == 0
    page.open("file://" + file)
    assert page.run("document.getElementById('player').hidden") and page.run("document.querySelector('h1').textContent")
    it_is_looked_at_from_near(page, "file://" + file)
    accessible("still picture")


def films(page, taut, data, folder, picture, accessible):
    addresses = {name: made(taut, data, folder, name) for name in FILMS}
    page.requests.clear()
    for name, address in addresses.items():
        it_plays_steps_and_is_scrubbed(page, address)
        page.run("tautFilm.go(tautFilm.film.lasts * 0.7)")
        picture(page, "film-" + name)
        print("passed: film of", name, flush=True)
    the_slider_and_the_buttons_do_the_same(page, addresses["mouse"])
    speed_is_kept(page, addresses["grid"])
    it_is_looked_at_from_near(page, addresses["bug"])
    who_wants_no_motion_sees_none(page, addresses["mouse"])
    page.size(390, 844, mobile=True)
    page.colours("dark")
    page.open(addresses["mouse"] + "#t=12")
    assert page.run("document.documentElement.scrollWidth") <= 390
    picture(page, "film-phone-dark")
    page.colours("light")
    page.size(1280, 800)
    page.open(addresses["mouse"] + "#t=3")
    accessible("film")
    a_still_picture_has_no_player(page, taut, data, folder, accessible)
    a_picture_alone_has_a_button(page, made(taut, data, folder, "bug", ".svg"))
    foreign = [r for r in page.requests if not r.startswith(("file://" + folder, "data:", "blob:", "about:"))]
    assert not foreign, foreign
    print("passed: films", flush=True)
