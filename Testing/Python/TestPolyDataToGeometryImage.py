# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkFeatureEdges, vtkStripper, vtkTriangleFilter)
from vtkmodules.vtkFiltersSources import (
    vtkConeSource, vtkCubeSource, vtkCylinderSource, vtkDiskSource, vtkPlaneSource,
    vtkPlatonicSolidSource, vtkRegularPolygonSource)

from bravais import vtkGeometryImageToPolyData, vtkPolyDataToGeometryImage
from meshes import (
    get_distances, get_gixels, get_points, get_triangles, get_volume, make_ball, make_filter,
    make_mesh, make_spikes, make_tube, run, run_source)


class TestPolyDataToGeometryImage(unittest.TestCase):
    def check_no_flips(self, mesh, width=33, height=33):
        algorithm = make_filter(mesh, width, height)
        algorithm.Update()
        self.assertEqual(algorithm.GetNumberOfFlippedTriangles(), 0)
        self.assertGreaterEqual(algorithm.GetStretch(), 1 - 1e-9)
        output = algorithm.GetOutput()
        self.assertEqual(output.GetDimensions(), (width, height, 1))
        self.assertTrue(np.isfinite(get_gixels(output)).all())
        return algorithm

    def check_folds(self, gixels):
        """Each edge is the same from both ends, to the last bit."""
        for edge in gixels[0], gixels[-1], gixels[:, 0], gixels[:, -1]:
            np.testing.assert_array_equal(edge, edge[::-1])

    def test_defaults(self):
        algorithm = vtkPolyDataToGeometryImage()
        self.assertEqual(algorithm.GetDimensions(), (257, 257))
        self.assertEqual(algorithm.GetRounds(), 8)

    def test_closed_surfaces_close(self):
        mesh = make_ball(bumps=0.2)
        for width, height in (33, 33), (32, 32), (17, 40), (3, 3), (2, 2):
            gixels = get_gixels(self.check_no_flips(mesh, width, height).GetOutput())
            self.check_folds(gixels)
            self.assertLess(get_distances(gixels, mesh).max(), 1e-6)
            if min(width, height) < 33:
                continue
            surface = vtkGeometryImageToPolyData()
            surface.SetInputData(run(mesh, width, height))
            for level in 0, 1, 2:
                surface.SetLevelOfDetail(level)
                clean = vtkCleanPolyData()
                clean.ToleranceIsAbsoluteOn()
                clean.SetAbsoluteTolerance(0)
                clean.SetInputConnection(surface.GetOutputPort())
                edges = vtkFeatureEdges()
                edges.SetInputConnection(clean.GetOutputPort())
                edges.FeatureEdgesOff()
                edges.ManifoldEdgesOff()
                edges.Update()
                self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_the_surface_is_kept(self):
        mesh = make_ball(bumps=0.2)
        errors = []
        for n in 33, 65, 129:
            surface = vtkGeometryImageToPolyData()
            surface.SetInputData(run(mesh, n, n))
            surface.Update()
            self.assertAlmostEqual(get_volume(surface.GetOutput()) / get_volume(mesh), 1,
                                   delta=20 / n ** 2)
            errors.append(np.sqrt(np.mean(get_distances(get_points(mesh), surface.GetOutput())**2)))
        self.assertLess(errors[0], 0.01)
        self.assertLess(errors[1], errors[0] / 1.7)
        self.assertLess(errors[2], errors[1] / 1.7)

    def test_stretch_is_low(self):
        for mesh, most in ((make_ball(), 1.08), (run_source(vtkCubeSource()), 1.25),
                           (make_spikes(4, 1), 1.6), (make_tube(10, 30, 12, True), 1.4)):
            algorithm = self.check_no_flips(mesh)
            self.assertLess(algorithm.GetStretch(), most)

    def test_rounds_lessen_the_stretch(self):
        stretches = []
        for rounds in 0, 1, 8:
            algorithm = make_filter(make_spikes(6, 2), rounds=rounds)
            algorithm.Update()
            self.assertEqual(algorithm.GetNumberOfFlippedTriangles(), 0)
            stretches.append(algorithm.GetStretch())
        self.assertLess(stretches[1], stretches[0])
        self.assertLess(stretches[2], stretches[1])

    def test_smallest_surfaces(self):
        for solid in range(5):
            mesh = run_source(vtkPlatonicSolidSource(), SolidType=solid)
            gixels = get_gixels(self.check_no_flips(mesh).GetOutput())
            self.check_folds(gixels)
            self.assertLess(get_distances(gixels, mesh).max(), 1e-6)
        for source in vtkCubeSource(), vtkConeSource(), vtkCylinderSource():
            self.check_folds(get_gixels(self.check_no_flips(run_source(source)).GetOutput()))
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], float)
        for triangles in [(0, 1, 2)], [(0, 1, 2), (1, 3, 2)]:
            mesh = make_mesh(points, triangles)
            gixels = get_gixels(self.check_no_flips(mesh).GetOutput())
            self.assertLess(get_distances(gixels, mesh).max(), 1e-9)

    def test_rough_and_spiky_surfaces(self):
        generator = np.random.default_rng(0)
        ball = make_ball(16)
        points, triangles = get_points(ball).astype(float), get_triangles(ball)
        noise = make_mesh(points * (0.2 + generator.random(len(points)))[:, None], triangles)
        chaos = make_mesh(generator.random(points.shape), triangles)
        line = make_mesh(np.outer(np.arange(len(points)), (1, 2, 3)).astype(float), triangles)
        tiny = make_mesh(points * 1e-150, triangles)
        huge = make_mesh(points * 1e150, triangles)
        for mesh in noise, chaos, line, tiny, huge, make_spikes(8, 3), make_spikes(20, 10):
            self.check_folds(get_gixels(self.check_no_flips(mesh).GetOutput()))
        for length in 30, 100:
            self.check_no_flips(make_tube(length, 3 * length, 8, True))
        self.check_no_flips(make_tube(30, 90, 8, False))

    def test_a_plane_is_itself(self):
        plane = vtkPlaneSource()
        plane.SetResolution(7, 5)
        plane.SetOrigin(0, 0, 0)
        plane.SetPoint1(2, 0, 0)
        plane.SetPoint2(0, 1, 0)
        algorithm = self.check_no_flips(run_source(plane), 33, 17)
        self.assertAlmostEqual(algorithm.GetStretch(), 1)
        y, x = np.mgrid[0:17, 0:33] / 16
        expected = np.stack((x, y, 0 * x), -1)
        np.testing.assert_allclose(get_gixels(algorithm.GetOutput()), expected, atol=1e-6)
        coordinates = get_gixels(algorithm.GetOutput(), "TextureCoordinates")
        np.testing.assert_allclose(coordinates, expected[..., :2] / (2, 1), atol=1e-6)

    def test_disks_keep_their_rim(self):
        hexagon = run_source(vtkRegularPolygonSource(), NumberOfSides=6)  # one polygon
        disk = run_source(vtkDiskSource(), InnerRadius=0, OuterRadius=1,
                          CircumferentialResolution=30, RadialResolution=5)
        for mesh in hexagon, disk, make_tube(3, 5, 8, False):
            gixels = get_gixels(self.check_no_flips(mesh).GetOutput())
            self.assertLess(get_distances(gixels, mesh).max(), 1e-6)
            edges = vtkFeatureEdges()
            clean = vtkCleanPolyData()
            clean.SetInputData(mesh)
            edges.SetInputConnection(clean.GetOutputPort())
            edges.FeatureEdgesOff()
            edges.ManifoldEdgesOff()
            edges.NonManifoldEdgesOff()
            edges.Update()
            rim = get_points(edges.GetOutput()).astype(float)
            ends = vtk_to_numpy(edges.GetOutput().GetLines().GetConnectivityArray()).reshape(-1, 2)
            a, b = rim[ends[:, 0]], rim[ends[:, 1]]
            for edge in gixels[0], gixels[-1], gixels[:, 0], gixels[:, -1]:
                for p in edge.astype(float):
                    t = (((p - a) * (b - a)).sum(1) / ((b - a) ** 2).sum(1)).clip(0, 1)
                    self.assertLess(np.linalg.norm(a + t[:, None] * (b - a) - p, axis=1).min(),
                                    1e-6)

    def test_attributes(self):
        mesh = make_ball(bumps=0.1)
        points = get_points(mesh)
        arrays = {"place": points.astype(float), "height": points[:, 2] * 100,
                  "count": np.arange(len(points)), "flat": np.full(len(points), 7, np.uint8)}
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            mesh.GetPointData().AddArray(array)
        normals = numpy_to_vtk(np.ascontiguousarray(points / np.linalg.norm(
            points, axis=1)[:, None]), deep=True)
        normals.SetName("directions")
        mesh.GetPointData().SetNormals(normals)
        mesh.GetPointData().SetActiveScalars("height")
        output = run(mesh)
        data = output.GetPointData()
        gixels = get_gixels(output)
        np.testing.assert_allclose(get_gixels(output, "place"), gixels, atol=1e-6)
        np.testing.assert_allclose(get_gixels(output, "height"), 100 * gixels[..., 2], atol=1e-4)
        self.assertTrue((get_gixels(output, "flat") == 7).all())
        self.assertEqual(get_gixels(output, "count").dtype, arrays["count"].dtype)
        self.assertEqual(data.GetScalars().GetName(), "height")
        self.assertEqual(data.GetNormals().GetName(), "directions")
        self.assertEqual(data.GetVectors().GetName(), "Points")
        np.testing.assert_allclose(
            np.linalg.norm(get_gixels(output, "directions"), axis=-1), 1, atol=1e-6)
        self.assertEqual(output.GetFieldData().GetAbstractArray("Lattice").GetValue(0),
                         "GeometryImage")

    def test_attributes_of_split_edges(self):
        # One triangle has three corners for four, so its rim is split.
        mesh = make_mesh(np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0)], float), [(0, 1, 2)])
        array = numpy_to_vtk(np.array([1.0, 2.0, 3.0]), deep=True)
        array.SetName("values")
        mesh.GetPointData().SetGlobalIds(numpy_to_vtkIdTypeArray(np.arange(3), deep=True))
        mesh.GetPointData().SetScalars(array)
        output = run(mesh)
        self.assertIsNone(output.GetPointData().GetGlobalIds())
        gixels = get_gixels(output)
        np.testing.assert_allclose(get_gixels(output, "values"),
                                   1 + gixels[..., 0] + 2 * gixels[..., 1], atol=1e-9)

    def test_point_types(self):
        for dtype, type in (np.float32, VTK_FLOAT), (np.float64, VTK_DOUBLE):
            array = run(make_ball(8, dtype=dtype)).GetPointData().GetArray("Points")
            self.assertEqual(array.GetDataType(), type)

    def test_sense_is_that_of_most_triangles(self):
        mesh = make_ball(12)
        points, triangles = get_points(mesh).astype(float), get_triangles(mesh)
        surface = vtkGeometryImageToPolyData()
        volumes = []
        for share in 0, 0.3, 0.7, 1:
            turned = triangles.copy()
            some = np.random.default_rng(3).random(len(turned)) < share
            turned[some] = turned[some, ::-1]
            surface.SetInputData(run(make_mesh(points, turned)))
            surface.Update()
            volumes.append(get_volume(surface.GetOutput()))
        self.assertGreater(volumes[0], 3)
        for volume, sense in zip(volumes[1:], (1, -1, -1)):
            self.assertAlmostEqual(volume, sense * volumes[0], delta=0.02)

    def test_repeated_triangles_and_points_change_nothing(self):
        mesh = make_ball(12)
        points, triangles = get_points(mesh), get_triangles(mesh)
        expected = get_gixels(run(make_mesh(points, triangles)))
        more = np.vstack((triangles, triangles[5:9], triangles[3:5, ::-1],
                          [(7, 7, 8), (3, 3, 3)]))
        np.testing.assert_array_equal(get_gixels(run(make_mesh(points, more))), expected)
        twice = np.vstack((points, points, points[:1] + 9))  # and one that no triangle has
        split = triangles + (np.arange(len(triangles)) % 2 * len(points))[:, None]
        np.testing.assert_array_equal(get_gixels(run(make_mesh(twice, split))), expected)

    def test_triangles_without_area(self):
        points = get_points(make_ball(12)).astype(float)
        triangles = get_triangles(make_ball(12))
        a, b, c = triangles[40]
        points = np.vstack((points, (points[a] + points[b]) / 2))  # on the edge of one alone
        split = [(a, len(points) - 1, c), (len(points) - 1, b, c), (b, len(points) - 1, a)]
        triangles = np.vstack((np.delete(triangles, 40, axis=0), split))
        self.check_folds(get_gixels(self.check_no_flips(make_mesh(points, triangles)).GetOutput()))

    def test_polygons_and_strips(self):
        plane = vtkPlaneSource()
        plane.SetResolution(6, 6)
        stripper = vtkStripper()
        triangulate = vtkTriangleFilter()
        triangulate.SetInputConnection(plane.GetOutputPort())
        stripper.SetInputConnection(triangulate.GetOutputPort())
        stripper.Update()
        self.assertGreater(stripper.GetOutput().GetNumberOfStrips(), 0)
        strips = get_gixels(run(stripper.GetOutput()))
        quads = get_gixels(run(run_source(plane)))
        np.testing.assert_allclose(strips, quads, atol=1e-6)

    def test_pieces_of_the_extent(self):
        mesh = make_ball(12, 0.1)
        whole = get_gixels(run(mesh))
        algorithm = make_filter(mesh)
        for x0, x1, y0, y1 in (0, 32, 0, 0), (5, 5, 3, 30), (10, 32, 20, 32), (0, 0, 0, 0):
            algorithm.UpdateExtent((x0, x1, y0, y1, 0, 0))
            output = algorithm.GetOutput()
            self.assertEqual(output.GetExtent(), (x0, x1, y0, y1, 0, 0))
            np.testing.assert_array_equal(get_gixels(output), whole[y0:y1 + 1, x0:x1 + 1])

    def test_results_repeat_and_follow_changes(self):
        mesh = make_ball(12, 0.1)
        algorithm = make_filter(mesh)
        algorithm.Update()
        first = get_gixels(algorithm.GetOutput()).copy()
        np.testing.assert_array_equal(get_gixels(run(mesh)), first)
        algorithm.SetDimensions(17, 21)
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetDimensions(), (17, 21, 1))
        algorithm.SetDimensions(33, 33)
        mesh.GetPoints().GetData().SetTuple3(0, 0, 0, 3)
        mesh.GetPoints().GetData().Modified()
        mesh.Modified()
        algorithm.Update()
        self.assertGreater(get_gixels(algorithm.GetOutput())[..., 2].max(), 1.5)

    def test_progress(self):
        algorithm = make_filter(make_ball(16, 0.2))
        amounts = []
        tag = algorithm.AddObserver(
            "ProgressEvent", lambda *unused: amounts.append(algorithm.GetProgress()))
        algorithm.Update()
        algorithm.RemoveObserver(tag)
        self.assertEqual(amounts, sorted(amounts))
        self.assertEqual(amounts[-1], 1)
        self.assertGreater(len(set(amounts)), 3)
        for stop in 0.01, 0.2, 0.5:
            def abort(*unused):
                algorithm.SetAbortExecute(algorithm.GetProgress() >= stop)
            tag = algorithm.AddObserver("ProgressEvent", abort)
            algorithm.SetDimensions(33, 34 + int(100 * stop))
            algorithm.Update()
            algorithm.RemoveObserver(tag)
            self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        algorithm.SetDimensions(33, 33)
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 33 * 33)


if __name__ == "__main__":
    unittest.main()
