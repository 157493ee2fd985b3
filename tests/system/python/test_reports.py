"""compare, verify, explain, brdf and bench: the dictionaries of the documented JSON."""

import json
import subprocess

import numpy as np
import pytest
import refraster


def of_program(program, *words):
    """What a command of the program writes as JSON."""
    run = program(*words, "--json", "-", stderr=subprocess.DEVNULL)
    assert run.returncode in (0, 1), words
    return json.loads(run.stdout)


@pytest.fixture
def images(hello, tmp_path):
    """A right image of a small scene, and one with a faulty corner."""
    frame = refraster.load(hello).render(size=(64, 36))
    frame.save(tmp_path / "a.png")
    wrong = frame.rgb8.copy()
    wrong[:4, :4] = 255
    np.save(tmp_path / "wrong.npy", wrong)
    return str(tmp_path / "a.png"), str(tmp_path / "wrong.npy")


def test_compare_gives_what_the_program_writes(images, program):
    ours = refraster.compare(*images, max_abs=1)
    assert ours == of_program(program, "compare", *images, "--max-abs", 1)
    assert not ours["same"] and ours["pixels"]["over_max_abs"] == 16


def test_compare_takes_arrays(images):
    wrong = np.load(images[1])
    right = wrong.copy()
    right[:4, :4] = 0
    found = refraster.compare(right, wrong)
    assert found["a"] == "a" and not found["same"] and found["pixels"]["over_max_abs"] == 16
    assert refraster.compare(right, right)["same"]
    assert refraster.compare(right / 255.0, wrong / 255.0, unit="values", max_abs=1)["same"]
    assert refraster.compare(right[:, :, 0], right[:, :, 0])["channels"] == 1
    with pytest.raises(refraster.UsageError, match="b: found an array of uint8 with shape .*, expected the shape"):
        refraster.compare(right, wrong[1:])
    with pytest.raises(refraster.UsageError, match="expected an array, as a is"):
        refraster.compare(right, "x.png")


def test_verify_gives_what_the_program_writes(hello, images, program):
    assert refraster.verify(hello, images[0]) == of_program(program, "verify", hello, images[0])


def test_verify_takes_scenes_and_arrays(hello, images):
    scene = refraster.load(hello)
    right = refraster.verify(scene, scene.render(size=(64, 36)).rgb8)
    assert right["passes"] and right["pixels"]["exact"] == right["pixels"]["all"] == 64 * 36
    scene.objects[0].material.function.kd = (0, 0, 0)  # the scene as it is in Python is judged
    assert refraster.verify(scene, scene.render(size=(64, 36)).color)["passes"]
    with pytest.raises(refraster.UsageError, match='fail_on: found "dept", expected one of'):
        refraster.verify(scene, np.load(images[1]), fail_on={"dept": 1})
    with pytest.raises(refraster.InputError):
        refraster.verify(scene, np.load(images[1]), device="nothing")


@pytest.mark.slow
def test_verify_finds_what_is_wrong(hello, images, program):
    assert refraster.verify(hello, images[1]) == of_program(program, "verify", hello, images[1])
    scene = refraster.load(hello)
    wrong = refraster.verify(scene, np.load(images[1]))
    assert not wrong["passes"] and wrong["pixels"]["unexplained"] == 16
    assert refraster.verify(scene, np.load(images[1]), fail_on={"unexplained": 16})["passes"]


def test_explain_gives_what_the_program_writes(hello, images, program):
    words = ["explain", hello, 32, 18, "--size", "64x36"]
    assert refraster.explain(hello, 32, 18, size=(64, 36)) == of_program(program, *words)
    with_actual = of_program(program, "explain", hello, 1, 2, "--actual", images[1], "--device", "llvmpipe")
    assert refraster.explain(hello, 1, 2, actual=images[1], device="llvmpipe") == with_actual
    radiance = refraster.explain(refraster.load(hello), 32, 18, size=(64, 36))["precisions"]["double"]["radiance"]
    frame = refraster.load(hello).render(size=(64, 36), color64=True)
    assert radiance == frame.color64[18, 32].tolist()
    with pytest.raises(refraster.UsageError, match="x: found 64, expected a whole number from 0 to 63"):
        refraster.explain(hello, 64, 0, size=(64, 36))


def test_brdf_gives_what_the_program_writes(program):
    phong = "blinn_phong:kd=0.5,ks=0.1,glossiness=32"
    assert refraster.brdf.eval(phong, angles=[[30, 30, 180], [10, 60, 90]], half=[0, 20, 90]) == of_program(
        program, "brdf", "eval", phong, "--angles", "30,30,180", "--angles", "10,60,90", "--half", "0,20,90")
    f = refraster.brdf.eval("lambert:albedo=0.5", directions=[0, 0, 1, 0, 1, 1])["points"][0]["f"]
    assert f == pytest.approx([0.5 / np.pi] * 3)
    with pytest.raises(refraster.UsageError, match='blinn_phong:kd: found "-1", expected'):
        refraster.brdf.eval("blinn_phong:kd=-1", angles=[0, 0, 0])
    with pytest.raises(refraster.UsageError, match="eval: found nothing, expected one of angles, half, directions"):
        refraster.brdf.eval(phong)
    with pytest.raises(refraster.InputError, match="angles:1"):
        refraster.brdf.eval(phong, angles=[91, 0, 0])
    with pytest.raises(refraster.InputError, match="no such file, expected a MERL table"):
        refraster.brdf.info("lambrt")


@pytest.mark.slow
def test_brdf_info_compare_and_fit_give_what_the_program_writes(program):
    a, b = "lambert:albedo=0.5", "blinn_phong:kd=0.5,ks=0.1,glossiness=32"
    assert refraster.brdf.info(a) == of_program(program, "brdf", "info", a)
    assert refraster.brdf.compare(a, b, max_rms=1) == of_program(program, "brdf", "compare", a, b, "--max-rms", 1)
    assert refraster.brdf.fit(b, "blinn_phong") == of_program(program, "brdf", "fit", b, "--to", "blinn_phong")


@pytest.mark.slow
def test_bench_has_the_members_that_the_program_writes(program, hello):
    options = dict(size=(32, 18), precisions="float", threads=1, frames=3, seconds=0)
    ours = refraster.bench(hello, marginals=False, **options)
    theirs = of_program(program, "bench", hello, "--size", "32x18", "--precisions", "float", "--threads", 1,
                        "--frames", 3, "--seconds", 0, "--no-marginal", "--no-command", "--gl", "none")

    def members(value):
        if isinstance(value, dict):
            return {key: members(each) for key, each in value.items() if key not in ("notes", "caches")}
        return [members(each) for each in value[:1]] if isinstance(value, list) else type(value) is dict

    assert members(ours) == members(theirs)
    in_memory = refraster.bench([refraster.load(hello)], marginals=False, errors=False, **options)
    assert in_memory["results"][0]["triangles"] == ours["results"][0]["triangles"]
