# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar types, named arrays and one to four components look as they do with VTK's mapper."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import scenes
from bravais import vtkBCCVolumeMapper

VTK_TYPES = range(2, 12)  # char to double
MORE_TYPES = (12, 15, 16, 17)  # id type, signed char, long long, unsigned long long


def distance(x, y, z):
    return 60 * numpy.sqrt(x * x + y * y + z * z)


def waves(components):
    """Values from 0 to 255, different in each component."""
    def function(x, y, z):
        return numpy.stack([127.5 + 127 * numpy.cos((2 + n) * x + n) * numpy.cos(3 * y - n * z)
                            for n in range(components)], axis=-1)
    return function


def make_components_property(count, independent, high=255):
    volume_property = scenes.make_property(0, high, ((0, 0), (high, 0.7)), shade=independent)
    volume_property.SetIndependentComponents(independent)
    for component in range(1, count if independent else 0):
        colors = vtkColorTransferFunction()
        colors.AddRGBPoint(0, 0, component / 4, 0)
        colors.AddRGBPoint(255, 1, 1 - component / 4, component / 3)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 0.1)
        opacity.AddPoint(200, 0)
        opacity.AddPoint(255, 0.5)
        volume_property.SetColor(component, colors)
        volume_property.SetScalarOpacity(component, opacity)
        volume_property.SetComponentWeight(component, 1 - 0.2 * component)
    return volume_property


def render(mapper, image, volume_property, mode="Composite"):
    mapper.SetInputData(image)
    getattr(mapper, "SetBlendModeTo" + mode)()
    return scenes.Scene(mapper, volume_property, size=100, sample_distance=0.04).render()


class TestBCCVolumeMapperScalars(unittest.TestCase):
    def test_every_scalar_type(self):
        volume_property = scenes.make_property(0, 104, ((0, 1), (40, 0.9), (60, 0.1), (104, 0)))
        source = scenes.make_bcc(lambda x, y, z: numpy.floor(distance(x, y, z)))
        reference = render(vtkBCCVolumeMapper(), source, volume_property)
        self.assertGreater(reference.std(axis=(0, 1)).max(), 10)
        for data_type in (*VTK_TYPES, *MORE_TYPES):
            image = source.NewInstance()
            image.ShallowCopy(source)
            scalars = vtkDataArray.CreateDataArray(data_type)
            scalars.DeepCopy(source.GetPointData().GetScalars())
            image.GetPointData().SetScalars(scalars)
            picture = render(vtkBCCVolumeMapper(), image, volume_property)
            numpy.testing.assert_allclose(
                picture, reference, atol=1, err_msg=scalars.GetClassName())

    def test_named_array(self):
        volume_property = scenes.make_property(0, 104, ((0, 1), (40, 0.9), (60, 0.1), (104, 0)))
        image = scenes.make_bcc(distance)
        reference = render(vtkBCCVolumeMapper(), image, volume_property)
        wanted = image.GetPointData().GetScalars()
        other = wanted.NewInstance()
        other.DeepCopy(wanted)
        other.Fill(50)
        other.SetName("Other")
        wanted.SetName("Wanted")
        image.GetPointData().SetScalars(other)
        image.GetPointData().AddArray(wanted)
        mapper = vtkBCCVolumeMapper()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectScalarArray("Wanted")
        numpy.testing.assert_array_equal(render(mapper, image, volume_property), reference)
        mapper = vtkBCCVolumeMapper()
        self.assertGreater(
            numpy.abs(render(mapper, image, volume_property) - reference).mean(), 5)

    def compare(self, count, independent, mode="Composite", dtype=numpy.uint8, tolerance=1.0):
        function = waves(count)
        pictures = []
        for mapper, image in (
                (vtkOpenGLGPUVolumeRayCastMapper(),
                 scenes.make_cartesian(function, (64, 64, 64), dtype=dtype)),
                (vtkBCCVolumeMapper(), scenes.make_bcc(function, dtype=dtype))):
            volume_property = make_components_property(count, independent)
            for component, value in enumerate((90, 180)):
                volume_property.GetIsoSurfaceValues().SetValue(component, value)
            pictures.append(render(mapper, image, volume_property, mode))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), tolerance)

    def test_independent_components(self):
        for count in (2, 3, 4):
            for mode in ("Composite", "MaximumIntensity"):
                with self.subTest(count=count, mode=mode):
                    self.compare(count, True, mode)

    def test_dependent_components(self):
        for count in (2, 4):
            with self.subTest(count=count):
                self.compare(count, False)

    def test_dependent_colors_of_short_integers(self):
        def function(x, y, z):
            return 257 * waves(4)(x, y, z)
        image = scenes.make_bcc(function, dtype=numpy.uint16)
        picture = render(vtkBCCVolumeMapper(), image, make_components_property(4, False, 257 * 255))
        image = scenes.make_bcc(waves(4), dtype=numpy.uint8)
        reference = render(vtkBCCVolumeMapper(), image, make_components_property(4, False))
        self.assertLess(numpy.abs(picture - reference).mean(), 1.0)

    def test_dependent_colors_of_types_that_vtk_scales(self):
        """Of 32 and 64 bits, but floats: each component's range makes a colour."""
        for dtype in (numpy.int32, numpy.float64):
            with self.subTest(dtype=dtype):
                self.compare(4, False, dtype=dtype)
                self.compare(4, False, "MaximumIntensity", dtype=dtype)

    def test_components_may_become_dependent(self):
        """And blend modes may follow one another: what is left from before shows nowhere."""
        image = scenes.make_bcc(waves(2), dtype=numpy.uint8)
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(image)
        volume_property = make_components_property(2, True)
        scene = scenes.Scene(mapper, volume_property, size=64, sample_distance=0.04)
        for independent, mode in ((True, "Composite"), (False, "Composite"), (False, "Additive"),
                                  (True, "Additive"), (True, "MaximumIntensity")):
            volume_property.SetIndependentComponents(independent)
            getattr(mapper, "SetBlendModeTo" + mode)()
            fresh = vtkBCCVolumeMapper()
            fresh.SetInputData(image)
            getattr(fresh, "SetBlendModeTo" + mode)()
            numpy.testing.assert_array_equal(scene.render(), scenes.Scene(
                fresh, volume_property, size=64, sample_distance=0.04).render())

    def test_components_may_become_more(self):
        """VTK's mapper crashes where nothing else tells of it."""
        def make(components):
            return scenes.make_bcc(lambda x, y, z: numpy.stack(
                [numpy.cos(3 * x + n) * numpy.cos(2 * y) for n in range(components)],
                axis=-1), (6, 6, 12))
        volume_property = scenes.make_property(-1, 1, ((-1, 0), (1, 0.8)))
        mapper = vtkBCCVolumeMapper()
        scene = scenes.Scene(mapper, volume_property, size=32, sample_distance=0.05)
        for components in 1, 4, 2, 3:
            mapper.SetInputData(make(components))
            fresh = vtkBCCVolumeMapper()
            fresh.SetInputData(make(components))
            numpy.testing.assert_array_equal(
                scene.render(), scenes.Scene(fresh, volume_property, 32, 0.05).render())

    def test_slices_of_independent_components(self):
        """VTK's shader for them does not compile. A component without weight is not seen."""
        plane = vtkPlane()
        plane.SetNormal(0.5, 0.3, 1)
        pictures = []
        for weights in ((1,), (1, 0), (0, 1), (1, 1)):
            image = scenes.make_bcc(waves(len(weights)))
            volume_property = make_components_property(len(weights), True)
            volume_property.SetSliceFunction(plane)
            for component, weight in enumerate(weights):
                volume_property.SetComponentWeight(component, weight)
            pictures.append(render(vtkBCCVolumeMapper(), image, volume_property, "Slice"))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
        numpy.testing.assert_array_equal(pictures[1], pictures[0])
        for other in pictures[:3]:
            self.assertGreater(numpy.abs(pictures[3] - other).mean(), 1)

    def test_isosurface_of_the_heaviest_component(self):
        image = scenes.make_bcc(waves(3), dtype=numpy.float32)
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        alone = scenes.make_bcc(lambda x, y, z: waves(3)(x, y, z)[..., 1])
        self.assertEqual(values.shape[1], 3)
        pictures = []
        for volume, count in ((alone, 1), (image, 3)):
            volume_property = scenes.make_property(
                0, 255, ((0, 1), (255, 1)), iso_values=(100, 160))
            if count == 3:
                for component in range(3):
                    volume_property.SetColor(component, volume_property.GetRGBTransferFunction(0))
                    volume_property.SetScalarOpacity(component, volume_property.GetScalarOpacity(0))
                    volume_property.SetShade(component, True)
                    volume_property.SetComponentWeight(component, 1 if component == 1 else 0.5)
            pictures.append(render(vtkBCCVolumeMapper(), volume, volume_property, "IsoSurface"))
        # The components' ranges differ a little, and with them the look-up tables.
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 1.0)

    def test_isovalues_are_of_the_heaviest_component(self):
        """Not in units of the first component's range, whatever that is."""
        pictures = []
        for factor in (1, 10):
            image = scenes.make_bcc(lambda x, y, z: waves(2)(x, y, z) * (factor, 1))
            volume_property = make_components_property(2, True)
            volume_property.SetComponentWeight(0, 0.5)
            volume_property.SetComponentWeight(1, 1)
            volume_property.GetIsoSurfaceValues().SetValue(0, 100)
            volume_property.GetIsoSurfaceValues().SetValue(1, 240)
            pictures.append(render(vtkBCCVolumeMapper(), image, volume_property, "IsoSurface"))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5)
        numpy.testing.assert_array_equal(pictures[1], pictures[0])


if __name__ == "__main__":
    unittest.main()
