# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes to make geometry images of, and how far these are from them."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDistancePolyDataFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

from bravais import vtkPolyDataToGeometryImage


def make_mesh(points, triangles):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtk(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    mesh.SetPolys(cells)
    return mesh


def run_source(source, **properties):
    for name, value in properties.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def get_points(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def get_triangles(mesh):
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(mesh)
    triangulate.Update()
    return vtk_to_numpy(triangulate.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)


def make_ball(resolution=24, bumps=0.0, dtype=np.float32):
    """A sphere's triangles, moved along their radius."""
    sphere = run_source(vtkSphereSource(), ThetaResolution=2 * resolution,
                        PhiResolution=resolution)
    points = get_points(sphere).astype(float) * 2
    radius = 1 + bumps * np.prod(np.sin(4 * points), axis=1)
    return make_mesh((points * radius[:, None]).astype(dtype), get_triangles(sphere))


def make_spikes(count, height, resolution=24):
    """A ball with narrow spikes, whose tips are far from everything."""
    points = get_points(make_ball(resolution)).astype(float)
    directions = np.random.default_rng(0).normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    radius = 1 + height * np.exp(50 * (points @ directions.T - 1)).sum(axis=1)
    return make_mesh(points * radius[:, None], get_triangles(make_ball(resolution)))


def make_tube(length, rings, sides, closed):
    """A tube with a tip at its end, and one at its start if it is closed."""
    z, t = np.meshgrid(np.linspace(0, length, rings), np.arange(sides) * 2 * np.pi / sides,
                       indexing="ij")
    points = np.stack((np.cos(t), np.sin(t), z), -1).reshape(-1, 3)
    n = len(points)
    points = np.vstack((points, [(0, 0, length + 1), (0, 0, -1)][:1 + closed]))
    triangles = []
    for j in range(sides):
        k = (j + 1) % sides
        for ring in range(0, n - sides, sides):
            triangles += [(ring + j, ring + k, ring + k + sides),
                          (ring + j, ring + k + sides, ring + j + sides)]
        triangles.append((n - sides + j, n - sides + k, n))
        triangles += [(k, j, n + 1)] if closed else []
    return make_mesh(points, triangles)


def make_filter(mesh, width=33, height=33, rounds=8):
    algorithm = vtkPolyDataToGeometryImage()
    algorithm.SetInputData(mesh)
    algorithm.SetDimensions(width, height)
    algorithm.SetRounds(rounds)
    return algorithm


def get_gixels(image, name="Points"):
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return values.reshape(image.GetDimensions()[1::-1] + values.shape[1:])


def run(*arguments, **keywords):
    algorithm = make_filter(*arguments, **keywords)
    algorithm.Update()
    return algorithm.GetOutput()


def get_distances(points, mesh):
    probe = make_mesh(np.asarray(points, float).reshape(-1, 3), [(0, 0, 0)])
    distance = vtkDistancePolyDataFilter()
    distance.SetInputData(0, probe)
    distance.SetInputData(1, mesh)
    distance.SignedDistanceOff()
    distance.ComputeSecondDistanceOff()
    distance.Update()
    return vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("Distance"))


def get_volume(mesh):
    clean = vtkCleanPolyData()
    clean.SetInputData(mesh)
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(clean.GetOutputPort())
    triangulate.Update()
    points = get_points(triangulate.GetOutput()).astype(float)
    triangles = get_triangles(triangulate.GetOutput())
    return np.linalg.det(points[triangles]).sum() / 6
