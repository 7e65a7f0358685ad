# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkIdTypeArray, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkImagingCore import vtkImageMapToColors, vtkImageTranslateExtent

from bravais import vtkBayerPattern, vtkBCCLattice, vtkOrderedDither
from checks import (
    Errors, check_numbered_pieces, check_pieces, check_progress, check_threads, make_image, refuses,
    to_numpy)

TYPES = [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64,
         np.float32, np.float64]


def get_thresholds(dimension, log2_size, base_order=vtkBayerPattern.FCC):
    pattern = vtkBayerPattern()
    pattern.SetBaseOrder(base_order)
    ranks = vtkIdTypeArray()
    assert pattern.GetThresholds(dimension, log2_size, ranks)
    side = 2 ** log2_size
    ranks = vtk_to_numpy(ranks).reshape((1, side, side) if dimension == 2 else (side,) * 3)
    return (ranks + 0.5) / ranks.size


def expect(values, levels, lo, hi, thresholds, start=(0, 0, 0)):
    """Levels of an array [z, y, x] or [z, y, x, component], by the definition."""
    u = np.clip((values.astype(float) - lo) / (hi - lo) * (levels - 1), 0, levels - 1)
    z, y, x = np.meshgrid(*(start[2 - a] + np.arange(values.shape[a]) for a in range(3)),
                          indexing="ij")
    n = thresholds.shape
    t = thresholds[z % n[0], y % n[1], x % n[2]]
    if values.ndim == 4:
        t = t[..., None]
    return (np.floor(u) + (u - np.floor(u) >= t)).astype(np.uint8)


def dither(image, levels=2, dimensionality=2, log2_size=3, input_range=(0, 0)):
    algorithm = vtkOrderedDither()
    algorithm.SetInputDataObject(image)
    algorithm.SetNumberOfLevels(levels)
    algorithm.SetDimensionality(dimensionality)
    algorithm.SetPatternLog2Size(log2_size)
    algorithm.SetInputRange(input_range)
    return algorithm


def run(*arguments, **keywords):
    algorithm = dither(*arguments, **keywords)
    algorithm.Update()
    return to_numpy(algorithm.GetOutput())


def make_noise(shape, dtype=np.float64):
    generator = np.random.default_rng(5)
    values = generator.integers(0, 120, shape)
    values.flat[:2] = 0, 119
    return values.astype(dtype)


class TestOrderedDither(unittest.TestCase):
    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_image(np.random.default_rng(2).normal(size=(4, 5, 6))))
        blocks.SetBlock(1, vtkPolyData())
        dither = vtkOrderedDither()
        dither.SetInputDataObject(blocks)
        for levels in 2, 1:  # what is no image, then no levels
            dither.SetNumberOfLevels(levels)
            with Errors(dither) as errors:
                dither.Update()
            self.assertEqual(len(errors.texts), 1, errors.texts)
        dither.SetNumberOfLevels(2)
        with Errors(dither):
            dither.Update()
        output = dither.GetOutputDataObject(0)
        self.assertEqual(output.GetBlock(0).GetNumberOfPoints(), 120)
        self.assertEqual(output.GetBlock(1).GetNumberOfPoints(), 0)

    def test_defaults(self):
        algorithm = vtkOrderedDither()
        self.assertEqual(algorithm.GetNumberOfLevels(), 2)
        self.assertEqual(algorithm.GetDimensionality(), 2)
        self.assertEqual(algorithm.GetPatternLog2Size(), 3)
        self.assertEqual(algorithm.GetInputRange(), (0, 0))
        self.assertEqual(algorithm.GetBaseOrderAsString(), "FCC")

    def test_all_types_and_numbers_of_components(self):
        for dtype in TYPES:
            for components in 1, 2, 3, 5:
                values = make_noise((3, 9, 21, components), dtype)
                values = values[..., 0] if components == 1 else values
                result = run(make_image(values), levels=3)
                self.assertEqual(result.dtype, np.uint8)
                expected = expect(values, 3, 0, 119, get_thresholds(2, 3))
                np.testing.assert_array_equal(result, expected, str(dtype))

    def test_patterns(self):
        values = make_noise((11, 13, 19))
        image = make_image(values, start=(-3, 5, 2))
        for dimensionality, sizes in (2, (0, 1, 4, 11)), (3, (0, 2, 4, 5)):
            for log2_size in sizes:
                for base_order in vtkOrderedDither.FCC, vtkOrderedDither.BCC:
                    thresholds = get_thresholds(dimensionality, log2_size, base_order)
                    algorithm = dither(image, 5, dimensionality, log2_size, (-3, 128))
                    algorithm.SetBaseOrder(base_order)
                    algorithm.Update()
                    np.testing.assert_array_equal(
                        to_numpy(algorithm.GetOutput()),
                        expect(values, 5, -3, 128, thresholds, (-3, 5, 2)))

    def test_largest_cube(self):
        values = np.linspace(0, 1, 4096).reshape(16, 16, 16)
        result = run(make_image(values), 256, 3, 7)
        np.testing.assert_array_equal(result, expect(values, 256, 0, 1, get_thresholds(3, 7)))

    def test_rows_longer_than_a_run(self):
        values = make_noise((1, 3, 5000, 3), np.uint8)
        np.testing.assert_array_equal(
            run(make_image(values), 4), expect(values, 4, 0, 119, get_thresholds(2, 3)))

    def test_output_is_the_input_but_for_its_scalars(self):
        image = make_image(make_noise((4, 5, 6)), (1, 2, 3), (4, 5, 6), "density")
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        other = numpy_to_vtk(np.arange(120.0), deep=True)
        other.SetName("other")
        image.GetPointData().AddArray(other)
        algorithm = dither(image)
        algorithm.Update()
        output = algorithm.GetOutput()
        self.assertEqual(output.GetScalarType(), VTK_UNSIGNED_CHAR)
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "density")
        self.assertEqual(output.GetSpacing(), (1, 2, 3))
        self.assertEqual(output.GetOrigin(), (4, 5, 6))
        self.assertEqual(output.GetDirectionMatrix().GetElement(0, 1), -1)
        np.testing.assert_array_equal(vtk_to_numpy(output.GetPointData().GetArray("other")),
                                      np.arange(120.0))

    def test_an_array_can_be_chosen(self):
        image = make_image(make_noise((1, 5, 6)))
        values = np.linspace(0, 1, 30)
        other = numpy_to_vtk(values, deep=True)
        other.SetName("other")
        image.GetPointData().AddArray(other)
        algorithm = dither(image)
        algorithm.SetInputArrayToProcess(0, 0, 0, 0, "other")
        algorithm.Update()
        np.testing.assert_array_equal(
            to_numpy(algorithm.GetOutput()),
            expect(values.reshape(1, 5, 6), 2, 0, 1, get_thresholds(2, 3)))

    def test_constants_keep_their_mean_to_half_a_threshold(self):
        for dimensionality, cells in (2, 16), (3, 64):
            for value in np.linspace(0, 1, 41):
                image = make_image(np.full((4, 4, 4), value))
                for levels in 2, 4, 7:
                    mean = run(image, levels, dimensionality, 2, (0, 1)).mean()
                    self.assertLessEqual(
                        abs(mean - value * (levels - 1)), 0.5 / cells + 1e-9, value)

    def test_gradients_rise_from_block_to_block(self):
        ramp = np.broadcast_to(np.linspace(0, 1, 512), (8, 8, 512))
        for dimensionality in 2, 3:
            for levels in 2, 4, 8:
                result = run(make_image(ramp), levels, dimensionality)
                means = result.reshape(8, 8, 64, 8).mean(axis=(0, 1, 3))
                self.assertTrue((np.diff(means) >= 0).all())
                expected = ramp.reshape(8, 8, 64, 8).mean(axis=(0, 1, 3)) * (levels - 1)
                self.assertLess(np.abs(means - expected).max(), (levels - 1) / 64)
                self.assertEqual((result.min(), result.max()), (0, levels - 1))

    def test_round_trip_through_a_lookup_table(self):
        levels = 4
        ramp = np.broadcast_to(np.linspace(0, 255, 1024), (1, 64, 1024))
        table = vtkLookupTable()
        table.SetNumberOfTableValues(levels)
        table.SetTableRange(0, levels - 1)
        for level in range(levels):
            grey = level / (levels - 1)
            table.SetTableValue(level, grey, grey, grey)
        colors = vtkImageMapToColors()
        colors.SetLookupTable(table)
        colors.SetOutputFormatToLuminance()
        algorithm = dither(make_image(ramp), levels)
        colors.SetInputConnection(algorithm.GetOutputPort())
        colors.Update()
        picture = to_numpy(colors.GetOutput()).astype(float)
        self.assertEqual(np.unique(picture).tolist(), [0, 85, 170, 255])
        blocks = picture.reshape(8, 8, 128, 8).mean(axis=(1, 3))
        expected = ramp.reshape(8, 8, 128, 8).mean(axis=(1, 3))
        rise = 8 * 255 / 1023  # of the ramp, in a block
        self.assertLess(np.abs(blocks - expected).max(), 0.5 * rise + 0.5 / 64 * 85)
        # The quantised values are fixed points: the same pattern finds the same levels again.
        again = run(make_image(picture), levels)
        np.testing.assert_array_equal(again, to_numpy(algorithm.GetOutput()))

    def test_256_levels_of_bytes_change_nothing(self):
        values = np.arange(256, dtype=np.uint8).reshape(4, 8, 8)
        np.testing.assert_array_equal(run(make_image(values), 256, 3), values)

    def test_range_of_all_components_together(self):
        values = np.array([[[[10, 0], [30, 50]]]], np.uint8)
        np.testing.assert_array_equal(run(make_image(values), 6, log2_size=0), values / 10)

    def test_nan_is_level_zero_and_changes_no_other_point(self):
        values = make_noise((3, 9, 12), np.float32)
        clean = run(make_image(values), 4)
        holes = values.copy()
        holes[1, 2:5, 3:9] = np.nan
        nan = np.isnan(holes)
        result = run(make_image(holes), 4)
        np.testing.assert_array_equal(result, np.where(nan, 0, clean))

    def test_infinities_are_the_ends(self):
        values = np.array([[[-np.inf, 0.0, 2.0, np.inf]]])
        self.assertEqual(run(make_image(values), 3).tolist(), [[[0, 0, 2, 2]]])

    def test_numbers_beyond_the_range(self):
        values = np.array([[[-1e300, -1.0, 3.0, 1e300]]])
        self.assertEqual(run(make_image(values), 3, input_range=(0, 1)).tolist(), [[[0, 0, 2, 2]]])

    def test_pieces_threads_and_progress(self):
        image = make_image(make_noise((12, 9, 11, 2)), start=(2, -3, 5))
        vtkBCCLattice.Tag(image)
        for dimensionality in 2, 3:
            for input_range in (0, 0), (10, 90):
                algorithm = dither(image, 4, dimensionality, 2, input_range)
                check_pieces(self, algorithm)
                check_numbered_pieces(self, algorithm, 3)
                check_threads(self, algorithm)
                check_progress(self, algorithm)

    def test_a_single_slice_is_shared_among_threads(self):
        check_threads(self, dither(make_image(make_noise((1, 300, 200), np.int16)), 4))

    def test_asks_for_the_whole_input_only_without_a_range(self):
        source = vtkTrivialProducer()
        source.SetOutput(make_image(make_noise((1, 40, 50))))
        source.SetWholeExtent(0, 49, 0, 39, 0, 0)
        upstream = vtkImageTranslateExtent()
        upstream.SetInputConnection(source.GetOutputPort())
        key = upstream.GetExecutive().UPDATE_EXTENT()
        for input_range, asked in ((0, 0), (0, 49, 0, 39, 0, 0)), ((0, 9), (3, 5, 7, 8, 0, 0)):
            algorithm = dither(None, input_range=input_range)
            algorithm.SetInputConnection(upstream.GetOutputPort())
            algorithm.UpdateExtent((3, 5, 7, 8, 0, 0))
            self.assertEqual(algorithm.GetOutput().GetExtent(), (3, 5, 7, 8, 0, 0))
            self.assertEqual(upstream.GetOutputInformation(0).Get(key), asked)


class TestOrderedDitherBadInput(unittest.TestCase):
    def test_levels(self):
        image = make_image(make_noise((1, 4, 4)))
        for levels in -1, 0, 1, 257, 2 ** 31 - 1:
            refuses(self, dither(image, levels), f"NumberOfLevels is {levels};", "2 to 256")

    def test_dimensionality(self):
        image = make_image(make_noise((1, 4, 4)))
        for dimensionality in 0, 1, 4:
            refuses(self, dither(image, 2, dimensionality),
                    f"Dimensionality is {dimensionality};", "2 or 3")

    def test_pattern_sizes(self):
        image = make_image(make_noise((1, 4, 4)))
        for dimensionality, most in (2, 11), (3, 7):
            for log2_size in -1, most + 1, 31, 32, 62, 2 ** 31 - 1:
                refuses(self, dither(image, 2, dimensionality, log2_size),
                        f"PatternLog2Size is {log2_size};", f"0 to {most} ")

    def test_ranges(self):
        image = make_image(make_noise((1, 4, 4)))
        infinity = float("inf")
        for bad in (3, 3), (3, 2), (float("nan"), 1), (0, infinity), (-infinity, 0), (-1e308, 1e308):
            refuses(self, dither(image, input_range=bad), "InputRange is ", "ascending")

    def test_scalar_ranges(self):
        for values in np.full((2, 3, 4), 7), np.full((1, 3, 4), np.nan):
            refuses(self, dither(make_image(values)), "The scalar range is ", "InputRange")

    def test_images_without_points_or_scalars(self):
        image = make_image(make_noise((1, 4, 4)))
        image.GetPointData().Initialize()
        refuses(self, dither(image, input_range=(0, 1)), "point scalars")
        image.Initialize()
        refuses(self, dither(image, input_range=(0, 1)), "no points")

    def test_too_few_scalars(self):
        image = make_image(make_noise((1, 4, 4)))
        image.SetExtent(0, 3, 0, 7, 0, 0)
        refuses(self, dither(image), "fewer than points")

    def test_an_error_empties_an_earlier_output(self):
        algorithm = dither(make_image(make_noise((1, 4, 4))))
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 16)
        algorithm.SetNumberOfLevels(257)
        refuses(self, algorithm, "257")
        algorithm.SetNumberOfLevels(256)
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 16)


if __name__ == "__main__":
    unittest.main()
