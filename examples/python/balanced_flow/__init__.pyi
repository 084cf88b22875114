# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, overload

from numpy.typing import ArrayLike, NDArray

_Array = NDArray[Any]  # of float64 or float32, as the points
_Callback = Callable[[float], object]
_Flow = Literal["balanced", "volume-preserving", "well-posed", "anisotropic", "curvature"]
_Curvature = Literal["learned", "tangent-plane", "covariance"]

class Canceled(Exception): ...

@dataclass(frozen=True)
class Report:
    number_of_points: int
    number_of_distinct_points: int
    noise: float
    spacing: float
    fewest_neighbors: int
    most_neighbors: int
    number_of_iterations: int
    number_of_relaxation_steps: int
    filter_width: float
    feature_threshold: float
    mean_movement: float
    last_movement: float
    number_of_moved_points: int
    number_of_constrained_points: int
    number_of_isolated_points: int
    number_of_points_without_noise: int
    number_of_points_at_rest: int
    @property
    def moved_share(self) -> float: ...

@overload
def smooth(
    points: ArrayLike, normals: None = ..., k: int | None = ..., noise: ArrayLike | None = ..., *,
    scans: ArrayLike | None = ..., constrained: ArrayLike | None = ..., neighbor_radius: float = ...,
    number_of_iterations: int | None = ..., number_of_relaxation_steps: int = ...,
    sharpness_angle: float | None = ..., step_length: float | None = ...,
    update_period: int = ..., flow: _Flow = ..., curvature: _Curvature = ..., block_size: int = ...,
    threads: int | None = ..., callback: _Callback | None = ...,
    out: _Array | None = ..., out_normals: None = ..., return_report: Literal[False] = ...,
) -> _Array: ...
@overload
def smooth(
    points: ArrayLike, normals: None = ..., k: int | None = ..., noise: ArrayLike | None = ..., *,
    scans: ArrayLike | None = ..., constrained: ArrayLike | None = ..., neighbor_radius: float = ...,
    number_of_iterations: int | None = ..., number_of_relaxation_steps: int = ...,
    sharpness_angle: float | None = ..., step_length: float | None = ...,
    update_period: int = ..., flow: _Flow = ..., curvature: _Curvature = ..., block_size: int = ...,
    threads: int | None = ..., callback: _Callback | None = ...,
    out: _Array | None = ..., out_normals: None = ..., return_report: Literal[True],
) -> tuple[_Array, Report]: ...
@overload
def smooth(
    points: ArrayLike, normals: ArrayLike, k: int | None = ..., noise: ArrayLike | None = ..., *,
    scans: ArrayLike | None = ..., constrained: ArrayLike | None = ..., neighbor_radius: float = ...,
    number_of_iterations: int | None = ..., number_of_relaxation_steps: int = ...,
    sharpness_angle: float | None = ..., step_length: float | None = ...,
    update_period: int = ..., flow: _Flow = ..., curvature: _Curvature = ..., block_size: int = ...,
    threads: int | None = ..., callback: _Callback | None = ...,
    out: _Array | None = ..., out_normals: _Array | None = ..., return_report: Literal[False] = ...,
) -> tuple[_Array, _Array]: ...
@overload
def smooth(
    points: ArrayLike, normals: ArrayLike, k: int | None = ..., noise: ArrayLike | None = ..., *,
    scans: ArrayLike | None = ..., constrained: ArrayLike | None = ..., neighbor_radius: float = ...,
    number_of_iterations: int | None = ..., number_of_relaxation_steps: int = ...,
    sharpness_angle: float | None = ..., step_length: float | None = ...,
    update_period: int = ..., flow: _Flow = ..., curvature: _Curvature = ..., block_size: int = ...,
    threads: int | None = ..., callback: _Callback | None = ...,
    out: _Array | None = ..., out_normals: _Array | None = ..., return_report: Literal[True],
) -> tuple[_Array, _Array, Report]: ...
def analyze(
    points: ArrayLike, normals: ArrayLike | None = ..., k: int | None = ..., noise: ArrayLike | None = ..., *,
    scans: ArrayLike | None = ..., constrained: ArrayLike | None = ..., neighbor_radius: float = ...,
    number_of_iterations: int | None = ..., number_of_relaxation_steps: int = ...,
    sharpness_angle: float | None = ..., step_length: float | None = ...,
    update_period: int = ..., flow: _Flow = ..., curvature: _Curvature = ..., block_size: int = ...,
    threads: int | None = ..., callback: _Callback | None = ...,
) -> Report: ...
def estimate_noise(points: ArrayLike, *, threads: int | None = ...) -> float: ...
