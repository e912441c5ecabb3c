"""Ways to the same things: wheel and keys, the slider's end, paper."""


def focus_map(page):
    page.run("document.getElementById('front').focus()")


def keys(page, *names, modifiers=0):
    for name in names:
        page.key(name, modifiers)


def the_map_is_panned_and_zoomed(page):
    at = page.run("tautApp.sheet.toScreen([2, 1])")
    before = page.run("tautApp.sheet.scale")
    page.call("Input.dispatchMouseEvent", type="mouseWheel", x=at[0], y=at[1], deltaX=0, deltaY=-300)
    page.wait(f"tautApp.sheet.scale > {before} * 1.3")
    there = page.run("tautApp.sheet.toScreen([2, 1])")
    assert max(abs(a - b) for a, b in zip(at, there)) < 1e-6, "what is below the mouse stays there"
    page.drag((100, 600), (160, 630))
    moved = page.run("tautApp.sheet.toScreen([2, 1])")
    assert abs(moved[0] - there[0] - 60) < 1e-6 and abs(moved[1] - there[1] - 30) < 1e-6, (there, moved)
    page.wait("location.hash.includes('v=')")
    focus_map(page)
    keys(page, "ArrowRight")
    assert page.run("tautApp.sheet.toScreen([2, 1])")[0] < moved[0]
    keys(page, "+")
    assert page.run("tautApp.sheet.scale") > before * 1.3
    keys(page, "0")
    assert page.run("tautApp.sheet.scale") == before


def walls_are_drawn_moved_and_removed_by_keys(page):
    """The crosshair begins in the middle."""
    walls, step = page.run("tautApp.model.wallCount()"), page.run("tautApp.step()")
    x, y = page.run("tautApp.snapped(tautApp.sheet.centre)")
    place = [x + step, y, x + step, y + step]
    focus_map(page)
    keys(page, "w", "ArrowRight", "Enter", "ArrowUp", "Enter")
    page.wait(f"tautApp.model.wallCount() === {walls + 1}")
    drawn = page.run(f"tautApp.model.wall({walls})")
    assert all(abs(a - b) < 1e-9 for a, b in zip(drawn, place)), (drawn, place)
    keys(page, "Escape", "m", "ArrowRight", "Enter")
    page.wait("document.getElementById('said').textContent.includes('held by its first end')")
    keys(page, "ArrowRight", "Enter")
    page.wait(f"Math.abs(tautApp.model.wall({walls})[0] - {x + 2 * step}) < 1e-9")
    assert page.run(f"tautApp.model.wall({walls})")[1:4] == drawn[1:4]
    keys(page, "Escape", "x", "ArrowRight", "ArrowRight", "Enter")
    page.wait(f"tautApp.model.wallCount() === {walls}")
    for count in (walls + 1, walls + 1, walls):
        keys(page, "z", modifiers=2)
        page.wait(f"tautApp.model.wallCount() === {count}")
    page.settle()
    keys(page, "v")


def the_widest_is_one_button_away(page):
    page.wait("!document.getElementById('set-widest').disabled")
    page.run("document.getElementById('set-widest').click()")
    page.wait("tautApp.model.radius === 0.25 && tautApp.answer.status === 'found'")
    page.settle()
    page.run("document.getElementById('radius').focus()")
    keys(page, "ArrowRight")
    page.wait("tautApp.model.radius > 0.25 && tautApp.answer.status === 'none'")
    page.settle()
    keys(page, "z", modifiers=2)
    page.wait("tautApp.model.radius === 0.25")
    keys(page, "z", modifiers=2)
    page.wait("tautApp.model.radius === 0")
    page.settle()


def digits_are_in_the_address(page):
    page.run("document.getElementById('digits').value = 30, document.getElementById('digits').dispatchEvent(new Event('input'))")
    page.settle()
    address = page.run("location.href")
    assert "d=30" in address, address
    page.open(address)
    page.settle()
    assert len(page.run("document.getElementById('length').textContent")) == 32
    page.run("document.getElementById('digits').value = 6, document.getElementById('digits').dispatchEvent(new Event('input'))")
    page.settle()


# How many pixels there are darker than this, and brighter than that, opaque.
INK = """((canvas) => {
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let dark = 0, bright = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) {
    const sum = data[i] + data[i + 1] + data[i + 2];
    if (sum < 250) ++dark;
    if (sum > 700) ++bright;
  }
  return [dark, bright];
})(document.getElementById("paper"))"""


def paper_is_bright_and_not_empty(page):
    """Also where the screen is dark: walls in ink, on white."""
    page.colours("dark")
    page.settle()
    page.call("Page.printToPDF")
    dark, bright = page.run(INK)
    assert dark > 1000 and bright > 20 * dark, (dark, bright)
    page.colours("light")


def controls(page):
    for test in (the_map_is_panned_and_zoomed, walls_are_drawn_moved_and_removed_by_keys, the_widest_is_one_button_away,
                 digits_are_in_the_address, paper_is_bright_and_not_empty):
        test(page)
        print("passed:", test.__name__.replace("_", " "), flush=True)
