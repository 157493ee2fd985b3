#!/usr/bin/env python3
"""Makes the pictures of docs/report-page.md: docs_images.py SAMPLE_PAGE SCENE FOLDER. Needs Chromium and chromedriver."""

import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # into the sources

import webdriver

SHOTS = {
    "report_light": ("light", "const note = model.notes[40]; pin([note.x, note.y]);"),
    "report_dark": ("dark", "choose(model.classes.length - 1); setMode('split'); setSplit(0.42);"),
}


def main():
    missing = webdriver.missing()
    if missing:
        print(f"{sys.argv[0]}: skipped: {missing}", file=sys.stderr)
        return
    sample_page, scene, images = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        subprocess.run([sample_page, scene, "960x540", "rgb8", page], check=True, stdout=subprocess.DEVNULL)
        browser = webdriver.Browser(pathlib.Path(folder) / "profile")
        try:
            for name, (scheme, script) in SHOTS.items():
                browser.show_as(1280, 800, scheme)
                browser.open(page.as_uri())
                while not browser.run("return document.getElementById('busy').hidden"):
                    time.sleep(0.1)
                browser.run(script)
                time.sleep(0.5)  # it is drawn with the next frame
                browser.screenshot(images / f"{name}.png")
        finally:
            browser.close()


main()
