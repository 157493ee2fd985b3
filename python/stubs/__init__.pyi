"""A reference for images of triangles: renders, compares and explains them, without a GPU. docs/python.md

Images are arrays with the top row first. Colours are linear r, g, b; angles are degrees; lengths are units of the scene.
"""

from os import PathLike
from typing import Any, Callable, Dict, Iterable, List, Literal, Optional, Sequence, Tuple, Type, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import brdf as brdf

__version__: str

_Path = Union[str, bytes, PathLike[str], PathLike[bytes]]
_Vector = Union[Sequence[float], NDArray[Any]]
_Size = Tuple[int, int]
_Precision = Literal["double", "float", "fast", "exact"]
_Progress = Optional[Callable[[float], object]]
_FragmentFunction = Union["Phong", "BlinnPhong", "Merl", "Microfacet"]

fragment_functions: Dict[str, Type[Any]]

class Error(Exception): ...

class InputError(Error, ValueError):
    faults: List[Dict[str, Any]]
    unlisted: int
    advice: str

class OutputError(Error, OSError): ...
class UsageError(Error, ValueError): ...

class Mesh:
    def __init__(
        self,
        positions: ArrayLike,
        triangles: ArrayLike,
        *,
        normals: Optional[ArrayLike] = ...,
        uvs: Optional[ArrayLike] = ...,
        colours: Optional[ArrayLike] = ...,
        tangents: Optional[ArrayLike] = ...,
    ) -> None: ...
    @staticmethod
    def allocate(vertices: int, triangles: int, attributes: Union[str, Sequence[str]] = ...) -> Mesh: ...
    @property
    def positions(self) -> NDArray[np.float32]: ...
    @property
    def normals(self) -> NDArray[np.float32]: ...
    @property
    def uvs(self) -> NDArray[np.float32]: ...
    @property
    def colours(self) -> NDArray[np.float32]: ...
    @property
    def tangents(self) -> NDArray[np.float32]: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    material_runs: List[Tuple[int, Optional[int]]]
    def with_tangents(self) -> Mesh: ...
    def save(self, path: _Path) -> None: ...

def read_mesh(
    path: _Path,
    normals: Union[Literal["file", "smooth", "flat"], float] = ...,
    colours: Literal["linear", "srgb", "ignored"] = ...,
    threads: int = ...,
) -> Mesh: ...
def sphere(*, segments: int = ..., rings: int = ...) -> Mesh: ...
def cube() -> Mesh: ...
def plane(*, segments: int = ...) -> Mesh: ...
def torus(*, segments: int = ..., rings: int = ..., tube_radius: float = ...) -> Mesh: ...
def knot(*, segments: int = ..., rings: int = ..., tube_radius: float = ...) -> Mesh: ...

class Texture:
    def __init__(
        self,
        image: Union[_Path, NDArray[Any]],
        color_space: Literal["linear", "srgb"] = ...,
        channel: Optional[Literal["auto", "red", "green", "blue", "alpha", "luminance"]] = ...,
    ) -> None: ...
    @property
    def values(self) -> NDArray[np.float32]: ...
    @property
    def full_scale(self) -> float: ...

class TextureMap:
    def __init__(
        self,
        texture: Texture,
        *,
        filter: Literal["nearest", "bilinear", "trilinear"] = ...,
        wrap: Literal["repeat", "clamp"] = ...,
        scale: _Vector = ...,
        offset: _Vector = ...,
    ) -> None: ...
    @property
    def texture(self) -> Texture: ...
    filter: str
    wrap: str
    scale: _Vector
    offset: _Vector

class Phong:
    name: str
    def __init__(
        self,
        *,
        ka: _Vector = ...,
        kd: _Vector = ...,
        ks: _Vector = ...,
        glossiness: float = ...,
        specular_gate: bool = ...,
    ) -> None: ...
    ka: _Vector
    kd: _Vector
    ks: _Vector
    glossiness: float
    specular_gate: bool

class BlinnPhong:
    name: str
    def __init__(
        self,
        *,
        ka: _Vector = ...,
        kd: _Vector = ...,
        ks: _Vector = ...,
        glossiness: float = ...,
        specular_gate: bool = ...,
    ) -> None: ...
    ka: _Vector
    kd: _Vector
    ks: _Vector
    glossiness: float
    specular_gate: bool

class Merl:
    name: str
    def __init__(
        self,
        *,
        table: Union[_Path, NDArray[Any]] = ...,
        merl_lookup: Literal["nearest", "trilinear", "trilinear-edge", "trilinear-log", "tricubic-log"] = ...,
        merl_angles: Literal["closed", "rotation", "frame"] = ...,
    ) -> None: ...
    table: Any
    merl_lookup: str
    merl_angles: str

class Microfacet:
    name: str
    def __init__(
        self,
        *,
        base_color: _Vector = ...,
        metallic: float = ...,
        roughness: float = ...,
        fresnel: Literal["schlick", "dielectric", "conductor"] = ...,
        ior: float = ...,
        eta: _Vector = ...,
        k: _Vector = ...,
    ) -> None: ...
    base_color: _Vector
    metallic: float
    roughness: float
    fresnel: str
    ior: float
    eta: _Vector
    k: _Vector

class Material:
    def __init__(
        self,
        function: Optional[_FragmentFunction] = ...,
        *,
        name: str = ...,
        emissive: _Vector = ...,
        opacity_threshold: float = ...,
        normal_scale: float = ...,
        bump_scale: float = ...,
        diffuse_map: Union[TextureMap, Texture, None] = ...,
        specular_map: Union[TextureMap, Texture, None] = ...,
        emissive_map: Union[TextureMap, Texture, None] = ...,
        opacity_map: Union[TextureMap, Texture, None] = ...,
        normal_map: Union[TextureMap, Texture, None] = ...,
        bump_map: Union[TextureMap, Texture, None] = ...,
        roughness_map: Union[TextureMap, Texture, None] = ...,
        metallic_map: Union[TextureMap, Texture, None] = ...,
    ) -> None: ...
    function: Any
    name: str
    emissive: _Vector
    opacity_threshold: float
    normal_scale: float
    bump_scale: float
    diffuse_map: Union[TextureMap, Texture, None]
    specular_map: Union[TextureMap, Texture, None]
    emissive_map: Union[TextureMap, Texture, None]
    opacity_map: Union[TextureMap, Texture, None]
    normal_map: Union[TextureMap, Texture, None]
    bump_map: Union[TextureMap, Texture, None]
    roughness_map: Union[TextureMap, Texture, None]
    metallic_map: Union[TextureMap, Texture, None]

class CameraFit:
    def __init__(
        self, *, azimuth: float = ..., elevation: float = ..., margin: float = ..., distance: Optional[float] = ...
    ) -> None: ...
    azimuth: float
    elevation: float
    margin: float
    distance: Optional[float]

class Camera:
    def __init__(
        self,
        *,
        position: _Vector = ...,
        target: Optional[_Vector] = ...,
        up: _Vector = ...,
        fov_y: float = ...,
        near: Optional[float] = ...,
        far: Optional[float] = ...,
        fit: Optional[CameraFit] = ...,
    ) -> None: ...
    position: Optional[_Vector]
    target: Optional[_Vector]
    up: _Vector
    fov_y: float
    near: Optional[float]
    far: Optional[float]
    fit: Optional[CameraFit]

class ShadowMap:
    def __init__(
        self,
        *,
        size: int = ...,
        filter: Literal["none", "2x2", "pcf3"] = ...,
        bias: float = ...,
        slope_bias: float = ...,
        near: float = ...,
    ) -> None: ...
    @property
    def size(self) -> int: ...
    @property
    def filter(self) -> str: ...
    @property
    def bias(self) -> float: ...
    @property
    def slope_bias(self) -> float: ...
    @property
    def near(self) -> float: ...

class PointLight:
    def __init__(
        self,
        *,
        position: _Vector = ...,
        radiance: _Vector = ...,
        constant: float = ...,
        linear: float = ...,
        quadratic: float = ...,
        shadow: Union[Literal["none", "exact", "map"], ShadowMap] = ...,
        space: Literal["world", "camera"] = ...,
    ) -> None: ...
    position: _Vector
    radiance: _Vector
    constant: float
    linear: float
    quadratic: float
    shadow: Union[Literal["none", "exact", "map"], ShadowMap]
    space: str

class DirectionLight:
    def __init__(
        self,
        *,
        direction: _Vector = ...,
        radiance: _Vector = ...,
        shadow: Union[Literal["none", "exact", "map"], ShadowMap] = ...,
        space: Literal["world", "camera"] = ...,
    ) -> None: ...
    direction: _Vector
    radiance: _Vector
    shadow: Union[Literal["none", "exact", "map"], ShadowMap]
    space: str

class Object:
    def __init__(
        self,
        mesh: Mesh,
        material: Union[Material, _FragmentFunction, None] = ...,
        *,
        name: str = ...,
        position: _Vector = ...,
        rotate_x: float = ...,
        rotate_y: float = ...,
        rotate_z: float = ...,
        scale: _Vector = ...,
        cull: Literal["none", "back"] = ...,
        two_sided: bool = ...,
        materials: Iterable[Material] = ...,
    ) -> None: ...
    mesh: Mesh
    material: Any
    materials: List[Material]
    name: str
    position: _Vector
    rotate_x: float
    rotate_y: float
    rotate_z: float
    scale: _Vector
    cull: str
    two_sided: bool

class Scene:
    def __init__(
        self,
        *,
        camera: Camera = ...,
        background: _Vector = ...,
        point_lights: Iterable[PointLight] = ...,
        direction_lights: Iterable[DirectionLight] = ...,
        objects: Iterable[Object] = ...,
        size: _Size = ...,
        samples: int = ...,
        srgb: bool = ...,
    ) -> None: ...
    camera: Camera
    background: _Vector
    point_lights: List[PointLight]
    direction_lights: List[DirectionLight]
    objects: List[Object]
    size: _Size
    samples: int
    srgb: bool
    @property
    def path(self) -> str: ...
    @property
    def notes(self) -> List[str]: ...
    def place(self, size: Optional[_Size] = ...) -> None: ...
    def validate(self) -> List[str]: ...
    def render(
        self,
        size: Optional[_Size] = ...,
        precision: _Precision = ...,
        samples: Optional[int] = ...,
        aovs: Union[str, Sequence[str]] = ...,
        *,
        aov_filter: Literal["nearest", "resolve"] = ...,
        crop: Optional[Tuple[int, int, int, int]] = ...,
        srgb: Optional[bool] = ...,
        threads: int = ...,
        tile_size: int = ...,
        color64: bool = ...,
        progress: _Progress = ...,
    ) -> Frame: ...

class Frame:
    @property
    def color(self) -> NDArray[np.float32]: ...
    @property
    def color64(self) -> Optional[NDArray[np.float64]]: ...
    @property
    def rgb8(self) -> NDArray[np.uint8]: ...
    @property
    def aovs(self) -> Dict[str, NDArray[Any]]: ...
    def __getitem__(self, name: str) -> NDArray[Any]: ...
    @property
    def size(self) -> _Size: ...
    @property
    def report(self) -> Dict[str, Any]: ...
    def save(self, path: _Path, aov: Optional[str] = ..., quality: int = ...) -> None: ...

def load(
    path: _Path,
    *,
    allow_outside: bool = ...,
    exposure: float = ...,
    mesh_cache: Optional[_Path] = ...,
    set: Dict[str, Any] = ...,
    shadow: Optional[Literal["none", "exact", "map"]] = ...,
    shadow_map_size: Optional[int] = ...,
    threads: int = ...,
) -> Scene: ...
def compare(
    a: Union[_Path, NDArray[Any]],
    b: Union[_Path, NDArray[Any]],
    *,
    max_abs: Optional[float] = ...,
    max_rms: Optional[float] = ...,
    max_count: Optional[int] = ...,
    unit: Literal["levels", "values"] = ...,
    alpha: Union[Literal["ignore", "compare"], _Vector, None] = ...,
    premultiplied: Optional[bool] = ...,
    layer: Optional[str] = ...,
    scene: Optional[_Path] = ...,
    flip: bool = ...,
    allow_outside: bool = ...,
) -> Dict[str, Any]: ...
def verify(
    scene: Union[Scene, _Path],
    actual: Union[_Path, NDArray[Any]],
    *,
    device: Optional[_Path] = ...,
    matrices: Optional[Literal["one", "three"]] = ...,
    samples: Optional[int] = ...,
    srgb: Optional[bool] = ...,
    flip_y: bool = ...,
    ids: Optional[_Path] = ...,
    depth: Optional[_Path] = ...,
    layer: Optional[str] = ...,
    alpha: Union[Literal["ignore"], _Vector, None] = ...,
    premultiplied: Optional[bool] = ...,
    fail_on: Optional[Dict[str, int]] = ...,
    allow_outside: bool = ...,
    progress: _Progress = ...,
) -> Dict[str, Any]: ...
def explain(
    scene: Union[Scene, _Path],
    x: int,
    y: int,
    *,
    size: Optional[_Size] = ...,
    samples: Optional[int] = ...,
    srgb: Optional[bool] = ...,
    actual: Optional[_Path] = ...,
    layer: Optional[str] = ...,
    device: Optional[_Path] = ...,
    allow_outside: bool = ...,
) -> Dict[str, Any]: ...
def bench(
    scenes: Union[Scene, _Path, Sequence[Union[Scene, _Path]], None] = ...,
    *,
    size: _Size = ...,
    precisions: Union[str, Sequence[str], None] = ...,
    threads: Union[int, Sequence[int], None] = ...,
    samples: int = ...,
    frames: int = ...,
    seconds: float = ...,
    marginals: bool = ...,
    errors: bool = ...,
    allow_outside: bool = ...,
    progress: _Progress = ...,
) -> Dict[str, Any]: ...
