# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""bravais.apply: what it sets, connects and returns, and how it reports errors."""
import os
import pathlib
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkSphere
from vtkmodules.vtkImagingCore import vtkImageReslice
from vtkmodules.vtkImagingMath import vtkImageMathematics

import bravais


class TestRank1Sample(unittest.TestCase):
    def test_shapes_and_files(self):
        values = numpy.random.default_rng(2).integers(0, 256, (16, 16), dtype=numpy.uint8)
        image = bravais.image_from_numpy(values)
        texture = bravais.apply(bravais.vtkRank1ImageResample, image, NumberOfPoints=64)
        texels, generator, _ = bravais.rank1_to_numpy(texture)
        uv = numpy.outer(numpy.arange(64), generator).reshape(8, 8, 2) / 64 % 1
        found = bravais.rank1_sample(texture, uv, Interpolation="Nearest")
        numpy.testing.assert_array_equal(found, texels.reshape(8, 8))
        path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], "sampled.tif")
        written = bravais.apply(bravais.vtkRank1TextureFileWriter, image, FileName=path,
                                NumberOfPoints=64, Tiles=(1, 1))
        self.assertIsNone(written)
        numpy.testing.assert_array_equal(bravais.rank1_sample(path, uv, Interpolation="Nearest"), found)
        numpy.testing.assert_array_equal(
            bravais.rank1_sample(pathlib.Path(path), uv, Interpolation="Nearest"), found)
        pyramid = bravais.apply(bravais.vtkRank1TexturePyramid, image)
        coarse = bravais.rank1_sample(pyramid, uv, (1, 0, 0, 1))
        self.assertLess(coarse.std(), 0.5 * found.std())
        colors = bravais.image_from_numpy(numpy.stack([values, values // 2], -1), components=True)
        texture = bravais.apply(bravais.vtkRank1ImageResample, colors, NumberOfPoints=64)
        self.assertEqual(bravais.rank1_sample(texture, uv[0, 0]).shape, (2,))

    def test_bad_input(self):
        with self.assertRaisesRegex(RuntimeError, "none.tif"):
            bravais.rank1_sample("none.tif", [0.5, 0.5])
        with self.assertRaisesRegex(RuntimeError, "rank-1|Lattice|Rank1"):
            bravais.rank1_sample(bravais.image_from_numpy(numpy.zeros((4, 4))), [0.5, 0.5])
        with self.assertRaisesRegex(RuntimeError, "omponents"):
            bravais.rank1_sample(bravais.rank1_from_numpy(numpy.zeros(5), (1, 2)), [0.5, 0.5, 0.5, 0.5])


class TestApply(unittest.TestCase):
    def test_settings(self):
        volume = bravais.apply(bravais.vtkBCCVolumeSource, Function="Gaussian", Dimensions=(4, 5, 6),
                               OutputScalarType=11, ImplicitFunction=None)
        source = bravais.vtkBCCVolumeSource()
        source.SetFunctionToGaussian()
        source.SetDimensions(4, 5, 6)
        source.SetOutputScalarTypeToDouble()
        source.Update()
        expected = bravais.bcc_to_numpy(source.GetOutput())
        self.assertEqual(bravais.bcc_to_numpy(volume).dtype, expected.dtype)
        numpy.testing.assert_array_equal(bravais.bcc_to_numpy(volume), expected)
        ball = bravais.apply(bravais.vtkBCCVolumeSource, ImplicitFunction=vtkSphere())
        self.assertLess(ball.GetScalarRange()[0], 0)

    def test_objects_and_other_filters(self):
        source = bravais.vtkBCCVolumeSource()
        source.SetDimensions(8, 8, 16)
        image = bravais.apply(bravais.vtkBCCVolumeToImage, source, OutputDimensions=(5, 6, 7))
        self.assertEqual(image.GetDimensions(), (5, 6, 7))
        reslice = vtkImageReslice()
        small = bravais.apply(reslice, image, OutputExtent=(0, 1, 0, 1, 0, 1))
        self.assertEqual(small.GetDimensions(), (2, 2, 2))
        self.assertEqual(reslice.GetOutputExtent(), (0, 1, 0, 1, 0, 1))

    def test_two_inputs(self):
        a, b = (bravais.image_from_numpy(numpy.full((2, 2), n)) for n in (5, 3))
        difference = bravais.apply(vtkImageMathematics, a, b, Operation="Subtract")
        self.assertEqual(difference.GetScalarRange(), (2, 2))

    def test_errors_are_exceptions(self):
        with self.assertRaisesRegex(ValueError, "vtkBCCVolumeSource has no SetSize"):
            bravais.apply(bravais.vtkBCCVolumeSource, Size=3)
        with self.assertRaisesRegex(RuntimeError, "Dimensions are 0, 1, 1"):
            bravais.apply(bravais.vtkBCCVolumeSource, Dimensions=(0, 1, 1))
        with self.assertRaisesRegex(RuntimeError, "[Ii]nput"):
            bravais.apply(bravais.vtkBCCVolumeToImage)
        source = bravais.vtkBCCVolumeSource()
        source.SetDimensions(0, 1, 1)
        with self.assertRaisesRegex(RuntimeError, "Dimensions are 0, 1, 1"):
            bravais.apply(bravais.vtkBCCVolumeToImage, source)
        with self.assertRaises(TypeError):
            bravais.apply(bravais.vtkBCCVolumeSource, Dimensions="many")
        with self.assertRaisesRegex(TypeError, "VTK object"):
            bravais.apply(bravais.vtkBCCVolumeToImage, numpy.zeros((4, 4, 4)))

    def test_is_left_as_it_was(self):
        """No observer stays, so that errors of later updates are heard again."""
        source = bravais.vtkBCCVolumeSource()
        bravais.apply(source)
        self.assertFalse(source.HasObserver("ErrorEvent"))
        self.assertFalse(source.GetExecutive().HasObserver("ErrorEvent"))


if __name__ == "__main__":
    unittest.main()
