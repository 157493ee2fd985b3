"""What the tests of the module have in common."""

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(os.environ.get("REFRASTER_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[3]))


@pytest.fixture
def root():
    return ROOT


@pytest.fixture
def hello():
    return str(ROOT / "scenes/hello.json")


@pytest.fixture
def program():
    """Runs the command `refraster`, which the module is compared with: program(word, ...) gives what subprocess.run does."""
    path = os.environ.get("REFRASTER_PROGRAM", "")
    if not os.path.exists(path):
        pytest.skip("no program: REFRASTER_PROGRAM")
    # A sanitizer's runtime must be there before Python is; the program has one within it, and ends where it finds two.
    environment = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}

    def run(*words, **settings):
        return subprocess.run([path, *map(str, words)], stdout=subprocess.PIPE, env=environment, **settings)

    return run


@pytest.fixture
def triangle_scene():
    """A white triangle that covers the lower left half of the image, unlit but for its own light; on black."""
    import numpy as np
    import refraster

    mesh = refraster.Mesh(np.array([[-1, -1, 0], [1, -1, 0], [-1, 1, 0]], np.float32), np.array([[0, 1, 2]], np.uint32))
    material = refraster.Material(refraster.Phong(ka=(0, 0, 0), kd=(0, 0, 0), ks=(0, 0, 0)), emissive=(1, 0.5, 0.25))
    camera = refraster.Camera(position=(0, 0, 1), target=(0, 0, 0), fov_y=90, near=0.5, far=2)
    return refraster.Scene(camera=camera, objects=[refraster.Object(mesh, material, name="half")], size=(16, 16))
