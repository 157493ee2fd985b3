"""The examples of the documentation run, and plot something."""

import os
import subprocess
import sys

import pytest

pytest.importorskip("matplotlib", reason="no matplotlib: scripts/setup python")


def run(root, tmp_path, name, *words):
    environment = dict(os.environ, MPLCONFIGDIR=str(tmp_path), ASAN_OPTIONS="detect_leaks=0")
    return subprocess.run([sys.executable, str(root / "python/examples" / name), *map(str, words)], check=True,
                          stdout=subprocess.PIPE, text=True, env=environment, cwd=tmp_path).stdout


def is_plotted(path):
    import matplotlib.image

    pixels = matplotlib.image.imread(path)
    return len(set(map(bytes, pixels.reshape(-1, pixels.shape[-1])[::97]))) > 20


@pytest.mark.slow
def test_from_a_model_to_a_depth_map_and_a_verdict(root, tmp_path):
    import refraster

    refraster.knot(segments=64, rings=8).save(tmp_path / "knot.obj")
    assert run(root, tmp_path, "depth_map.py", "knot.obj", "figure.png") == "passes\n"
    assert is_plotted(tmp_path / "figure.png")


@pytest.mark.slow
def test_cost_against_error(root, tmp_path):
    run(root, tmp_path, "cost_and_error.py", root / "scenes/hello.json", "figure.png")
    assert is_plotted(tmp_path / "figure.png")
