# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of geometry images by the definitions, slowly."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from bravais import vtkGeometryImageToPolyData


def add_array(image, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    image.GetPointData().AddArray(array)


def make_image(points, defined=None, mask=None):
    """A geometry image of an array [row, column, xyz], and of bytes [row, column]."""
    image = vtkImageData()
    image.SetDimensions(points.shape[1], points.shape[0], 1)
    add_array(image, "Points", points.reshape(-1, 3))
    image.GetPointData().SetActiveVectors("Points")
    for name, values in ("Defined", defined), ("LocalityMask", mask):
        if values is not None:
            add_array(image, name, values.astype(np.uint8).ravel())
    tag = vtkStringArray()
    tag.SetName("Lattice")
    tag.InsertNextValue("GeometryImage")
    image.GetFieldData().AddArray(tag)
    return image


def make_surface(image, level=0, **properties):
    surface = vtkGeometryImageToPolyData()
    surface.SetInputData(image)
    surface.SetLevelOfDetail(level)
    for name, value in properties.items():
        getattr(surface, "Set" + name)(value)
    return surface


def run(*arguments, **keywords):
    surface = make_surface(*arguments, **keywords)
    surface.Update()
    return surface.GetOutput()


def make_bumps(height, width, dtype=np.float64, seed=3):
    """A rough sheet, so that both diagonals occur."""
    y, x = np.mgrid[0:height, 0:width].astype(float)
    z = np.random.default_rng(seed).random((height, width))
    return np.stack((x, y, z), -1).astype(dtype)


def make_ball(n, dtype=np.float64):
    """The octahedral layout: |x| + |y| <= 1 above, the rest folded below; outward normals."""
    t = np.abs(np.arange(n) * 2 - (n - 1)) / (n - 1) * np.sign(np.arange(n) * 2 - (n - 1))
    x, y = np.meshgrid(t, t)
    z = 1 - np.abs(x) - np.abs(y)
    below = z < 0
    sign_x, sign_y = np.where(x < 0, -1, 1), np.where(y < 0, -1, 1)
    u = np.where(below, (1 - np.abs(y)) * sign_x, x)
    v = np.where(below, (1 - np.abs(x)) * sign_y, y)
    p = np.stack((u, v, z), -1)
    p /= np.linalg.norm(p, axis=-1, keepdims=True)
    # The border, bit by bit the same from both ends.
    p[0] = (p[0] + p[0, ::-1]) / 2
    p[-1] = (p[-1] + p[-1, ::-1]) / 2
    p[:, 0] = (p[:, 0] + p[::-1, 0]) / 2
    p[:, -1] = (p[:, -1] + p[::-1, -1]) / 2
    return p.astype(dtype)


def get_kept(size, level):
    kept = list(range(0, size, 2 ** level))
    return kept if kept[-1] == size - 1 else kept + [size - 1]


def expect(points, level=0, used=None, mask=None):
    """Triangles, as tuples of (row, column), by the definition."""
    height, width = points.shape[:2]
    used = np.ones((height, width), bool) if used is None else used
    rows, columns = get_kept(height, level), get_kept(width, level)

    def is_masked(row, column):
        n, m = rows.index(row), columns.index(column)
        y = slice(rows[n - 1] + 1 if n else 0, rows[n + 1] if n + 1 < len(rows) else None)
        x = slice(columns[m - 1] + 1 if m else 0, columns[m + 1] if m + 1 < len(columns) else None)
        return mask is None or mask[y, x].any()

    def is_whole(triangle):
        (y0, x0), (y1, x1), (y2, x2) = triangle
        for y in range(min(y0, y1, y2), max(y0, y1, y2) + 1):
            for x in range(min(x0, x1, x2), max(x0, x1, x2) + 1):
                edges = [(bx - ax) * (y - ay) - (by - ay) * (x - ax)
                         for (ay, ax), (by, bx) in zip(triangle, triangle[1:] + triangle[:1])]
                if min(edges) >= 0 and not used[y, x]:
                    return False
        return True

    triangles = []
    for y0, y1 in zip(rows, rows[1:]):
        for x0, x1 in zip(columns, columns[1:]):
            a, b, c, d = (y0, x0), (y0, x1), (y1, x0), (y1, x1)
            if all(used[p] for p in (a, b, c, d)):
                split_bc = (((points[b] - points[c]) ** 2).sum() <
                            ((points[a] - points[d]) ** 2).sum())
            else:
                split_bc = used[b] and used[c]
            for triangle in ((a, b, c), (b, d, c)) if split_bc else ((a, b, d), (a, d, c)):
                if is_whole(triangle) and any(is_masked(*p) for p in triangle):
                    triangles.append(triangle)
    return triangles


def get_triangles(output):
    cells = vtkTriangleFilter()
    cells.SetInputData(output)
    cells.Update()
    return vtk_to_numpy(cells.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)


def turn(triangle):
    """A triangle's corners, so that the least comes first, in the same sense."""
    triangle = [tuple(corner) for corner in triangle]
    first = triangle.index(min(triangle))
    return tuple(triangle[first:] + triangle[:first])


def get_places(output):
    points = vtk_to_numpy(output.GetPoints().GetData())
    return sorted(turn(points[corners].tolist()) for corners in get_triangles(output))
