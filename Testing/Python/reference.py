# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slow splines on the BCC lattice, from their definitions, for comparison.

The box-splines are evaluated by de Boor's recursion, which removes one direction at a time, and the
tri-cubic one as a product. Volumes are arrays [k, j, i] or [k, j, i, component], continued by the
mirrors of their box; `start` is the index (i, j, k) of the first sample.
"""
import functools

import numpy as np

_S1 = [(-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1)]
_S2 = [(2, 0, 0), (0, 2, 0), (0, 0, 2)]
_DIRECTIONS = {4: (_S1, [1] * 4), 7: (_S1 + _S2, [1] * 7), 8: (_S1, [2] * 4)}
KERNELS = 4, 7, 8, 12
QUASI_INTERPOLANTS = {4: (1, 0), 7: (5 / 3, -1 / 12), 8: (5 / 3, -1 / 12), 12: (7 / 3, -1 / 6)}


def _box_spline(directions, multiplicities, x):
    """The box-spline over the unit cube of parameters, at points x[n, 3] off its knot planes."""
    directions = np.array(directions, float)

    @functools.lru_cache(None)
    def value(taken, shift):
        left = np.repeat(directions, taken, axis=0)
        if len(left) < 3 or np.linalg.matrix_rank(left) < 3:
            return 0
        p = x - np.array(shift) @ directions
        if len(left) == 3:
            t = np.linalg.solve(left.T, p.T)
            return np.all((t >= 0) & (t < 1), axis=0) / abs(np.linalg.det(left))
        t = p @ np.linalg.inv(left.T @ left) @ directions.T
        total = 0
        for d, count in enumerate(taken):
            if count:
                fewer = taken[:d] + (count - 1,) + taken[d + 1:]
                moved = shift[:d] + (shift[d] + 1,) + shift[d + 1:]
                # the share of a direction that is taken several times, each of the same t
                total = total + count * (
                    t[:, d] * value(fewer, shift) + (1 - t[:, d]) * value(fewer, moved))
        return total / (len(left) - 3)

    return value(tuple(multiplicities), (0,) * len(directions))


def _cubic(t):
    t = np.abs(t)
    return np.where(t < 1, 2 / 3 - t * t + t ** 3 / 2, np.maximum(2 - t, 0) ** 3 / 6)


def evaluate_kernel(kernel, x):
    """The kernel at points x[n, 3] in lattice coordinates; its shifts sum to 1."""
    if kernel == 12:
        return np.prod(_cubic(x / 2), axis=1) / 2
    directions, multiplicities = _DIRECTIONS[kernel]
    middle = np.array(multiplicities) @ np.array(directions) / 2
    # a little off the knot planes, where the pieces' ends would count twice or not at all
    p = x + middle + 1e-11 * np.array([1, np.sqrt(2), np.sqrt(3)])
    result = np.zeros(len(x))
    for begin in range(0, len(x), 4000):
        result[begin:begin + 4000] = 4 * _box_spline(
            directions, multiplicities, p[begin:begin + 4000])
    return result


def mirror(x, first, last):
    rest = np.mod(x - first, 2 * (last - first))
    return first + np.minimum(rest, 2 * (last - first) - rest)


def fetch(volume, start, points):
    """Samples at integer lattice points [n, 3], anywhere."""
    i0, j0, k0 = start
    nk, nj, ni = volume.shape[:3]
    x = mirror(points[:, 0], 2 * i0, 2 * (i0 + ni) - 1)
    y = mirror(points[:, 1], 2 * j0, 2 * (j0 + nj) - 1)
    z = mirror(points[:, 2], k0, k0 + nk - 1)
    odd = z & 1
    return volume[z - k0, (y - odd) // 2 - j0, (x - odd) // 2 - i0]


def lattice_points(shape, start=(0, 0, 0)):
    """Lattice coordinates [nk, nj, ni, 3]."""
    k, j, i = np.meshgrid(*(np.arange(n) + s for n, s in zip(shape[:3], start[::-1])),
                          indexing="ij")
    odd = k & 1
    return np.stack((2 * i + odd, 2 * j + odd, k), -1)


_AROUND = np.array([(x, y, z) for x in range(-5, 6) for y in range(-5, 6) for z in range(-5, 6)
                    if (x - z) % 2 == 0 and (y - z) % 2 == 0])


def evaluate(kernel, coefficients, points, start=(0, 0, 0)):
    """The spline at points [n, 3] in lattice coordinates."""
    points = np.asarray(points, float)
    centers = 2 * np.floor(points / 2 + 0.5).astype(int)
    which, around = np.meshgrid(np.arange(len(points)), np.arange(len(_AROUND)), indexing="ij")
    which, around = which.ravel(), around.ravel()
    offsets = points[which] - centers[which] - _AROUND[around]
    near = np.max(np.abs(offsets), axis=1) < 4
    if kernel != 12:  # inside the rhombic dodecahedron of S1, or of S1 twice
        a = np.sort(np.abs(offsets), axis=1)
        near &= a[:, 1] + a[:, 2] < (2.1 if kernel == 4 else 4.1)
    which, around, offsets = which[near], around[near], offsets[near]
    weights = evaluate_kernel(kernel, offsets)
    values = fetch(coefficients, start, centers[which] + _AROUND[around]).astype(float)
    components = values.reshape(len(values), -1)
    result = np.stack([np.bincount(which, weights * c, len(points)) for c in components.T], -1)
    return result.reshape((len(points),) + coefficients.shape[3:])


def evaluate_gradient(kernel, coefficients, points, start=(0, 0, 0), step=1e-4):
    """Central differences along the lattice coordinates, the last axis of the result."""
    differences = []
    for axis in np.eye(3):
        high = evaluate(kernel, coefficients, points + step * axis, start)
        low = evaluate(kernel, coefficients, points - step * axis, start)
        differences.append((high - low) / (2 * step))
    return np.stack(differences, -1)


def quasi_interpolate(kernel, volume, start=(0, 0, 0)):
    center, neighbor = QUASI_INTERPOLANTS[kernel]
    points = lattice_points(volume.shape, start).reshape(-1, 3)
    total = sum(fetch(volume, start, points + (x, y, z)).astype(float)
                for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
    return center * volume.astype(float) + neighbor * total.reshape(volume.shape)


def interpolate(kernel, volume, start=(0, 0, 0)):
    """Coefficients of the spline through the samples, by a dense system for a small volume."""
    count = int(np.prod(volume.shape[:3]))
    units = np.eye(count).reshape(volume.shape[:3] + (count,))
    points = lattice_points(volume.shape, start).reshape(-1, 3)
    matrix = evaluate(kernel, units, points, start)
    return np.linalg.solve(matrix, volume.reshape(count, -1).astype(float)).reshape(volume.shape)
