# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import (
    VTK_CHAR, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, vtkBitArray, vtkDataArray, vtkStringArray)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkImagingCore import vtkImageDataStreamer, vtkImageTranslateExtent

from bravais import vtkBCCLattice, vtkImageToBCCVolume
from checks import (
    check_numbered_pieces, check_pieces, check_progress, check_threads, get_points, make_image,
    to_numpy)

DTYPES = "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64".split()


def make_random(shape, dtype="float64", seed=1):
    data = np.random.default_rng(seed).bytes(int(np.prod(shape)) * np.dtype(dtype).itemsize)
    return np.frombuffer(data, dtype).reshape(shape)  # all bit patterns, NaNs among them


def pick(array):
    """The points with indices all even or all odd, by the definition."""
    nz, ny, nx = array.shape[:3]
    result = np.empty((nz, ny // 2, nx // 2) + array.shape[3:], array.dtype)
    for k in range(nz):
        result[k] = array[k, k % 2::2, k % 2::2][:ny // 2, :nx // 2]
    return result


def make_filter(image):
    subset = vtkImageToBCCVolume()
    subset.SetModeToSubset()
    subset.SetInputData(image)
    return subset


class TestImageToBCCVolumeSubset(unittest.TestCase):
    def test_every_type_and_component_count_bit_for_bit(self):
        for dtype in DTYPES:
            for components in 1, 2, 3, 5:
                array = make_random((5, 6, 9, components), dtype)
                subset = make_filter(make_image(array, name=dtype))
                subset.Update()
                output = subset.GetOutput()
                self.assertEqual(output.GetPointData().GetScalars().GetName(), dtype)
                self.assertEqual(output.GetScalarType(), subset.GetInput().GetScalarType())
                self.assertEqual(output.GetNumberOfScalarComponents(), components)
                self.assertEqual(
                    to_numpy(output).reshape(5, 3, 4, components).tobytes(),
                    pick(array).tobytes())

    def test_types_that_numpy_lacks(self):
        for type_ in VTK_CHAR, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG:
            image = make_image(np.zeros((3, 4, 4)))
            scalars = vtkDataArray.CreateDataArray(type_)
            scalars.SetNumberOfTuples(48)
            for i in range(48):
                scalars.SetTuple1(i, 2 * i)
            image.GetPointData().SetScalars(scalars)
            subset = make_filter(image)
            subset.Update()
            output = subset.GetOutput()
            self.assertEqual(output.GetScalarType(), type_)
            values = [output.GetPointData().GetScalars().GetTuple1(i) for i in range(12)]
            expected = pick(2 * np.arange(48).reshape(3, 4, 4)).ravel()
            self.assertEqual(values, list(expected))

    def test_geometry(self):
        for size, dimensions in (((2, 2, 2), (1, 1, 2)), ((7, 8, 3), (3, 4, 3)),
                                 ((9, 4, 6), (4, 2, 6))):
            array = np.zeros(size[::-1])
            subset = make_filter(make_image(array, (0.5, 1, 3), (7, 8, 9)))
            subset.Update()
            output = subset.GetOutput()
            self.assertTrue(vtkBCCLattice.IsBCC(output))
            self.assertEqual(output.GetExtent()[::2], (0, 0, 0))
            self.assertEqual(output.GetDimensions(), dimensions)
            self.assertEqual(output.GetSpacing(), (1, 2, 3))
            self.assertEqual(output.GetOrigin(), (7, 8, 9))

    def check_world(self, image, output):
        """Values that are coordinates of the world are still those of their points."""
        x = [0.0] * 3
        nx, ny, nz = output.GetDimensions()
        values = to_numpy(output)
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    vtkBCCLattice.GetPoint(output, (i, j, k), x)
                    np.testing.assert_allclose(values[k, j, i], x, atol=1e-12)

    def test_any_whole_extent_and_direction(self):
        for start in ((0, 0, 0), (1, 0, 0), (-3, 4, 5), (7, 7, -8)):
            image = make_image(np.zeros((6, 11, 12)), (0.5, 1, 3), (7, 8, 9), start=start)
            image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
            image.GetPointData().SetScalars(make_image(np.array(
                [image.GetPoint(p) for p in range(792)]).reshape(6, 11, 12, 3)
            ).GetPointData().GetScalars())
            subset = make_filter(image)
            subset.Update()
            output = subset.GetOutput()
            self.assertEqual(output.GetDimensions(), (6, 5, 6))
            self.assertEqual([output.GetDirectionMatrix().GetElement(1, c) for c in range(3)],
                             [1, 0, 0])
            self.check_world(image, output)
            check_pieces(self, subset)
            check_numbered_pieces(self, subset, 5)

    def test_all_point_arrays_and_field_data(self):
        array = make_random((4, 5, 6), "int16")
        image = make_image(array)
        vectors = make_image(make_random((4, 5, 6, 3), "float32"), name="vectors")
        image.GetPointData().SetVectors(vectors.GetPointData().GetScalars())
        labels, bits, note = vtkStringArray(), vtkBitArray(), vtkStringArray()
        labels.SetName("labels")
        bits.SetName("bits")
        note.SetName("note")
        for i in range(120):
            labels.InsertNextValue(str(i))
            bits.InsertNextValue(i * i % 7 < 3)
        note.InsertNextValue("kept")
        image.GetPointData().AddArray(labels)
        image.GetPointData().AddArray(bits)
        image.GetFieldData().AddArray(note)
        subset = make_filter(image)
        subset.Update()
        output = subset.GetOutput()
        data = output.GetPointData()
        self.assertEqual(data.GetNumberOfArrays(), 4)
        self.assertEqual(data.GetScalars().GetName(), "values")
        self.assertEqual(data.GetVectors().GetName(), "vectors")
        np.testing.assert_array_equal(to_numpy(output), pick(array))
        self.assertEqual(
            to_numpy(output, "vectors").tobytes(), pick(to_numpy(vectors)).tobytes())
        kept = pick(np.arange(120).reshape(4, 5, 6)).ravel()
        for to, point in enumerate(kept):
            self.assertEqual(data.GetAbstractArray("labels").GetValue(to), str(point))
            self.assertEqual(data.GetAbstractArray("bits").GetValue(to),
                             int(point * point % 7 < 3))
        self.assertEqual(output.GetFieldData().GetAbstractArray("note").GetValue(0), "kept")
        self.assertTrue(vtkBCCLattice.IsBCC(output))
        self.assertFalse(vtkBCCLattice.IsBCC(image))

    def test_pieces_threads_and_progress(self):
        subset = make_filter(make_image(make_random((12, 17, 14, 2), "uint16")))
        check_pieces(self, subset)
        check_threads(self, subset)
        check_progress(self, subset)

    def test_only_what_is_needed_is_asked_for(self):
        image = make_image(make_random((12, 17, 14), "uint16"), start=(0, 0, 3))
        source = vtkTrivialProducer()
        source.SetOutput(image)
        source.SetWholeExtent(image.GetExtent())
        passing = vtkImageTranslateExtent()  # tells what was asked of it
        passing.SetInputConnection(source.GetOutputPort())
        subset = vtkImageToBCCVolume()
        subset.SetModeToSubset()
        subset.SetInputConnection(passing.GetOutputPort())
        subset.UpdateExtent((2, 3, 4, 6, 5, 8))
        asked = passing.GetUpdateExtent()
        self.assertEqual(tuple(asked), (4, 7, 8, 13, 8, 11))

    def test_streaming_gives_the_whole(self):
        array = make_random((11, 8, 6), "int32")
        subset = make_filter(make_image(array))
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(subset.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(4)
        streamer.Update()
        np.testing.assert_array_equal(to_numpy(streamer.GetOutput()), pick(array))

    def test_points_are_the_inputs(self):
        z, y, x = np.indices((6, 7, 8))
        subset = make_filter(make_image(np.stack((x, y, z), -1) * 1.5, (1.5, 1.5, 1.5)))
        subset.Update()
        np.testing.assert_array_equal(
            to_numpy(subset.GetOutput()), get_points(subset.GetOutput()))


if __name__ == "__main__":
    unittest.main()
