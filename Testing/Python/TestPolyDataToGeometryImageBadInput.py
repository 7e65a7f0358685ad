# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkDiskSource, vtkSphereSource, vtkSuperquadricSource

from checks import refuses
from meshes import (
    get_points, get_triangles, make_ball, make_filter, make_mesh, make_tube, run_source)


class TestPolyDataToGeometryImageBadInput(unittest.TestCase):
    def test_dimensions(self):
        for bad in (1, 5), (5, 0), (-3, 5):
            refuses(self, make_filter(make_ball(8), *bad),
                    f"Dimensions are {bad[0]} x {bad[1]};", "2 x 2")
        refuses(self, make_filter(make_ball(8), 2 ** 30, 2 ** 30), "1073741824")

    def test_no_surface(self):
        refuses(self, make_filter(vtkPolyData()), "0 points and 0 polygons")
        lines = vtkPolyData()
        lines.SetPoints(make_ball(8).GetPoints())
        lines.SetLines(vtkCellArray())
        lines.GetLines().InsertNextCell(2, (0, 1))
        refuses(self, make_filter(lines), "0 polygons")
        points = np.zeros((3, 3))
        refuses(self, make_filter(make_mesh(points, [(0, 1, 2)])), "no triangles")

    def test_points_and_values_that_there_are_not(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0)], float)
        for bad in -1, 3, 10 ** 6:
            refuses(self, make_filter(make_mesh(points, [(0, 1, bad)])), f"point {bad};", "0 to 2")
        mesh = make_mesh(points, [(0, 1, 2)])
        values = vtkDoubleArray()
        values.SetName("few")
        values.SetNumberOfValues(2)
        mesh.GetPointData().AddArray(values)
        refuses(self, make_filter(mesh), "few", "2 tuples", "3 points")

    def test_coordinates(self):
        for bad in np.nan, np.inf:
            points = get_points(make_ball(8)).copy()
            points[11, 2] = bad
            refuses(self, make_filter(make_mesh(points, get_triangles(make_ball(8)))),
                    "Point 11", "finite")

    def test_edges_of_three_triangles(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], float)
        mesh = make_mesh(points, [(0, 1, 2), (0, 3, 1), (0, 1, 4)])
        refuses(self, make_filter(mesh), "not manifold", "1 edge ", "at most two")

    def test_vertices_of_two_fans(self):
        points = np.random.default_rng(0).random((6, 3))  # a strip that ends where it begins
        mesh = make_mesh(points, [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4), (4, 5, 0)])
        refuses(self, make_filter(mesh), "not manifold", "1 vertex")

    def test_one_sided(self):
        t = np.linspace(0, 2 * np.pi, 21)[:-1]
        ring = np.stack((np.cos(t), np.sin(t), 0 * t), -1)
        across = ring * np.cos(t / 2)[:, None] + np.outer(np.sin(t / 2), (0, 0, 1))
        points = np.vstack((ring * 3 + across, ring * 3 - across))
        triangles = []
        for n in range(20):
            a, b, c, d = n, n + 20, n + 1, n + 21
            if n == 19:
                c, d = 20, 0
            triangles += [(a, b, c), (b, d, c)]
        refuses(self, make_filter(make_mesh(points, triangles)), "one side only")

    def test_genus_and_boundaries(self):
        torus = run_source(vtkSuperquadricSource(), Toroidal=1)
        refuses(self, make_filter(torus), "genus 1 and 0 boundaries", "genus 0")
        ring = run_source(vtkDiskSource(), InnerRadius=0.5, OuterRadius=1)
        refuses(self, make_filter(ring), "genus 0 and 2 boundaries", "genus 0")
        points, triangles = get_points(torus), get_triangles(torus)
        refuses(self, make_filter(make_mesh(points, triangles[1:])), "genus 1 and 1 boundary;")

    def test_components(self):
        both = vtkAppendPolyData()
        both.AddInputData(make_ball(8))
        both.AddInputData(run_source(vtkSphereSource(), Center=(9, 0, 0)))
        refuses(self, make_filter(run_source(both)), "2 components", "1 was expected")

    def test_too_long_and_thin(self):
        refuses(self, make_filter(make_tube(5000, 5000, 4, True)), "too long and thin")

    def test_an_error_empties_an_earlier_output(self):
        algorithm = make_filter(make_ball(8))
        algorithm.Update()
        algorithm.SetInputData(run_source(vtkSuperquadricSource(), Toroidal=1))
        refuses(self, algorithm, "genus 1")
        algorithm.SetInputData(make_ball(8))
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 33 * 33)


if __name__ == "__main__":
    unittest.main()
