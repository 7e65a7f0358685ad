# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageDataStreamer, vtkImageShiftScale

from bravais import vtkBCCPrefilter, vtkBCCVolumeSource, vtkBCCVolumeToImage
from checks import (
    PieceSource, check_blocks, check_numbered_pieces, check_pieces, check_progress,
    check_threads, make_volume, modify, to_numpy)

METHODS = [(7, 1), (12, 0), (4, 1), (8, 2), (7, 3)]


def make_array(shape=(11, 8, 9), dtype=np.float32):
    return (100 * np.random.default_rng(3).uniform(-1, 1, shape)).astype(dtype)


def make_filter(source, dimensions, kernel=7, prefilter=1, gradients=True):
    to_image = vtkBCCVolumeToImage()
    to_image.SetInputConnection(source.GetOutputPort())
    to_image.SetOutputDimensions(dimensions)
    to_image.SetKernel(kernel)
    to_image.SetPrefilter(prefilter)
    to_image.SetComputeGradients(gradients)
    return to_image


class TestBCCVolumeToImagePipeline(unittest.TestCase):
    def test_pieces_are_parts_of_the_whole(self):
        for start in (0, 0, 0), (-2, 5, 3):
            for kernel, prefilter in METHODS:
                source = PieceSource(make_volume(make_array(), start=start))
                to_image = make_filter(source, (14, 9, 23), kernel, prefilter)
                check_pieces(self, to_image, bcc=False)

    def test_pieces_of_other_types(self):
        for dtype in np.float64, np.int16:
            source = PieceSource(make_volume(make_array((11, 8, 9, 3), dtype), start=(0, 0, 1)))
            check_pieces(self, make_filter(source, (14, 9, 23)), bcc=False)

    def test_pieces_near_not_a_number(self):
        array = make_array()
        array[6, 3, 4] = array[0, 0, 0] = array[2, 7, 8] = math.nan
        for start in (0, 0, 0), (0, 0, 1):
            source = PieceSource(make_volume(array, start=start))
            for kernel in 4, 7, 8, 12:
                to_image = make_filter(source, (14, 9, 21), kernel)
                to_image.Update()
                whole = to_numpy(to_image.GetOutput()).copy()
                for z in 0, 10, 11, 20:
                    modify(to_image)
                    to_image.UpdateExtent((0, 13, 0, 8, z, z))
                    np.testing.assert_array_equal(
                        to_numpy(to_image.GetOutput())[0], whole[z])

    def test_single_points(self):
        source = PieceSource(make_volume(make_array(), start=(1, 1, 1)))
        to_image = make_filter(source, (7, 6, 11), gradients=False)
        to_image.Update()
        whole = to_numpy(to_image.GetOutput()).copy()
        for k, j, i in np.ndindex(whole.shape):
            if (i + j + k) % 5 == 0 or k == 10:
                modify(to_image)
                to_image.UpdateExtent((i, i, j, j, k, k))
                self.assertEqual(to_numpy(to_image.GetOutput()).item(), whole[k, j, i])

    def test_no_more_is_asked_for_than_needed(self):
        whole = 0, 39, 0, 29, 1, 90
        volume = make_volume(make_array((90, 30, 40), np.uint8), start=(0, 0, 1))
        for prefilter, margin in (0, 0), (1, 1):
            source = PieceSource(volume)
            # points that are the lattice's even ones, and those between them
            to_image = make_filter(source, (80, 60, 90), 7, prefilter)
            to_image.UpdateInformation()
            for x, y, z in (40, 30, 50), (0, 0, 0), (79, 59, 89):
                modify(to_image)
                to_image.UpdateExtent((x, x, y, y, z, z))
                cell = x // 2, y // 2, z + 1
                for axis, (below, above) in enumerate(((2, 2), (2, 2), (4, 4))):
                    low, high = source.asked[-1][2 * axis:2 * axis + 2]
                    first = max(whole[2 * axis], cell[axis] - below - margin)
                    last = min(whole[2 * axis + 1], cell[axis] + above + margin)
                    self.assertGreaterEqual(low, first)
                    self.assertLessEqual(high, last)
            modify(to_image)
            to_image.UpdateExtent((10, 20, 30, 31, 40, 49))
            i0, i1, j0, j1, k0, k1 = source.asked[-1]
            self.assertLessEqual((i1 - i0 + 1) * (j1 - j0 + 1) * (k1 - k0 + 1), 12 * 8 * 19)

    def test_methods_of_the_whole_ask_for_the_whole(self):
        source = PieceSource(make_volume(make_array(), start=(0, 0, 1)))
        to_image = make_filter(source, (5, 5, 5), 8, 2)
        to_image.UpdateExtent((1, 1, 2, 2, 3, 3))
        self.assertEqual(source.asked, [[0, 8, 0, 7, 1, 11]])
        self.assertEqual(to_image.GetOutput().GetExtent(), (1, 1, 2, 2, 3, 3))

    def test_downstream_of_filters(self):
        source = vtkBCCVolumeSource()
        source.SetDimensions(13, 12, 21)
        shift = vtkImageShiftScale()
        shift.SetInputConnection(source.GetOutputPort())
        shift.SetScale(1000)
        shift.SetOutputScalarTypeToShort()
        check_pieces(self, make_filter(shift, (20, 20, 20)), bcc=False)

    def test_a_cut_of_a_volume_is_a_volume(self):
        source = vtkBCCVolumeSource()
        source.SetDimensions(13, 12, 21)
        source.Update()
        cut = vtkExtractVOI()
        cut.SetInputConnection(source.GetOutputPort())
        cut.SetVOI(2, 9, 3, 10, 5, 17)
        to_image = make_filter(cut, (16, 16, 13), 4, 0)
        to_image.Update()
        values = to_numpy(source.GetOutput())
        for k in range(13):
            odd = (k + 5) & 1
            np.testing.assert_allclose(
                to_numpy(to_image.GetOutput())[k, odd::2, odd::2],
                values[5 + k, 3:11, 2:10], atol=1e-6)
        check_pieces(self, to_image, bcc=False)

    def test_streaming_gives_the_whole(self):
        for prefilter in 1, 3:
            source = PieceSource(make_volume(make_array()))
            to_image = make_filter(source, (14, 9, 23), 7, prefilter)
            to_image.Update()
            whole = to_numpy(to_image.GetOutput()).copy()
            streamer = vtkImageDataStreamer()
            streamer.SetInputConnection(to_image.GetOutputPort())
            streamer.SetNumberOfStreamDivisions(6)
            streamer.Update()
            self.assertEqual(to_numpy(streamer.GetOutput()).tobytes(), whole.tobytes())

    def test_blocks(self):
        volumes = []
        for number in 5, 8:
            source = vtkBCCVolumeSource()
            source.SetDimensions(number, 6, 9)
            source.SetBounds(-1, 1, -1, number, -1, 1)
            source.Update()
            volumes.append(source.GetOutput())
        for make in vtkBCCPrefilter, vtkBCCVolumeToImage:
            check_blocks(self, make, volumes)

    def test_numbered_pieces(self):
        source = PieceSource(make_volume(make_array(), start=(1, 2, 3)))
        for kernel, prefilter in METHODS:
            for dimensions, count in ((14, 9, 23), 5), ((3, 3, 3), 40):
                to_image = make_filter(source, dimensions, kernel, prefilter)
                check_numbered_pieces(self, to_image, count)
            coefficients = vtkBCCPrefilter()
            coefficients.SetInputConnection(source.GetOutputPort())
            coefficients.SetKernel(kernel)
            coefficients.SetMethod(prefilter)
            check_numbered_pieces(self, coefficients, 7)
            to_image = make_filter(coefficients, (14, 9, 23), kernel, 0)
            check_numbered_pieces(self, to_image, 6)
        check_numbered_pieces(self, make_filter(vtkBCCVolumeSource(), (9, 9, 9)), 3)

    def test_threads(self):
        for kernel, prefilter in METHODS:
            source = PieceSource(make_volume(make_array((11, 8, 9, 2))))
            check_threads(self, make_filter(source, (14, 19, 23), kernel, prefilter))

    def test_progress_and_abort(self):
        for kernel, prefilter in METHODS:
            source = PieceSource(make_volume(make_array((60, 8, 9))))
            check_progress(self, make_filter(source, (14, 19, 83), kernel, prefilter))

    def test_changes_are_followed(self):
        source = vtkBCCVolumeSource()
        source.SetDimensions(6, 6, 12)
        source.SetFunctionToConstant()
        to_image = make_filter(source, (4, 4, 4), gradients=False)
        to_image.Update()
        self.assertAlmostEqual(to_numpy(to_image.GetOutput())[1, 1, 1], 1, 5)
        source.SetValue(3)
        to_image.Update()
        self.assertAlmostEqual(to_numpy(to_image.GetOutput())[1, 1, 1], 3, 5)
        to_image.SetOutputDimensions(5, 4, 3)
        to_image.Update()
        self.assertEqual(to_image.GetOutput().GetDimensions(), (5, 4, 3))

    def test_volumes_of_many_slabs(self):
        source = PieceSource(make_volume(make_array((300, 3, 2))))
        for depth in 5, 31, 901:
            check_pieces(self, make_filter(source, (5, 5, depth)), bcc=False)


if __name__ == "__main__":
    unittest.main()
