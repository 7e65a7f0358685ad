# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays become lattice images and come back: shapes, types, memory, and what is refused."""
import gc
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import bravais

TYPES = "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64".split()


def count_up(shape, dtype="float32"):
    return (numpy.arange(numpy.prod(shape)) % 100).astype(dtype).reshape(shape)


class TestRoundTrip(unittest.TestCase):
    def test_types_are_kept(self):
        for dtype in TYPES:
            values = count_up((4, 3, 2), dtype)
            with self.subTest(dtype):
                back = bravais.bcc_to_numpy(bravais.bcc_from_numpy(values))
                self.assertEqual(back.dtype, values.dtype)
                numpy.testing.assert_array_equal(back, values)

    def test_cartesian(self):
        for shape, components, dimensions in (
            ((4, 3, 2), False, (2, 3, 4)),
            ((4, 3), False, (3, 4, 1)),
            ((4, 3, 2), True, (3, 4, 1)),
            ((5, 4, 3, 2), True, (3, 4, 5)),
        ):
            image = bravais.image_from_numpy(count_up(shape), components=components)
            self.assertEqual(image.GetDimensions(), dimensions)
            back = bravais.image_to_numpy(image)
            numpy.testing.assert_array_equal(back.squeeze(), count_up(shape))

    def test_bcc(self):
        values = count_up((6, 5, 4, 3))
        image = bravais.bcc_from_numpy(values, spacing=(2, 2, 1), origin=(1, 2, 3))
        self.assertTrue(bravais.vtkBCCLattice.IsBCC(image))
        self.assertEqual(image.GetDimensions(), (4, 5, 6))
        self.assertEqual(image.GetScalarComponentAsFloat(1, 2, 3, 1), values[3, 2, 1, 1])
        numpy.testing.assert_array_equal(bravais.bcc_to_numpy(image), values)

    def test_named_array(self):
        volume = bravais.apply(bravais.vtkBCCVolumeSource, Dimensions=(4, 4, 8))
        image = bravais.apply(bravais.vtkBCCVolumeToImage, volume, ComputeGradients=True)
        gradients = bravais.image_to_numpy(image, "Gradients")
        self.assertEqual(gradients.shape, bravais.image_to_numpy(image).shape + (3,))
        with self.assertRaisesRegex(ValueError, "no point array Nothing"):
            bravais.image_to_numpy(image, "Nothing")

    def test_rank1(self):
        for shape in ((13,), (13, 3), (2, 4, 13), (2, 4, 13, 3)):
            values = count_up(shape)
            image = bravais.rank1_from_numpy(values, (1, 5), domain=(0, 4, 1, 2))
            back, generator, domain = bravais.rank1_to_numpy(image)
            self.assertEqual(generator, (1, 5))
            self.assertEqual(domain, (0.0, 4.0, 1.0, 2.0))
            numpy.testing.assert_array_equal(back.squeeze(), values)
        self.assertEqual(image.GetDimensions(), (13, 4, 2))

    def test_geometry(self):
        points = count_up((4, 5, 3), "float64")
        points[1, 2, 0] = numpy.nan
        defined = numpy.ones((4, 5), dtype=bool)
        defined[3, 3] = False
        image = bravais.geometry_from_numpy(points, defined)
        self.assertEqual(image.GetDimensions(), (5, 4, 1))
        self.assertEqual(image.GetPointData().GetVectors().GetName(), "Points")
        back, used = bravais.geometry_to_numpy(image)
        numpy.testing.assert_array_equal(back, points)
        defined[1, 2] = False
        numpy.testing.assert_array_equal(used, defined)

    def test_bcc_points(self):
        image = bravais.bcc_from_numpy(count_up((4, 3, 2)), (2, 3, 4), (5, 6, 7))
        image.SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1)
        points = bravais.bcc_points(image)
        expected = [0.0, 0.0, 0.0]
        for index in numpy.ndindex(4, 3, 2):
            bravais.vtkBCCLattice.GetPoint(image, index[::-1], expected)
            numpy.testing.assert_allclose(points[index], expected)

    def test_bayer(self):
        ranks = bravais.bayer_thresholds(2, 2)
        self.assertEqual(ranks.ravel().tolist(), [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5])
        self.assertEqual(bravais.bayer_thresholds(3, 1, base_order="BCC")[1, 1, 1], 1)


class TestMemory(unittest.TestCase):
    def test_is_shared_both_ways(self):
        values = count_up((4, 3, 2))
        image = bravais.bcc_from_numpy(values)
        values[3, 2, 1] = -7
        self.assertEqual(image.GetScalarComponentAsFloat(1, 2, 3, 0), -7)
        bravais.bcc_to_numpy(image)[0, 0, 0] = 9
        self.assertEqual(values[0, 0, 0], 9)

    def test_is_kept_alive(self):
        size = (40, 100, 100)
        image = bravais.bcc_from_numpy(numpy.full(size, 3.0))
        gc.collect()
        rubbish = [numpy.full(size, 5.0) for _ in range(4)]
        self.assertTrue((bravais.bcc_to_numpy(image) == 3.0).all())
        values = bravais.bcc_to_numpy(image)
        del image, rubbish
        gc.collect()
        rubbish = [numpy.full(size, 6.0) for _ in range(4)]
        self.assertTrue((values == 3.0).all())
        self.assertEqual(len(rubbish), 4)

    def test_other_layouts_are_copied(self):
        values = count_up((4, 3, 2))
        for other in (
            values.transpose(2, 1, 0),
            values[::-1],
            values[:, ::2],
            values.astype(">f4"),
            numpy.asfortranarray(values),
        ):
            numpy.testing.assert_array_equal(bravais.bcc_to_numpy(bravais.bcc_from_numpy(other)), other)
        values.flags.writeable = False
        numpy.testing.assert_array_equal(bravais.bcc_to_numpy(bravais.bcc_from_numpy(values)), values)

    def test_bool_is_uint8(self):
        values = bravais.bcc_to_numpy(bravais.bcc_from_numpy(count_up((4, 3, 2)) > 5))
        self.assertEqual(values.dtype, numpy.uint8)
        self.assertEqual(int(values.sum()), 18)


class TestBadInput(unittest.TestCase):
    def refuse(self, error, text, function, *arguments, **options):
        with self.assertRaisesRegex(error, text):
            function(*arguments, **options)

    def test_types(self):
        for dtype in ("float16", "complex64", "object", "U3", "datetime64[s]"):
            with self.subTest(dtype):
                self.refuse(TypeError, "no arrays", bravais.bcc_from_numpy, numpy.zeros((4, 3, 2), dtype))
        self.refuse(TypeError, "no floats", bravais.geometry_from_numpy, count_up((4, 3, 3), "int32"))

    def test_shapes(self):
        refuse = self.refuse
        refuse(ValueError, "no BCC volume", bravais.bcc_from_numpy, count_up((4, 3)))
        refuse(ValueError, "no points", bravais.bcc_from_numpy, numpy.zeros((4, 0, 2)))
        refuse(ValueError, "no image", bravais.image_from_numpy, count_up((3,)))
        refuse(ValueError, "no image", bravais.image_from_numpy, count_up((4, 3)), components=True)
        refuse(ValueError, "no rank-1", bravais.rank1_from_numpy, count_up((1, 1, 1, 1, 5)), (1, 2))
        refuse(ValueError, "no rank-1", bravais.rank1_from_numpy, numpy.float32(3), (1, 2))
        refuse(ValueError, "generate", bravais.rank1_from_numpy, count_up((8,)), (2, 4))
        for domain in (0, 1, 0), (0, 1, 0, numpy.nan), (1, 0, 0, 1), (0, 1, 2, 2):
            refuse(ValueError, "domain", bravais.rank1_from_numpy, count_up((8,)), (1, 3), domain)
        refuse(ValueError, "no geometry", bravais.geometry_from_numpy, count_up((4, 3, 2)))
        refuse(ValueError, "defined", bravais.geometry_from_numpy, count_up((4, 3, 3)), numpy.ones((3, 4)))
        refuse(ValueError, "base_order", bravais.bayer_thresholds, 3, 1, base_order="SC")
        refuse(ValueError, "no pattern", bravais.bayer_thresholds, 4, 1)

    def test_images(self):
        image = bravais.image_from_numpy(count_up((4, 3, 2)))
        for function in (bravais.bcc_to_numpy, bravais.bcc_points, bravais.rank1_to_numpy):
            self.refuse(ValueError, "not tagged", function, image)
            self.refuse(TypeError, "no vtkImageData", function, None)
        self.refuse(ValueError, "no point scalars", bravais.image_to_numpy, vtkImageData())
        with self.assertRaises(AttributeError):
            bravais.not_there


class TestPackage(unittest.TestCase):
    def test_names(self):
        for name in bravais.arrays.__all__:
            self.assertIn(name, dir(bravais))
            self.assertTrue(getattr(bravais, name).__doc__)
        self.assertIn("body-centred", bravais.vtkBCCVolumeMapper.__doc__)


if __name__ == "__main__":
    unittest.main()
