# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules import vtkCommonCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageDataStreamer

import reference
from bravais import vtkBCCLattice, vtkBCCPrefilter, vtkBCCVolumeSource, vtkBCCVolumeToImage
from checks import (
    PieceSource, check_pieces, check_progress, check_threads, make_volume, modify, refuses,
    to_numpy)

METHODS = [(4, 1), (7, 0), (7, 1), (8, 1), (12, 1), (4, 2), (8, 2), (7, 3), (12, 3)]


def make_filter(source, kernel=7, method=1):
    prefilter = vtkBCCPrefilter()
    prefilter.SetInputConnection(source.GetOutputPort())
    prefilter.SetKernel(kernel)
    prefilter.SetMethod(method)
    return prefilter


def run(volume, kernel=7, method=1):
    prefilter = make_filter(PieceSource(volume), kernel, method)
    prefilter.Update()
    return prefilter.GetOutput()


class TestBCCPrefilter(unittest.TestCase):
    def setUp(self):
        self.array = np.random.default_rng(7).uniform(-1, 1, (6, 3, 4))

    def test_none_copies(self):
        for kernel in reference.KERNELS:
            np.testing.assert_array_equal(
                to_numpy(run(make_volume(self.array), kernel, 0)), self.array)

    def test_quasi_interpolation(self):
        for start in (0, 0, 0), (2, -3, 1), (-1, 4, -3):
            volume = make_volume(self.array, start=start)
            for kernel in reference.KERNELS:
                np.testing.assert_allclose(
                    to_numpy(run(volume, kernel, 1)),
                    reference.quasi_interpolate(kernel, self.array, start), atol=1e-14)

    def test_interpolation(self):
        for start in (0, 0, 0), (2, -3, 1):
            volume = make_volume(self.array, start=start)
            for kernel in 4, 8:
                np.testing.assert_allclose(
                    to_numpy(run(volume, kernel, 2)),
                    reference.interpolate(kernel, self.array, start), atol=1e-9)

    def test_constants_stay(self):
        for kernel, method in METHODS:
            values = to_numpy(run(make_volume(np.full((6, 3, 4), 42.0)), kernel, method))
            np.testing.assert_allclose(values, 42.0, rtol=1e-12)

    def test_every_type_of_samples(self):
        array = np.round(100 * np.abs(self.array))
        for name, output in (
                ("CHAR", VTK_FLOAT), ("SIGNED_CHAR", VTK_FLOAT), ("UNSIGNED_CHAR", VTK_FLOAT),
                ("SHORT", VTK_FLOAT), ("UNSIGNED_SHORT", VTK_FLOAT), ("INT", VTK_FLOAT),
                ("UNSIGNED_INT", VTK_FLOAT), ("LONG", VTK_DOUBLE), ("UNSIGNED_LONG", VTK_DOUBLE),
                ("LONG_LONG", VTK_DOUBLE), ("UNSIGNED_LONG_LONG", VTK_DOUBLE),
                ("FLOAT", VTK_FLOAT), ("DOUBLE", VTK_DOUBLE)):
            volume = make_volume(array, getattr(vtkCommonCore, "VTK_" + name), name="height")
            for kernel, method in METHODS:
                image = run(volume, kernel, method)
                self.assertEqual(image.GetScalarType(), output, name)
                self.assertEqual(image.GetPointData().GetScalars().GetName(), "height")
                self.assertEqual(image.GetPointData().GetNumberOfArrays(), 1)
                expected = to_numpy(run(make_volume(array), kernel, method))
                np.testing.assert_allclose(
                    to_numpy(image), expected, rtol=0, atol=1e-5 * np.abs(expected).max(),
                    err_msg=name)

    def test_components_are_independent(self):
        for dtype in np.float64, np.float32, np.uint8:
            for count in 1, 2, 3, 4, 7:
                array = (100 * np.random.default_rng(3).uniform(0, 1, (6, 3, 4, count)))
                array = array.astype(dtype)
                for kernel, method in METHODS:
                    values = to_numpy(run(make_volume(array), kernel, method))
                    values = values.reshape((6, 3, 4, count))
                    for c in range(count):
                        one = to_numpy(run(make_volume(array[..., c]), kernel, method))
                        np.testing.assert_array_equal(values[..., c], one)

    def test_geometry_and_tag_are_kept(self):
        volume = make_volume(
            self.array, spacing=(2, 3, 0.5), origin=(4, 5, 6), start=(1, 2, 3))
        volume.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        for method in 0, 1, 3:
            image = run(volume, 7, method)
            self.assertTrue(vtkBCCLattice.IsBCC(image))
            self.assertEqual(image.GetExtent(), volume.GetExtent())
            self.assertEqual(image.GetSpacing(), volume.GetSpacing())
            self.assertEqual(image.GetOrigin(), volume.GetOrigin())
            self.assertEqual(image.GetDirectionMatrix().GetElement(0, 1), -1)

    def test_cubics_are_reproduced(self):
        shape = 28, 14, 14
        points = reference.lattice_points(shape) / 10 - 1.3

        def cubic(p):
            x, y, z = np.moveaxis(p, -1, 0)
            return 1 + x - 2 * y + x * y * z - 3 * z ** 3 + x * x * y + 0.5 * y ** 3 - x ** 3
        volume = make_volume(cubic(points))
        for kernel in 7, 8, 12:
            to_image = vtkBCCVolumeToImage()
            prefilter = make_filter(PieceSource(volume), kernel)
            to_image.SetInputConnection(prefilter.GetOutputPort())
            to_image.SetOutputDimensions(31, 33, 35)
            to_image.SetKernel(kernel)
            to_image.SetPrefilterToNone()
            to_image.Update()
            k, j, i = np.meshgrid(*(np.arange(n) for n in (35, 33, 31)), indexing="ij")
            grid = np.stack((i * 27 / 30, j * 27 / 32, k * 27 / 34), -1)
            inside = np.all((grid > 6) & (grid < 21), axis=-1)
            np.testing.assert_allclose(
                to_numpy(to_image.GetOutput())[inside], cubic(grid / 10 - 1.3)[inside], atol=1e-12)

    def test_errors_on_marschner_lobb(self):
        source = vtkBCCVolumeSource()
        source.SetOutputScalarTypeToDouble()
        exact = None
        for kernel, method, limit in ((7, 1, 0.0094), (7, 3, 0.0013), (12, 3, 0.0005)):
            to_image = vtkBCCVolumeToImage()
            prefilter = make_filter(source, kernel, method)
            to_image.SetInputConnection(prefilter.GetOutputPort())
            to_image.SetKernel(kernel)
            to_image.SetPrefilterToNone()
            to_image.SetOutputDimensions(61, 61, 61)
            to_image.Update()
            x = np.linspace(-1, 1, 61)
            if exact is None:
                z, y, x = np.meshgrid(x, x, x, indexing="ij")
                rho = np.cos(12 * np.pi * np.cos(np.pi / 2 * np.hypot(x, y)))
                exact = (1 - np.sin(np.pi * z / 2) + 0.25 * (1 + rho)) / 2.5
                inside = np.maximum(np.maximum(abs(x), abs(y)), abs(z)) <= 0.6
            error = (to_numpy(to_image.GetOutput()) - exact)[inside]
            self.assertLess(np.sqrt(np.mean(error ** 2)), limit, (kernel, method))

    def test_pieces_are_parts_of_the_whole(self):
        array = np.random.default_rng(3).uniform(-1, 1, (11, 8, 9))
        for start in (0, 0, 0), (-2, 5, 3):
            for dtype in np.float64, np.float32:
                source = PieceSource(make_volume(array.astype(dtype), start=start))
                for kernel, method in METHODS:
                    check_pieces(self, make_filter(source, kernel, method))
        check_pieces(self, make_filter(
            PieceSource(make_volume(np.stack((array, 2 * array, -array), -1))), 7, 1))

    def test_methods_of_the_whole_ask_for_the_whole(self):
        source = PieceSource(make_volume(self.array, start=(0, 0, 1)))
        prefilter = make_filter(source, 8, 2)
        prefilter.UpdateExtent((1, 2, 1, 1, 3, 4))
        self.assertEqual(prefilter.GetOutput().GetExtent(), (1, 2, 1, 1, 3, 4))
        self.assertEqual(source.asked, [[0, 3, 0, 2, 1, 6]])

    def test_the_whole_is_computed_once_for_all_pieces(self):
        for kernel, method in (8, 2), (7, 3):
            values = self.array.copy()
            volume = make_volume(values)
            expected = to_numpy(run(volume, kernel, method)).copy()
            prefilter = vtkBCCPrefilter()
            prefilter.SetInputData(volume)
            prefilter.SetKernel(kernel)
            prefilter.SetMethod(method)
            samples = vtk_to_numpy(volume.GetPointData().GetScalars())

            def layer(k):
                prefilter.UpdateExtent((0, 3, 0, 2, k, k))
                return to_numpy(prefilter.GetOutput())[0]
            for k in 0, 3, 1:
                np.testing.assert_array_equal(layer(k), expected[k])
                samples *= 2  # which nobody is told of
            prefilter.SetReleaseDataFlag(True)  # keeps nothing
            np.testing.assert_array_equal(layer(2), expected[2])
            np.testing.assert_allclose(layer(0), 8 * expected[0], rtol=1e-12)
            prefilter.SetReleaseDataFlag(False)
            np.testing.assert_allclose(layer(1), 8 * expected[1], rtol=1e-12)
            samples *= 2
            np.testing.assert_allclose(layer(5), 8 * expected[5], rtol=1e-12)  # the last one
            np.testing.assert_allclose(layer(0), 16 * expected[0], rtol=1e-12)
            samples *= 2
            volume.GetPointData().GetScalars().Modified()
            np.testing.assert_allclose(layer(2), 32 * expected[2], rtol=1e-12)
            prefilter.SetMethodToNone()
            np.testing.assert_array_equal(layer(0), 32 * self.array[0])
            prefilter.SetMethod(method)
            np.testing.assert_allclose(layer(2), 32 * expected[2], rtol=1e-12)

    def test_streamed_slabs_are_parts_of_the_whole(self):
        array = np.random.default_rng(3).uniform(-1, 1, (11, 8, 9))
        prefilter = make_filter(PieceSource(make_volume(array)), 7, 3)
        expected = to_numpy(run(make_volume(array), 7, 3)).copy()
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(prefilter.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(5)
        streamer.Update()
        np.testing.assert_array_equal(to_numpy(streamer.GetOutput()), expected)
        self.assertRegex(str(prefilter), "Kept Coefficients: (0|0x0|.nil.)\n")

    def test_no_more_is_asked_for_than_needed(self):
        source = PieceSource(make_volume(self.array, start=(0, 0, 1)))
        prefilter = make_filter(source)
        prefilter.UpdateExtent((1, 2, 1, 1, 3, 4))
        prefilter.SetMethodToNone()
        modify(prefilter)
        prefilter.UpdateExtent((1, 2, 1, 1, 5, 5))
        self.assertEqual(source.asked, [[0, 3, 0, 2, 2, 5], [1, 2, 1, 1, 5, 5]])

    def test_samples_near_the_limits_of_their_type(self):
        for dtype in np.float32, np.float64:
            limit = float(np.finfo(dtype).max)
            array = self.array.astype(dtype)
            large = np.ldexp(array, np.finfo(dtype).maxexp - 13)
            for kernel, method in METHODS:
                np.testing.assert_array_equal(
                    to_numpy(run(make_volume(large), kernel, method)),
                    np.ldexp(to_numpy(run(make_volume(array), kernel, method)),
                             np.finfo(dtype).maxexp - 13))
            large = np.full((6, 3, 4), 0.9 * limit, dtype)
            large[::2] *= -1
            np.testing.assert_array_equal(to_numpy(run(make_volume(large), 7, 0)), large)
            for kernel, method in (7, 1), (8, 1), (12, 1), (8, 2), (7, 3), (8, 3), (12, 3):
                prefilter = make_filter(PieceSource(make_volume(large)), kernel, method)
                refuses(self, prefilter, "samples reach %g" % (0.9 * limit),
                        "float" if dtype == np.float32 else "double")
                # What is not finite by itself is no error.
                strange = large.copy()
                strange[1, 1, 1] = np.nan
                self.assertTrue(np.isnan(
                    to_numpy(run(make_volume(strange), kernel, method))[1, 1, 1]))

    def test_threads_and_progress(self):
        array = np.random.default_rng(3).uniform(-1, 1, (40, 8, 9, 2)).astype(np.float32)
        for kernel, method in METHODS:
            prefilter = make_filter(PieceSource(make_volume(array)), kernel, method)
            check_threads(self, prefilter)
            check_progress(self, prefilter)

    def test_information_tells_the_type(self):
        prefilter = make_filter(PieceSource(make_volume(self.array.astype(np.int16))))
        prefilter.UpdateInformation()
        information = prefilter.GetOutputInformation(0)
        self.assertEqual(vtkImageData.GetScalarType(information), VTK_FLOAT)
        self.assertEqual(vtkImageData.GetNumberOfScalarComponents(information), 1)

    def test_names_of_the_enumerations(self):
        prefilter = vtkBCCPrefilter()
        self.assertEqual(prefilter.GetKernelAsString(), "BCC7")
        self.assertEqual(prefilter.GetMethodAsString(), "QuasiInterpolation")
        for name in "BCC4", "BCC7", "BCC8", "BCC12":
            getattr(prefilter, "SetKernelTo" + name)()
            self.assertEqual(prefilter.GetKernel(), getattr(vtkBCCLattice, name))
            self.assertEqual(prefilter.GetKernelAsString(), name)
        for name in "None", "QuasiInterpolation", "Interpolation", "Projection":
            getattr(prefilter, "SetMethodTo" + name)()
            self.assertEqual(prefilter.GetMethodAsString(), name)
        self.assertIn("Method: Projection", str(prefilter))
        self.assertIn("Kernel: BCC12", str(prefilter))


if __name__ == "__main__":
    unittest.main()
