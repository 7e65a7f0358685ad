# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import itertools
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkMassProperties

from bravais import vtkGeometryImageToPolyData
from surfaces import (
    add_array, expect, get_kept, get_places, get_triangles, make_ball, make_bumps, make_image,
    make_surface, run, turn)


class TestGeometryImageToPolyData(unittest.TestCase):
    def check(self, points, level=0, used=None, mask=None, **properties):
        image = make_image(points, used, mask)
        output = run(image, level, **properties)
        expected = expect(points, level, used, mask)
        self.assertEqual(
            get_places(output), sorted(turn([points[p].tolist() for p in t]) for t in expected))
        return output

    def test_defaults(self):
        surface = vtkGeometryImageToPolyData()
        self.assertEqual(surface.GetLevelOfDetail(), 0)
        self.assertTrue(surface.GetUseLocalityMask())
        self.assertFalse(surface.GetGenerateTriangleStrips())
        self.assertTrue(surface.GetComputeNormals())
        self.assertTrue(surface.GetComputeTextureCoordinates())

    def test_all_gixels(self):
        for dtype in np.float32, np.float64:
            points = make_bumps(7, 9, dtype)
            output = self.check(points)
            self.assertEqual(output.GetNumberOfPolys(), 2 * 6 * 8)
            self.assertEqual(vtk_to_numpy(output.GetPoints().GetData()).dtype, dtype)

    def test_points_and_arrays_are_shared(self):
        image = make_image(make_bumps(5, 6))
        add_array(image, "other", np.arange(30))
        output = run(image)
        data = image.GetPointData()
        self.assertIs(output.GetPoints().GetData(), data.GetArray("Points"))
        self.assertIs(output.GetPointData().GetArray("other"), data.GetArray("other"))
        self.assertFalse(output.GetPointData().HasArray("Points"))

    def test_equal_diagonals_go_from_the_first_gixel(self):
        y, x = np.mgrid[0:2, 0:2].astype(float)
        output = run(make_image(np.stack((x, y, 0 * x), -1)))
        self.assertEqual(get_triangles(output).tolist(), [[0, 1, 3], [0, 3, 2]])

    def test_levels_keep_the_last_row_and_column(self):
        for height, width in (9, 17), (10, 7), (2, 5), (13, 2):
            for level in 0, 1, 2, 3, 30:
                self.check(make_bumps(height, width), level)

    def test_charts(self):
        generator = np.random.default_rng(8)
        for share in 0.5, 0.8, 0.95:
            points = make_bumps(14, 17)
            used = generator.random((14, 17)) < share
            for level in 0, 1, 2:
                output = self.check(points, level, used)
                kept = used[np.ix_(get_kept(14, level), get_kept(17, level))]
                self.assertEqual(output.GetNumberOfPoints(), kept.sum())

    def test_nan_is_as_good_as_undefined(self):
        points = make_bumps(8, 8)
        points[3, 4, 1] = np.nan
        points[7, :, :] = np.nan
        used = ~np.isnan(points).any(axis=-1)
        output = run(make_image(points))
        self.assertEqual(get_places(output), get_places(run(make_image(make_bumps(8, 8), used))))
        self.assertTrue(np.isfinite(vtk_to_numpy(output.GetPoints().GetData())).all())

    def test_no_triangle_bridges_a_gap(self):
        points = make_bumps(9, 9)
        used = np.ones((9, 9), bool)
        used[:, 3] = False  # between two columns of level 1
        x = np.array(get_places(run(make_image(points, used), 1)))[:, :, 0]
        self.assertFalse(((x < 3).any(axis=1) & (x > 3).any(axis=1)).any())

    def test_masks(self):
        generator = np.random.default_rng(4)
        for share in 0.02, 0.2, 1:
            points = make_bumps(14, 17)
            mask = generator.random((14, 17)) < share
            used = generator.random((14, 17)) < 0.9
            for level in 0, 1, 2:
                self.check(points, level, None, mask)
                self.check(points, level, used, mask)

    def test_masks_cover_at_every_level_what_they_cover(self):
        points = make_bumps(17, 17)
        for row, column in (0, 0), (5, 6), (8, 8), (16, 3):
            mask = np.zeros((17, 17), bool)
            mask[row, column] = True
            for level in 1, 2, 3:
                places = np.array(get_places(run(make_image(points, mask=mask), level)))[..., :2]
                area = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
                self.assertTrue((area > 0).all())
                lo = np.maximum(np.array([column, row]) - 1, 0)
                hi = np.minimum(np.array([column, row]) + 1, 16)
                for x, y in itertools.product(*np.linspace(lo + 0.01, hi - 0.01, 5).T):
                    near = abs(x - column) + abs(y - row) < 1
                    inside = [all(np.cross(t[(n + 1) % 3] - t[n], (x, y) - t[n]) >= -1e-9
                                  for n in range(3)) for t in places]
                    self.assertTrue(any(inside) or not near, (row, column, level, x, y))

    def test_a_mask_can_be_ignored(self):
        points = make_bumps(5, 5)
        image = make_image(points, mask=np.zeros((5, 5)))
        self.assertEqual(run(image).GetNumberOfCells(), 0)
        self.assertEqual(run(image, UseLocalityMask=False).GetNumberOfCells(), 32)
        self.assertTrue(run(image).GetPointData().HasArray("LocalityMask"))

    def test_strips_are_the_same_triangles(self):
        generator = np.random.default_rng(6)
        points = make_bumps(14, 17)
        used = generator.random((14, 17)) < 0.9
        mask = generator.random((14, 17)) < 0.6
        for level, mask in itertools.product((0, 1), (None, mask)):
            output = self.check(points, level, used, mask, GenerateTriangleStrips=True)
            self.assertEqual(output.GetNumberOfPolys(), 0)
        y, x = np.mgrid[0:9, 0:9].astype(float)
        for shear in -0.5, 0.5:  # one diagonal alone: one strip a row, and at most a triangle
            output = run(make_image(np.stack((x + shear * y, y, 0 * x), -1)),
                         GenerateTriangleStrips=True)
            self.assertLessEqual(output.GetNumberOfStrips(), 16)
            self.assertEqual(len(get_triangles(output)), 128)

    def test_attributes_follow_their_gixels(self):
        points = make_bumps(9, 12)
        used = np.ones((9, 12), bool)
        used[2, 4] = False
        image = make_image(points, used)
        add_array(image, "row", np.repeat(np.arange(9), 12))
        add_array(image, "place", points.reshape(-1, 3).astype(np.float32))
        image.GetPointData().SetActiveScalars("row")
        for level in 0, 1, 3:
            output = run(image, level)
            places = vtk_to_numpy(output.GetPoints().GetData())
            data = output.GetPointData()
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray("row")), places[:, 1])
            np.testing.assert_array_equal(
                vtk_to_numpy(data.GetArray("place")), places.astype(np.float32))
            self.assertEqual(data.GetScalars().GetName(), "row")
            self.assertFalse(data.HasArray("Defined"))

    def test_texture_coordinates(self):
        points = make_bumps(9, 12)
        for level in 0, 2:
            output = run(make_image(points), level)
            expected = vtk_to_numpy(output.GetPoints().GetData())[:, :2] / (11, 8)
            coordinates = vtk_to_numpy(output.GetPointData().GetTCoords())
            np.testing.assert_allclose(coordinates, expected, atol=1e-6)
        image = make_image(points)
        add_array(image, "own", np.zeros((108, 2)))
        image.GetPointData().SetActiveTCoords("own")
        self.assertEqual(run(image).GetPointData().GetTCoords().GetName(), "own")
        output = run(make_image(points), ComputeTextureCoordinates=False)
        self.assertIsNone(output.GetPointData().GetTCoords())

    def test_normals_of_a_plane(self):
        y, x = np.mgrid[0:6, 0:7].astype(float)
        points = np.stack((x, y, 2 * x - 3 * y), -1)
        used = np.random.default_rng(1).random((6, 7)) < 0.8
        output = run(make_image(points, used))
        normals = vtk_to_numpy(output.GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
        corners = np.unique(get_triangles(output))
        expected = np.array([-2, 3, 1]) / np.sqrt(14)
        np.testing.assert_allclose(normals[corners], np.tile(expected, (len(corners), 1)),
                                   atol=1e-6)

    def test_normals_of_a_ball_have_no_seam(self):
        points = make_ball(65)
        for level in 0, 2:
            output = run(make_image(points), level)
            places = vtk_to_numpy(output.GetPoints().GetData())
            normals = vtk_to_numpy(output.GetPointData().GetNormals())
            self.assertGreater((places * normals).sum(axis=1).min(), 0.998)
            grid = normals.reshape(64 // 2 ** level + 1, -1, 3)
            for edge in grid[0], grid[-1], grid[:, 0], grid[:, -1]:
                np.testing.assert_array_equal(edge, edge[::-1])

    def test_normals_of_a_torus_have_no_seam(self):
        t = np.linspace(0, 2 * np.pi, 33)
        u, v = np.meshgrid(t, t)
        radius = 3 + np.cos(v)
        points = np.stack((radius * np.cos(u), radius * np.sin(u), np.sin(v)), -1)
        points[:, -1] = points[:, 0]
        points[-1] = points[0]
        expected = np.stack((np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)), -1)
        normals = vtk_to_numpy(run(make_image(points)).GetPointData().GetNormals())
        self.assertGreater((normals.reshape(33, 33, 3) * expected).sum(axis=-1).min(), 0.999)

    def test_normals_where_points_fall_together(self):
        points = make_bumps(5, 5)
        points[2, 1:4] = points[2, 2]
        points[4] = 7
        normals = vtk_to_numpy(run(make_image(points)).GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
        points[:] = 1
        normals = vtk_to_numpy(run(make_image(points)).GetPointData().GetNormals())
        np.testing.assert_array_equal(normals, np.tile([0, 0, 1], (25, 1)))

    def test_own_normals_can_be_kept(self):
        image = make_image(make_bumps(4, 4))
        add_array(image, "own", np.ones((16, 3), np.float32))
        image.GetPointData().SetActiveNormals("own")
        self.assertEqual(
            run(image, ComputeNormals=False).GetPointData().GetNormals().GetName(), "own")
        self.assertEqual(run(image).GetPointData().GetNormals().GetName(), "Normals")

    def test_closed_surfaces_stay_closed_at_every_level(self):
        for level in 0, 1, 2, 4:
            clean = vtkCleanPolyData()
            clean.ToleranceIsAbsoluteOn()
            clean.SetAbsoluteTolerance(0)
            clean.SetInputData(run(make_image(make_ball(33)), level))
            edges = vtkFeatureEdges()
            edges.SetInputConnection(clean.GetOutputPort())
            edges.FeatureEdgesOff()
            edges.ManifoldEdgesOff()
            edges.Update()
            self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)
            volume = vtkMassProperties()
            volume.SetInputConnection(clean.GetOutputPort())
            self.assertGreater(volume.GetVolume(), 1)

    def test_numbered_pieces_are_parts_of_the_whole(self):
        points = make_bumps(9, 7)
        used = np.random.default_rng(2).random((9, 7)) < 0.9
        for image, level in (make_image(points), 0), (make_image(points, used), 1):
            whole = run(image, level)
            expected = get_places(whole)
            normals = {tuple(p): tuple(n) for p, n in zip(
                vtk_to_numpy(whole.GetPoints().GetData()),
                vtk_to_numpy(whole.GetPointData().GetNormals()))}
            for count in 1, 2, 3, 11:
                found = []
                for piece in range(count):
                    surface = make_surface(image, level)
                    surface.UpdatePiece(piece, count, 0)
                    output = surface.GetOutput()
                    if output.GetNumberOfPolys():
                        found += get_places(output)
                        for p, n in zip(vtk_to_numpy(output.GetPoints().GetData()),
                                        vtk_to_numpy(output.GetPointData().GetNormals())):
                            self.assertEqual(normals[tuple(p)], tuple(n))
                self.assertEqual(sorted(found), expected)

    def test_threads(self):
        points = make_bumps(60, 50, np.float32)
        used = np.random.default_rng(2).random((60, 50)) < 0.9
        for image, level in (make_image(points), 0), (make_image(points, used), 1):
            for strips in False, True:
                results = []
                for threads in 1, 2:
                    vtkSMPTools.Initialize(threads)
                    output = run(image, level, GenerateTriangleStrips=strips)
                    normals = output.GetPointData().GetNormals()
                    results.append((get_triangles(output).tobytes(),
                                    vtk_to_numpy(normals).tobytes()))
                vtkSMPTools.Initialize(0)
                self.assertEqual(len(set(results)), 1)

    def test_progress(self):
        vtkSMPTools.Initialize(1)  # the calling thread alone reports
        for strips in False, True:
            surface = make_surface(make_image(make_bumps(60, 50)), GenerateTriangleStrips=strips)
            amounts = []
            tag = surface.AddObserver(
                "ProgressEvent", lambda *unused: amounts.append(surface.GetProgress()))
            surface.Update()
            surface.RemoveObserver(tag)
            self.assertEqual(amounts, sorted(amounts))
            self.assertEqual(amounts[-1], 1)
            self.assertGreater(len(set(amounts)), 3)
            for stop in 0.1, 0.5, 0.9:
                def abort(*unused):
                    surface.SetAbortExecute(surface.GetProgress() >= stop)
                tag = surface.AddObserver("ProgressEvent", abort)
                surface.Modified()
                surface.Update()
                surface.RemoveObserver(tag)
                self.assertEqual(surface.GetOutput().GetNumberOfPoints(), 0)
                self.assertEqual(surface.GetOutput().GetNumberOfCells(), 0)
            surface.Modified()
            surface.Update()
            self.assertEqual(surface.GetOutput().GetNumberOfPoints(), 3000)
        vtkSMPTools.Initialize(0)

    def test_an_extent_need_not_start_at_zero(self):
        points = make_bumps(5, 6)
        image = make_image(points)
        image.SetExtent(3, 8, -2, 2, 4, 4)
        self.assertEqual(get_places(run(image)), get_places(run(make_image(points))))


if __name__ == "__main__":
    unittest.main()
