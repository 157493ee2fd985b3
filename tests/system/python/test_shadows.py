"""Shadows of lights, exact and by maps."""

import numpy as np
import pytest
import refraster


def table(shadow):
    """A small square before a large one, which a light from the eye's side falls on at a slant."""
    material = refraster.Material(refraster.Phong(ka=(0, 0, 0), kd=(1, 1, 1), ks=(0, 0, 0)))
    mesh = refraster.Mesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    return refraster.Scene(
        camera=refraster.Camera(position=(0, 0, 4), target=(0, 0, 0), fov_y=28, near=0.5, far=8),
        direction_lights=[refraster.DirectionLight(direction=(-0.5, 0, -1), shadow=shadow)],
        objects=[
            refraster.Object(mesh, material, scale=(1.5, 1.5, 1)),
            refraster.Object(mesh, material, scale=(0.25, 0.25, 1), position=(0, 0, 1)),
        ],
        size=(64, 64),
    )


def shadowed(scene):
    return (scene.render().color == 0).all(axis=2)


def test_a_shadow_falls_where_the_light_is_kept_away():
    assert not shadowed(table("none")).any()
    exact = shadowed(table("exact"))
    # The light goes half a unit to the left on its way: seen from (0, 0, 4), the square stands at 4/3 of its size.
    assert exact[32, 12:15].all() and not exact[32, 36:].any() and not exact[:12].any()
    fine = shadowed(table(refraster.ShadowMap(size=2048)))
    assert exact.any() and (exact != fine).mean() < 0.02
    coarse = shadowed(table(refraster.ShadowMap(size=16)))
    assert (exact != coarse).sum() > (exact != fine).sum()
    assert np.array_equal(table("map").render().color, table(refraster.ShadowMap()).render().color)


def test_each_value_of_a_map_changes_what_is_drawn():
    plain = table(refraster.ShadowMap(size=32)).render().color
    for change in [{"filter": "pcf3"}, {"filter": "none"}, {"bias": 40}, {"slope_bias": 400}]:
        assert not np.array_equal(plain, table(refraster.ShadowMap(size=32, **change)).render().color), change


def test_a_map_is_a_value():
    one = refraster.ShadowMap(size=512, filter="none", bias=0.5, slope_bias=3)
    assert (one.size, one.filter, one.bias, one.slope_bias, one.near) == (512, "none", 0.5, 3, 0)
    assert one == refraster.ShadowMap(size=512, filter="none", bias=0.5, slope_bias=3) and one != refraster.ShadowMap()
    assert repr(one) == "ShadowMap(size=512, filter='none', bias=0.5, slope_bias=3.0, near=0.0)"
    light = refraster.PointLight(shadow=one)
    assert light.shadow == one and refraster.PointLight().shadow == "none"
    with pytest.raises(AttributeError):
        light.shadow.size = 1024
    light.shadow = "map"
    assert light.shadow == refraster.ShadowMap()
    light.shadow = "exact"
    assert light.shadow == "exact"


@pytest.mark.parametrize(
    "given, message",
    [
        ({"size": 15}, "ShadowMap.size: found 15, expected a whole number from 16 to 8192"),
        ({"filter": "3x3"}, 'ShadowMap.filter: found "3x3", expected "none" or "2x2" or "pcf3"'),
        ({"bias": -1}, "ShadowMap.bias: found -1, expected a number >= 0"),
        ({"sise": 512}, 'ShadowMap: found the keyword "sise".*did you mean size'),
    ],
)
def test_a_wrong_map_is_refused(given, message):
    with pytest.raises(refraster.UsageError, match=message):
        refraster.ShadowMap(**given)


def test_maps_of_a_file_are_read_and_may_be_replaced(root, program, tmp_path):
    room = str(root / "scenes/gallery/room.json")
    scene = refraster.load(room)
    lights = scene.point_lights + scene.direction_lights
    assert any(isinstance(light.shadow, refraster.ShadowMap) for light in lights)
    small = refraster.load(room, shadow_map_size=16)
    assert {light.shadow.size for light in small.point_lights + small.direction_lights
            if isinstance(light.shadow, refraster.ShadowMap)} == {16}
    exact = refraster.load(room, shadow="exact")
    assert {light.shadow for light in exact.point_lights + exact.direction_lights} <= {"none", "exact"}
    small_maps = refraster.load(room, shadow="map", shadow_map_size=16)
    for given, of in [("map:16", small_maps), ("exact", exact)]:
        program("render", "-q", room, "--shadow", given, "--size", "64x48", "-o", tmp_path / "x.npy", check=True)
        assert np.array_equal(np.load(tmp_path / "x.npy"), of.render(size=(64, 48)).color), given
    for given, message in [({"shadow": "soft"}, 'shadow: found "soft"'), ({"shadow_map_size": 15}, "shadow_map_size: found 15")]:
        with pytest.raises(refraster.UsageError, match=message):
            refraster.load(room, **given)
