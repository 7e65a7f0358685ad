# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkQuadric, vtkSphere
from vtkmodules.vtkImagingCore import vtkImageDataStreamer

from bravais import vtkBCCLattice, vtkBCCVolumeSource
from checks import (
    check_pieces, check_progress, check_threads, get_points, refuses, to_numpy)


def make_source():
    source = vtkBCCVolumeSource()
    source.SetDimensions(7, 9, 12)
    source.SetBounds(-1, 2, 0.5, 3, -4, -1)
    source.SetOutputScalarTypeToDouble()
    return source


def marschner_lobb(points, alpha, frequency):
    x, y, z = np.moveaxis(points, -1, 0)
    rho = np.cos(2 * np.pi * frequency * np.cos(np.pi / 2 * np.hypot(x, y)))
    return (1 - np.sin(np.pi * z / 2) + alpha * (1 + rho)) / (2 * (1 + alpha))


class TestBCCVolumeSource(unittest.TestCase):
    def test_default_is_the_volume_of_the_literature(self):
        source = vtkBCCVolumeSource()
        source.Update()
        output = source.GetOutput()
        self.assertTrue(vtkBCCLattice.IsBCC(output))
        self.assertEqual(output.GetDimensions(), (39, 39, 78))
        self.assertEqual(output.GetScalarType(), VTK_FLOAT)
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "Scalars")
        self.assertEqual(output.GetPointData().GetNumberOfArrays(), 1)
        expected = marschner_lobb(get_points(output), 0.25, 6)
        np.testing.assert_allclose(to_numpy(output), expected, atol=1e-6)

    def test_lattice_fills_the_bounds(self):
        source = make_source()
        source.Update()
        output = source.GetOutput()
        self.assertEqual(output.GetOrigin(), (-1, 0.5, -4))
        self.assertEqual(output.GetSpacing(), (3 / 6.5, 2.5 / 8.5, 3 / 11))
        box = [0.0] * 6
        vtkBCCLattice.GetBox(output, box)
        np.testing.assert_allclose(box, source.GetBounds(), atol=1e-14)
        x = [0.0] * 3
        vtkBCCLattice.GetPoint(output, (3, 4, 5), x)
        np.testing.assert_allclose(get_points(output)[5, 4, 3], x, atol=1e-14)

    def check_values(self, source, function):
        source.Update()
        output = source.GetOutput()
        self.assertEqual(output.GetScalarType(), VTK_DOUBLE)
        np.testing.assert_allclose(
            to_numpy(output), function(get_points(output)), rtol=1e-12, atol=1e-12)

    def test_marschner_lobb_follows_its_parameters(self):
        source = make_source()
        source.SetAlpha(1.5)
        source.SetFrequency(2.5)
        self.assertEqual(source.GetFunctionAsString(), "MarschnerLobb")
        self.check_values(source, lambda x: marschner_lobb(x, 1.5, 2.5))

    def test_sphere_is_the_distance_to_the_centre(self):
        source = make_source()
        source.SetFunctionToSphere()
        self.assertEqual(source.GetFunctionAsString(), "Sphere")
        self.check_values(source, lambda x: np.linalg.norm(x - (0.5, 1.75, -2.5), axis=-1))

    def test_gaussian_is_one_at_the_centre(self):
        source = make_source()
        source.SetFunctionToGaussian()
        source.SetStandardDeviation(0.7)
        self.assertEqual(source.GetFunctionAsString(), "Gaussian")
        self.check_values(source, lambda x: np.exp(
            -np.sum((x - (0.5, 1.75, -2.5)) ** 2, -1) / (2 * 0.7 ** 2)))

    def test_constant(self):
        source = make_source()
        source.SetFunctionToConstant()
        source.SetValue(-3.25)
        self.assertEqual(source.GetFunctionAsString(), "Constant")
        self.check_values(source, lambda x: np.full(x.shape[:-1], -3.25))

    def test_implicit_function_comes_first_and_is_followed(self):
        quadric = vtkQuadric()
        quadric.SetCoefficients(1, 2, 3, 4, 5, 6, 7, 8, 9, 10)
        source = make_source()
        source.SetImplicitFunction(quadric)

        def expected(p):
            x, y, z = np.moveaxis(p, -1, 0)
            return (x * x + 2 * y * y + 3 * z * z + 4 * x * y + 5 * y * z + 6 * x * z
                    + 7 * x + 8 * y + 9 * z + 10)
        self.check_values(source, expected)
        check_pieces(self, source)
        check_progress(self, source)
        quadric.SetCoefficients(0, 0, 0, 0, 0, 0, 0, 0, 0, 2)
        self.check_values(source, lambda x: np.full(x.shape[:-1], 2.0))
        sphere = vtkSphere()
        source.SetImplicitFunction(sphere)
        self.check_values(source, lambda x: np.sum(x * x, -1) - 0.25)
        source.SetImplicitFunction(None)
        source.SetFunctionToConstant()
        self.check_values(source, lambda x: np.ones(x.shape[:-1]))

    def test_pieces_threads_and_progress(self):
        for function in range(4):
            source = make_source()
            source.SetFunction(function)
            check_pieces(self, source)
            check_threads(self, source)
            check_progress(self, source)

    def test_streaming_gives_the_whole(self):
        source = make_source()
        source.Update()
        whole = to_numpy(source.GetOutput()).copy()
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(source.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(5)
        streamer.Update()
        self.assertEqual(to_numpy(streamer.GetOutput()).tobytes(), whole.tobytes())

    def test_smallest_volume(self):
        source = vtkBCCVolumeSource()
        source.SetDimensions(1, 1, 2)
        source.Update()
        output = source.GetOutput()
        self.assertEqual(output.GetNumberOfPoints(), 2)
        np.testing.assert_array_equal(get_points(output)[:, 0, 0], [(-1, -1, -1), (1, 1, 1)])

    def test_bad_dimensions(self):
        for dimensions in ((0, 9, 9), (9, 0, 9), (9, 9, 1), (9, 9, 0), (-3, 9, 9)):
            source = make_source()
            source.Update()
            source.SetDimensions(dimensions)
            refuses(self, source, str(dimensions)[1:-1], "1, 1, 2")

    def test_absurd_dimensions(self):
        source = make_source()
        source.SetDimensions(2 ** 31 - 1, 2, 2)
        refuses(self, source, "2147483647")
        source.SetDimensions(2 ** 29, 2 ** 29, 2 ** 29)
        refuses(self, source, "536870912", "counted")
        source.SetDimensions(2 ** 17, 2 ** 17, 2 ** 17)
        refuses(self, source, "131072", "bytes")

    def test_a_piece_of_more_than_memory_holds(self):
        source = make_source()
        source.SetDimensions(2 ** 17, 2 ** 17, 2 ** 17)
        source.UpdateExtent((7, 9, 5, 5, 2 ** 16 + 1, 2 ** 16 + 2))
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 6)

    def test_bad_bounds(self):
        for bounds in ((math.nan, 1, 0, 1, 0, 1), (0, 1, 0, math.inf, 0, 1), (0, 1, 0, 1, 1, 0),
                       (0, 1, 2, 2, 0, 1), (-1.5e308, 1.5e308, 0, 1, 0, 1)):
            source = make_source()
            source.SetBounds(bounds)
            refuses(self, source, "Bounds", "ascending")

    def test_bad_parameters(self):
        for set_up, name in ((lambda s: s.SetAlpha(math.nan), "Alpha"),
                             (lambda s: s.SetAlpha(-1), "Alpha"),
                             (lambda s: s.SetFrequency(math.inf), "Frequency")):
            source = make_source()
            set_up(source)
            refuses(self, source, name, "finite")
            source.SetFunctionToSphere()  # which does not use them
            source.Update()
            self.assertEqual(source.GetOutput().GetNumberOfPoints(), 7 * 9 * 12)
        source.SetFunctionToGaussian()
        for deviation in 0, -1, math.nan:
            source.SetStandardDeviation(deviation)
            refuses(self, source, "StandardDeviation")
        source.SetFunctionToConstant()
        source.SetValue(math.nan)
        refuses(self, source, "Value")

    def test_print(self):
        text = str(make_source())
        for name in ("Dimensions", "Bounds", "Function", "Alpha", "Frequency",
                     "StandardDeviation", "Value", "ImplicitFunction", "OutputScalarType"):
            self.assertIn(name + ": ", text)


if __name__ == "__main__":
    unittest.main()
