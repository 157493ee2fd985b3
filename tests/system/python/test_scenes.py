"""Scenes: read, made and changed in Python; meshes and textures of arrays."""

import numpy as np
import pytest
import refraster


def test_a_scene_renders_as_the_program_does(hello, program, tmp_path):
    program("render", "-q", hello, "--size", "160x90", "-o", tmp_path / "x.npy", check=True)
    assert np.array_equal(np.load(tmp_path / "x.npy"), refraster.load(hello).render(size=(160, 90)).color)


def test_a_model_is_framed_and_lit_as_the_program_does(program, tmp_path):
    model = tmp_path / "model.obj"
    refraster.torus(segments=12, rings=8).save(model)
    program("render", "-q", model, "--size", "80x60", "-o", tmp_path / "x.npy", check=True)
    scene = refraster.load(model)
    frame = scene.render(size=(80, 60))
    assert np.array_equal(np.load(tmp_path / "x.npy"), frame.color)
    # Placed for good, it is the same, and may be changed.
    assert scene.camera.fit is not None and scene.camera.position is None
    with pytest.raises(refraster.UsageError, match="Camera.position: found a camera with a fit"):
        scene.camera.position = (0, 0, 9)
    scene.place((80, 60))
    assert scene.camera.fit is None and all(light.space == "world" for light in scene.direction_lights)
    assert np.array_equal(scene.render(size=(80, 60)).color, frame.color)
    x, y, z = scene.camera.position
    scene.camera.position = (x, y, z + 1)
    assert not np.array_equal(scene.render(size=(80, 60)).color, frame.color)


def test_values_of_a_file_are_set_before_it_is_read(hello):
    scene = refraster.load(hello, set={"/scene/camera/fov_y": 50, "/scene/background": [1, 0, 0]})
    assert scene.camera.fov_y == 50 and scene.background == (1, 0, 0)


def test_a_wrong_file_is_told_with_all_of_its_faults(tmp_path):
    path = tmp_path / "wrong.json"
    path.write_text('{"scene": {"camera": {"position": "0 0 1", "fov_y": 200}, "point_lights": 3, '
                    '"direction_lights": [], "objects": []}}')
    with pytest.raises(refraster.InputError) as caught:
        refraster.load(path)
    faults = caught.value.faults
    assert [fault["path"] for fault in faults] == ["/scene/camera/fov_y", "/scene/point_lights"]
    assert faults[0]["found"] == "200" and faults[0]["line"] == 1 and faults[0]["file"] == str(path)
    assert str(caught.value) == "\n".join(fault["text"] for fault in faults)
    with pytest.raises(refraster.InputError, match="no such file"):
        refraster.load(tmp_path / "nothing.json")


def test_changes_of_materials_and_lights_are_seen(triangle_scene):
    triangle_scene.objects[0].material.emissive = (0, 0, 0)
    triangle_scene.objects[0].material.function.kd = (1, 1, 1)
    assert triangle_scene.render().color[15, 0].tolist() == [0, 0, 0]
    triangle_scene.direction_lights.append(refraster.DirectionLight(direction=(0, 0, -1), radiance=(0.5, 0.25, 0)))
    assert triangle_scene.render().color[15, 0].tolist() == [0.5, 0.25, 0]
    triangle_scene.objects.clear()
    assert not triangle_scene.render().color.any()


def test_fragment_functions_have_the_parameters_that_the_library_declares():
    assert set(refraster.fragment_functions) == {"phong", "blinn_phong", "merl", "microfacet"}
    phong = refraster.Phong(kd=np.array([0.5, 0.25, 0]), glossiness=20, specular_gate=True)
    assert phong.kd == (0.5, 0.25, 0) and phong.glossiness == 20 and phong.specular_gate is True
    assert repr(refraster.Microfacet(roughness=0.5)).startswith("Microfacet(base_color=(1.0, 1.0, 1.0), metallic=1.0")
    assert "exponent of the highlight; a number >= 0" in refraster.Phong.glossiness.__doc__


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: refraster.Phong(kd=(1, 2)), r"Phong.kd: found \(1, 2\), expected three numbers >= 0"),
        (lambda: refraster.Phong(glossiness=-1), "Phong.glossiness: found -1, expected a number >= 0"),
        (lambda: refraster.Phong(glosiness=1), 'Phong: found the keyword "glosiness".*did you mean glossiness'),
        (lambda: refraster.Microfacet(fresnel="x"), 'found "x", expected "schlick" or "dielectric" or "conductor"'),
        (lambda: refraster.PointLight(shadow="soft"), 'PointLight.shadow: found "soft", expected "none" or "exact" or "map" or a ShadowMap'),
        (lambda: refraster.DirectionLight(direction=(0, 0, 0)), r"found \(0, 0, 0\), expected three numbers"),
        (lambda: refraster.Camera(fov_y=180), "Camera.fov_y: found 180, expected a number > 0 and < 180"),
        (lambda: refraster.Camera(fit=3), "Camera.fit: found 3, expected a CameraFit or None"),
        (lambda: refraster.CameraFit(distance=0), "CameraFit.distance: found 0, expected a number > 0"),
        (lambda: refraster.Object("mesh"), 'Object.mesh: found "mesh", expected a Mesh'),
        (lambda: refraster.Material(3), "Material.function: found 3, expected a fragment function"),
        (lambda: refraster.sphere(segments=2), "sphere.segments: found 2, expected a whole number from 3 to 4096"),
        (lambda: refraster.Scene(objects=[1]).render(), "objects/0: found 1, expected a refraster.Object"),
    ],
)
def test_a_wrong_value_is_told_with_what_was_expected(make, message):
    with pytest.raises(refraster.UsageError, match=message):
        make()


def grid(n):
    """n x n vertices on [-1, 1]^2, and their triangles."""
    x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    positions = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
    a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).reshape(-1)
    triangles = np.concatenate([np.stack([a, a + 1, a + n + 1], -1), np.stack([a, a + n + 1, a + n], -1)])
    return positions, triangles


def test_meshes_of_any_layout_are_the_same():
    positions, triangles = grid(5)
    plain = refraster.Mesh(positions.astype(np.float32), triangles.astype(np.uint32))
    for other in [
        refraster.Mesh(positions, triangles),
        refraster.Mesh(np.asfortranarray(positions), triangles.astype(np.int16)),
        refraster.Mesh(positions.tolist(), triangles.tolist()),
        refraster.Mesh(np.repeat(positions, 2, 0)[::2], triangles[::-1][::-1]),
    ]:
        assert np.array_equal(other.positions, plain.positions) and np.array_equal(other.triangles, plain.triangles)
    assert np.array_equal(plain.normals, np.tile(np.float32([0, 0, 1]), (25, 1)))
    assert plain.uvs.shape == (0, 2)


def test_a_mesh_copies_what_it_is_given_and_its_arrays_are_its_own(triangle_scene):
    positions = np.array([[-1, -1, 0], [1, -1, 0], [-1, 1, 0]], np.float32)
    mesh = refraster.Mesh(positions, np.uint32([[0, 1, 2]]))
    positions[:] = 0
    assert mesh.positions[0, 0] == -1 and not mesh.positions.flags.owndata
    triangle_scene.objects[0].mesh = mesh
    assert triangle_scene.render().color.any()
    mesh.positions[:] = mesh.positions * 0  # in place: no area is left
    assert not triangle_scene.render().color.any()


def test_an_allocated_mesh_is_filled_in_place(triangle_scene):
    expected = triangle_scene.render().color
    mesh = refraster.Mesh.allocate(3, 1, attributes=["uvs"])
    assert mesh.uvs.shape == (3, 2) and not mesh.triangles.any()
    mesh.positions[:] = [[-1, -1, 0], [1, -1, 0], [-1, 1, 0]]
    mesh.normals[:] = [0, 0, 1]
    mesh.triangles[:] = [[0, 1, 2]]
    triangle_scene.objects[0].mesh = mesh
    assert np.array_equal(triangle_scene.render().color, expected)
    mesh.triangles[0, 2] = 3  # names no vertex
    assert len(triangle_scene.validate()) == 1
    with pytest.raises(refraster.UsageError, match="triangles"):
        triangle_scene.render()


def test_the_arrays_of_a_mesh_from_a_file_are_not_to_be_written_to(tmp_path):
    refraster.cube().save(tmp_path / "cube.obj")
    mesh = refraster.read_mesh(tmp_path / "cube.obj")
    with pytest.raises(ValueError, match="read-only"):
        mesh.positions[0] = 0


@pytest.mark.parametrize(
    "given, message",
    [
        (([[0, 0]], [[0, 0, 0]]), r"positions: found \[\[0, 0\]\], expected an array of numbers with shape \(vertices, 3\)"),
        (([[0, 0, 0]], [[0, 0, 1]]), r"triangles\[0\]: found index 1, expected one of the 1 vertices, from 0"),
        (([[0, 0, 0]], [[0, 0, -1]]), r"triangles\[0\]: found index -1"),
        (([[0, 0, 0]], [[0, 0, 0.5]]), "expected an array of whole numbers"),
        (([[0, 0, 0]], [0, 0, 0]), "expected an array of whole numbers"),
    ],
)
def test_a_wrong_mesh_is_refused(given, message):
    with pytest.raises(refraster.UsageError, match=message):
        refraster.Mesh(*given)


def test_lists_that_do_not_belong_together_are_refused():
    with pytest.raises(refraster.UsageError, match="normals: found 2 rows, expected 1, as many as positions"):
        refraster.Mesh([[0, 0, 0]], [[0, 0, 0]], normals=[[0, 0, 1]] * 2)
    with pytest.raises(refraster.UsageError, match="uvs: found 2 rows, expected at most 1"):
        refraster.Mesh([[0, 0, 0]], [[0, 0, 0]], uvs=[[0, 0]] * 2)
    with pytest.raises(refraster.UsageError, match='Mesh: found the keyword "uv".*did you mean uvs'):
        refraster.Mesh([[0, 0, 0]], [[0, 0, 0]], uv=[[0, 0]])


def test_a_texture_of_an_array_shows_it_upright(triangle_scene):
    mesh = refraster.Mesh(
        [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]], uvs=[[0, 0], [1, 0], [1, 1], [0, 1]]
    )
    image = np.arange(16 * 16 * 3, dtype=np.uint16).reshape(16, 16, 3).astype(np.uint8)
    texture = refraster.Texture(image)
    assert np.array_equal(texture.values, image) and texture.full_scale == 255
    material = refraster.Material(
        refraster.Phong(ka=(1, 1, 1), kd=(0, 0, 0), ks=(0, 0, 0)),
        diffuse_map=refraster.TextureMap(texture, filter="nearest"),
    )
    triangle_scene.objects = [refraster.Object(mesh, material)]
    assert np.array_equal(triangle_scene.render().rgb8, image)
    # Floats are those values; sRGB is decoded.
    material.diffuse_map = refraster.TextureMap(refraster.Texture(image / 255.0), filter="nearest")
    assert np.array_equal(triangle_scene.render().rgb8, image)
    material.diffuse_map = refraster.TextureMap(refraster.Texture(image, color_space="srgb"), filter="nearest")
    assert np.array_equal(triangle_scene.render(srgb=True).rgb8, image)
    material.diffuse_map.filter = "trilinear"  # its smaller levels are made
    assert triangle_scene.validate() == []
    triangle_scene.render()
    material.diffuse_map = None
    assert (triangle_scene.render().rgb8 == 255).all()


def test_a_wrong_texture_is_refused():
    for wrong in [np.zeros((4, 4, 2), np.uint8), np.zeros((4, 4, 3), np.int32), np.zeros((0, 4, 3), np.uint8)]:
        with pytest.raises(refraster.UsageError, match="image: found an array of"):
            refraster.Texture(wrong)
    with pytest.raises(refraster.UsageError, match="expected values from 0 to 1"):
        refraster.Texture(np.full((4, 4), np.nan))


def test_parts_of_a_mesh_have_materials_of_their_own(triangle_scene):
    red, green = (
        refraster.Material(refraster.Phong(ka=(0, 0, 0), kd=(0, 0, 0), ks=(0, 0, 0)), emissive=colour)
        for colour in [(1, 0, 0), (0, 1, 0)]
    )
    mesh = refraster.Mesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 3], [1, 2, 3]])
    mesh.material_runs = [(0, 0), (1, 1)]
    triangle_scene.objects = [refraster.Object(mesh, materials=[red, green])]
    color = triangle_scene.render().color
    assert color[15, 0].tolist() == [1, 0, 0] and color[0, 15].tolist() == [0, 1, 0]


def test_a_measured_table_is_read_from_an_array(triangle_scene):
    with pytest.raises(refraster.UsageError, match="table: found none"):
        triangle_scene.objects[0].material = refraster.Merl()
        triangle_scene.render()
    merl = refraster.Merl(table=np.full((90, 90, 180, 3), 0.25), merl_lookup="nearest")
    assert merl.table.shape == (90, 90, 180, 3) and merl.table[3, 4, 5, 1] == 0.25
    triangle_scene.objects[0].material = merl
    triangle_scene.direction_lights = [refraster.DirectionLight(direction=(0, 0, -1), radiance=(1, 1, 1))]
    assert triangle_scene.render().color[12, 4].tolist() == [0.25] * 3
