# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_UNSIGNED_CHAR, vtkBitArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from bravais import vtkBCCLattice, vtkBCCPrefilter, vtkBCCVolumeToImage
from checks import Errors, make_image, make_volume, refuses, to_numpy


def make_filters(volume):
    """The two filters that take a volume, with it as their input."""
    to_image = vtkBCCVolumeToImage()
    to_image.SetOutputDimensions(5, 6, 7)
    prefilter = vtkBCCPrefilter()
    for algorithm in to_image, prefilter:
        algorithm.SetInputData(volume)
    return to_image, prefilter


def make_array(shape=(6, 3, 4)):
    return np.random.default_rng(3).uniform(-1, 1, shape)


class TestBCCVolumeToImageBadInput(unittest.TestCase):
    """What vtkBCCVolumeToImage and vtkBCCPrefilter do with bad input."""

    def check_refused(self, volume, *words):
        for algorithm in make_filters(volume):
            refuses(self, algorithm, *words)
            # and it works on as soon as it is given a good one
            algorithm.SetInputData(make_volume(make_array()))
            algorithm.Update()
            self.assertGreater(algorithm.GetOutput().GetNumberOfPoints(), 0)
            # which leaves nothing behind when the bad one comes again
            algorithm.SetInputData(volume)
            refuses(self, algorithm, *words)

    def test_no_input(self):
        for algorithm in vtkBCCVolumeToImage(), vtkBCCPrefilter():
            with Errors(algorithm.GetExecutive()) as errors:
                algorithm.Update()
            self.assertEqual(len(errors.texts), 1)
            self.assertIn("0 connections", errors.texts[0])
            self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)

    def test_untagged(self):
        self.check_refused(make_image(make_array()), "tagged", "BCC")

    def test_tagged_otherwise(self):
        volume = make_volume(make_array())
        volume.GetFieldData().GetAbstractArray("Lattice").SetValue(0, "Rank1")
        self.check_refused(volume, "tagged", "BCC")

    def test_zero_size(self):
        volume = vtkImageData()
        vtkBCCLattice.Tag(volume)
        self.check_refused(volume, "0 x 0 x 0")
        self.check_refused(vtkImageData(), "0 x 0 x 0")

    def test_single_layer(self):
        self.check_refused(make_volume(make_array((1, 3, 4))), "4 x 3 x 1", "1 x 1 x 2")

    def test_two_dimensions(self):
        self.check_refused(make_image(make_array((1, 3, 4))), "tagged")

    def test_missing_scalars(self):
        volume = vtkImageData()
        volume.SetDimensions(4, 3, 6)
        vtkBCCLattice.Tag(volume)
        self.check_refused(volume, "no point scalars")

    def test_too_few_scalars(self):
        volume = make_volume(make_array())
        volume.GetPointData().GetScalars().SetNumberOfTuples(71)
        self.check_refused(volume, "fewer than points")

    def test_bits(self):
        volume = make_volume(make_array())
        bits = vtkBitArray()
        bits.SetNumberOfTuples(72)
        volume.GetPointData().SetScalars(bits)
        self.check_refused(volume, "bit", "8 to 64")

    def test_bad_spacing(self):
        for spacing in ((math.nan, 1, 1), (1, math.inf, 1), (1, 1, 0), (-1, 1, 1), (1, 1, math.nan),
                        (1, -math.inf, 1)):
            volume = make_volume(make_array())
            volume.SetSpacing(spacing)
            self.check_refused(volume, "spacing", "positive and finite")
            to_image = make_filters(volume)[0]
            to_image.SetOutputDimensions(0, 0, 0)
            refuses(self, to_image, "spacing", "positive and finite")

    def test_bad_origin(self):
        for origin in (math.nan, 0, 0), (0, math.inf, 0), (0, 0, -math.inf):
            volume = make_volume(make_array())
            volume.SetOrigin(origin)
            self.check_refused(volume, "origin", "finite")

    def test_bad_kernel(self):
        for kernel in -1, 0, 5, 13, 2 ** 31 - 1:
            for algorithm in make_filters(make_volume(make_array())):
                algorithm.SetKernel(kernel)
                self.assertEqual(algorithm.GetKernelAsString(), "Unknown")
                refuses(self, algorithm, "Kernel is " + str(kernel), "4, 7, 8 or 12")

    def test_bad_prefilter(self):
        for number in -1, 4, 2 ** 31 - 1:
            to_image, prefilter = make_filters(make_volume(make_array()))
            to_image.SetPrefilter(number)
            self.assertEqual(to_image.GetPrefilterAsString(), "Unknown")
            refuses(self, to_image, f"is {number};", "0 (None)", "3 (Projection)")
            prefilter.SetMethod(number)
            self.assertEqual(prefilter.GetMethodAsString(), "Unknown")
            refuses(self, prefilter, f"is {number};", "0 (None)", "3 (Projection)")

    def test_interpolation_without_solution(self):
        for kernel, name in (7, "BCC7"), (12, "BCC12"):
            to_image, prefilter = make_filters(make_volume(make_array()))
            to_image.SetPrefilterToInterpolation()
            prefilter.SetMethodToInterpolation()
            for algorithm in to_image, prefilter:
                algorithm.SetKernel(kernel)
                refuses(self, algorithm, name, "linearly dependent", "BCC4 and BCC8")

    def test_bad_output_dimensions(self):
        for dimensions in (-1, 5, 5), (5, -7, 5), (5, 5, -2 ** 31):
            to_image = make_filters(make_volume(make_array()))[0]
            to_image.SetOutputDimensions(dimensions)
            refuses(self, to_image, "OutputDimensions", str(dimensions)[1:-1])

    def test_absurd_output_dimensions(self):
        for dimensions in ((2 ** 30,) * 3, (2 ** 31 - 1, 1, 1), (2 ** 29,) * 3, (2 ** 17,) * 3):
            to_image = make_filters(make_volume(make_array()))[0]
            to_image.SetOutputDimensions(dimensions)
            refuses(self, to_image, str(dimensions[0]))

    def test_absurd_default_dimensions(self):
        volume = make_volume(make_array(), spacing=(1e12, 1, 1))
        to_image = make_filters(volume)[0]
        to_image.SetOutputDimensions(0, 5, 5)
        refuses(self, to_image, "0, 5, 5", "3.5e+12")

    def test_a_piece_of_absurd_dimensions(self):
        array = make_array()
        to_image = make_filters(make_volume(array))[0]
        to_image.SetOutputDimensions(2 ** 19 + 1, 2 ** 19 + 1, 2 ** 19 + 1)
        to_image.SetKernelToBCC4()
        to_image.SetPrefilterToNone()
        n = 2 ** 19
        to_image.UpdateExtent((0, 0, 0, 0, 0, 0))
        self.assertAlmostEqual(to_numpy(to_image.GetOutput()).item(), array[0, 0, 0], 12)
        to_image.UpdateExtent((n, n, n, n, n, n))
        self.assertAlmostEqual(to_numpy(to_image.GetOutput()).item(), array[-1, -1, -1], 12)

    def test_bad_output_type(self):
        for number in -7, 0, 1, 13, 14, 20, 99:
            to_image = make_filters(make_volume(make_array()))[0]
            to_image.SetOutputScalarType(number)
            refuses(self, to_image, "OutputScalarType", str(number))

    def test_return_code(self):
        for algorithm in make_filters(make_image(make_array())):
            executive = algorithm.GetExecutive()
            with Errors(algorithm):
                self.assertEqual(executive.Update(), 0)
            algorithm.SetKernel(1)
            with Errors(algorithm):
                self.assertEqual(executive.UpdateInformation(), 0)

    def test_input_smaller_than_the_extent_it_announces(self):
        volume = make_volume(make_array())
        for algorithm in make_filters(volume):
            producer = vtkTrivialProducer()
            producer.SetOutput(volume)
            producer.SetWholeExtent(0, 3, 0, 2, 0, 9)
            algorithm.SetInputConnection(producer.GetOutputPort())
            with Errors(algorithm) as errors:
                algorithm.Update()
            self.assertLessEqual(len(errors.texts), 1)
            self.assertEqual(algorithm.GetOutput().GetPointData().GetNumberOfArrays(), 0)

    def test_nan_stays_local(self):
        for kernel in 4, 7, 8, 12:
            array = make_array((24, 12, 12))
            clean = make_filters(make_volume(array))
            array = array.copy()
            array[11, 6, 6] = math.nan  # X, Y, Z = 13, 13, 11
            spoilt = make_filters(make_volume(array))
            for algorithm in clean + spoilt:
                algorithm.SetKernel(kernel)
            for algorithm in clean[0], spoilt[0]:
                algorithm.SetOutputDimensions(24, 24, 24)
                algorithm.ComputeGradientsOn()
            results = []
            for algorithm in clean + spoilt:
                algorithm.Update()
                results.append(to_numpy(algorithm.GetOutput()))
            for before, after, reach in ((results[0], results[2], 6),
                                         (results[1], results[3], 1)):
                different = ~((before == after) & np.isfinite(after))
                where = np.argwhere(different)
                self.assertTrue(np.isnan(after[different]).all())
                center = (11, 13, 13) if reach == 6 else (11, 6, 6)
                self.assertGreater(len(where), 0)
                self.assertLessEqual(np.abs(where - center).max(), reach)

    def test_nan_in_integers_is_zero(self):
        array = make_array()
        array[3, 1, 2] = math.nan
        to_image = make_filters(make_volume(array))[0]
        to_image.SetOutputScalarType(VTK_UNSIGNED_CHAR)
        to_image.Update()
        self.assertEqual(to_numpy(to_image.GetOutput())[3, 3, 3], 0)

    def test_nan_spoils_one_component_of_the_spectral_methods(self):
        array = make_array((6, 3, 4, 2))
        array[3, 1, 2, 1] = math.nan
        for algorithm in make_filters(make_volume(array)):
            algorithm.SetKernel(8)
            for method in 2, 3:
                if isinstance(algorithm, vtkBCCPrefilter):
                    algorithm.SetMethod(method)
                else:
                    algorithm.SetPrefilter(method)
                algorithm.Update()
                values = to_numpy(algorithm.GetOutput())
                self.assertTrue(np.isfinite(values[..., 0]).all())
                self.assertTrue(np.isnan(values[..., 1]).all())

    def test_infinities(self):
        array = make_array((24, 12, 12))
        array[11, 6, 6] = math.inf
        array[0, 0, 0] = -math.inf
        for kernel in 4, 7, 8, 12:
            for algorithm in make_filters(make_volume(array)):
                algorithm.SetKernel(kernel)
                algorithm.Update()
                values = to_numpy(algorithm.GetOutput())
                self.assertFalse(np.isfinite(values).all())
                self.assertTrue(np.isfinite(values).any())

    def test_huge_values(self):
        for dtype, huge in (np.float32, 1e30), (np.float32, 1e35), (np.float64, 1e300):
            array = make_array((8, 5, 6))
            for kernel in 4, 7, 8, 12:
                small = make_filters(make_volume(array.astype(dtype)))
                large = make_filters(make_volume((huge * array).astype(dtype)))
                for one, other in zip(small, large):
                    one.SetKernel(kernel)
                    other.SetKernel(kernel)
                    one.Update()
                    other.Update()
                    np.testing.assert_allclose(
                        to_numpy(other.GetOutput()) / huge, to_numpy(one.GetOutput()),
                        rtol=0, atol=1e-5, err_msg=f"{huge} {kernel}")

    def test_far_origin(self):
        volume = make_volume(make_array(), origin=(1e15, -1e15, 1e300))
        for algorithm in make_filters(volume):
            algorithm.Update()
            self.assertTrue(np.isfinite(to_numpy(algorithm.GetOutput())).all())

    def test_tiny_and_huge_spacing(self):
        for spacing in (1e-300, 1e300, 1), (1e-30, 2e-30, 1e-30):
            to_image = make_filters(make_volume(make_array(), spacing=spacing))[0]
            to_image.SetOutputScalarType(VTK_DOUBLE)
            to_image.Update()
            self.assertEqual(to_image.GetOutput().GetDimensions(), (5, 6, 7))
            self.assertTrue(np.isfinite(to_numpy(to_image.GetOutput())).all())


if __name__ == "__main__":
    unittest.main()
