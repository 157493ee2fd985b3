#!/usr/bin/env python3
"""Drives the window of `refraster view` under Xvfb, as a person does: keys, the mouse, an editor that saves files.

    run.py REFRASTER [FOLDER]      FOLDER: where screenshots go; by default none are made

The events are those of a real X server, by xdotool, and what is judged are the pixels on its screen: all of the program
is tested, with SDL, and nothing in it is there for the test. Exit 1 where the window does not do what it should. Exit
77, with a word, where the program has no window, or Xvfb, xdotool or ImageMagick are missing."""

import ctypes
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support/script"))

from checks import check, faults


def wait(condition, what):
    """What never comes is a fault; how long it takes is none."""
    for _ in range(1200):
        if found := condition():
            return found
        time.sleep(0.1)
    check(False, what)
    return None


def pixels(image):
    """Width and height, and all bytes."""
    size = subprocess.run(["identify", "-format", "%wx%h", image], check=True, stdout=subprocess.PIPE, text=True).stdout
    return size, subprocess.run(["convert", image, "-depth", "8", "rgb:-"], check=True, stdout=subprocess.PIPE).stdout


class Viewer:
    """The program, running, and its window."""

    def __init__(self, program, folder, arguments, shots):
        self.program, self.folder, self.shots = program, folder, shots
        self.out = open(folder / "out.txt", "wb+")
        self.process = subprocess.Popen([program, "view", *arguments], cwd=folder, stdout=self.out)
        self.window = wait(self.find, "there is a window")
        self.xdotool("windowfocus", "--sync", self.window)

    def find(self):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "refraster"], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True).stdout.split()
        return found[0] if found else None

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=True)

    def key(self, *names):
        self.xdotool("key", *names)

    def at(self, x, y):
        self.xdotool("mousemove", "--window", self.window, x, y)

    def click(self, x, y):
        self.at(x, y)
        self.xdotool("click", 1)

    def drag(self, start, end):
        self.at(*start)
        self.xdotool("mousedown", 1)
        for i in range(1, 6):  # as a hand does
            self.at(*(round(a + (b - a) * i / 5) for a, b in zip(start, end)))
        self.xdotool("mouseup", 1)

    def screen(self):
        path = self.folder / "screen.png"
        subprocess.run(["import", "-silent", "-window", self.window, path], check=True)
        return pixels(path)

    def shot(self, name):
        """For people."""
        if self.shots:
            subprocess.run(["import", "-silent", "-window", self.window, self.shots / f"{name}.png"], check=True)

    def shows(self, image, what):
        """Waits until the window shows the image and nothing else."""
        expected = pixels(image)
        wait(lambda: self.screen() == expected, what)

    def shows_over(self, image, what, name):
        """Waits until something more than the image is to be seen."""
        expected = pixels(image)
        wait(lambda: self.screen() != expected, what)
        time.sleep(0.5)  # for the shot: all of it
        self.shot(name)

    def render(self, *more):
        """What `refraster render` makes of the same arguments."""
        path = self.folder / "expected.png"
        subprocess.run([self.program, "render", *more, "-q", "-o", path], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL)
        return path

    def lines(self):
        return (self.folder / "out.txt").read_text().splitlines()

    def picture(self, stem, aov=None):
        """Presses P; judges what is written, and gives the path of the image."""
        count = len(self.lines())
        self.key("p")
        if not wait(lambda: len(self.lines()) > count, f"P writes {stem}"):
            return None
        image, camera, script = (self.folder / f"{stem}{end}" for end in (".png", ".camera.json", ".sh"))
        check(image.exists() and camera.exists() and script.exists(), f"{stem}: all three files are there")
        written = image.read_bytes()
        subprocess.run(["sh", script, "again.png"], cwd="/", check=True, stdout=subprocess.DEVNULL)
        check((self.folder / "again.png").read_bytes() == written, f"{stem}: the script makes the same bytes")
        image.unlink()
        subprocess.run(self.lines()[-1], shell=True, cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        check(image.read_bytes() == written, f"{stem}: the printed command makes the same bytes")
        check(set(json.loads(camera.read_text())) == {"position", "target", "up", "fov_y", "near", "far"},
              f"{stem}: the camera is one")
        if aov:
            check((self.folder / f"{stem}.{aov}.pfm").exists(), f"{stem}: its {aov} is beside it")
        return image

    def camera(self, stem):
        return json.loads((self.folder / f"{stem}.camera.json").read_text())

    def press_close(self):
        """What a window manager sends when its button is pressed (ICCCM, 4.2.8): there is none here, and xdotool sends no
        such message."""

        class ClientMessage(ctypes.Structure):
            _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                        ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("rest", ctypes.c_long * 24)]

        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype, x11.XInternAtom.restype = ctypes.c_void_p, ctypes.c_ulong
        display = ctypes.c_void_p(x11.XOpenDisplay(None))
        protocols, close = (x11.XInternAtom(display, name, 0) for name in (b"WM_PROTOCOLS", b"WM_DELETE_WINDOW"))
        message = ClientMessage(type=33, window=int(self.window), message_type=protocols, format=32)
        message.data[0] = close
        x11.XSendEvent(display, ctypes.c_ulong(int(self.window)), 0, ctypes.c_long(0), ctypes.byref(message))
        x11.XCloseDisplay(display)  # after what was sent has arrived

    def cpu_ticks(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return int(fields[11]) + int(fields[12])

    def ends(self, code, how):
        self.process.wait()
        check(self.process.returncode == code, f"{how} ends it with {code}, found {self.process.returncode}")


SCENE = """{"scene": {
  "camera": {"position": "0 1 4", "target": "0 0 0", "fov_y": 40, "movement_speed": 2, "mouse_sensitivity": 0.2},
  "background": "0.1 0.2 0.3",
  "picture": {"width": 480, "height": 320, "samples": 4, "srgb": true},
  "point_lights": [{"position": [2, 3, 4], "radiance": [8, 8, 8], "constant": 1, "linear": 0, "quadratic": 0.2}],
  "direction_lights": [{"direction": "-1 -1 -1", "radiance": "0.4 0.3 0.2"}],
  "objects": [
    {"obj_file_path": "ball.obj", "fragment_function": "phong", "position": "0 0 0",
     "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
     "material": {"ka": "0.05 0.05 0.05", "kd": "0.7 0.4 0.2", "ks": "0.5 0.5 0.5", "glossiness": 20}},
    {"mesh": {"plane": {"segments": 2}}, "fragment_function": "blinn_phong", "position": "0 -1 0",
     "rotate_x": 0, "rotate_y": 30, "rotate_z": 0, "scale": "3 1 3",
     "material": {"ka": "0.02 0.02 0.02", "kd": "0.3 0.5 0.3", "ks": "0.2 0.2 0.2", "glossiness": 50}}
  ]}}"""


def without_display(program, folder):
    """Exit code 5, and one line that says what else there is."""
    nowhere = {key: value for key, value in os.environ.items()
               if key not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    done = subprocess.run([program, "view", "ball.json"], cwd=folder, env=nowhere, stderr=subprocess.PIPE, text=True)
    if "built without a window" in done.stderr:
        check(done.returncode == 5, "a program without a window says so with exit code 5")
        print("skipped: " + done.stderr.strip())
        sys.exit(1 if faults else 77)
    check(done.returncode == 5, f"no display is exit code 5, found {done.returncode}")
    check(len(done.stderr.splitlines()) == 1 and "render" in done.stderr and "turntable" in done.stderr,
          f"no display is one line that names render and turntable: {done.stderr}")


def looks_around(viewer):
    viewer.shows(viewer.render("ball.json"), "the first picture is what render makes")
    viewer.shot("first")
    first = viewer.picture("ball-001")
    viewer.shows(first, "what P writes is what the window shows")

    before = viewer.cpu_ticks()
    time.sleep(3)
    check(viewer.cpu_ticks() - before <= 0.1 * os.sysconf("SC_CLK_TCK") * 3, "a still window uses no processor")

    # Each key that moves, and the mouse: another camera each time, whose picture is made again by its command.
    number, cameras = 1, [viewer.camera("ball-001")]

    def moved(what):
        nonlocal number
        number += 1
        image = viewer.picture(f"ball-{number:03}")
        viewer.shows(image, f"{what}: the window shows what P writes")
        check(viewer.camera(f"ball-{number:03}") not in cameras, f"{what} moves the camera")
        cameras.append(viewer.camera(f"ball-{number:03}"))

    for key in ("w", "a", "s", "d", "Prior", "Next"):
        viewer.xdotool("keydown", key)
        time.sleep(0.15)
        viewer.xdotool("keyup", key)
        moved(key)
    viewer.drag((200, 150), (260, 170))
    moved("drag")
    check(cameras[-1]["position"] == cameras[-2]["position"], "a drag turns the head, and the eye stays")
    viewer.at(240, 160)
    viewer.xdotool("click", 4)
    moved("wheel")
    viewer.key("Tab")
    viewer.drag((200, 150), (260, 170))
    moved("drag around")
    check(cameras[-1]["target"] == cameras[-2]["target"], "around the target, the target stays")
    viewer.shot("moved")
    viewer.key("Tab", "Home")
    viewer.shows(first, "Home goes back to the scene's camera")
    return number


def switches(viewer, number):
    first = viewer.folder / "ball-001.png"

    def switched(keys, what, *options):
        nonlocal number
        for key in keys:
            viewer.key(key)
        expected = viewer.render("ball.json", *options)
        viewer.shows(expected, f"{what}: as render {options}")
        number += 1
        image = viewer.picture(f"ball-{number:03}")
        check(image.read_bytes() == expected.read_bytes(), f"{what}: P writes what render makes")

    off = "--set=/scene/{}/0/radiance=[0,0,0]".format
    on = ["--set=/scene/point_lights/0/shadow=\"exact\"", "--set=/scene/direction_lights/0/shadow=\"exact\""]
    switched(["1"], "the first light off", off("point_lights"))
    switched(["1", "2"], "the second light off", off("direction_lights"))
    switched(["2", "o"], "shadows on", *on)
    switched(["o", "n"], "float", "--precision", "float")
    switched(["n"], "fast", "--precision", "fast")
    viewer.key("n", "n")
    switched(["f", "f"], "blinn_phong for all", "--fragment-function", "blinn_phong")
    functions = subprocess.run([viewer.program, "list", "fragment-functions"], check=True, stdout=subprocess.PIPE,
                               text=True).stdout.splitlines()
    for _ in range(len([name for name in functions if not name.startswith(" ")]) - 1):
        viewer.key("f")  # those whose parameters the scene has not say so, and the picture stays
        time.sleep(0.5)
    viewer.shot("not_this_function")
    viewer.shows(first, "after the last fragment function comes the scene's own")

    viewer.key("e")
    viewer.shows_over(first, "edges are seen", "edges")
    viewer.key("e")
    viewer.shows(first, "and not any more")
    viewer.key("h")
    viewer.shows_over(first, "help is seen", "help")
    viewer.key("h")
    viewer.shows(first, "and not any more")
    viewer.click(240, 160)
    viewer.shows_over(first, "a click shows the pixel's story", "story")
    wait(lambda: viewer.screen() != pixels(first), "the story stays")
    viewer.key("Escape")
    viewer.shows(first, "Esc closes it, and leaves the window")

    aovs = ["depth", "normal", "position", "uv", "albedo", "triangle", "object", "distance", "alpha", "material"]
    seen = [pixels(first)]
    for aov in aovs:
        viewer.key("v")
        wait(lambda: viewer.screen() not in seen, f"{aov} is seen")
        time.sleep(0.5)
        viewer.shot(f"aov_{aov}")
        seen.append(viewer.screen())
        number += 1
        viewer.picture(f"ball-{number:03}", aov)
    viewer.key("v")
    viewer.shows(first, "after the last AOV comes the colour")
    return number


def watches(viewer, number):
    scene, mesh = viewer.folder / "ball.json", viewer.folder / "ball.obj"
    viewer.drag((200, 150), (260, 170))
    number += 1
    moved = viewer.picture(f"ball-{number:03}")
    kept = viewer.camera(f"ball-{number:03}")

    def after(what):
        nonlocal number
        number += 1
        image = viewer.picture(f"ball-{number:03}")
        viewer.shows(image, f"{what}: shown")
        check(viewer.camera(f"ball-{number:03}") == kept, f"{what}: the camera stays where it was moved to")
        return image

    viewer.shows(moved, "the moved picture")
    scene.write_text(SCENE.replace("0.1 0.2 0.3", "0.5 0.1 0.1"))
    wait(lambda: viewer.screen() != pixels(moved), "a scene that changes is read again")
    check(pixels(after("another background")) != pixels(moved), "it is another picture")
    scene.write_text(SCENE.replace('"glossiness": 20', '"glossiness": "much"'))
    good = viewer.folder / f"ball-{number:03}.png"
    viewer.shows_over(good, "a fault is shown", "fault")
    check(viewer.process.poll() is None, "a fault does not end it")
    scene.write_text(SCENE)
    viewer.shows(moved, "a scene that is right again is shown")
    text = mesh.read_text()
    mesh.write_text("v 0 0 x\n")
    viewer.shows_over(moved, "a fault in a mesh is shown", "fault_in_mesh")
    mesh.unlink()
    time.sleep(1)
    check(viewer.process.poll() is None, "a mesh that is gone does not end it")
    mesh.write_text(text)
    viewer.shows(moved, "a mesh that is back is shown")
    scene.write_text(SCENE.replace("0 1 4", "0 2 4"))
    viewer.shows(viewer.render("ball.json"), "where the scene's own camera changes, it is taken")
    scene.write_text(SCENE)
    viewer.shows(viewer.folder / "ball-001.png", "and back")


def main(program, shots):
    missing = [tool for tool in ("Xvfb", "xdotool", "import", "convert") if not shutil.which(tool)]
    folder = pathlib.Path(tempfile.mkdtemp(prefix="refraster_view_"))
    server = None
    try:
        (folder / "ball.json").write_text(SCENE)
        subprocess.run([program, "mesh", "sphere", "--segments", "24", "--rings", "12", "-o", "ball.obj"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        without_display(program, folder)
        if missing:
            print(f"skipped: no {', '.join(missing)}: scripts/setup view")
            return 1 if faults else 77
        read, write = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
                                   "-noreset"],
                                  pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as display:
            os.environ["DISPLAY"] = ":" + display.readline().strip()

        viewer = Viewer(program, folder, ["ball.json"], shots)
        number = looks_around(viewer)
        number = switches(viewer, number)
        watches(viewer, number)
        viewer.xdotool("windowsize", viewer.window, 401, 299)
        viewer.shows(viewer.render("ball.json", "--size", "401x299"), "another size of the window is another picture")
        viewer.key("q")
        viewer.ends(0, "Q")

        viewer = Viewer(program, folder, ["ball.obj", "--size", "300x300", "--background", "1,1,1", "--fov", "20"],
                        shots)
        viewer.shows(viewer.render("ball.obj", "--size", "300x300", "--background", "1,1,1", "--fov", "20"),
                     "a model is shown as render shows it")
        viewer.drag((100, 150), (180, 120))
        viewer.shows(viewer.picture(next_stem(folder)), "a model that was turned")
        viewer.shot("model")
        viewer.key("Escape")
        viewer.ends(0, "Esc")

        viewer = Viewer(program, folder, ["ball.json"], shots)
        viewer.process.send_signal(signal.SIGINT)
        viewer.ends(130, "SIGINT")
        viewer = Viewer(program, folder, ["ball.json"], shots)
        viewer.press_close()
        viewer.ends(0, "the window's own button")
    finally:
        if server:
            server.terminate()
            server.wait()
        shutil.rmtree(folder)
    return 1 if faults else 0


def next_stem(folder):
    """Of the picture that P writes next."""
    number = 1
    while any(folder.glob(f"ball-{number:03}.*")):
        number += 1
    return f"ball-{number:03}"


if __name__ == "__main__":
    shots = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    if shots:
        shots.mkdir(parents=True, exist_ok=True)
    sys.exit(main(os.path.abspath(sys.argv[1]), shots))
