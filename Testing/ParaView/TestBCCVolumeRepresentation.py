# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The representation "BCC Volume" beside ParaView's "Volume" of the same spline, resampled."""
import unittest

import views
from paraview import simple

views.load_plugin()


class TestBCCVolumeRepresentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """The same function in two views: by its lattice, and by a fine Cartesian grid."""
        cls.source = simple.BCCVolumeSource(Function="Gaussian", Dimensions=[24, 24, 48])
        cls.image = simple.BCCVolumeToImage(Input=cls.source, OutputDimensions=[95, 95, 95])
        cls.bcc_view, cls.image_view = views.make_view(), views.make_view()
        cls.bcc = simple.Show(cls.source, cls.bcc_view)
        cls.bcc.SetRepresentationType("BCC Volume")
        cls.reference = simple.Show(cls.image, cls.image_view)
        cls.reference.SetRepresentationType("Volume")
        for display in cls.bcc, cls.reference:
            simple.ColorBy(display, ("POINTS", "Scalars"))
            display.ScalarOpacityUnitDistance = 0.05
        for view in cls.bcc_view, cls.image_view:
            view.CameraPosition = [2, -5, 3]
            view.CameraFocalPoint = [0, 0, 0]
            view.CameraViewUp = [0, 0, 1]

    def compare(self, name, limit):
        a = views.take_picture(self.bcc_view, f"{name}BCC")
        b = views.take_picture(self.image_view, f"{name}Cartesian")
        self.assertGreater(views.get_shown(a).mean(), 0.01)
        self.assertLess(views.differ(a, b), limit)
        return a

    def test_composite(self):
        self.bcc.BCCBlendMode = "Composite"
        self.reference.BlendMode = "Composite"
        self.bcc.BCCShade = self.reference.Shade = 0
        first = self.compare("Composite", 6)
        # The colour map editor is shared by every representation of an image.
        table = simple.GetColorTransferFunction("Scalars")
        self.addCleanup(setattr, table, "RGBPoints", list(table.RGBPoints))
        table.RGBPoints = [0, 1, 1, 0, 1, 0, 1, 0]
        second = self.compare("CompositeColours", 6)
        self.assertGreater(views.differ(first, second), 20)
        opacity = simple.GetOpacityTransferFunction("Scalars")
        self.addCleanup(setattr, opacity, "Points", list(opacity.Points))
        opacity.Points = [0, 0, 0.5, 0, 0.8, 0, 0.5, 0, 1, 1, 0.5, 0]
        third = self.compare("CompositeOpacity", 6)
        self.assertGreater(views.differ(first, third), 20)

    def test_isosurface(self):
        self.bcc.BCCBlendMode = "Isosurface"
        self.reference.BlendMode = "Isosurface"
        self.bcc.BCCIsosurfaceValues = self.reference.IsosurfaceValues = [0.3]
        for shade in 0, 1:
            self.bcc.BCCShade = self.reference.Shade = shade
            self.compare(f"Isosurface{shade}", 8)

    def test_slice(self):
        self.bcc.BCCBlendMode = "Slice"
        self.reference.BlendMode = "Slice"
        for function in self.bcc.BCCSliceFunction, self.reference.SliceFunction:
            function.Origin = [0, 0, 0]
            function.Normal = [0.2, 1, 0.3]
        self.compare("Slice", 6)

    def test_maximum(self):
        self.bcc.BCCBlendMode = "Maximum intensity"
        picture = views.take_picture(self.bcc_view, "Maximum")
        self.assertGreater(views.get_shown(picture).mean(), 0.1)
        self.bcc.BCCKernel = "bcc4, linear"
        other = views.take_picture(self.bcc_view, "MaximumLinear")
        self.assertGreater(views.differ(picture, other), 0.01)
        self.bcc.BCCKernel = "bcc7, quartic"

    def test_cropping(self):
        self.bcc.BCCBlendMode = "Composite"
        whole = views.get_shown(views.take_picture(self.bcc_view, "Whole"))
        self.bcc.UseCropping = 1
        self.bcc.CroppingScale = [0.3, 0.3, 0.3]
        part = views.get_shown(views.take_picture(self.bcc_view, "Cropped"))
        self.bcc.UseCropping = 0
        self.bcc.CroppingScale = [1, 1, 1]
        self.assertLess(part.sum(), 0.5 * whole.sum())
        self.assertGreater(part.sum(), 100)
        self.assertFalse((part & ~whole).any())


if __name__ == "__main__":
    views.run()
