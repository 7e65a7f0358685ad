# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray

from bravais import vtkBayerPattern
from checks import Errors


def get(method, *arguments, array=vtkIdTypeArray):
    values = array()
    assert method(*arguments, values)
    return vtk_to_numpy(values).tolist()


class TestBayerPattern(unittest.TestCase):
    def test_thresholds_and_order_of_four_by_four(self):
        pattern = vtkBayerPattern()
        self.assertEqual(get(pattern.GetThresholds, 2, 2),
                         [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5])
        self.assertEqual(get(pattern.GetOrder, 2, 2),
                         [0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12])
        self.assertEqual(get(pattern.GetThresholds, 2, 0), [0])
        self.assertEqual(get(pattern.GetThresholds, 3, 0), [0])

    def test_base_orders(self):
        pattern = vtkBayerPattern()
        self.assertEqual(pattern.GetBaseOrderAsString(), "FCC")
        fcc = [0, 3, 5, 6, 7, 4, 2, 1]  # x + 2 y + 4 z
        bcc = [0, 7, 3, 4, 5, 2, 6, 1]
        self.assertEqual(get(pattern.GetOrder, 3, 1), fcc)
        pattern.SetBaseOrderToBCC()
        self.assertEqual(pattern.GetBaseOrderAsString(), "BCC")
        self.assertEqual(pattern.GetBaseOrder(), vtkBayerPattern.BCC)
        self.assertEqual(get(pattern.GetOrder, 3, 1), bcc)
        self.assertEqual(get(pattern.GetOrder, 2, 1), [0, 3, 1, 2])
        pattern.SetBaseOrderToFCC()
        self.assertEqual(get(pattern.GetOrder, 3, 1), fcc)

    def test_order_is_the_inverse_of_the_thresholds(self):
        pattern = vtkBayerPattern()
        for dimension, log2_size in (2, 5), (3, 3):
            for base_order in vtkBayerPattern.FCC, vtkBayerPattern.BCC:
                pattern.SetBaseOrder(base_order)
                thresholds = np.array(get(pattern.GetThresholds, dimension, log2_size))
                order = get(pattern.GetOrder, dimension, log2_size)
                self.assertEqual(thresholds[order].tolist(), list(range(len(order))))

    def test_minimum_distances(self):
        distances = get(vtkBayerPattern().GetMinimumDistances, 3, 2, array=vtkDoubleArray)
        self.assertEqual(len(distances), 64)
        np.testing.assert_allclose(
            distances[:9], np.sqrt([16, 8, 8, 8, 4, 4, 4, 4, 2]), rtol=1e-15)

    def test_power_spectra(self):
        pattern = vtkBayerPattern()
        ranks = np.array(get(pattern.GetThresholds, 3, 2)).reshape(4, 4, 4)
        for values, arguments in ((ranks + 0.5) / 64, ()), ((ranks < 5) * 1.0, (5,)):
            power = get(pattern.GetPowerSpectrum, 3, 2, *arguments, array=vtkDoubleArray)
            expected = np.abs(np.fft.fftn(values - values.mean())) ** 2 / 64
            np.testing.assert_allclose(np.reshape(power, (4, 4, 4)), expected, atol=1e-12)

    def refuses(self, method, array, arguments, *words):
        pattern = vtkBayerPattern()
        with Errors(pattern) as errors:
            self.assertFalse(getattr(pattern, method)(*arguments, array))
        self.assertEqual(len(errors.texts), 1)
        for word in words:
            self.assertIn(word, errors.texts[0])
        if array:
            self.assertEqual(array.GetNumberOfValues(), 0)

    def test_bad_input_is_one_error_and_an_empty_array(self):
        for method, kind, tail in (
                ("GetThresholds", vtkIdTypeArray, ()), ("GetOrder", vtkIdTypeArray, ()),
                ("GetMinimumDistances", vtkDoubleArray, ()),
                ("GetPowerSpectrum", vtkDoubleArray, ()),
                ("GetPowerSpectrum", vtkDoubleArray, (1,))):
            array = kind()
            array.InsertNextValue(7)
            for dimension in 1, 4, -2:
                self.refuses(method, array, (dimension, 1) + tail, f"dimension is {dimension};")
            self.refuses(method, array, (2, -1) + tail, "log2 size is -1;", "0 to 29")
            self.refuses(method, array, (2, 30) + tail, "log2 size is 30;")
            self.refuses(method, array, (3, 21) + tail, "log2 size is 21;", "0 to 20")
            self.refuses(method, array, (3, 2 ** 31 - 1) + tail, "log2 size is 2147483647;")
            # These can be counted but not held.
            self.refuses(method, array, (2, 29) + tail, "log2 size is 29.", "bytes")
            self.refuses(method, array, (3, 20) + tail, "log2 size is 20.", "bytes")
            self.refuses(method, None, (2, 2) + tail, "no array")

    def test_count_beyond_the_cells(self):
        for count in -1, 65:
            array = vtkDoubleArray()
            self.refuses("GetPowerSpectrum", array, (3, 2, count), f"count is {count};", "0 to 64")


if __name__ == "__main__":
    unittest.main()
