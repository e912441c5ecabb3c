"""What axe-core finds in a page: rules of WCAG 2 and good practice. `./dev check page` fetches it (npm)."""


def find_faults(page, axe, where):
    """None, of any impact, in what is shown now."""
    page.run(axe + ";0")
    faults = page.run("axe.run(document, {resultTypes: ['violations']}).then((found) => found.violations.map((fault) => "
                      "[fault.impact, fault.help, ...fault.nodes.map((node) => node.target.join(' '))].join('; ')))")
    assert not faults, (where, faults)
    rules = page.run("axe.run(document).then((found) => found.passes.map((rule) => rule.id))")
    assert {"button-name", "color-contrast", "document-title", "html-has-lang"} <= set(rules), (where, rules)


def in_all_lights_and_widths(page, axe, where):
    for scheme in ("light", "dark"):
        page.colours(scheme)
        for width, height in ((1280, 800), (390, 844)):
            page.size(width, height, mobile=width < 500)
            find_faults(page, axe, (where, scheme, width))
    page.colours("light")
    page.size(1280, 800)


def world(page, axe):
    """As it is opened, with all that folds open, and where there is no path."""
    in_all_lights_and_widths(page, axe, "world")
    page.run("document.querySelector('details').open = true, tautApp.tools.choose('draw'), tautApp.setRadius(1)")
    page.settle()
    in_all_lights_and_widths(page, axe, "no path")
    page.run("tautApp.tools.choose('look'), tautApp.setRadius(0)")
    page.settle()


def a_fault_is_found(page, axe):
    page.run("document.getElementById('save').ariaLabel = ' ', document.getElementById('save').textContent = ''")
    try:
        find_faults(page, axe, "a button without a name")
    except AssertionError:
        page.run("document.getElementById('save').removeAttribute('aria-label'), document.getElementById('save').textContent = 'Save'")
        return
    raise AssertionError("a button without a name was not found")
