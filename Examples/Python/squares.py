# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Square textures, what rank-1 ones are compared with."""
import numpy as np


def average(values, count):
    """Means over `count` equal parts of the first axis, which may cut pixels."""
    n = len(values)
    edges = np.arange(count + 1) * n / count
    pixels = np.minimum(edges.astype(int), n - 1)
    sums = np.concatenate([np.zeros_like(values[:1]), np.cumsum(values, axis=0)])
    shares = (edges - pixels).reshape((-1,) + (1,) * (values.ndim - 1))
    return np.diff(sums[pixels] + shares * values[pixels], axis=0) * (count / n)


def make_square(picture, r):
    """r x r texels of a picture [row, column] or [row, column, RGB]: means over equal squares."""
    return average(average(np.asarray(picture, float), r).swapaxes(0, 1), r).swapaxes(0, 1)
