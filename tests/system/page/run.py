#!/usr/bin/env python3
"""Drives the pages of docs/report-page.md in headless Chromium, as a person does: clicks, slides, types.

    run.py SAMPLE_PAGE REFRASTER SCENE [FOLDER]      FOLDER: where screenshots go; by default none are made

Exit 1 where a page does not do what it should. Exit 77, with a word, where there is no Chromium or chromedriver."""

import array
import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support/script"))

import webdriver
from checks import check, faults


class Pages:
    def __init__(self, browser, folder, sample_page, scene, shots):
        self.browser, self.folder, self.sample_page, self.scene, self.shots = browser, folder, sample_page, scene, shots

    def sample(self, size, images):
        """Makes a page, and says what some of its pixels are."""
        self.page = self.folder / f"{size}_{images}.html"
        made = subprocess.run([self.sample_page, self.scene, size, images, self.page], check=True, text=True,
                              stdout=subprocess.PIPE)
        return [line.split() for line in made.stdout.splitlines()]

    def open(self, page, after=""):
        self.browser.open("about:blank")
        self.browser.messages(), self.browser.requests()  # what came before
        self.url = page.as_uri()
        self.browser.open(self.url + after)
        self.wait("document.getElementById('busy').hidden", f"{page.name} is unpacked")
        # Of a copy, which the browser is not told to draw fast.
        self.browser.run("""
            window.read = (x, y, width, height) => {
              const copy = new OffscreenCanvas(width, height).getContext("2d", {willReadFrequently: true});
              copy.drawImage(canvas, x, y, width, height, 0, 0, width, height);
              return copy.getImageData(0, 0, width, height).data;
            };""")
        self.settle()

    def wait(self, condition, what):
        """A page that never gets there is a fault; how long it takes is none."""
        for _ in range(1200):
            if self.browser.run(f"return {condition}"):
                return
            time.sleep(0.1)
        check(False, what)

    def settle(self):
        """Until what was asked to be drawn is drawn."""
        self.browser.run("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def press(self, *keys):
        self.browser.press(*keys)
        self.settle()

    def click(self, selector):
        self.browser.click(selector)
        self.settle()

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def place(self, x, y):
        """Where in the window the middle of a pixel of the image is."""
        return self.browser.run("""
            const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width, [ox, oy] = imageCorner();
            return [box.left + (ox + (arguments[0] + 0.5) * state.zoom) / ratio,
                    box.top + (oy + (arguments[1] + 0.5) * state.zoom) / ratio];""", x, y)

    def colour(self, x, y):
        """What the canvas shows of a pixel of the image."""
        return self.browser.run("""
            const at = imageCorner().map((corner, k) => Math.floor(corner + (arguments[k] + 0.5) * state.zoom));
            return [...read(...at, 1, 1)].slice(0, 3);""", x, y)

    def quiet(self, what):
        """No message on the console, and nothing asked for but the page itself."""
        said = self.browser.messages()
        check(said == [], f"{what}: nothing on the console, found {said}")
        asked = {url for url in self.browser.requests() if not url.startswith(("data:", "chrome:", "about:"))}
        check({url.split("#")[0] for url in asked} <= {self.url}, f"{what}: no request but for the page, found {asked}")

    def shot(self, name):
        if self.shots:
            self.settle()
            self.browser.screenshot(self.shots / f"{name}.png")


def inspector_shows(pages, pixel):
    """Place, levels, class, object."""
    x, y, *levels, kind, seen = pixel
    check(pages.text("#place") == f"{x}, {y}", f"({x}, {y}) is inspected, found {pages.text('#place')}")
    cells = pages.browser.run("""
        return [...document.querySelectorAll("table.values tbody tr:not(.allowed)")]
          .map((row) => [...row.querySelectorAll("td")].slice(0, 2).map((cell) => cell.firstChild.data));""")
    found = [cells[c][k] for k in (0, 1) for c in range(3)] if len(cells) == 3 else cells
    numbers = [float(text.replace("−", "-")) for text in found]
    same = all(a == float(b) or (a != a and float(b) != float(b)) for a, b in zip(numbers, levels))
    check(same, f"({x}, {y}) has the levels {levels}, found {found}")
    facts = pages.text("dl.facts")
    check(kind in facts and seen in facts, f"({x}, {y}) is {kind}, of {seen}, found {facts}")


def pixels_are_inspected(pages, pixels):
    for pixel in pixels:
        pages.browser.point(*pages.place(*map(int, pixel[:2])), "down", "up")
        pages.settle()
        inspector_shows(pages, pixel)


def classes_are_chosen(pages, pixels):
    x, y = map(int, next(pixel for pixel in pixels if pixel[8] == "unexplained")[:2])
    pages.press("1")
    before, other = pages.colour(x, y), pages.colour(2, 2)
    last = pages.browser.run("return String(model.classes.length - 1)") # unexplained
    unexplained = f'#legend button[data-class="{last}"]'
    pages.click(unexplained)
    pressed = pages.browser.run("return [...document.querySelectorAll('#legend [aria-pressed=true]')].map((b) => b.dataset.class)")
    check(pressed == [last], "a class that is clicked is chosen")
    check(pages.colour(x, y) == before, "a pixel of a chosen class is as before")
    check(pages.colour(2, 2) != other, "a pixel of another class is dimmed")
    pages.press("."), pages.press(".")
    check(pages.text("dl.facts").count("unexplained") > 0, "the next pixel is of the chosen class")
    pages.click(unexplained)
    check(pages.colour(2, 2) == other, "a second click shows all again")
    pages.click('#legend button[data-class="0"]')
    pages.press("a")
    check(pages.browser.run("return state.chosen.size") == 0, "the key A shows all classes")


def zooms(pages):
    pages.browser.run("canvas.focus()")
    pages.press("0")
    fitted = pages.browser.run("return state.zoom")
    pages.press("+"), pages.press("+")
    check(pages.browser.run("return state.zoom") > fitted, "the key + zooms in")
    pages.press("-"), pages.press("-")
    check(pages.browser.run("return state.zoom") == fitted, "the key − zooms out as far")
    pages.press("+", "+", "+")  # larger than the stage in both directions, so that no border stops it
    x, y = 140, 80
    at, before = pages.place(x, y), pages.browser.run("return state.zoom")
    pages.browser.wheel(*at, -120)
    pages.settle()
    near = pages.place(x, y)
    step = pages.browser.run("return state.zoom")
    check(step > before, "the wheel zooms in")
    check(max(abs(a - b) for a, b in zip(at, near)) <= 1.5 * step, "the wheel zooms to where it points")
    before = pages.browser.run("return [...state.centre]")
    pages.browser.point(*at, "down", (at[0] - 30, at[1] - 20), "up")
    pages.settle()
    check(pages.browser.run("return [...state.centre]") != before, "dragging moves the image")
    pages.press("z")
    check(pages.browser.run("return state.zoom") == 1, "the key Z shows it 1:1")
    pages.press("0")


def pixel_by_keys(pages):
    pages.browser.run("canvas.focus()")
    pages.press("escape")
    check(pages.browser.run("return state.pinned") is None, "Esc unpins")
    pages.browser.run("pin([50, 40])")
    for keys, place in ((("right",), [51, 40]), (("down", "down"), [51, 42]), (("shift+left",), [41, 42]), (("up",), [41, 41])):
        pages.press(*keys)
        check(pages.browser.run("return state.pinned") == place, f"{keys} go to {place}")
    check(pages.text("#place") == "41, 41", "the inspector follows the keys")
    check(pages.text("#pixel-line").startswith("(41, 41)"), "what is said aloud follows the keys")
    pages.browser.run("pin([0, 0])")
    pages.press("left", "up")
    check(pages.browser.run("return state.pinned") == [0, 0], "no key leads out of the image")


def two_images(pages, pixels):
    """Split and blink. At whole zooms the canvas shows a pixel's levels as they are."""
    pages.press("0"), pages.press("escape"), pages.press("2")
    if pages.browser.run("return state.marks"):
        pages.press("m")
    x, y, *levels = next(pixel for pixel in pixels if pixel[8] == "unexplained")
    reference, actual = [[int(level) for level in levels[k:k + 3]] for k in (0, 3)]
    x, y = int(x), int(y)
    check(pages.colour(x, y) == actual, "the view of the key 2 is the actual image")
    pages.press("1")
    check(pages.colour(x, y) == reference, "the view of the key 1 is the reference")
    pages.press("s")
    divider = pages.browser.box("#divider")
    for side, colour in (("right", actual), ("left", reference)):
        box = pages.browser.box("#divider")
        at = pages.place(x, y)
        goal = at[0] - 20 if side == "right" else at[0] + 20
        pages.browser.point(box["x"] + box["width"] / 2, divider["y"] + 30, "down", (goal, divider["y"] + 30), "up")
        pages.settle()
        check(pages.colour(x, y) == colour, f"on the {side} of the divider is {colour}, found {pages.colour(x, y)}")
    value = int(pages.browser.run("return document.getElementById('divider').getAttribute('aria-valuenow')"))
    pages.browser.run("document.getElementById('divider').focus()")
    pages.press("left", "left")
    moved = int(pages.browser.run("return document.getElementById('divider').getAttribute('aria-valuenow')"))
    check(value - 3 <= moved < value, "arrow keys move the divider")
    pages.press("b")
    check(pages.browser.run("return state.mode") == "blink", "the key B blinks")
    for label in ("reference", "actual", "reference"):
        pages.wait(f"document.getElementById('label-left').textContent === '{label}'", f"blinking shows {label}")
    pages.press("b")
    check(pages.browser.run("return state.mode") == "single", "the key B ends it")
    pages.press("m")


def gain(pages, pixels):
    x, y = map(int, next(pixel for pixel in pixels if pixel[8] == "unexplained")[:2])
    pages.press("4")
    pages.browser.run("document.getElementById('gain').focus()")
    pages.press("home")
    check(pages.text("#gain-value") == "× 1", "the slider's least gain is 1")
    dark = sum(pages.colour(x, y))
    pages.press("right", "right", "right", "right")
    check(pages.text("#gain-value") == "× 4", "four steps of the slider are a gain of 4")
    check(sum(pages.colour(x, y)) > dark, "more gain is lighter")
    pages.browser.run("canvas.focus()")
    pages.press("]", "]")
    check(pages.text("#gain-value") == "× 8", "the key ] is more gain")


def findings(pages):
    pages.click('[data-show="hypothesis-0"]')
    pages.wait("state.view === 'hypothesis-0'", "the image of a hypothesis is a view")
    check(pages.browser.run("return document.querySelectorAll('#views button').length") == 6, "it has a button")
    pages.click('[data-cluster="1"]')
    cluster = pages.browser.run("return model.clusters[1]")
    check(pages.browser.run("return state.pinned") == cluster[4:], "a cluster's worst pixel is pinned")
    pages.press("n")
    check(pages.browser.run("return state.pinned") == pages.browser.run("return model.clusters[2]")[4:], "N is the next cluster")


def help_opens(pages):
    pages.press("?")
    check(pages.browser.run("return document.getElementById('help').open"), "? opens the list of keys")
    pages.shot("keys")
    pages.press("escape")
    check(not pages.browser.run("return document.getElementById('help').open"), "Esc closes it")


def accessible(pages):
    nodes = pages.browser.devtools("Accessibility.getFullAXTree")["nodes"]
    for node in nodes:
        role = node.get("role", {}).get("value")
        if role in ("button", "slider", "image", "link", "textbox", "checkbox") and not node.get("ignored"):
            check(node.get("name", {}).get("value"), f"a {role} has a name")
    pages.browser.run("document.activeElement.blur(); window.scrollTo(0, 0)")
    reached, previous = set(), None
    for _ in range(60):
        pages.browser.press("tab")
        focus = pages.browser.run("""
            const e = document.activeElement, style = getComputedStyle(e);
            return [e.id || (e === document.body ? "" : e.textContent.slice(0, 30)), style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2];""")
        if focus[0] == previous:
            break
        reached.add(focus[0])
        previous = focus[0]
        check(focus[1] or focus[0] == "", f"the focus is seen on {focus[0]}")
    check({"canvas", "split", "blink", "zoom-in", "help-button"} <= reached, f"Tab reaches all, found {reached}")


LUMINANCE = """
    const parts = (css) => css.match(/[\\d.]+/g).map(Number);
    const lightness = ([r, g, b]) => [r, g, b].map((c) => c / 255).map((c) => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
    const ground = (e) => { for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] === 1) return c; }
                            return parts(getComputedStyle(document.body).backgroundColor); };
    return ["h1", ".headline .soft", "nav a", "#views button", "#legend .percent", "table.values small", "dl.facts dt", "pre", ".explained", ".sections td"].map((selector) => {
      const e = document.querySelector(selector), [a, b] = [parts(getComputedStyle(e).color), ground(e)].map(lightness);
      return [selector, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)];
    });"""


def both_schemes(pages, page, pixels):
    papers = {}
    for scheme in ("light", "dark"):
        pages.browser.show_as(1280, 800, scheme)
        pages.open(page)
        pages.browser.run(f"pin([{pixels[-1][0]}, {pixels[-1][1]}])")
        papers[scheme] = pages.browser.run("return getComputedStyle(document.body).backgroundColor")
        for selector, contrast in pages.browser.run(LUMINANCE):
            check(contrast >= 4.5, f"{scheme}: {selector} has a contrast of {contrast:.2f}, WCAG asks for 4.5")
        pages.shot(f"{scheme}_1280")
        pages.browser.show_as(1920, 1080, scheme)
        pages.shot(f"{scheme}_1920")
        pages.quiet(scheme)
    check(papers["light"] != papers["dark"], "the two schemes differ")


def narrow(pages, page):
    for width in (390, 320, 700):
        pages.browser.show_as(width, 844, mobile=True)
        pages.open(page)
        check(pages.browser.run("return document.documentElement.scrollWidth <= innerWidth"), f"nothing sticks out at a width of {width}")
        check(pages.browser.box("#canvas")["height"] > 200, f"the image has room at a width of {width}")
        pages.shot(f"phone_{width}")
    pages.quiet("phone")
    pages.browser.show_as(1280, 800)


def floats(pages):
    pixels = pages.sample("320x180", "values")
    pages.open(pages.page)
    pixels_are_inspected(pages, pixels)
    pages.press("2")
    check(pages.colour(3, 90) == [0, 255, 255], "NaN has its colour")
    x, y = map(int, pixels[2][:2])
    before = pages.colour(x, y)
    pages.press("escape"), pages.press("e", "e")
    check(pages.text("#exposure-value") == "+1", "the key E is half a stop more")
    check(sum(pages.colour(x, y)) > sum(before), "more exposure is lighter")
    pages.press("4")
    check(pages.colour(3, 90) == [0, 255, 255], "so has a difference that is none")
    pages.quiet("floats")


def odd_sizes(pages):
    for size in ("1x1", "8192x5", "3x2000", "2x16384"):
        pixels = pages.sample(size, "rgb8")
        for pixel in pixels:
            pages.open(pages.page, f"#{pixel[0]},{pixel[1]}")
            inspector_shows(pages, pixel)
        for key in "12345szsb0+":
            pages.press(key)
        pages.press("b")
        pages.quiet(size)
    # A single pixel of the most severe class is seen where a hundred share a point of the screen.
    pages.sample("8192x5", "rgb8")
    pages.open(pages.page)
    pages.browser.run("""
        model.classMap.values.fill(0);
        model.classMap.values[2 * 8192 + 4099] = model.classes.length - 1;
        layers.get("classes").changed(true);
        state.marks = false;
        show("classes");""")
    pages.settle()
    found = pages.browser.run("""
        const data = read(0, 0, canvas.width, canvas.height);
        for (let i = 0; i < data.length; i += 4) if (data[i] === 0xf1 && data[i + 1] === 0x4d && data[i + 2] === 0x10) return true;
        return false;""")
    check(found, "one pixel of 8192 is seen in the whole image")


def wider_than_a_canvas(pages, refraster):
    """Browsers draw no canvas of more than 16384 to 65535 pixels on a side; `compare` reads images up to the latter."""
    width, files = 40000, [pages.folder / name for name in ("a.pfm", "b.pfm")]
    for file, last in zip(files, (0.25, 0.75)):
        row = array.array("f", [x / width for x in range(width - 1)] + [last])
        file.write_bytes(f"Pf\n{width} 1\n-1.0\n".encode() + row.tobytes())
    page = pages.folder / "wide.html"
    subprocess.run([refraster, "compare", "-q", *files, "--html", page])
    pages.open(page)
    check(pages.colour(width - 1, 0) == [0xf1, 0x4d, 0x10], "the pixel that differs is seen in the whole image")
    pages.open(page, f"#{width - 1},0")
    pages.press("2")
    check(pages.colour(width - 1, 0) == [191] * 3, "and large, as it is")
    check(pages.colour(width - 2, 0) == [255] * 3, "beside its neighbour")
    pages.quiet("a wide image")


def comparison(pages, refraster):
    """The page that `refraster compare` writes."""
    a, b, page = (pages.folder / name for name in ("a.png", "b.png", "compare.html"))
    for image, words in ((a, []), (b, ["--samples", "2"])):
        subprocess.run([refraster, "render", "-q", pages.scene, "--size", "160x90", "-o", image, *words], check=True,
                       stdout=subprocess.DEVNULL)
    ran = subprocess.run([refraster, "compare", "-q", a, b, "--scene", pages.scene, "--html", page])
    check(ran.returncode == 1, "images that differ: exit code 1")
    pages.open(page)
    check(pages.browser.run("return [...document.querySelectorAll('#views button')].map((b) => b.textContent)") ==
          ["A", "B", "classes", "difference"], "the views of a comparison")
    check("knot" in pages.text("#clusters"), "clusters are named by objects")
    pages.shot("compare")
    pages.quiet("compare")


def main():
    missing = webdriver.missing()
    if missing:
        print(f"SKIPPED, not tested: {missing}")
        return 77
    sample_page, refraster, scene = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    shots = pathlib.Path(sys.argv[4]).resolve() if len(sys.argv) > 4 else None
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        browser = webdriver.Browser(folder / "profile")
        try:
            pages = Pages(browser, folder, sample_page, scene, shots)
            browser.show_as(1280, 800)
            pixels = pages.sample("320x180", "rgb8")
            page = pages.page
            pages.open(page)
            check(browser.run("return document.activeElement.id") == "canvas", "keys work at once: the image has the focus")
            pixels_are_inspected(pages, pixels)
            check("sees knot" in pages.text("#pixel pre"), "the text of a pixel is shown")
            check("allowed" in pages.text("table.values"), "what is allowed is shown")
            classes_are_chosen(pages, pixels)
            zooms(pages)
            pixel_by_keys(pages)
            two_images(pages, pixels)
            gain(pages, pixels)
            findings(pages)
            help_opens(pages)
            accessible(pages)
            pages.quiet("the page")
            pages.open(page, "#7,9")
            check(browser.run("return state.pinned") == [7, 9], "a link leads to a pixel")
            both_schemes(pages, page, pixels)
            narrow(pages, page)
            floats(pages)
            odd_sizes(pages)
            comparison(pages, refraster)
            wider_than_a_canvas(pages, refraster)
        finally:
            browser.close()
    print(f"{len(faults)} faults")
    return 1 if faults else 0


sys.exit(main())
