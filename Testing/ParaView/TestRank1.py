# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture on a rank-1 lattice is shown through its filter, and written as a texture on demand."""
import os
import unittest

import bravais
import numpy
import views
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

views.load_plugin()


class TestRank1(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.picture = simple.Wavelet(WholeExtent=[-31, 32, -31, 32, 0, 0])
        cls.rank1 = simple.Rank1ImageResample(Input=cls.picture)

    def take_picture(self, source, name):
        view = views.make_view()
        display = simple.Show(source, view)
        display.SetRepresentationType("Slice")
        simple.ColorBy(display, ("POINTS", "RTData"))
        view.CameraPosition, view.CameraFocalPoint = [0.5, 0.5, 100], [0.5, 0.5, 0]
        view.CameraParallelProjection, view.CameraParallelScale = 1, 30
        return views.take_picture(view, name)

    def test_reconstruction_is_the_picture(self):
        again = simple.Rank1ImageReconstruct(Input=self.rank1, OutputDimensions=[128, 128])
        self.assertEqual(again.Interpolation, "Barycentric")
        table = simple.GetColorTransferFunction("RTData")
        table.RescaleTransferFunction(60, 280)
        first = self.take_picture(self.picture, "Rank1Picture")
        second = self.take_picture(again, "Rank1Reconstructed")
        self.assertGreater(views.get_shown(first).mean(), 0.9)
        self.assertLess(views.differ(first, second), 8)
        again.Interpolation = "Nearest"
        nearest = self.take_picture(again, "Rank1Nearest")
        self.assertGreater(views.differ(first, nearest), 1.2 * views.differ(first, second))

    def test_texture_file(self):
        """Save Data knows the writer by the ending; what it writes is the texture."""
        path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], "wavelet.tif")
        if os.path.exists(path):
            os.remove(path)
        simple.SaveData(path, proxy=self.picture, NumberOfPoints=256, Compression="none")
        x, y = numpy.meshgrid(*2 * [(numpy.arange(64) + 0.5) / 64])
        found = bravais.rank1_sample(path, numpy.stack([x, y], -1))
        self.picture.UpdatePipeline()
        image = self.picture.SMProxy.GetClientSideObject().GetOutputDataObject(0)
        values = vtk_to_numpy(image.GetPointData().GetArray("RTData")).reshape(64, 64)
        self.assertLess(abs(found - values)[4:-4, 4:-4].mean(), 0.05 * numpy.ptp(values))


if __name__ == "__main__":
    views.run()
