# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, VTK_SHORT, VTK_UNSIGNED_CHAR

import reference
from bravais import vtkBCCLattice, vtkBCCPrefilter, vtkBCCVolumeToImage
from checks import make_volume, to_numpy

TYPES = {name: getattr(vtkCommonCore, "VTK_" + name) for name in (
    "CHAR", "SIGNED_CHAR", "UNSIGNED_CHAR", "SHORT", "UNSIGNED_SHORT", "INT", "UNSIGNED_INT",
    "LONG", "UNSIGNED_LONG", "LONG_LONG", "UNSIGNED_LONG_LONG", "FLOAT", "DOUBLE")}


def make_filter(volume, dimensions, kernel=7, prefilter=1, **properties):
    to_image = vtkBCCVolumeToImage()
    to_image.SetInputData(volume)
    to_image.SetOutputDimensions(dimensions)
    to_image.SetKernel(kernel)
    to_image.SetPrefilter(prefilter)
    for name, value in properties.items():
        getattr(to_image, "Set" + name)(value)
    return to_image


def run(volume, dimensions, kernel=7, prefilter=1, **properties):
    to_image = make_filter(volume, dimensions, kernel, prefilter, **properties)
    to_image.Update()
    return to_image.GetOutput()


def choose_points(dimensions, count=24):
    """Indices of grid points: the corners, some of the faces, and some anywhere."""
    rng = np.random.default_rng(5)
    last = np.array(dimensions) - 1
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * last
    faces = rng.integers(0, last + 1, (count, 3))
    for n, face in enumerate(faces[:count // 2]):
        face[n % 3] = (n // 3 % 2) * last[n % 3]
    return np.unique(np.concatenate((corners, faces)), axis=0)


def to_lattice(indices, dimensions, shape, start=(0, 0, 0)):
    """Lattice coordinates of grid points; the grid spans the box of a volume of that shape."""
    length = np.array((2 * shape[2] - 1, 2 * shape[1] - 1, shape[0] - 1))
    return np.array((2 * start[0], 2 * start[1], start[2])) + indices * length / (
        np.array(dimensions) - 1)


def pick(image, indices, name=None):
    x, y, z = indices.T
    return to_numpy(image, name)[z, y, x]


class TestBCCVolumeToImage(unittest.TestCase):
    dimensions = 7, 6, 10

    def setUp(self):
        self.rng = np.random.default_rng(11)

    def check(self, array, kernel, prefilter, coefficients, start=(0, 0, 0), tolerance=1e-9):
        indices = choose_points(self.dimensions)
        points = to_lattice(indices, self.dimensions, array.shape, start)
        expected = reference.evaluate(kernel, coefficients, points, start)
        image = run(make_volume(array, start=start), self.dimensions, kernel, prefilter)
        np.testing.assert_allclose(
            pick(image, indices), expected, rtol=0, atol=tolerance * np.abs(array).max(),
            err_msg=f"kernel {kernel}, prefilter {prefilter}")

    def test_values_without_prefilter(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        for kernel in reference.KERNELS:
            self.check(array, kernel, 0, array)
            self.check(array.astype(np.float32), kernel, 0, array, tolerance=3e-6)

    def test_values_of_quasi_interpolation(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        for kernel in reference.KERNELS:
            coefficients = reference.quasi_interpolate(kernel, array)
            self.check(array, kernel, 1, coefficients)
            self.check(array.astype(np.float32), kernel, 1, coefficients, tolerance=6e-6)

    def test_values_of_interpolation(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        for kernel in 4, 8:
            coefficients = reference.interpolate(kernel, array)
            self.check(array, kernel, 2, coefficients)
            self.check(array.astype(np.float32), kernel, 2, coefficients, tolerance=6e-6)

    def test_values_of_projection(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        for kernel in reference.KERNELS:
            prefilter = vtkBCCPrefilter()
            prefilter.SetInputData(make_volume(array))
            prefilter.SetKernel(kernel)
            prefilter.SetMethodToProjection()
            prefilter.Update()
            self.check(array, kernel, 3, to_numpy(prefilter.GetOutput()))

    def test_volumes_that_start_anywhere(self):
        array = self.rng.uniform(-1, 1, (5, 3, 4))
        for start in (2, -3, 1), (-5, 4, -3), (7, 0, 4):
            for kernel in 7, 12:
                coefficients = reference.quasi_interpolate(kernel, array, start)
                self.check(array, kernel, 1, coefficients, start)
            self.check(array, 8, 2, reference.interpolate(8, array, start), start)

    def test_smallest_volumes(self):
        for shape in (2, 1, 1), (2, 1, 5), (2, 6, 1), (9, 1, 1), (3, 2, 2):
            array = self.rng.uniform(-1, 1, shape)
            for kernel in 8, 12:
                self.check(array, kernel, 1, reference.quasi_interpolate(kernel, array))

    def test_grid_much_coarser_than_the_volume(self):
        array = self.rng.uniform(-1, 1, (40, 9, 8))
        self.dimensions = 2, 3, 3
        self.check(array, 7, 1, reference.quasi_interpolate(7, array))

    def test_every_scalar_type(self):
        indices = choose_points(self.dimensions)
        for name, number in TYPES.items():
            whole = name not in ("FLOAT", "DOUBLE")
            low, high = 0, 100
            if whole:
                scalars = vtkCommonCore.vtkDataArray.CreateDataArray(number)
                low, high = scalars.GetDataTypeMin(), scalars.GetDataTypeMax()
                if scalars.GetDataTypeSize() > 2:  # beyond what float tells apart
                    low, high = max(low, -2 ** 20), 2 ** 20
            array = np.round(self.rng.choice([low, 0.5 * (low + high), high], (6, 3, 4)))
            coefficients = reference.quasi_interpolate(7, array)
            expected = reference.evaluate(
                7, coefficients, to_lattice(indices, self.dimensions, array.shape))
            volume = make_volume(array, number)
            self.assertEqual(volume.GetScalarType(), number)
            image = run(volume, self.dimensions)
            self.assertEqual(image.GetScalarType(), number)
            values = pick(image, indices).astype(float)
            if whole:
                scalars = image.GetPointData().GetScalars()
                expected = np.clip(expected, scalars.GetDataTypeMin(), scalars.GetDataTypeMax())
            np.testing.assert_allclose(
                values, expected, rtol=0, atol=0.5 * whole + 1e-6 * (high - low), err_msg=name)

    def test_integers_are_rounded_and_clamped(self):
        array = np.zeros((2, 1, 2), np.uint8)
        array[0], array[1] = 10, 13
        image = run(make_volume(array), (2, 2, 5), kernel=4, prefilter=0)
        exact = run(make_volume(array), (2, 2, 5), kernel=4, prefilter=0,
                    OutputScalarType=VTK_DOUBLE)
        np.testing.assert_array_equal(
            to_numpy(image)[:, 0, 0], np.floor(to_numpy(exact)[:, 0, 0] + 0.5))
        array = self.rng.choice([0, 255], (6, 3, 4)).astype(np.uint8)
        exact = to_numpy(run(make_volume(array), (9, 9, 9), OutputScalarType=VTK_DOUBLE))
        self.assertTrue(exact.min() < -1 and exact.max() > 256)
        clamped = to_numpy(run(make_volume(array), (9, 9, 9)))
        np.testing.assert_array_equal(clamped, np.floor(np.clip(exact, 0, 255) + 0.5))

    def test_constants_of_every_integer_type_stay(self):
        for name, number in TYPES.items():
            if name in ("FLOAT", "DOUBLE"):
                continue
            scalars = vtkCommonCore.vtkDataArray.CreateDataArray(number)
            digits = 23 if scalars.GetDataTypeSize() < 8 else 52
            value = min(int(scalars.GetDataTypeMax()), 2 ** digits + 1)
            volume = make_volume(np.full((4, 2, 2), value), number)
            for kernel in reference.KERNELS:
                values = to_numpy(run(volume, (2, 3, 7), kernel, 0)).astype(np.int64)
                exact = to_numpy(
                    run(volume, (2, 3, 7), kernel, 0, OutputScalarType=VTK_DOUBLE))
                np.testing.assert_array_equal(
                    values, np.clip(np.round(exact), None, scalars.GetDataTypeMax()), name)

    def test_large_integers_keep_their_digits(self):
        array = self.rng.integers(-2 ** 52, 2 ** 52, (6, 3, 4))
        for name in "LONG", "LONG_LONG":
            volume = make_volume(array, TYPES[name])
            values = to_numpy(run(volume, self.dimensions)).astype(float)
            exact = to_numpy(run(make_volume(array.astype(float)), self.dimensions))
            np.testing.assert_allclose(values, exact, rtol=0, atol=0.51)

    def test_every_output_type(self):
        volume = make_volume(self.rng.uniform(0, 100, (6, 3, 4)))
        exact = to_numpy(run(volume, self.dimensions))
        for number in TYPES.values():
            image = run(volume, self.dimensions, OutputScalarType=number)
            self.assertEqual(image.GetScalarType(), number)
            whole = number not in (VTK_FLOAT, VTK_DOUBLE)
            scalars = image.GetPointData().GetScalars()
            expected = np.clip(exact, scalars.GetDataTypeMin(), scalars.GetDataTypeMax())
            np.testing.assert_allclose(
                to_numpy(image), expected, rtol=1e-6, atol=0.5 * whole)

    def test_components_are_independent(self):
        for dtype in np.float64, np.float32, np.int16:
            for count in 1, 2, 3, 4, 7:
                array = (1000 * self.rng.uniform(-1, 1, (6, 3, 4, count))).astype(dtype)
                for kernel, prefilter in (7, 1), (12, 0), (8, 2), (7, 3):
                    image = run(
                        make_volume(array), self.dimensions, kernel, prefilter,
                        ComputeGradients=True)
                    self.assertEqual(image.GetNumberOfScalarComponents(), count)
                    gradients = to_numpy(image, "Gradients")
                    self.assertEqual(gradients.shape[-1], 3 * count)
                    for c in range(count):
                        one = run(
                            make_volume(array[..., c]), self.dimensions, kernel, prefilter,
                            ComputeGradients=True)
                        values = to_numpy(image).reshape(to_numpy(one).shape + (count,))
                        np.testing.assert_array_equal(values[..., c], to_numpy(one))
                        np.testing.assert_array_equal(
                            gradients[..., 3 * c:3 * c + 3], to_numpy(one, "Gradients"))

    def test_gradients_in_world_units(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        turn = np.linalg.qr(self.rng.normal(size=(3, 3)))[0]
        spacing = np.array((0.7, 2.5, 0.3))
        for kernel in 7, 8, 12:
            coefficients = reference.quasi_interpolate(kernel, array)
            indices = choose_points(self.dimensions, 12)
            points = to_lattice(indices, self.dimensions, array.shape)
            along_lattice = reference.evaluate_gradient(kernel, coefficients, points)
            expected = (along_lattice * (2, 2, 1) / spacing) @ turn.T
            for dtype, tolerance in (np.float64, 1e-6), (np.float32, 1e-4):
                volume = make_volume(array.astype(dtype), spacing=spacing, origin=(5, -3, 2))
                volume.SetDirectionMatrix(*turn.ravel())
                image = run(volume, self.dimensions, kernel, ComputeGradients=True)
                gradients = image.GetPointData().GetArray("Gradients")
                self.assertEqual(
                    gradients.GetDataType(), VTK_DOUBLE if dtype == np.float64 else VTK_FLOAT)
                np.testing.assert_allclose(
                    pick(image, indices, "Gradients"), expected, rtol=0, atol=tolerance)

    def test_gradients_of_a_linear_function(self):
        turn = np.linalg.qr(self.rng.normal(size=(3, 3)))[0]
        slope = np.array((3.0, -2.0, 5.0))
        volume = make_volume(np.zeros((24, 12, 12)), spacing=(2, 3, 0.5), origin=(5, 1, 2))
        volume.SetDirectionMatrix(*turn.ravel())
        values = to_numpy(volume)
        x = [0.0] * 3
        for k, j, i in np.ndindex(values.shape):
            vtkBCCLattice.GetPoint(volume, (i, j, k), x)
            values[k, j, i] = slope @ x
        for kernel in reference.KERNELS:
            image = run(volume, (20, 22, 23), kernel, ComputeGradients=True)
            inside = to_numpy(image, "Gradients")[8:-8, 8:-8, 8:-8]
            np.testing.assert_allclose(inside, np.broadcast_to(slope, inside.shape), atol=1e-10)
            for ijk in (9, 10, 11), (12, 9, 10):
                image.TransformIndexToPhysicalPoint(ijk, x)
                i, j, k = ijk
                self.assertAlmostEqual(to_numpy(image)[k, j, i], slope @ x, 9)

    def test_gradients_are_made_on_demand(self):
        volume = make_volume(self.rng.uniform(0, 9, (6, 3, 4)).astype(np.int16), name="height")
        image = run(volume, (3, 4, 5))
        self.assertEqual(image.GetPointData().GetNumberOfArrays(), 1)
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "height")
        image = run(volume, (3, 4, 5), ComputeGradients=True)
        self.assertEqual(image.GetPointData().GetNumberOfArrays(), 2)
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "height")
        self.assertEqual(image.GetPointData().GetArray("Gradients").GetDataType(), VTK_FLOAT)

    def test_default_dimensions(self):
        volume = make_volume(np.zeros((6, 3, 4), np.uint8), spacing=(2, 2, 1), origin=(5, 6, 7))
        image = run(volume, (0, 0, 0))
        self.assertEqual(image.GetDimensions(), (8, 6, 6))
        self.assertEqual(image.GetSpacing(), (1, 1, 1))
        self.assertEqual(image.GetOrigin(), (5, 6, 7))
        self.assertEqual(run(volume, (0, 3, 0)).GetDimensions(), (8, 3, 6))
        volume.SetSpacing(3, 1, 2)  # a box of 10.5 x 2.5 x 10
        image = run(volume, (0, 0, 0))
        self.assertEqual(image.GetDimensions(), (6, 2, 6))
        self.assertEqual(image.GetSpacing(), (10.5 / 5, 2.5, 2))

    def test_grid_spans_the_box(self):
        turn = np.linalg.qr(self.rng.normal(size=(3, 3)))[0]
        for start in (0, 0, 0), (3, -2, 5):
            volume = make_volume(
                np.zeros((6, 3, 4)), spacing=(0.7, 2.5, 0.3), origin=(5, -3, 2), start=start)
            volume.SetDirectionMatrix(*turn.ravel())
            box, bounds = [0.0] * 6, [0.0] * 6
            vtkBCCLattice.GetBox(volume, box)
            run(volume, self.dimensions).GetBounds(bounds)
            np.testing.assert_allclose(bounds, box, atol=1e-12)

    def test_single_points_lie_in_the_middle(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        start = 1, 2, 3
        volume = make_volume(array, spacing=(2, 4, 3), origin=(5, 6, 7), start=start)
        image = run(volume, (1, 1, 1))
        self.assertEqual(image.GetDimensions(), (1, 1, 1))
        box = [0.0] * 6
        vtkBCCLattice.GetBox(volume, box)
        np.testing.assert_allclose(
            image.GetOrigin(), [0.5 * (box[2 * a] + box[2 * a + 1]) for a in range(3)])
        middle = np.array([(2 + 3.5, 4 + 2.5, 3 + 2.5)])
        coefficients = reference.quasi_interpolate(7, array, start)
        expected = reference.evaluate(7, coefficients, middle, start)
        self.assertAlmostEqual(to_numpy(image)[0, 0, 0], expected[0], 9)
        row = to_numpy(run(volume, (3, 1, 5)))
        self.assertAlmostEqual(row[2, 0, 1], expected[0], 9)

    def test_interpolation_passes_through_the_samples(self):
        array = self.rng.uniform(-1, 1, (6, 3, 4))
        for start in (0, 0, 0), (1, 2, 3):
            for kernel in 4, 8:
                image = run(make_volume(array, start=start), (8, 6, 6), kernel, 2)
                for k in range(6):
                    odd = (k + start[2]) & 1
                    np.testing.assert_allclose(
                        to_numpy(image)[k, odd::2, odd::2], array[k], atol=1e-10)

    def test_output_is_no_bcc_volume(self):
        self.assertFalse(vtkBCCLattice.IsBCC(run(make_volume(np.zeros((6, 3, 4))), (2, 2, 2))))

    def test_other_field_data_stay(self):
        volume = make_volume(np.zeros((6, 3, 4)))
        names = vtkCommonCore.vtkStringArray()
        names.SetName("Patient")
        names.InsertNextValue("anonymous")
        volume.GetFieldData().AddArray(names)
        field = run(volume, (2, 2, 2)).GetFieldData()
        self.assertEqual(field.GetAbstractArray("Patient").GetValue(0), "anonymous")
        self.assertTrue(vtkBCCLattice.IsBCC(volume))

    def test_precomputed_coefficients(self):
        volume = make_volume(self.rng.uniform(-1, 1, (6, 3, 4)))
        for kernel in reference.KERNELS:
            for method in 1, 2, 3:
                if method == 2 and kernel in (7, 12):
                    continue
                prefilter = vtkBCCPrefilter()
                prefilter.SetInputData(volume)
                prefilter.SetKernel(kernel)
                prefilter.SetMethod(method)
                to_image = make_filter(volume, self.dimensions, kernel, 0)
                to_image.SetInputConnection(prefilter.GetOutputPort())
                to_image.Update()
                both = run(volume, self.dimensions, kernel, method)
                np.testing.assert_array_equal(to_numpy(to_image.GetOutput()), to_numpy(both))

    def test_names_of_the_enumerations(self):
        to_image = vtkBCCVolumeToImage()
        self.assertEqual(to_image.GetKernelAsString(), "BCC7")
        self.assertEqual(to_image.GetPrefilterAsString(), "QuasiInterpolation")
        for name in "BCC4", "BCC7", "BCC8", "BCC12":
            getattr(to_image, "SetKernelTo" + name)()
            self.assertEqual(to_image.GetKernel(), getattr(vtkBCCLattice, name))
            self.assertEqual(to_image.GetKernelAsString(), name)
        for number, name in enumerate(("None", "QuasiInterpolation", "Interpolation",
                                       "Projection")):
            getattr(to_image, "SetPrefilterTo" + name)()
            self.assertEqual(to_image.GetPrefilter(), number)
            self.assertEqual(to_image.GetPrefilterAsString(), name)
        self.assertEqual(to_image.GetOutputScalarTypeAsString(), "input")
        to_image.SetOutputScalarTypeToDouble()
        self.assertEqual(to_image.GetOutputScalarTypeAsString(), "double")
        for name in ("OutputDimensions", "Kernel", "Prefilter", "ComputeGradients",
                     "OutputScalarType"):
            self.assertIn(name + ": ", str(to_image))


if __name__ == "__main__":
    unittest.main()
