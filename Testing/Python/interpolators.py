# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Interpolators of BCC volumes, made in few lines."""
import numpy as np

from bravais import vtkBCCInterpolator

CASES = [(4, 0), (4, 2), (7, 1), (7, 3), (8, 1), (8, 2), (12, 0), (12, 1)]
SPACING = 0.7, 2.5, 0.3
ORIGIN = 5, -3, 2


def make_array(shape=(6, 3, 4)):
    return np.random.default_rng(7).uniform(-1, 1, shape)


def make_interpolator(volume, kernel=7, prefilter=1, **properties):
    interpolator = vtkBCCInterpolator()
    interpolator.SetKernel(kernel)
    interpolator.SetPrefilter(prefilter)
    for name, value in properties.items():
        getattr(interpolator, "Set" + name)(value)
    if volume:
        interpolator.Initialize(volume)
    return interpolator


def to_world(points, spacing=SPACING, origin=ORIGIN):
    """World positions of points in lattice coordinates."""
    return np.asarray(points) * np.array(spacing) * (0.5, 0.5, 1) + origin


def interpolate(interpolator, points, component=0):
    return np.array([interpolator.Interpolate(*p, component) for p in points])


def make_points(shape, start=(0, 0, 0), count=12):
    """Points of the box in lattice coordinates, some on its faces."""
    low = np.array((2 * start[0], 2 * start[1], start[2]))
    size = np.array((2 * shape[2] - 1, 2 * shape[1] - 1, shape[0] - 1))
    unit = np.random.default_rng(2).uniform(0, 1, (count, 3))
    unit[0], unit[1] = 0, 1
    unit[2, 0] = unit[3, 1] = 0
    unit[4, 2] = unit[5, 0] = 1
    return low + unit * size
