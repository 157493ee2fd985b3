"""Rendering: arrays, their shapes and values, memory, Ctrl-C, threads."""

import gc
import os
import signal
import threading
import time

import numpy as np
import pytest
import refraster


def test_a_frame_has_arrays_with_the_top_row_first(triangle_scene):
    frame = triangle_scene.render(aovs=["depth", "normal", "uv", "object"])
    assert frame.color.shape == (16, 16, 3) and frame.color.dtype == np.float32
    assert frame.rgb8.shape == (16, 16, 3) and frame.rgb8.dtype == np.uint8
    assert frame["depth"].shape == (16, 16) and frame["depth"].dtype == np.float32
    assert frame["normal"].shape == (16, 16, 3) and frame.aovs["uv"].shape == (16, 16, 2)
    assert frame["object"].dtype == np.uint32
    # At distance 1 with 90 degrees the image shows [-1, 1]: the triangle is its lower left half.
    assert frame.color[15, 0].tolist() == [1, 0.5, 0.25] and frame.color[0, 15].tolist() == [0, 0, 0]
    assert frame["object"][15, 0] == 1 and frame["object"][0, 15] == 0
    assert frame["normal"][15, 0].tolist() == [0, 0, 1]
    # z/w between near 0.5 and far 2 at distance 1: (1/0.5 - 1) / (1/0.5 - 1/2) = 2/3.
    assert frame["depth"][15, 0] == pytest.approx(2 / 3, rel=2**-22) and frame["depth"][0, 15] == 1
    assert frame.rgb8[15, 0].tolist() == [255, 128, 64]
    assert frame.color64 is None and frame.size == (16, 16)
    assert frame.report["counts"]["triangles"]["drawn"] == 1 and frame.report["size"] == [16, 16]


def test_arrays_are_the_frames_own_memory_and_outlive_it(triangle_scene):
    frame = triangle_scene.render()
    color = frame.color
    assert not color.flags.owndata and np.shares_memory(color, frame.color)
    expected = color.copy()
    del frame
    gc.collect()
    triangle_scene.render()
    assert np.array_equal(color, expected)


def test_size_crop_samples_and_precisions(triangle_scene):
    whole = triangle_scene.render(size=(40, 20), samples=4)
    part = triangle_scene.render(size=(40, 20), samples=4, crop=(8, 4, 16, 10))
    assert whole.color.shape == (20, 40, 3) and part.color.shape == (10, 16, 3)
    assert np.array_equal(part.color, whole.color[4:14, 8:24])
    double = triangle_scene.render(color64=True)
    assert double.color64.dtype == np.float64
    assert np.array_equal(double.color64.astype(np.float32), double.color)
    for precision in ["float", "fast", "exact"]:
        assert np.allclose(triangle_scene.render(precision=precision).color, double.color, rtol=0, atol=2**-20)


def test_a_frame_is_saved_in_the_format_of_its_name(triangle_scene, tmp_path):
    frame = triangle_scene.render(aovs=["depth", "uv"])
    frame.save(tmp_path / "x.npy")
    assert np.array_equal(np.load(tmp_path / "x.npy"), frame.color)
    frame.save(tmp_path / "d.npy", aov="depth")
    assert np.array_equal(np.load(tmp_path / "d.npy").squeeze(), frame["depth"])
    for name in ["x.png", "x.jpg", "x.exr", "x.hdr", "x.pfm"]:
        frame.save(tmp_path / name)
    assert refraster.compare(tmp_path / "x.png", tmp_path / "x.png")["same"]
    with pytest.raises(refraster.UsageError, match=r'path: found "x.doc", expected a name ending in \.png'):
        frame.save("x.doc")
    with pytest.raises(refraster.UsageError, match='found "normal", expected one of depth, uv'):
        frame.save(tmp_path / "x.npy", aov="normal")
    with pytest.raises(refraster.OutputError):
        frame.save(tmp_path / "nowhere" / "x.png")


def test_progress_is_called_in_the_calling_thread_and_rises_to_1(hello):
    seen = []
    refraster.load(hello).render(size=(320, 180), progress=lambda done: seen.append((done, threading.get_ident())))
    assert seen[-1][0] == 1 and seen == sorted(seen)
    assert {thread for _, thread in seen} == {threading.get_ident()}


def test_what_progress_raises_ends_the_frame(hello):
    def stop(done):
        raise RuntimeError("enough")

    scene = refraster.load(hello)
    with pytest.raises(RuntimeError, match="enough"):
        scene.render(size=(2000, 2000), samples=16, progress=stop)
    assert scene.render(size=(8, 8)).color.shape == (8, 8, 3)


def endless(scene):
    """A frame of minutes."""
    return scene.render(size=(4000, 4000), precision="exact")


def test_ctrl_c_stops_a_frame(hello):
    scene = refraster.load(hello)
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        endless(scene)
    timer.join()
    assert scene.render(size=(8, 8)).color.shape == (8, 8, 3)


def test_other_threads_of_python_go_on_while_a_frame_is_rendered(hello):
    scene = refraster.load(hello)
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    scene.render(size=(1280, 720), samples=4)
    done.set()
    counter.join()
    assert counted > 3  # with the lock held, it would have counted to 1


def test_frames_of_several_threads_are_those_of_one(hello):
    scene = refraster.load(hello)
    alone = scene.render(size=(160, 90)).color
    found = [None] * 4

    def work(i):
        found[i] = scene.render(size=(160, 90), threads=1 + i % 2).color

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(each, alone) for each in found)


@pytest.mark.parametrize(
    "given, message",
    [
        ({"size": (0, 5)}, r"size: found \(0, 5\), expected \(width, height\), whole numbers from 1 to 16384"),
        ({"size": "640x360"}, 'size: found "640x360", expected'),
        ({"precision": "duoble"}, 'precision: found "duoble", expected "double" or "float" or "fast" or "exact"'),
        ({"samples": 3}, "samples: found 3, expected 1, 2, 4, 8 or 16"),
        ({"aovs": ["depht"]}, 'aovs: found "depht", expected one of .*did you mean depth'),
        ({"crop": (0, 0, 17, 1)}, "crop: found .*within the image of 16x16"),
        ({"tile_size": 7}, "tile_size: found 7, expected a whole number from 8 to 128"),
    ],
)
def test_a_wrong_argument_is_told_with_what_was_expected(triangle_scene, given, message):
    with pytest.raises(refraster.UsageError, match=message):
        triangle_scene.render(**given)
    with pytest.raises(ValueError):
        triangle_scene.render(**given)
