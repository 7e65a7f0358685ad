# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What clipping planes cut away may count as an intensity in gradients."""
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane

import comparison
import scenes

PLANE = (0.05, 0, 0), (-1, 0.2, -0.4)


def clip(scene, mapper, volume_property):
    plane = vtkPlane()
    plane.SetOrigin(PLANE[0])
    plane.SetNormal(PLANE[1])
    mapper.AddClippingPlane(plane)


def clip_by_intensity(scene, mapper, volume_property):
    clip(scene, mapper, volume_property)
    volume_property.UseClippedVoxelIntensityOn()
    volume_property.SetClippedVoxelIntensity(-1)


class TestBCCVolumeMapperClipped(unittest.TestCase):
    def test_clipping(self):
        for mode in "Composite", "MaximumIntensity":
            comparison.compare(self, mode, 1.0, clip)

    def test_intensity(self):
        """Differences reach as far as a cell: VTK's grid has as many along each axis as layers."""
        cartesian = scenes.make_cartesian(comparison.wave, (48, 48, 48))
        bcc = scenes.make_bcc(comparison.wave, (48, 48, 95))
        comparison.compare(self, "Composite", 1.6, clip_by_intensity, cartesian=cartesian, bcc=bcc)
        pictures = [comparison.make_scenes("Composite", prepare)[1].render()
                    for prepare in (clip, clip_by_intensity)]
        self.assertGreater(numpy.abs(pictures[1] - pictures[0]).mean(), 0.5)


if __name__ == "__main__":
    unittest.main()
