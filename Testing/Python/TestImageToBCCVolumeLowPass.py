# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sinusoids of whole numbers of half waves, which mirrors continue smoothly."""
import unittest

import numpy as np
from vtkmodules.vtkImagingCore import vtkImageInterpolator

from bravais import vtkImageToBCCVolume
from checks import get_points, make_image, to_numpy


def make_wave(shape, spacing, half_waves):
    """cos(pi m x / edge) along x, y, z multiplied, and their frequencies per world unit."""
    wave = np.ones(())
    frequency = []
    for n, s, m in zip(shape, spacing, half_waves):
        wave = np.multiply.outer(np.cos(np.pi * m * np.arange(n) / (n - 1)), wave)
        frequency.append(m / (2 * (n - 1) * s))
    return wave, np.array(frequency)


def resample(array, spacing, ratio=None, low_pass=True, dimensions=(0, 0, 0)):
    to_bcc = vtkImageToBCCVolume()
    to_bcc.SetInputData(make_image(array, spacing))
    if ratio:
        to_bcc.SetSampleRatio(ratio)
    to_bcc.SetDimensions(dimensions)
    to_bcc.SetLowPass(low_pass)
    to_bcc.Update()
    return to_bcc.GetOutput()


def reach(frequency, output):
    """How far to the border of what the lattice can represent a frequency is: 1 on it."""
    f = np.sort(np.abs(frequency))
    return 2 * output.GetSpacing()[2] * (f[1] + f[2])


class TestImageToBCCVolumeLowPass(unittest.TestCase):
    def check(self, shape, spacing, ratio, half_waves, kept, low_pass=True):
        wave, frequency = make_wave(shape, spacing, half_waves)
        output = resample(wave, spacing, ratio, low_pass)
        values = to_numpy(output)
        if kept:
            points = get_points(output)
            expected = np.cos(2 * np.pi * points * frequency).prod(-1)
            np.testing.assert_allclose(values, expected, atol=0.02)
        else:
            self.assertLess(np.abs(values).max(), 1e-6)
        return reach(frequency, output)

    def test_beyond_the_lattice_is_removed_and_within_is_kept(self):
        shape, spacing, ratio = (41, 37, 33), (1, 1, 1), 1 / 16
        for half_waves in ((30, 0, 0), (0, 27, 0), (0, 0, 24), (20, 18, 0), (0, 20, 18),
                           (18, 17, 15)):
            self.assertGreater(self.check(shape, spacing, ratio, half_waves, False), 1)
        for half_waves in ((18, 0, 0), (0, 16, 0), (0, 0, 14), (9, 8, 0), (0, 8, 7), (9, 8, 7)):
            self.assertLess(self.check(shape, spacing, ratio, half_waves, True), 0.8)

    def test_axes_differ_where_the_input_does(self):
        # The input is four times finer along x than along y and z, the lattice is not.
        shape, spacing = (81, 21, 21), (0.25, 1, 1)
        self.assertGreater(self.check(shape, spacing, 1, (60, 0, 0), False), 1)
        self.assertLess(self.check(shape, spacing, 1, (24, 0, 0), True), 0.8)
        self.assertLess(self.check(shape, spacing, 1, (0, 8, 0), True), 0.8)

    def test_without_it_what_is_removed_would_alias(self):
        wave, _ = make_wave((41, 37, 33), (1, 1, 1), (30, 0, 0))
        self.assertGreater(np.abs(to_numpy(resample(wave, (1, 1, 1), 1 / 16, False))).max(), 0.5)

    def test_no_decimation_no_low_pass(self):
        rng = np.random.default_rng(4)
        for shape, spacing in (((10, 11, 12), (1, 1, 1)), ((12, 14, 7), (0.9, 0.9, 1.5))):
            array = rng.uniform(size=shape[::-1])
            for ratio in 1, 3:
                on, off = (to_numpy(resample(array, spacing, ratio, p)) for p in (True, False))
                np.testing.assert_array_equal(on, off)
        # Half the samples are decimation, though no axis has a coarser lattice.
        on, off = (to_numpy(resample(array, spacing, 0.5, p)) for p in (True, False))
        self.assertGreater(np.abs(on - off).max(), 1e-3)

    def test_constants_stay(self):
        for dtype in "uint8", "float32", "float64", "int64":
            values = to_numpy(resample(np.full((17, 18, 19), 100, dtype), (1, 2, 1), 0.1))
            np.testing.assert_allclose(values, 100, rtol=1e-6)

    def test_noise_keeps_its_share_of_power(self):
        array = np.random.default_rng(5).normal(size=(40, 40, 40))
        output = resample(array, (1, 1, 1), 1 / 8)
        share = to_numpy(output).var()
        # The passband is 1/8 of the input's, up to its smooth border.
        self.assertGreater(share, 0.5 / 8)
        self.assertLess(share, 1.0 / 8)

    def test_applies_to_any_interpolator(self):
        wave, _ = make_wave((41, 37, 33), (1, 1, 1), (30, 0, 0))
        to_bcc = vtkImageToBCCVolume()
        to_bcc.SetInputData(make_image(wave))
        to_bcc.SetInterpolator(vtkImageInterpolator())
        to_bcc.SetDimensions(7, 7, 12)
        to_bcc.Update()
        self.assertLess(np.abs(to_numpy(to_bcc.GetOutput())).max(), 1e-6)
        to_bcc.LowPassOff()
        to_bcc.Update()
        self.assertGreater(np.abs(to_numpy(to_bcc.GetOutput())).max(), 0.5)


if __name__ == "__main__":
    unittest.main()
