# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.vtkImagingCore import (
    vtkImageBSplineInterpolator, vtkImageDataStreamer, vtkImageInterpolator,
    vtkImageSincInterpolator, vtkImageTranslateExtent)

from bravais import vtkBCCLattice, vtkImageToBCCVolume
from checks import (
    check_blocks, check_numbered_pieces, check_pieces, check_progress, check_threads,
    get_points, make_image, to_numpy)

TYPES = "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64".split()


def make_filter(image, interpolator=None, ratio=1, dimensions=(0, 0, 0)):
    resample = vtkImageToBCCVolume()
    resample.SetInputData(image)
    resample.SetSampleRatio(ratio)
    resample.SetDimensions(dimensions)
    if interpolator:
        resample.SetInterpolator(interpolator)
    return resample


def make_noise(shape, seed=2):
    return np.random.default_rng(seed).uniform(-1, 1, shape)


def cubic(t):
    t = np.abs(t)
    return np.where(t < 1, 2 / 3 - t * t + t ** 3 / 2, np.where(t < 2, (2 - t) ** 3 / 6, 0))


def make_spline(count):
    """Rows that give the mirrored interpolating cubic spline at positions 0 .. count - 1."""
    def evaluate(positions):
        rows = np.zeros((len(positions), count))
        for n in range(-3, count + 3):
            mirrored = abs(n) if n < count else 2 * (count - 1) - n
            rows[:, mirrored] += cubic(positions - n)
        return rows
    inverse = np.linalg.inv(evaluate(np.arange(count)))
    return lambda positions: evaluate(positions) @ inverse


def resample_by_spline(array, image, output):
    """The default, by linear algebra."""
    points = (get_points(output) - image.GetOrigin()) / image.GetSpacing()
    splines = [make_spline(n) for n in array.shape]
    layers = splines[0](points[:, 0, 0, 2])
    result = np.empty(points.shape[:3])
    for k, layer in enumerate(layers):
        plane = np.tensordot(layer, array, 1)
        result[k] = splines[1](points[k, :, 0, 1]) @ plane @ splines[2](points[k, 0, :, 0]).T
    return result


class TestImageToBCCVolumeResample(unittest.TestCase):
    def test_lattice_is_isotropic_and_fits_the_input(self):
        for size, spacing in (((20, 20, 20), (1, 1, 1)), ((31, 17, 9), (1, 2, 3)),
                              ((12, 40, 23), (0.9, 0.3, 1.5)), ((5, 6, 50), (7, 7, 0.5))):
            for ratio in 0.3, 1, 2.5:
                image = make_image(np.zeros(size[::-1]), spacing, (1, -2, 3))
                resample = make_filter(image, vtkImageInterpolator(), ratio)
                resample.Update()
                output = resample.GetOutput()
                s = output.GetSpacing()
                self.assertEqual((s[0], s[1]), (2 * s[2], 2 * s[2]))
                self.assertEqual(output.GetExtent()[::2], (0, 0, 0))
                # As many samples as the steps of n allow.
                n = np.array(output.GetDimensions())
                wanted = ratio * image.GetNumberOfPoints()
                self.assertLess(abs(n.prod() / wanted - 1), 0.6 * (1 / n).sum())
                box = [0.0] * 6
                vtkBCCLattice.GetBox(output, box)
                low = np.array(box[::2]) - image.GetBounds()[::2]
                high = np.array(image.GetBounds()[1::2]) - box[1::2]
                np.testing.assert_allclose(low, high, atol=1e-9)
                self.assertTrue((low > -1e-9).all())
                self.assertTrue((low + high < np.array((1, 1, 0.5)) * s[0]).all())
                self.assertAlmostEqual((low / s[2]).min(), 0)

    def test_dimensions_are_obeyed(self):
        image = make_image(make_noise((20, 15, 10)), (1, 2, 1.5))
        for dimensions in ((8, 9, 10), (1, 1, 2), (30, 5, 12)):
            resample = make_filter(image, dimensions=dimensions)
            resample.Update()
            output = resample.GetOutput()
            self.assertEqual(output.GetDimensions(), dimensions)
            s = output.GetSpacing()
            self.assertEqual((s[0], s[1]), (2 * s[2], 2 * s[2]))
            edges = np.array(dimensions) * (2, 2, 1) - 1
            self.assertAlmostEqual(s[2], (np.array((9, 28, 28.5)) / edges).min())

    def test_default_is_the_interpolating_cubic_spline(self):
        array = make_noise((9, 12, 10))
        image = make_image(array, (1, 1, 2), (3, 4, 5))
        resample = make_filter(image)
        resample.Update()
        output = resample.GetOutput()
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "values")
        self.assertEqual(resample.GetInterpolator().GetClassName(), "vtkImageBSplineInterpolator")
        np.testing.assert_allclose(
            to_numpy(output), resample_by_spline(array, image, output), atol=1e-12)

    def test_ramp_is_exact_in_the_interior(self):
        z, y, x = np.indices((40, 36, 38)) * 1.5
        for dtype, tolerance in ((np.float32, 2e-5), (np.float64, 1e-6)):
            image = make_image((x + 2 * y - 3 * z).astype(dtype), (1.5, 1.5, 1.5))
            resample = make_filter(image)
            resample.Update()
            p = get_points(resample.GetOutput())
            inside = ((p > 21) & (p < (np.array((38, 36, 40)) - 15) * 1.5)).all(-1)
            self.assertGreater(inside.sum(), 100)
            expected = p @ (1, 2, -3)
            np.testing.assert_allclose(
                to_numpy(resample.GetOutput())[inside], expected[inside], atol=tolerance)

    def test_linear_interpolator_keeps_ramps_to_the_border(self):
        z, y, x = np.indices((8, 9, 10)) * 1.0
        resample = make_filter(make_image(x + 2 * y - 3 * z), vtkImageInterpolator(), 3)
        resample.Update()
        output = resample.GetOutput()
        # VTK's own interpolators know a place to 2^-16 of a step.
        np.testing.assert_allclose(to_numpy(output), get_points(output) @ (1, 2, -3), atol=1e-4)

    def test_splines_of_any_degree_and_border_interpolate(self):
        array = make_noise((10, 10, 10))
        for degree in range(10):
            # For higher degrees VTK's coefficients of clamped borders are approximate.
            for border in range(3) if degree < 4 else (1, 2):
                spline = vtkImageBSplineInterpolator()
                spline.SetSplineDegree(degree)
                spline.SetBorderMode(border)
                resample = make_filter(make_image(array), spline, dimensions=(5, 5, 10))
                resample.LowPassOff()
                resample.Update()
                output = resample.GetOutput()
                at = np.round(get_points(output)).astype(int)
                np.testing.assert_allclose(get_points(output), at, atol=1e-12)  # nodes, all of them
                expected = array[at[..., 2], at[..., 1], at[..., 0]]
                np.testing.assert_allclose(
                    to_numpy(output), expected, atol=1e-9, err_msg=f"{degree} {border}")

    def test_integers_are_rounded_and_clamped(self):
        for name in TYPES[:8]:
            info = np.iinfo(name)
            rng = np.random.default_rng(3)
            small = rng.integers(0, 100, (7, 8, 9)).astype(name)
            extreme = rng.choice(np.array((info.min, info.max), name), (7, 8, 9))
            for array in small, extreme:
                resample = make_filter(make_image(array))
                resample.Update()
                output = resample.GetOutput()
                self.assertEqual(output.GetScalarType(), resample.GetInput().GetScalarType())
                exact = resample_by_spline(array.astype(float), resample.GetInput(), output)
                values = to_numpy(output)
                self.assertEqual(values.dtype, name)
                if array is small:
                    clamped = np.clip(exact, info.min, info.max)
                    self.assertLess(np.abs(values - clamped).max(), 0.5 + 1e-4)
                else:
                    span = float(info.max) - float(info.min)
                    self.assertTrue((values[exact > info.max + 1e-3 * span] == info.max).all())
                    self.assertTrue((values[exact < info.min - 1e-3 * span] == info.min).all())
                    self.assertGreater((values == info.max).sum(), 0)

    def test_components(self):
        array = make_noise((7, 8, 9, 3))
        for ratio in 1, 0.1:
            resample = make_filter(make_image(array), ratio=ratio)
            resample.Update()
            together = to_numpy(resample.GetOutput())
            self.assertEqual(together.shape[3], 3)
            for c in range(3):
                resample = make_filter(make_image(array[..., c]), ratio=ratio)
                resample.Update()
                np.testing.assert_array_equal(to_numpy(resample.GetOutput()), together[..., c])
        spline = vtkImageBSplineInterpolator()
        spline.SetBorderModeToMirror()
        spline.SetComponentOffset(1)
        spline.SetComponentCount(1)
        resample = make_filter(make_image(array), spline, ratio=ratio)
        resample.Update()
        np.testing.assert_array_equal(to_numpy(resample.GetOutput()), together[..., 1])

    def test_other_extents_and_directions_give_the_same(self):
        array = make_noise((8, 9, 10))
        resample = make_filter(make_image(array, (1, 2, 3)))
        resample.Update()
        expected = to_numpy(resample.GetOutput()).copy()
        origin = np.array(resample.GetOutput().GetOrigin())
        image = make_image(array, (1, 2, 3), (-5 * 1, 3 * 2, -7 * 3), start=(5, -3, 7))
        resample.SetInputData(image)
        resample.Update()
        np.testing.assert_allclose(to_numpy(resample.GetOutput()), expected, atol=1e-12)
        np.testing.assert_allclose(resample.GetOutput().GetOrigin(), origin, atol=1e-12)
        image = make_image(array, (1, 2, 3), (7, 8, 9))
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)  # a quarter turn about z
        resample.SetInputData(image)
        resample.Update()
        output = resample.GetOutput()
        np.testing.assert_array_equal(to_numpy(output), expected)
        turned = (7 - origin[1], 8 + origin[0], 9 + origin[2])
        np.testing.assert_allclose(output.GetOrigin(), turned, atol=1e-12)
        self.assertEqual(output.GetDirectionMatrix().GetElement(1, 0), 1)

    def test_pieces_threads_and_progress(self):
        sinc = vtkImageSincInterpolator()
        sinc.AntialiasingOn()
        nearest, cubic_, linear = (vtkImageInterpolator() for _ in range(3))
        nearest.SetInterpolationModeToNearest()
        cubic_.SetInterpolationModeToCubic()
        image = make_image(make_noise((14, 17, 13)).astype("f4"), (1, 1, 1.5), start=(2, -3, 1))
        for interpolator in None, sinc, nearest, cubic_, linear:
            for ratio, low_pass in ((1.0, True), (0.2, True), (0.2, False), (8.0, True)):
                resample = make_filter(image, interpolator, ratio)
                resample.SetLowPass(low_pass)
                check_pieces(self, resample)
                check_numbered_pieces(self, resample, 4)
                check_threads(self, resample)
        check_progress(self, make_filter(image))
        check_progress(self, make_filter(image, None, 0.2))

    def test_blocks(self):
        values = np.random.default_rng(4).normal(size=(9, 8, 11))
        check_blocks(self, vtkImageToBCCVolume, [make_image(values), make_image(values[2:, :5])])

    def test_streaming_gives_the_whole(self):
        resample = make_filter(make_image(make_noise((12, 13, 14)).astype("f4")))
        resample.Update()
        whole = to_numpy(resample.GetOutput()).copy()
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(resample.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(5)
        streamer.Update()
        np.testing.assert_array_equal(to_numpy(streamer.GetOutput()), whole)

    def test_small_kernels_ask_for_less_than_the_whole(self):
        passing = vtkImageTranslateExtent()  # tells what was asked of it
        passing.SetInputData(make_image(np.zeros((60, 20, 20))))
        resample = vtkImageToBCCVolume()
        resample.SetInputConnection(passing.GetOutputPort())
        for interpolator, most in ((vtkImageInterpolator(), 8), (None, 60)):
            if interpolator:
                resample.SetInterpolator(interpolator)
            else:
                resample.SetInterpolator(vtkImageBSplineInterpolator())
            resample.UpdateInformation()
            n = resample.GetOutputInformation(0).Get(
                resample.GetExecutive().WHOLE_EXTENT())
            resample.UpdateExtent((0, n[1], 0, n[3], n[5] // 2, n[5] // 2))
            asked = passing.GetUpdateExtent()
            self.assertLessEqual(asked[5] - asked[4] + 1, most)

    def test_the_interpolator_is_followed_and_left_alone(self):
        array = make_noise((8, 9, 10))
        interpolator = vtkImageInterpolator()
        resample = make_filter(make_image(array), interpolator)
        resample.Update()
        linear = to_numpy(resample.GetOutput()).copy()
        self.assertFalse(interpolator.GetSlidingWindow())
        interpolator.SetInterpolationModeToNearest()
        resample.Update()
        self.assertTrue(np.isin(to_numpy(resample.GetOutput()), array).all())
        self.assertFalse(np.isin(linear, array).all())

    def test_nan_and_infinity_pass_through(self):
        for value in np.nan, np.inf:
            array = make_noise((12, 12, 12))
            array[6, 6, 6] = value
            for ratio in 1, 0.2:
                resample = make_filter(make_image(array), ratio=ratio)
                resample.Update()
                self.assertFalse(np.isfinite(to_numpy(resample.GetOutput())).all())
            resample = make_filter(make_image(array), vtkImageInterpolator())
            resample.Update()
            output = resample.GetOutput()
            far = (np.abs(get_points(output) - 6) > 1.01).any(-1)
            finite = np.isfinite(to_numpy(output))
            self.assertTrue(finite[far].all())
            self.assertFalse(finite.all())

    def test_smallest_input(self):
        resample = make_filter(make_image(np.arange(8.0).reshape(2, 2, 2)), ratio=0.5)
        resample.Update()
        output = resample.GetOutput()
        self.assertGreaterEqual(output.GetNumberOfPoints(), 2)
        self.assertTrue(np.isfinite(to_numpy(output)).all())

    def test_field_data(self):
        image = make_image(make_noise((5, 6, 7)))
        note = make_image(np.zeros((1, 1, 1)), name="note").GetPointData().GetScalars()
        image.GetFieldData().AddArray(note)
        resample = make_filter(image)
        resample.Update()
        self.assertTrue(vtkBCCLattice.IsBCC(resample.GetOutput()))
        self.assertFalse(vtkBCCLattice.IsBCC(image))
        self.assertIsNotNone(resample.GetOutput().GetFieldData().GetArray("note"))


if __name__ == "__main__":
    unittest.main()
