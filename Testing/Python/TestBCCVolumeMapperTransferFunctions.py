# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Transfer functions of one and two dimensions, their ranges, and what else tells a sample's colour."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

import comparison
import scenes
from bravais import vtkBCCVolumeMapper

def make_2d_function(edge):
    """Colours by the scalar, along x, and opacities by the gradient too, along y."""
    size = 128
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.AllocateScalars(VTK_FLOAT, 4)
    table = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(size, size, 4)
    y, x = numpy.indices((size, size)) / (size - 1)
    table[...] = numpy.stack((x, 0.3 + 0 * x, 1 - x, 0 * x), axis=-1)
    # Rows are magnitudes up to a quarter of the range of 2, per cell edge.
    steepness = y * 0.5 / edge
    table[..., 3] = (x > 0.6) * numpy.clip(steepness / 3 - 0.2, 0, 0.8)
    return image


class TestBCCVolumeMapperTransferFunctions(unittest.TestCase):
    def test_two_dimensions(self):
        def prepare(scene, mapper, volume_property):
            volume_property.SetTransferFunction2D(make_2d_function(comparison.get_edge(mapper)))
        for shade in False, True:
            comparison.compare(self, "Composite", 1.2, prepare, shade=shade)

    def test_gradient_opacity(self):
        def prepare(scene, mapper, volume_property):
            function = vtkPiecewiseFunction()
            for steepness, opacity in ((0.5, 0), (2.5, 1)):
                function.AddPoint(steepness * comparison.get_edge(mapper), opacity)
            volume_property.SetGradientOpacity(function)
        comparison.compare(self, "Composite", 1.0, prepare)
        comparison.compare(self, "Composite", 1.0, prepare, shade=False)

        def disable(scene, mapper, volume_property):
            prepare(scene, mapper, volume_property)
            volume_property.DisableGradientOpacityOn()
        comparison.compare(self, "Composite", 1.0, disable, change=False)
        plain = comparison.make_scenes("Composite")[1].render()
        numpy.testing.assert_array_equal(
            comparison.make_scenes("Composite", disable)[1].render(), plain)

    def test_gradients_of_large_values_in_small_volumes(self):
        """Floats do not hold their squares."""
        pictures = []
        for factor, edge in (1, 1), (1e18, 1e-3), (1e-15, 1e3):
            box = [edge * b for b in scenes.BOX]
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(scenes.make_bcc(
                lambda x, y, z: factor * comparison.wave(x / edge, y / edge, z / edge),
                (12, 12, 24), box))
            volume_property = scenes.make_property(
                -factor, factor, [(factor * x, a) for x, a in comparison.OPACITIES])
            function = vtkPiecewiseFunction()
            for steepness, opacity in ((0.05, 0), (0.25, 1)):
                function.AddPoint(factor * steepness, opacity)
            volume_property.SetGradientOpacity(function)
            volume_property.SetScalarOpacityUnitDistance(0.1 * edge)
            scene = scenes.Scene(mapper, volume_property, size=48, sample_distance=0.04 * edge)
            scene.renderer.ResetCamera(box)
            pictures.append(scene.render())
        self.assertGreater(pictures[0].std(), 5)
        for picture in pictures[1:]:
            self.assertLess(numpy.abs(picture - pictures[0]).mean(), 0.1)

    def test_range_types(self):
        def make(color, opacity, gradient):
            def prepare(scene, mapper, volume_property):
                mapper.SetColorRangeType(color)
                mapper.SetScalarOpacityRangeType(opacity)
                mapper.SetGradientOpacityRangeType(gradient)
                colors = vtkColorTransferFunction()  # narrower than the scalars' range
                colors.AddRGBPoint(0.2, 0, 0, 1)
                colors.AddRGBPoint(0.6, 1, 0.5, 0)
                volume_property.SetColor(colors)
                function = vtkPiecewiseFunction()
                function.AddPoint(0.1, 0)
                function.AddPoint(0.5, 0.9)
                volume_property.SetScalarOpacity(function)
                if gradient:
                    function = vtkPiecewiseFunction()
                    function.AddPoint(0, 0)
                    function.AddPoint(0.3, 1)
                    volume_property.SetGradientOpacity(function)
            return prepare
        for types in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1)):
            with self.subTest(types=types):
                comparison.compare(self, "Composite", 1.2, make(*types))

    def test_unit_distance(self):
        def prepare(scene, mapper, volume_property):
            volume_property.SetScalarOpacityUnitDistance(0.4)
        comparison.compare(self, "Composite", 0.8, prepare)

    def test_range_of_averages(self):
        def prepare(scene, mapper, volume_property):
            mapper.SetAverageIPScalarRange(-0.2, 0.5)
        comparison.compare(self, "AverageIntensity", 0.8, prepare, shade=False)

    def test_final_window_and_level(self):
        def prepare(scene, mapper, volume_property):
            mapper.SetFinalColorWindow(0.5)
            mapper.SetFinalColorLevel(0.6)
        comparison.compare(self, "Composite", 0.8, prepare)

    def test_isosurfaces_have_their_own_colors_and_opacities(self):
        def prepare(scene, mapper, volume_property):
            colors, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
            for value, color, alpha in ((-0.6, (1, 0, 0), 0.2), (-0.2, (0, 1, 0), 0.4),
                                        (0.2, (0, 0, 1), 0.6), (0.6, (1, 1, 0), 0.9)):
                for side in -0.1, 0.1:
                    colors.AddRGBPoint(value + side, *color)
                    opacity.AddPoint(value + side, alpha)
            volume_property.SetColor(colors)
            volume_property.SetScalarOpacity(opacity)
            values = volume_property.GetIsoSurfaceValues()
            values.SetNumberOfContours(0)
            for number, value in enumerate((0.2, -0.6, 0.6, -0.2)):  # in any order
                values.SetValue(number, value)
        comparison.compare(self, "IsoSurface", 1.6, prepare)

    def test_functions_of_one_point(self):
        """One colour, and one opacity, for all isovalues and all scalars, within the range or not."""
        for value in -5, -1, 0, 0.3, 1, 7:
            def prepare(scene, mapper, volume_property):
                colors, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
                colors.AddRGBPoint(value, 1, 0.5, 0.2)
                opacity.AddPoint(value, 0.7)
                volume_property.SetColor(colors)
                volume_property.SetScalarOpacity(opacity)
                volume_property.ShadeOff()
            for mode in "IsoSurface", "MaximumIntensity":
                with self.subTest(value=value, mode=mode):
                    _, pictures = comparison.compare(self, mode, 1.2, prepare, change=False)
                    self.assertGreater(pictures[1].max(), 150)

    def test_slices_lie_where_they_are_asked_for(self):
        """In a volume that is scaled, and cut by clipping planes: world positions tell the values."""
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(scenes.make_bcc(lambda x, y, z: x, (8, 8, 16)))
        mapper.SetBlendModeToSlice()
        volume_property = scenes.make_property(-1, 1, ((-1, 1), (1, 1)), shade=False)
        grays = vtkColorTransferFunction()
        grays.AddRGBPoint(-1, 0, 0, 0)
        grays.AddRGBPoint(1, 1, 1, 1)
        volume_property.SetColor(grays)
        plane, cut = vtkPlane(), vtkPlane()
        plane.SetNormal(0.6, 0.3, 1)
        volume_property.SetSliceFunction(plane)
        cut.SetOrigin(0.1, 0, 0)
        cut.SetNormal(-1, 0.5, 0)
        mapper.AddClippingPlane(cut)
        scene = scenes.Scene(mapper, volume_property, size=60)
        scene.volume.SetScale(0.8, 0.7, 2)
        scene.renderer.SetBackground(1, 0, 0)
        scene.look_along_z()
        picture = scene.render()
        y, x = ((n + 0.5) / 30 - 1 for n in numpy.indices((60, 60)))
        z = -0.6 * x - 0.3 * y
        distance = numpy.min((0.8 - abs(x), 0.7 - abs(y), 2 - abs(z), 0.5 * y + 0.1 - x), axis=0)
        shown = distance > 0.02
        self.assertGreater(shown.sum(), 300)
        numpy.testing.assert_allclose(
            picture[shown], numpy.repeat(127.5 * (x[shown] / 0.8 + 1)[:, None], 3, 1), atol=4)
        numpy.testing.assert_array_equal(picture[distance < -0.02][:, 1:], 0)

    def test_slices_are_shaded_and_translucent(self):
        def prepare(scene, mapper, volume_property):
            plane = vtkPlane()
            plane.SetOrigin(0.1, 0, 0)
            plane.SetNormal(0.3, 0.2, 1)
            volume_property.SetSliceFunction(plane)
        for shade in False, True:
            comparison.compare(self, "Slice", 1.2, prepare, change=False, shade=shade,
                               opacities=((-1, 0.2), (1, 0.9)))


if __name__ == "__main__":
    unittest.main()
