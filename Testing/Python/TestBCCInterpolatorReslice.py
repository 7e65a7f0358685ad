# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkLookupTable
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkImagingCore import vtkImageReslice, vtkImageResliceToColors

from bravais import vtkBCCVolumeSource, vtkBCCVolumeToImage
from checks import Errors, PieceSource, make_image, make_pieces, make_volume, modify, to_numpy
from interpolators import CASES, ORIGIN, SPACING, make_array, make_interpolator


class TestBCCInterpolatorReslice(unittest.TestCase):
    def make_reslice(self, source, volume, kernel=7, prefilter=1):
        reslice = vtkImageReslice()
        reslice.SetInputConnection(source.GetOutputPort())
        reslice.SetInterpolator(make_interpolator(None, kernel, prefilter))
        reslice.SetOutputScalarType(VTK_DOUBLE)
        reslice.SetBackgroundLevel(-9)
        return reslice

    def test_reslice_gives_what_volume_to_image_gives(self):
        for dtype, tolerance in (np.float64, 1e-12), (np.float32, 3e-6), (np.int16, 1e-3):
            for start in (0, 0, 0), (2, -1, 3):
                array = (1 if dtype != np.int16 else 1000) * make_array()
                volume = make_volume(
                    array.astype(dtype), spacing=SPACING, origin=ORIGIN, start=start)
                source = PieceSource(volume)
                for kernel, prefilter in CASES:
                    to_image = vtkBCCVolumeToImage()
                    to_image.SetInputConnection(source.GetOutputPort())
                    to_image.SetOutputDimensions(7, 6, 9)
                    to_image.SetKernel(kernel)
                    to_image.SetPrefilter(prefilter)
                    to_image.SetOutputScalarTypeToDouble()
                    to_image.Update()
                    image = to_image.GetOutput()
                    reslice = self.make_reslice(source, volume, kernel, prefilter)
                    reslice.SetOutputExtent(image.GetExtent())
                    reslice.SetOutputSpacing(image.GetSpacing())
                    reslice.SetOutputOrigin(image.GetOrigin())
                    reslice.Update()
                    np.testing.assert_allclose(
                        to_numpy(reslice.GetOutput()), to_numpy(image), rtol=0, atol=tolerance,
                        err_msg=f"{dtype} {kernel} {prefilter}")

    def test_reslice_turned(self):
        volume = make_volume(make_array((10, 6, 5)), spacing=(2, 2, 1))
        source = PieceSource(volume)
        turns = [((0, 0, 1), 0), ((0, 0, 1), 90), ((1, 0, 0), -90), ((1, 2, 3), 40)]
        for kernel, prefilter in (7, 1), (12, 1), (8, 2):
            interpolator = make_interpolator(volume, kernel, prefilter)
            for axis, angle in turns:
                turn = vtkTransform()
                turn.Translate(4, 5, 4.5)
                turn.RotateWXYZ(angle, *axis)
                reslice = self.make_reslice(source, volume, kernel, prefilter)
                reslice.SetResliceAxes(turn.GetMatrix())
                reslice.SetOutputExtent(0, 8, 0, 7, 0, 6)
                reslice.SetOutputSpacing(0.75, 0.8, 0.85)
                reslice.SetOutputOrigin(-3, -2.8, -2.5)
                reslice.Update()
                values = to_numpy(reslice.GetOutput())
                inside = 0
                for k, j, i in np.ndindex(values.shape):
                    p = turn.TransformPoint(-3 + 0.75 * i, -2.8 + 0.8 * j, -2.5 + 0.85 * k)
                    expected = interpolator.Interpolate(*p, 0)
                    if np.all(np.array(p) > 0) and np.all(np.array(p) < (9, 11, 9)):
                        inside += 1
                        self.assertAlmostEqual(values[k, j, i], expected, 9)
                self.assertGreater(inside, 200)

    def test_reslice_in_pieces(self):
        volume = make_volume(make_array((40, 14, 15)), start=(0, 0, 1), spacing=(2, 2, 1))
        source = PieceSource(volume)
        for kernel, prefilter in (7, 1), (12, 1), (8, 2):
            for angle in 0, 30:
                turn = vtkTransform()
                turn.RotateWXYZ(angle, 1, 2, 3)
                reslice = self.make_reslice(source, volume, kernel, prefilter)
                reslice.SetResliceAxes(turn.GetMatrix())
                reslice.SetOutputExtent(0, 20, 0, 19, 0, 38)
                reslice.SetOutputSpacing(1, 1, 1)
                reslice.SetOutputOrigin(0, 0, 1)
                reslice.Update()
                whole = to_numpy(reslice.GetOutput()).copy()
                self.assertGreater(np.mean(whole != -9), 0.2)
                for piece in make_pieces((0, 20, 0, 19, 0, 38)):
                    modify(reslice)
                    reslice.UpdateExtent(piece)
                    x0, x1, y0, y1, z0, z1 = piece
                    np.testing.assert_array_equal(
                        to_numpy(reslice.GetOutput()),
                        whole[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1])
                asked = np.array(source.asked[-1])
                if angle == 0 and prefilter == 1:  # it was a part that was asked for
                    self.assertLess(np.prod(asked[1::2] - asked[::2] + 1), 40 * 14 * 15 / 2)

    def test_reslice_to_colors(self):
        source = PieceSource(make_volume(make_array(), spacing=(2, 2, 1)))
        table = vtkLookupTable()
        table.SetRange(-1, 1)
        table.SetSaturationRange(0, 0)
        table.SetValueRange(0, 1)
        table.SetRampToLinear()
        table.Build()
        colors = vtkImageResliceToColors()
        colors.SetInputConnection(source.GetOutputPort())
        colors.SetInterpolator(make_interpolator(None, 8, 2))
        colors.SetLookupTable(table)
        colors.SetOutputFormatToLuminance()
        colors.SetOutputExtent(0, 7, 0, 5, 0, 5)
        colors.SetOutputSpacing(1, 1, 1)
        colors.SetOutputOrigin(0, 0, 0)
        colors.Update()
        values = make_array()
        for k in range(6):  # at the lattice points the samples themselves
            odd = k & 1
            np.testing.assert_allclose(
                to_numpy(colors.GetOutput())[k, odd::2, odd::2], (values[k] + 1) / 2 * 255, atol=2)

    def test_reslice_follows_changes(self):
        source = vtkBCCVolumeSource()
        source.SetDimensions(6, 6, 12)
        source.SetFunctionToConstant()
        interpolator = make_interpolator(None)
        reslice = vtkImageReslice()
        reslice.SetInputConnection(source.GetOutputPort())
        reslice.SetInterpolator(interpolator)
        reslice.SetOutputExtent(0, 2, 0, 2, 0, 2)
        reslice.SetOutputSpacing(0.1, 0.1, 0.1)
        reslice.SetOutputOrigin(0, 0, 0)
        for value in 1, 3:
            source.SetValue(value)
            reslice.Update()
            np.testing.assert_allclose(to_numpy(reslice.GetOutput()), value, rtol=1e-5)
        source.SetFunctionToMarschnerLobb()
        reslice.Update()
        first = to_numpy(reslice.GetOutput()).copy()
        interpolator.SetKernelToBCC12()
        reslice.Update()
        self.assertGreater(np.abs(to_numpy(reslice.GetOutput()) - first).max(), 1e-4)

    def test_reslice_of_bad_input(self):
        reslice = vtkImageReslice()
        reslice.SetInputData(make_image(make_array()))
        interpolator = make_interpolator(None)
        reslice.SetInterpolator(interpolator)
        reslice.SetBackgroundLevel(-9)
        with Errors(interpolator) as errors:
            reslice.Update()
        self.assertEqual(len(errors.texts), 1, errors.texts)
        np.testing.assert_array_equal(to_numpy(reslice.GetOutput()), -9)

    def test_reslice_beyond_the_volume(self):
        volume = make_volume(make_array())
        reslice = self.make_reslice(PieceSource(volume), volume)
        reslice.SetOutputOrigin(40, 0, 0)
        reslice.SetOutputSpacing(1, 1, 1)
        reslice.SetOutputExtent(0, 3, 0, 3, 0, 3)
        reslice.Update()
        np.testing.assert_array_equal(to_numpy(reslice.GetOutput()), -9)

    def test_all_of_the_box_can_be_resliced(self):
        volume = make_volume(np.ones((6, 3, 4)), spacing=(2, 2, 1))
        reslice = self.make_reslice(PieceSource(volume), volume)
        reslice.BorderOff()  # which would be half a spacing of tolerance
        reslice.SetOutputOrigin(-1, -1, -1)
        reslice.SetOutputSpacing(1, 1, 1)
        reslice.SetOutputExtent(0, 9, 0, 7, 0, 7)
        reslice.Update()
        expected = np.full((8, 8, 10), -9.0)
        expected[1:-1, 1:-1, 1:-1] = 1
        np.testing.assert_allclose(to_numpy(reslice.GetOutput()), expected)


if __name__ == "__main__":
    unittest.main()
