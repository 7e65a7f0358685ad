# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

import reference
from bravais import vtkBCCInterpolator
from checks import Errors, make_image, make_volume, to_numpy
from interpolators import (
    CASES, ORIGIN, SPACING, interpolate, make_array, make_interpolator, make_points, to_world)


class TestBCCInterpolator(unittest.TestCase):
    def test_values(self):
        for start in (0, 0, 0), (-1, 2, 3):
            array = make_array()
            points = make_points(array.shape, start)
            for dtype, tolerance in (np.float64, 1e-9), (np.float32, 1e-6):
                volume = make_volume(
                    array.astype(dtype), spacing=SPACING, origin=ORIGIN, start=start)
                for kernel, prefilter in CASES:
                    coefficients = {
                        0: lambda: array,
                        1: lambda: reference.quasi_interpolate(kernel, array, start),
                        2: lambda: reference.interpolate(kernel, array, start)}
                    if prefilter == 3 or (start[2] and kernel == 7):
                        continue
                    expected = reference.evaluate(
                        kernel, coefficients[prefilter](), points, start)
                    interpolator = make_interpolator(volume, kernel, prefilter)
                    np.testing.assert_allclose(
                        interpolate(interpolator, to_world(points)), expected, atol=tolerance,
                        err_msg=f"{kernel} {prefilter}")

    def test_coefficients_are_kept_until_something_changes(self):
        array = make_array()
        volume = make_volume(array, spacing=SPACING, origin=ORIGIN)
        point = to_world([(3.2, 2.1, 2.7)])[0]
        interpolator = make_interpolator(volume)
        first = interpolator.Interpolate(*point, 0)
        interpolator.ReleaseData()
        interpolator.Initialize(volume)
        self.assertEqual(interpolator.Interpolate(*point, 0), first)
        to_numpy(volume)[...] *= 2
        volume.GetPointData().GetScalars().Modified()
        interpolator.Initialize(volume)
        self.assertAlmostEqual(interpolator.Interpolate(*point, 0), 2 * first, 12)
        for change, value in (("Prefilter", 0), ("Kernel", 8), ("Prefilter", 2)):
            getattr(interpolator, "Set" + change)(value)
            interpolator.Update()
            fresh = make_interpolator(volume, interpolator.GetKernel(), interpolator.GetPrefilter())
            self.assertEqual(
                interpolator.Interpolate(*point, 0), fresh.Interpolate(*point, 0))
        other = make_volume(make_array((9, 4, 5)), spacing=SPACING, origin=ORIGIN)
        interpolator.Initialize(other)
        self.assertEqual(
            interpolator.Interpolate(*point, 0),
            make_interpolator(other, 8, 2).Interpolate(*point, 0))

    def test_the_volume_is_not_kept_alive(self):
        volume = make_volume(make_array())
        interpolator = make_interpolator(volume)
        before = volume.GetPointData().GetScalars().GetReferenceCount()
        interpolator.ReleaseData()
        self.assertEqual(volume.GetPointData().GetScalars().GetReferenceCount(), before - 1)

    def test_components(self):
        array = make_array((6, 3, 4, 5))
        for dtype in np.float64, np.float32, np.int8:
            volume = make_volume((100 * array).astype(dtype), spacing=SPACING, origin=ORIGIN)
            points = to_world(make_points(array.shape))
            singles = [interpolate(make_interpolator(make_volume(
                (100 * array[..., c]).astype(dtype), spacing=SPACING, origin=ORIGIN)), points)
                for c in range(5)]
            for offset, count, shown in ((0, -1, (0, 1, 2, 3, 4)), (2, 2, (2, 3)), (3, -1, (3, 4)),
                                         (4, 9, (4,)), (-3, 1, (0,)), (7, 1, (4,))):
                interpolator = make_interpolator(
                    volume, ComponentOffset=offset, ComponentCount=count)
                self.assertEqual(interpolator.GetNumberOfComponents(), len(shown))
                for p, *expected in zip(points, *(singles[c] for c in shown)):
                    values = [0.0] * len(shown)
                    self.assertTrue(interpolator.Interpolate(p, values))
                    self.assertEqual(values, expected)
            interpolator = make_interpolator(volume)
            for component, expected in enumerate(singles):
                np.testing.assert_array_equal(
                    interpolate(interpolator, points, component), expected)
            interpolator = make_interpolator(volume, ComponentOffset=2)
            np.testing.assert_array_equal(interpolate(interpolator, points, 1), singles[3])

    def test_border_modes(self):
        start = -1, 2, 3
        array = make_array()
        volume = make_volume(array, spacing=SPACING, origin=ORIGIN, start=start)
        low, size = np.array((-2, 4, 3)), np.array((7, 5, 5))
        inner = low + np.random.default_rng(3).uniform(0, 1, (30, 3)) * size
        outer = inner + size * np.random.default_rng(4).integers(-1, 2, (30, 3))
        mirrored = low + np.abs(outer - low)
        mirrored = np.where(mirrored > low + size, 2 * (low + size) - mirrored, mirrored)
        plain = make_interpolator(volume)
        reach = 1e3  # as far as points may lie outside
        for mode, expected in (("Repeat", inner), ("Mirror", mirrored),
                               ("Clamp", np.clip(outer, low, low + size))):
            interpolator = vtkBCCInterpolator()
            getattr(interpolator, "SetBorderModeTo" + mode)()
            interpolator.SetTolerance(reach)
            interpolator.Initialize(volume)
            np.testing.assert_allclose(
                interpolate(interpolator, to_world(outer)),
                interpolate(plain, to_world(expected)), atol=1e-9, err_msg=mode)

    def test_mirrored_spline_is_smooth(self):
        volume = make_volume(make_array())
        interpolator = make_interpolator(volume, Tolerance=100)
        interpolator.SetBorderModeToMirror()
        interpolator.Update()
        for axis, face in (0, 0), (0, 3.5), (1, 2.5), (2, 0), (2, 5):
            p = np.array((1.3, 0.8, 2.2))
            p[axis] = face
            step = 1e-3 * np.eye(3)[axis]
            self.assertAlmostEqual(
                interpolator.Interpolate(*(p + step), 0), interpolator.Interpolate(*(p - step), 0),
                12)

    def test_bounds_and_tolerance(self):
        volume = make_volume(make_array(), spacing=SPACING, origin=ORIGIN)
        interpolator = make_interpolator(volume, OutValue=77)
        middle = np.array((3.5, 2.5, 2.5))
        for axis, last in enumerate((7, 5, 5)):
            for face, outward in (0, -1), (last, 1):
                p = middle.copy()
                p[axis] = face
                unit = np.eye(3)[axis] * (2, 2, 1)  # an index, VTK's unit of the tolerance
                inside, outside = p - 1e-9 * outward * unit, p + 1e-4 * outward * unit
                self.assertNotEqual(interpolator.Interpolate(*to_world(inside), 0), 77)
                self.assertEqual(interpolator.Interpolate(*to_world(outside), 0), 77)
                values = [0.0]
                self.assertFalse(interpolator.Interpolate(to_world(outside), values))
                self.assertEqual(values, [77])
                interpolator.SetTolerance(1e-3)
                interpolator.Update()
                self.assertAlmostEqual(
                    interpolator.Interpolate(*to_world(outside), 0),
                    interpolator.Interpolate(*to_world(p), 0), 9)
                interpolator.SetTolerance(1e-5)
                interpolator.Update()
        for p in (1e30, 0, 0), (0, -math.inf, 0), (0, 0, math.inf):
            self.assertEqual(interpolator.Interpolate(*p, 0), 77)
        interpolator.Interpolate(math.nan, math.nan, math.nan, 0)  # anything, but no crash

    def test_deep_copy(self):
        volume = make_volume(make_array(), spacing=SPACING, origin=ORIGIN)
        original = make_interpolator(volume, 8, 2, OutValue=5, Tolerance=0.25)
        copy = vtkBCCInterpolator()
        copy.DeepCopy(original)
        copy.Update()
        self.assertEqual(copy.GetKernelAsString(), "BCC8")
        self.assertEqual(copy.GetPrefilterAsString(), "Interpolation")
        points = to_world(make_points((6, 3, 4)))
        expected = interpolate(original, points)
        np.testing.assert_array_equal(interpolate(copy, points), expected)
        original.SetKernelToBCC4()
        original.Initialize(make_volume(make_array((2, 2, 2))))
        del original, volume
        np.testing.assert_array_equal(interpolate(copy, points), expected)

    def check_refused(self, volume, words, **properties):
        interpolator = make_interpolator(
            make_volume(make_array((9, 5, 5))), OutValue=77)  # it worked before
        for name, value in properties.items():
            getattr(interpolator, "Set" + name)(value)
        with Errors(interpolator) as errors:
            interpolator.Initialize(volume)
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        for p in (0, 0, 0), (1, 1, 1), (0.5, 0.2, 0):
            self.assertEqual(interpolator.Interpolate(*p, 0), 77)
        values = [1.0] * 7
        interpolator.InterpolateIJK((1, 1, 1), values)  # which asks for no bounds
        interpolator.SetKernel(7)
        interpolator.SetPrefilter(1)
        interpolator.Initialize(make_volume(np.full((6, 3, 4), 3.0)))
        self.assertAlmostEqual(interpolator.Interpolate(1, 1, 1, 0), 3.0)

    def test_bad_input(self):
        good = make_volume(make_array())
        self.check_refused(None, ["no input image"])
        self.check_refused(vtkImageData(), ["tagged"])
        self.check_refused(make_image(make_array()), ["tagged", "BCC"])
        self.check_refused(make_volume(make_array((1, 3, 4))), ["4 x 3 x 1", "1 x 1 x 2"])
        self.check_refused(make_volume(make_array(), spacing=(1, math.nan, 1)), ["spacing"])
        self.check_refused(make_volume(make_array(), origin=(math.inf, 0, 1)), ["origin"])
        empty = make_volume(make_array())
        empty.GetPointData().Initialize()
        self.check_refused(empty, ["no point scalars"])
        self.check_refused(good, ["Kernel is 9", "4, 7, 8 or 12"], Kernel=9)
        self.check_refused(good, ["Prefilter is 4"], Prefilter=4)
        for kernel, name in (7, "BCC7"), (12, "BCC12"):
            self.check_refused(good, [name, "BCC4 and BCC8"], Kernel=kernel, Prefilter=2)

    def test_names_of_the_enumerations(self):
        interpolator = vtkBCCInterpolator()
        self.assertEqual(interpolator.GetKernelAsString(), "BCC7")
        self.assertEqual(interpolator.GetPrefilterAsString(), "QuasiInterpolation")
        self.assertFalse(interpolator.IsSeparable())
        for name in "BCC4", "BCC7", "BCC8", "BCC12":
            getattr(interpolator, "SetKernelTo" + name)()
            self.assertEqual(interpolator.GetKernelAsString(), name)
        for name in "None", "QuasiInterpolation", "Interpolation", "Projection":
            getattr(interpolator, "SetPrefilterTo" + name)()
            self.assertEqual(interpolator.GetPrefilterAsString(), name)
        interpolator.SetKernel(5)
        self.assertEqual(interpolator.GetKernelAsString(), "Unknown")
        self.assertIn("Prefilter: Projection", str(interpolator))


if __name__ == "__main__":
    unittest.main()
