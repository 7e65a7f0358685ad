# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import VTK_BIT, vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from bravais import (
    vtkBCCInterpolator, vtkBCCLattice, vtkBCCVolumeSource, vtkImageToBCCVolume)
from checks import Errors, make_image, refuses


def make_filter(image, mode=vtkImageToBCCVolume.Resample):
    to_bcc = vtkImageToBCCVolume()
    to_bcc.SetMode(mode)
    to_bcc.SetInputData(image)
    return to_bcc


def make_volume():
    return make_image(np.zeros((5, 6, 7)))


class TestImageToBCCVolumeBadInput(unittest.TestCase):
    def refuses_in_both_modes(self, image, *words):
        for mode in vtkImageToBCCVolume.Subset, vtkImageToBCCVolume.Resample:
            refuses(self, make_filter(image, mode), *words)

    def test_a_former_output_does_not_stay(self):
        to_bcc = make_filter(make_volume())
        to_bcc.Update()
        self.assertGreater(to_bcc.GetOutput().GetNumberOfPoints(), 0)
        to_bcc.SetSampleRatio(-1)
        refuses(self, to_bcc, "SampleRatio", "-1")

    def test_no_input(self):
        to_bcc = vtkImageToBCCVolume()
        with Errors(to_bcc) as errors:
            to_bcc.Update()
        self.assertEqual(to_bcc.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(errors.window.GetOutput().count("ERROR"), 1)
        self.assertIn("0 connections", errors.window.GetOutput())

    def test_wrong_kind_of_input(self):
        to_bcc = make_filter(vtkPolyData())
        with Errors(to_bcc) as errors:
            to_bcc.Update()
        self.assertEqual(to_bcc.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(errors.window.GetOutput().count("ERROR"), 1)
        self.assertIn("vtkPolyData", errors.window.GetOutput())

    def test_input_without_thickness_or_points(self):
        for shape in ((1, 6, 7), (5, 1, 7), (5, 6, 1)):
            self.refuses_in_both_modes(make_image(np.zeros(shape)), "two points along each axis")
        self.refuses_in_both_modes(vtkImageData(), "two points along each axis", "0 .. -1")

    def test_input_that_is_bcc_already(self):
        source = vtkBCCVolumeSource()
        source.Update()
        self.refuses_in_both_modes(source.GetOutput(), "BCC", "Cartesian")
        image = make_volume()
        vtkBCCLattice.Tag(image)
        self.refuses_in_both_modes(image, "BCC", "Cartesian")

    def test_input_without_scalars(self):
        image = vtkImageData()
        image.SetDimensions(4, 5, 6)
        self.refuses_in_both_modes(image, "no point scalars")
        image = make_volume()
        image.GetPointData().SetActiveScalars(None)
        self.refuses_in_both_modes(image, "no point scalars")

    def test_input_of_another_lattice_or_of_bits(self):
        image = make_volume()
        tag = vtkStringArray()
        tag.SetName("Lattice")
        tag.InsertNextValue("Rank1")
        image.GetFieldData().AddArray(tag)
        self.refuses_in_both_modes(image, "Rank1", "Cartesian")
        image = make_volume()
        image.AllocateScalars(VTK_BIT, 1)
        refuses(self, make_filter(image), "bit", "8 to 64")

    def test_short_arrays(self):
        image = make_volume()
        short = vtkDoubleArray()
        short.SetName("few")
        short.SetNumberOfValues(3)
        image.GetPointData().AddArray(short)
        refuses(self, make_filter(image, vtkImageToBCCVolume.Subset), "few", "3 tuples", "210 points")

    def test_bad_spacing_and_origin(self):
        for spacing in ((0, 1, 1), (1, -1, 1), (1, 1, math.nan), (math.inf, 1, 1)):
            image = make_volume()
            image.SetSpacing(spacing)
            self.refuses_in_both_modes(image, "spacing", "positive")
        image = make_volume()
        image.SetOrigin(0, math.nan, 0)
        self.refuses_in_both_modes(image, "origin", "nan")

    def test_bad_sample_ratio(self):
        for ratio in 0, -2, math.nan, math.inf, 1e300:
            to_bcc = make_filter(make_volume())
            to_bcc.SetSampleRatio(ratio)
            refuses(self, to_bcc, "SampleRatio")

    def test_bad_dimensions(self):
        for dimensions in ((0, 5, 5), (5, 5, 1), (-1, -1, -1), (0, 0, 1)):
            to_bcc = make_filter(make_volume())
            to_bcc.SetDimensions(dimensions)
            refuses(self, to_bcc, str(dimensions)[1:-1], "1, 1, 2")

    def test_absurd_dimensions(self):
        to_bcc = make_filter(make_volume())
        to_bcc.SetDimensions(2 ** 31 - 1, 2, 2)
        refuses(self, to_bcc, "2147483647")
        to_bcc.SetDimensions(2 ** 29, 2 ** 29, 2 ** 29)
        refuses(self, to_bcc, "536870912", "counted")
        to_bcc.SetDimensions(2 ** 17, 2 ** 17, 2 ** 17)
        refuses(self, to_bcc, "131072", "bytes")

    def test_no_interpolator(self):
        to_bcc = make_filter(make_volume())
        to_bcc.SetInterpolator(None)
        refuses(self, to_bcc, "Interpolator", "none")
        to_bcc.SetModeToSubset()  # which does not use it
        to_bcc.Update()
        self.assertGreater(to_bcc.GetOutput().GetNumberOfPoints(), 0)

    def test_interpolator_of_bcc_volumes(self):
        to_bcc = make_filter(make_volume())
        to_bcc.SetInterpolator(vtkBCCInterpolator())
        refuses(self, to_bcc, "vtkBCCInterpolator", "Cartesian")

    def test_print(self):
        text = str(vtkImageToBCCVolume())
        for name in "Mode", "Dimensions", "SampleRatio", "Interpolator", "LowPass":
            self.assertIn(name + ": ", text)


if __name__ == "__main__":
    unittest.main()
