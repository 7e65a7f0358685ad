# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkRank1ImageReconstruct, vtkRank1ImageResample
from checks import (
    PieceSource, check_blocks, check_progress, check_threads, make_image, refuses, to_numpy)
from rank1 import TYPES, get_places, make_picture, make_rank1, resample

MODES = [vtkRank1ImageReconstruct.Nearest, vtkRank1ImageReconstruct.Bilinear,
         vtkRank1ImageReconstruct.Barycentric, vtkRank1ImageReconstruct.BoxSpline]
LATTICE = (97, 1, 14)


def reconstruct(image, width=0, height=0, mode=vtkRank1ImageReconstruct.Barycentric, samples=1):
    algorithm = vtkRank1ImageReconstruct()
    algorithm.SetInputDataObject(image)
    algorithm.SetOutputDimensions(width, height)
    algorithm.SetInterpolation(mode)
    algorithm.SetSamplesPerAxis(samples)
    return algorithm


def run(*arguments, **keywords):
    algorithm = reconstruct(*arguments, **keywords)
    algorithm.Update()
    return to_numpy(algorithm.GetOutput())[0]


def make_noise(tiles, dtype=np.float64, components=()):
    generator = np.random.default_rng(9)
    return generator.integers(0, 120, (tiles[1], tiles[0], 97) + components).astype(dtype)


def get_centers(width, height):
    y, x = np.meshgrid(np.arange(height) + 0.5, np.arange(width) + 0.5, indexing="ij")
    return np.stack((x / width, y / height), -1)


class TestRank1ImageReconstruct(unittest.TestCase):
    def test_defaults(self):
        algorithm = vtkRank1ImageReconstruct()
        self.assertEqual(algorithm.GetOutputDimensions(), (0, 0))
        self.assertEqual(algorithm.GetInterpolationAsString(), "Barycentric")
        self.assertEqual(algorithm.GetSamplesPerAxis(), 1)
        algorithm.SetInterpolationToBoxSpline()
        self.assertIn("BoxSpline", str(algorithm))

    def test_place_and_size(self):
        image = make_rank1(make_noise((3, 2)), LATTICE, (3, 2), (5, 17, -4, 2))
        image.SetOrigin(0, 0, 9)
        for wanted, size in (((24, 6), (24, 6)), ((24, 0), (24, 12)), ((0, 10), (20, 10)),
                             ((0, 0), (34, 17))):
            algorithm = reconstruct(image, *wanted)
            algorithm.Update()
            output = algorithm.GetOutput()
            self.assertEqual(output.GetDimensions(), size + (1,))
            spacing = (12 / size[0], 6 / size[1])
            np.testing.assert_allclose(output.GetSpacing(), spacing + (1,))
            np.testing.assert_allclose(
                output.GetOrigin(), (5 + spacing[0] / 2, -4 + spacing[1] / 2, 9))
            self.assertEqual(output.GetPointData().GetScalars().GetName(), "values")
            self.assertEqual(output.GetFieldData().GetNumberOfArrays(), 0)

    def test_place_is_that_of_the_picture(self):
        _, image = make_picture((6, 9), spacing=(2, 3, 1), origin=(1, 2, 3), start=(5, 6, 7))
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        rank1 = resample(image, 40)
        rank1.Update()
        algorithm = reconstruct(rank1.GetOutput(), 9, 6)
        algorithm.Update()
        output = algorithm.GetOutput()
        self.assertEqual(output.GetSpacing()[:2], (2, 3))
        for corner in (0, 0, 0), (8, 5, 0):
            there, here = [0.0] * 3, [0.0] * 3
            output.TransformIndexToPhysicalPoint(corner, here)
            image.TransformIndexToPhysicalPoint([c + s for c, s in zip(corner, (5, 6, 7))], there)
            np.testing.assert_allclose(here, there)

    def test_nearest_is_the_nearest(self):
        for tiles, domain in ((1, 1), (0, 1, 0, 1)), ((3, 2), (0, 3, 0, 5)):
            values = make_noise(tiles)
            centers = get_centers(31, 29)
            places = get_places(LATTICE, tiles).reshape(-1, 2)
            apart = centers[:, :, None] - places
            apart = (apart - np.round(apart)) * (domain[1], domain[3])
            expected = values.reshape(-1)[np.hypot(*np.moveaxis(apart, -1, 0)).argmin(-1)]
            image = make_rank1(values, LATTICE, tiles, domain)
            np.testing.assert_array_equal(run(image, 31, 29, MODES[0]), expected)

    def test_constants_are_kept(self):
        for dtype in TYPES:
            image = make_rank1(np.full((1, 2, 97), 77, dtype), LATTICE, (2, 1))
            for mode in MODES:
                np.testing.assert_allclose(run(image, 13, 17, mode, 2), 77, rtol=1e-6)

    def test_linear_functions_are_reproduced(self):
        # Away from the border, where a periodic picture jumps.
        tiles = (2, 3)
        places = get_places(LATTICE, tiles)
        image = make_rank1(3 * places[..., 0] - 2 * places[..., 1], LATTICE, tiles)
        centers = get_centers(40, 40)
        inside = ((centers > 0.2) & (centers < 0.8)).all(-1)
        expected = 3 * centers[..., 0] - 2 * centers[..., 1]
        for mode in MODES[1:]:
            np.testing.assert_allclose(
                run(image, 40, 40, mode)[inside], expected[inside], atol=1e-12)

    def test_box_spline_smooths(self):
        values = np.zeros((1, 1, 97))
        values[0, 0, 0] = 1
        image = make_rank1(values, LATTICE)
        result = run(image, 97, 97, MODES[3])
        self.assertAlmostEqual(result.sum() / 97, 1, 5)
        self.assertLess(result.max(), 0.5)
        self.assertGreaterEqual(result.min(), 0)

    def test_supersampling_is_the_mean_of_a_finer_picture(self):
        image = make_rank1(make_noise((2, 1)), LATTICE, (2, 1))
        for mode in MODES:
            fine = run(image, 36, 27, mode)
            expected = fine.reshape(9, 3, 12, 3).mean((1, 3))
            np.testing.assert_allclose(run(image, 12, 9, mode, 3), expected, atol=1e-12)

    def test_tiles_go_over_into_each_other(self):
        # Tiles of equal texels are a picture of the lattice repeated.
        one = make_noise((1, 1))
        image = make_rank1(np.tile(one, (2, 3, 1)), LATTICE, (3, 2), (0, 3, 0, 2))
        for mode in MODES:
            small = run(make_rank1(one, LATTICE), 20, 20, mode)
            np.testing.assert_allclose(
                run(image, 60, 40, mode), np.tile(small, (2, 3)), atol=1e-10)

    def test_all_types_and_numbers_of_components(self):
        for dtype in TYPES:
            for components in (), (2,), (3,), (5,):
                values = make_noise((1, 1), dtype, components)
                for mode in MODES:
                    result = run(make_rank1(values, LATTICE), 9, 7, mode)
                    self.assertEqual(result.dtype, dtype)
                    expected = run(make_rank1(values.astype(float), LATTICE), 9, 7, mode)
                    if np.issubdtype(dtype, np.integer):
                        expected = np.floor(expected + 0.5)
                    np.testing.assert_allclose(result, expected, rtol=1e-5, atol=1e-5)

    def test_round_trip(self):
        y, x = np.meshgrid(np.arange(128) + 0.5, np.arange(128) + 0.5, indexing="ij")
        f = np.sin(2 * np.pi * x / 64) * np.cos(2 * np.pi * y / 32)
        for tiles in (1, 1), (4, 2):
            rank1 = resample(make_image(f[None]), 0, tiles)
            rank1.Update()
            for mode, tolerance in zip(MODES, (0.2, 0.02, 0.02, 0.05)):
                result = run(rank1.GetOutput(), 128, 128, mode)
                np.testing.assert_allclose(result, f, atol=tolerance)

    def test_pieces_threads_and_progress(self):
        _, picture = make_picture((20, 20, 3), np.float32)
        rank1 = resample(picture, 50, (2, 2))
        rank1.Update()
        source = PieceSource(rank1.GetOutput())
        algorithm = vtkRank1ImageReconstruct()
        marks = rank1.GetOutput().GetFieldData()
        algorithm.SetInputConnection(source.GetOutputPort())
        algorithm.SetOutputDimensions(120, 110)
        algorithm.Update()
        self.assertEqual(marks.GetNumberOfArrays(), 3)
        whole = to_numpy(algorithm.GetOutput())[0].copy()
        for extent in (0, 119, 0, 0, 0, 0), (5, 5, 7, 99, 0, 0), (30, 60, 109, 109, 0, 0):
            algorithm.Modified()
            algorithm.UpdateExtent(extent)
            part = to_numpy(algorithm.GetOutput())[0]
            x0, x1, y0, y1 = extent[:4]
            np.testing.assert_array_equal(part, whole[y0:y1 + 1, x0:x1 + 1])
        check_threads(self, algorithm)
        check_progress(self, algorithm)

    def test_small_lattices(self):
        for generator in (1, 0, 0), (2, 1, 1), (3, 1, 1):
            values = np.arange(generator[0], dtype=float).reshape(1, 1, -1)
            for mode in MODES:
                result = run(make_rank1(values, generator), 8, 8, mode)
                self.assertGreaterEqual(result.min(), -1e-12)
                self.assertLessEqual(result.max(), generator[0] - 1 + 1e-12)
                self.assertAlmostEqual(result.mean(), values.mean(), delta=0.4)

    def test_blocks(self):
        pictures = [make_image(np.random.default_rng(n).normal(size=(1, n, 9))) for n in (7, 8)]
        check_blocks(self, vtkRank1ImageResample, pictures)
        images = []
        for picture in pictures:
            rank1 = vtkRank1ImageResample()
            rank1.SetInputData(picture)
            rank1.Update()
            images.append(rank1.GetOutput())
        check_blocks(self, vtkRank1ImageReconstruct, images)

    def test_bad_input(self):
        values = make_noise((1, 1))
        refuses(self, reconstruct(make_image(np.zeros((1, 4, 4)))), "not tagged")
        refuses(self, reconstruct(vtkImageData()), "not tagged")
        for generator, words in (((50, 1, 3), ["97 x 1 x 1", "of 50 points"]),
                                 ((97, 97, 0), ["(97, 0)", "1 points, not 97"])):
            image = make_rank1(values, LATTICE)
            for i, number in enumerate(generator):
                image.GetFieldData().GetArray("Rank1.Generator").SetValue(i, number)
            refuses(self, reconstruct(image), *words)
        for number in 1.5, math.nan, 1e300:
            image = make_rank1(values, LATTICE)
            marks = numpy_to_vtk(np.array((97, number, 3)), deep=True)
            marks.SetName("Rank1.Generator")
            image.GetFieldData().AddArray(marks)
            refuses(self, reconstruct(image), "Rank1.Generator", "whole numbers")
        for domain in (0, 0, 0, 1), (1, 0, 0, 1), (0, math.nan, 0, 1), (0, math.inf, 0, 1):
            refuses(self, reconstruct(make_rank1(values, LATTICE, domain=domain)), "The area is")
        for name in "Rank1.Generator", "Rank1.Domain":
            image = make_rank1(values, LATTICE)
            image.GetFieldData().RemoveArray(name)
            refuses(self, reconstruct(image), "no array " + name)
        image = make_rank1(values, LATTICE)
        image.GetPointData().Initialize()
        refuses(self, reconstruct(image), "no point scalars")

    def test_bad_parameters(self):
        image = make_rank1(make_noise((1, 1)), LATTICE)
        refuses(self, reconstruct(image, -1, 5), "-1 x 5")
        refuses(self, reconstruct(image, 5, -7), "5 x -7")
        refuses(self, reconstruct(image, 2 ** 31 - 1, 4), "2147483647 x 4")
        refuses(self, reconstruct(image, 2 ** 29, 2 ** 29), "the machine has")
        for samples in 0, -3, 257:
            refuses(self, reconstruct(image, samples=samples), "SamplesPerAxis is %d" % samples)


if __name__ == "__main__":
    unittest.main()
