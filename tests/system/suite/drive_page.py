#!/usr/bin/env python3
"""Drives the wall of thumbnails of `refraster suite` in headless Chromium, as a person does.

    drive_page.py REFRASTER SCENE [FOLDER]      FOLDER: where screenshots go; by default none are made

Exit 1 where the page does not do what it should. Exit 77, with a word, where there is no Chromium or chromedriver."""

import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support/script"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "page"))

import webdriver
from checks import check, faults


def make_results(folder, refraster, scene):
    """Six entries: equal, different, of another size, without a reference, without a scene, verified."""
    text = scene.read_text()
    for name in ("same", "also", "changed", "larger"):
        (folder / f"{name}.json").write_text(text)
    size = ["--references", "refs", "--size", "160x90"]
    subprocess.run([refraster, "suite", "update", "same.json", "also.json", "changed.json", "larger.json", *size], cwd=folder,
                   check=True, stdout=subprocess.DEVNULL)
    (folder / "changed.json").write_text(text.replace('"glossiness": 90', '"glossiness": 12'))
    (folder / "new.json").write_text(text)
    (folder / "suite.json").write_text("""{"references": "refs", "defaults": {"size": [160, 90]}, "entries": [
      {"scene": ["same.json", "changed.json"], "tags": ["knots"]},
      {"scene": "also.json"},
      {"scene": "larger.json", "size": [320, 180], "tags": ["knots", "large"]},
      {"scene": ["new.json", "none.json"], "tags": ["odd <tag> & more"]}]}""")
    run = subprocess.run([refraster, "suite", "run", "suite.json"], cwd=folder, stdout=subprocess.DEVNULL)
    check(run.returncode == 3, "a run with a scene that is missing has exit code 3")
    return folder / "results/index.html"


class Wall:
    def __init__(self, browser, page, shots):
        self.browser, self.page, self.shots = browser, page, shots

    def open(self, after=""):
        self.browser.open("about:blank")
        self.browser.messages(), self.browser.requests()
        self.browser.open(self.page.as_uri() + after)

    def shown(self):
        return self.browser.run(
            "return [...document.querySelectorAll('.card')].filter((c) => !c.hidden).map((c) => c.dataset.name)")

    def click(self, selector):
        self.browser.click(selector)

    def shot(self, name):
        if self.shots:
            self.browser.screenshot(self.shots / f"{name}.png")


def filters(wall):
    check(wall.shown() == ["changed", "larger", "none", "new", "also", "same"] or
          wall.shown() == ["larger", "changed", "none", "new", "also", "same"], f"the worst come first: {wall.shown()}")
    wall.click('[data-choose-state="different"]')
    check(sorted(wall.shown()) == ["changed", "larger"], "a state is chosen")
    wall.click('[data-choose-state="equal"]')
    check(sorted(wall.shown()) == ["also", "changed", "larger", "same"], "a second state is shown too")
    wall.click('[data-choose-state="different"]'), wall.click('[data-choose-state="equal"]')
    check(len(wall.shown()) == 6, "without a chosen state all are shown")
    wall.click('[data-choose-state="bless"]')
    check(sorted(wall.shown()) == ["changed", "larger", "new"], "what update would store")
    wall.click('[data-choose-state="bless"]')
    wall.browser.run("""for (const b of document.querySelectorAll('[data-choose-tag]'))
      if (b.textContent.startsWith('large')) b.click();""")
    check(wall.shown() == ["larger"], "a tag is chosen")
    address = wall.browser.run("return location.hash")
    wall.open(address)
    check(wall.shown() == ["larger"], "the address leads to what is chosen")
    wall.open()
    wall.click("#words")
    wall.browser.press("n", "o", "n", "e")
    check(wall.shown() == ["none"], "words are looked for")
    wall.open()
    wall.browser.run("""const o = document.getElementById('object'); o.selectedIndex = 1; o.dispatchEvent(new Event('change'));""")
    check(0 < len(wall.shown()) < 6, "an object is chosen")
    wall.open()
    wall.browser.run("""const o = document.getElementById('order'); o.value = 'name'; o.dispatchEvent(new Event('change'));""")
    check(wall.shown() == ["also", "changed", "larger", "new", "none", "same"], "sorted by name")


def cards(wall):
    images = wall.browser.run("""return Object.fromEntries([...document.querySelectorAll('.card')].map((c) =>
      [c.dataset.name, [...c.querySelectorAll('img')].map((i) => i.naturalWidth)]))""")
    check(len(images["changed"]) == 3 and len(images["same"]) == 1 and images["none"] == [], f"thumbnails: {images}")
    check(all(width > 0 for widths in images.values() for width in widths), "every thumbnail is an image")
    captions = wall.browser.run(
        "return [...document.querySelector('[data-name=changed]').querySelectorAll('figcaption')].map((c) => c.textContent)")
    check(captions == ["reference", "now", "difference"], f"what was, what is, where they differ: {captions}")
    wall.click('[data-name="changed"] a.images')
    check(wall.browser.run("return location.pathname").endswith("/results/pages/changed.html"), "a click leads to the page")


def looks(wall):
    for scheme in ("light", "dark"):
        wall.browser.show_as(1280, 900, scheme)
        wall.open()
        wall.shot(f"wall_{scheme}")
    wall.browser.show_as(390, 800, mobile=True)
    wall.open()
    check(wall.browser.run("return document.documentElement.scrollWidth") <= 390, "nothing is wider than a small screen")
    wall.shot("wall_narrow")
    wall.browser.show_as(1280, 900)


def main():
    missing = webdriver.missing()
    if missing:
        print(f"SKIPPED, not tested: {missing}")
        return 77
    refraster, scene = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    shots = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        page = make_results(folder, refraster, scene)
        browser = webdriver.Browser(folder / "profile")
        try:
            wall = Wall(browser, page, shots)
            browser.show_as(1280, 900)
            wall.open()
            filters(wall)
            cards(wall)
            looks(wall)
            wall.open()
            check([m for m in browser.messages() if m] == [], "the console is silent")
            asked = [r for r in browser.requests() if not r.startswith(("file:", "data:"))]
            check(asked == [], f"nothing is asked of a network: {asked}")
        finally:
            browser.close()
    print(f"{len(faults)} faults")
    return 1 if faults else 0


sys.exit(main())
