"""Reflectance apart from scenes. All give the dictionaries of docs/reports.md; f is in 1/sr, angles in degrees."""

from os import PathLike
from typing import Any, Dict, Literal, Optional, Union

from numpy.typing import ArrayLike

_Brdf = Union[str, bytes, PathLike[str], PathLike[bytes]]
_Lookup = Literal["nearest", "trilinear", "trilinear-edge", "trilinear-log", "tricubic-log"]

def info(brdf: _Brdf, *, lookup: _Lookup = ...) -> Dict[str, Any]: ...
def eval(
    brdf: _Brdf,
    *,
    angles: Optional[ArrayLike] = ...,
    half: Optional[ArrayLike] = ...,
    directions: Optional[ArrayLike] = ...,
    lookup: _Lookup = ...,
) -> Dict[str, Any]: ...
def compare(
    a: _Brdf,
    b: _Brdf,
    *,
    max_rms: Optional[float] = ...,
    max_cosine_rms: Optional[float] = ...,
    max_log_rms: Optional[float] = ...,
    max_cube_root_rms: Optional[float] = ...,
    lookup: _Lookup = ...,
) -> Dict[str, Any]: ...
def fit(brdf: _Brdf, to: str, lobes: Literal[1, 2, 3] = ..., *, lookup: _Lookup = ...) -> Dict[str, Any]: ...
