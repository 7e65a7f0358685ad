# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkRank1ImageReconstruct, vtkRank1ImageToPolyData
from checks import make_image, refuses
from rank1 import TYPES, get_places, make_picture, make_rank1, resample

CELLS, TRIANGLES, POINTS = range(3)
LATTICES = [((1, 0, 0), (0, 1, 0, 1)), ((2, 1, 1), (0, 3, 0, 1)), ((56, 4, 7), (-1, 1, 5, 6)),
            ((97, 1, 14), (0, 2, 0, 3)), ((64, 1, 1), (0, 1, 0, 1))]


def convert(image, shape):
    algorithm = vtkRank1ImageToPolyData()
    algorithm.SetInputDataObject(image)
    algorithm.SetShape(shape)
    return algorithm


def run(*arguments):
    algorithm = convert(*arguments)
    algorithm.Update()
    return algorithm.GetOutput()


def make_values(n, tiles=(1, 1), dtype=np.float64, components=()):
    generator = np.random.default_rng(3)
    return generator.integers(0, 120, (tiles[1], tiles[0], n) + components).astype(dtype)


def get_polygons(data):
    """Corners [corner, xyz] of each polygon."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    offsets = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    return [points[corners[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]


def get_areas(data):
    areas = []
    for p in get_polygons(data):
        x, y = p[:, 0], p[:, 1]
        areas.append(0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum())
    return np.array(areas)


class TestRank1ImageToPolyData(unittest.TestCase):
    def test_defaults(self):
        algorithm = vtkRank1ImageToPolyData()
        self.assertEqual(algorithm.GetShapeAsString(), "VoronoiCells")
        algorithm.SetShapeToPoints()
        self.assertIn("Shape: Points", str(algorithm))

    def test_area_is_covered_once(self):
        for generator, domain in LATTICES:
            for tiles in (1, 1), (3, 2):
                image = make_rank1(make_values(generator[0], tiles), generator, tiles, domain)
                for shape in CELLS, TRIANGLES:
                    output = run(image, shape)
                    areas = get_areas(output)
                    self.assertGreaterEqual(areas.min(), -1e-12)
                    total = (domain[1] - domain[0]) * (domain[3] - domain[2])
                    self.assertAlmostEqual(areas.sum() / total, 1, 11)
                    np.testing.assert_allclose(output.GetBounds(), domain + (0, 0))

    def test_cells_of_a_texel_have_its_value_and_area(self):
        for generator, domain in LATTICES:
            n = generator[0]
            values = np.arange(6.0 * n).reshape(2, 3, n)
            output = run(make_rank1(values, generator, (3, 2), domain), CELLS)
            scalars = output.GetCellData().GetScalars()
            self.assertEqual(scalars.GetName(), "values")
            sums = np.bincount(vtk_to_numpy(scalars).astype(int), get_areas(output))
            total = (domain[1] - domain[0]) * (domain[3] - domain[2])
            np.testing.assert_allclose(sums, total / (6 * n))

    def test_centres_of_cells_are_nearest_to_their_texel(self):
        generator, tiles, domain = (56, 4, 7), (3, 2), (-1, 1, 5, 6)
        values = np.arange(6.0 * 56).reshape(2, 3, 56)
        output = run(make_rank1(values, generator, tiles, domain), CELLS)
        places = get_places(generator, tiles, domain).reshape(-1, 2)
        size = np.array((2, 1))
        for polygon, texel in zip(
                get_polygons(output), vtk_to_numpy(output.GetCellData().GetScalars())):
            apart = places - polygon.mean(0)[:2]
            apart -= np.round(apart / size) * size
            self.assertEqual(np.hypot(*apart.T).argmin(), texel)

    def test_triangles_interpolate_as_the_reconstruction_does(self):
        generator, tiles = (97, 1, 14), (2, 1)
        image = make_rank1(make_values(97, tiles), generator, tiles, (0, 2, 0, 1))
        output = run(image, TRIANGLES)
        reconstruct = vtkRank1ImageReconstruct()
        reconstruct.SetInputDataObject(image)
        reconstruct.SetOutputDimensions(800, 400)
        reconstruct.Update()
        pixels = vtk_to_numpy(reconstruct.GetOutput().GetPointData().GetScalars())
        pixels = pixels.reshape(400, 800)
        values = vtk_to_numpy(output.GetPointData().GetScalars())
        corners = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        middles = np.array(get_polygons(output)).mean(1)
        x, y = (np.clip(np.floor(middles[:, a] * 400).astype(int), 0, 799 if a == 0 else 399)
                for a in (0, 1))
        large = get_areas(output) > 2e-4
        self.assertGreater(large.sum(), 300)
        difference = np.abs(values[corners].mean(1) - pixels[y, x])[large]
        self.assertLess(difference.max(), 8)
        self.assertLess(difference.mean(), 2)

    def test_triangles_share_the_texels(self):
        values = make_values(97)
        output = run(make_rank1(values, (97, 1, 14)), TRIANGLES)
        self.assertGreaterEqual(output.GetNumberOfCells(), 2 * 97)
        points = vtk_to_numpy(output.GetPoints().GetData())[:, :2]
        scalars = vtk_to_numpy(output.GetPointData().GetScalars())
        found = {tuple(np.round(p, 9)): v for p, v in zip(points, scalars)}
        for place, value in zip(get_places((97, 1, 14))[0, 0], values[0, 0]):
            self.assertAlmostEqual(found[tuple(np.round(place, 9))], value)

    def test_points(self):
        for generator, domain in LATTICES:
            values = make_values(generator[0], (3, 2))
            output = run(make_rank1(values, generator, (3, 2), domain), POINTS)
            points = vtk_to_numpy(output.GetPoints().GetData())
            expected = get_places(generator, (3, 2), domain).reshape(-1, 2)
            np.testing.assert_allclose(points[:, :2], expected, atol=1e-12)
            self.assertEqual(output.GetNumberOfVerts(), len(points))
            np.testing.assert_array_equal(
                vtk_to_numpy(output.GetPointData().GetScalars()), values.reshape(-1))

    def test_all_types_and_numbers_of_components(self):
        for dtype in TYPES:
            for components in (), (2,), (3,), (5,):
                values = make_values(56, (1, 1), dtype, components)
                image = make_rank1(values, (56, 4, 7))
                for shape in CELLS, TRIANGLES, POINTS:
                    output = run(image, shape)
                    data = output.GetCellData() if shape == CELLS else output.GetPointData()
                    result = vtk_to_numpy(data.GetScalars())
                    self.assertEqual(result.dtype, dtype)
                    self.assertEqual(result.shape[1:], components)
                    self.assertEqual(
                        len(result), output.GetNumberOfCells() if shape == CELLS else
                        output.GetNumberOfPoints())
                    self.assertGreaterEqual(result.min(), values.min())
                    self.assertLessEqual(result.max(), values.max())

    def test_plane_of_the_picture(self):
        _, picture = make_picture((6, 9), spacing=(2, 3, 1), origin=(1, 2, 3))
        picture.SetDirectionMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0)
        rank1 = resample(picture, 40)
        rank1.Update()
        for shape in CELLS, TRIANGLES:
            # The picture is in y and z of the world, its edges half a pixel outside its centres.
            np.testing.assert_allclose(
                run(rank1.GetOutput(), shape).GetBounds(), (1, 1, 1, 19, 1.5, 19.5))

    def test_pieces(self):
        image = make_rank1(make_values(97, (2, 1)), (97, 1, 14), (2, 1))
        for shape in CELLS, TRIANGLES, POINTS:
            algorithm = convert(image, shape)
            algorithm.Update()
            whole = algorithm.GetOutput().GetNumberOfCells()
            area = 0.0
            count = 0
            for piece in range(5):
                algorithm.UpdatePiece(piece, 5, 0)
                count += algorithm.GetOutput().GetNumberOfCells()
                if shape != POINTS:
                    area += get_areas(algorithm.GetOutput()).sum()
            self.assertEqual(count, whole)
            if shape != POINTS:
                self.assertAlmostEqual(area, 1, 11)

    def test_threads(self):
        image = make_rank1(make_values(3000), (3000, 1, 131))
        for shape in CELLS, TRIANGLES:
            results = []
            for threads in 1, 2:
                vtkSMPTools.Initialize(threads)
                output = run(image, shape)
                data = output.GetCellData() if shape == CELLS else output.GetPointData()
                results.append([vtk_to_numpy(a).tobytes() for a in (
                    output.GetPoints().GetData(), output.GetPolys().GetConnectivityArray(),
                    output.GetPolys().GetOffsetsArray(), data.GetScalars())])
            self.assertEqual(results[0], results[1])
        vtkSMPTools.Initialize(0)

    def test_progress_and_abort(self):
        algorithm = convert(make_rank1(make_values(3000), (3000, 1, 131)), CELLS)
        vtkSMPTools.Initialize(1)
        amounts = []

        def observe(*unused):
            amounts.append(algorithm.GetProgress())
        tag = algorithm.AddObserver("ProgressEvent", observe)
        algorithm.Update()
        algorithm.RemoveObserver(tag)
        self.assertEqual(amounts, sorted(amounts))
        self.assertEqual(amounts[-1], 1)
        tag = algorithm.AddObserver("ProgressEvent", lambda *u: algorithm.SetAbortExecute(
            algorithm.GetProgress() >= 0.25))
        algorithm.Modified()
        algorithm.Update()
        algorithm.RemoveObserver(tag)
        vtkSMPTools.Initialize(0)
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        algorithm.SetAbortExecute(0)
        algorithm.Modified()
        algorithm.Update()
        self.assertGreater(algorithm.GetOutput().GetNumberOfPoints(), 0)

    def test_bad_input(self):
        for shape in CELLS, TRIANGLES, POINTS:
            refuses(self, convert(make_image(np.zeros((1, 4, 4))), shape), "not tagged")
            refuses(self, convert(vtkImageData(), shape), "not tagged")
            image = make_rank1(make_values(97), (97, 1, 14))
            image.GetFieldData().GetArray("Rank1.Generator").SetValue(0, 96)
            refuses(self, convert(image, shape), "97 x 1 x 1", "of 96 points")
            image = make_rank1(make_values(97), (97, 1, 14), domain=(0, -1, 0, 1))
            refuses(self, convert(image, shape), "The area is -1 x 1")
            image = make_rank1(make_values(97), (97, 1, 14))
            image.GetPointData().Initialize()
            refuses(self, convert(image, shape), "no point scalars")


if __name__ == "__main__":
    unittest.main()
