#!/usr/bin/env python3
"""Draws scenes in headless Chromium (WebGL 2 on SwiftShader, no GPU, no network) with the GLSL of `refraster gl`,
and holds the pixels to the bound of docs/verification.md.

    run.py TOOLS SCENE...       TOOLS: folder of the programs scene_page and judge_pixels

Exit 1 where a pixel is not explained, or the page does not draw. Exit 77, with a word, where there is no Chromium."""

import base64
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

SIZE = "160x90"
BROWSERS = ["chromium", "chromium-browser", "google-chrome"]
OPTIONS = [
    "--headless", "--dump-dom",
    "--no-sandbox",  # which root must not have; the only page that is opened is ours
    "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-background-networking", "--disable-component-update", "--disable-default-apps", "--disable-sync",
    "--disable-quic", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    "--no-first-run", "--no-default-browser-check", "--disable-dev-shm-usage",
]


def text_of(page, name):
    found = re.search(r'<pre id="%s">([^<]*)</pre>' % name, page)
    return found.group(1) if found else ""


def drawn(browser, page, profile):
    """The text of the page at this address after it has drawn, and what the browser said."""
    run = subprocess.Popen([browser, *OPTIONS, f"--user-data-dir={profile}", page], text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
    try:
        return run.communicate(timeout=600)
    except subprocess.TimeoutExpired:  # it hangs: away with it and all its children
        os.killpg(run.pid, signal.SIGKILL)
        return run.communicate()


def check(browser, tools, scene, folder):
    page = folder / "page.html"
    template = pathlib.Path(__file__).resolve().parent / "page.html"
    subprocess.run([tools / "scene_page", scene, SIZE, template, page], check=True)
    text, messages = drawn(browser, page.as_uri(), folder / "profile")
    error, driver, subpixel_bits = (text_of(text, name) for name in ("error", "driver", "subpixel_bits"))
    if error or not driver:
        print(f"{scene.stem}: {error or 'the page did not run: ' + messages[-2000:]}")
        return False
    for name in ("radiance", "ids"):
        (folder / name).write_bytes(base64.b64decode(text_of(text, name)))
    judged = subprocess.run([tools / "judge_pixels", scene, SIZE, folder / "radiance", folder / "ids", subpixel_bits,
                             driver], capture_output=True, text=True)
    print(f"{scene.stem}, {SIZE}, {driver}, lattice of 1/{2 ** int(subpixel_bits)} pixel:\n"
          f"  {judged.stdout}{judged.stderr}", end="", flush=True)
    return judged.returncode == 0


def browser():
    """The path of a Chromium, or None."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def main():
    chromium = browser()
    if not chromium:
        print("SKIPPED, not tested: no Chromium (Debian: scripts/setup browser)")
        return 77
    tools = pathlib.Path(sys.argv[1]).resolve()
    good = True
    for scene in sys.argv[2:]:
        with tempfile.TemporaryDirectory() as folder:
            good &= check(chromium, tools, pathlib.Path(scene).resolve(), pathlib.Path(folder))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
