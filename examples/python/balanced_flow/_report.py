# SPDX-License-Identifier: GPL-3.0-or-later
"""What is reported of a run."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Report:
    """What was found in a point set, which parameters follow from it, and how the points moved.

    Lengths are in the unit of the points. Noise, spacing, number of neighbors and feature threshold are found
    around each point; the medians in this report describe the point set.
    """

    number_of_points: int
    number_of_distinct_points: int  #: exact duplicates move as one
    noise: float  #: the standard deviation of the noise, given or estimated: the median
    spacing: float  #: the square root of the surface area per point: the median
    fewest_neighbors: int  #: the smallest number of neighbors of a point
    most_neighbors: int  #: the largest
    number_of_iterations: int  #: the largest number of steps
    number_of_relaxation_steps: int  #: along the surface, after them
    filter_width: float  #: in multiples of the neighborhood radius
    feature_threshold: float  #: the constant K of the diffusivity: the median
    mean_movement: float  #: the mean distance between the points before and after
    last_movement: float  #: the mean distance that the distinct points moved in the last step
    number_of_moved_points: int  #: it and the next four add up to the number of points
    number_of_constrained_points: int  #: not moved: they or duplicates of them are constrained
    number_of_isolated_points: int  #: not moved: fewer than two neighbors, or far from all others
    number_of_points_without_noise: int  #: not moved: their noise is 0, given or estimated
    number_of_points_at_rest: int  #: not moved: they lie on their surface, or no step was made

    @property
    def moved_share(self) -> float:
        """The share of the points that moved, from 0 to 1."""
        return self.number_of_moved_points / self.number_of_points if self.number_of_points else 0.0
