# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a BCC volume are those that VTK's mapper makes of the same function on a fine grid."""
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import scenes
from bravais import vtkBCCVolumeMapper

KERNELS = (4, 7, 8, 12)
OPACITIES = ((-1, 0), (0, 0), (0.3, 0.8), (0.5, 0.1), (1, 0.9))


def wave(x, y, z):
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


def render(mapper, image, mode, volume_property, sample_distance=0.03):
    mapper.SetInputData(image)
    getattr(mapper, "SetBlendModeTo" + mode)()
    return scenes.Scene(mapper, volume_property, sample_distance=sample_distance).render()


class TestBCCVolumeMapperBlendModes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bcc = scenes.make_bcc(wave)
        cls.cartesian = scenes.make_cartesian(wave)

    def compare(self, mode, volume_property, tolerance, reference_distance=0.03):
        reference = render(vtkOpenGLGPUVolumeRayCastMapper(), self.cartesian, mode,
                           volume_property, reference_distance)
        self.assertGreater(reference.std(axis=(0, 1)).max(), 10, "nothing to see")
        for kernel in KERNELS:
            for analytic in (False, True) if volume_property.GetShade() else (True,):
                mapper = vtkBCCVolumeMapper()
                mapper.SetKernel(kernel)
                mapper.SetAnalyticGradients(analytic)
                picture = render(mapper, self.bcc, mode, volume_property)
                difference = numpy.abs(picture - reference).mean()
                # bcc4 is linear, and coarse at this number of samples.
                self.assertLess(difference, tolerance * (3 if kernel == 4 else 1),
                                f"{mode}, bcc{kernel}, analytic {analytic}")

    def test_composite(self):
        self.compare("Composite", scenes.make_property(-1, 1, OPACITIES, shade=False), 0.5)

    def test_composite_with_shading(self):
        self.compare("Composite", scenes.make_property(-1, 1, OPACITIES), 0.9)

    def test_maximum_intensity(self):
        self.compare("MaximumIntensity",
                     scenes.make_property(-1, 1, ((-1, 0.2), (1, 1)), shade=False), 0.5)

    def test_minimum_intensity(self):
        self.compare("MinimumIntensity",
                     scenes.make_property(-1, 1, ((-1, 0.8), (1, 0.1)), shade=False), 0.5)

    def test_minimum_intensity_of_independent_components(self):
        """Half of each of two components that are the same is one; VTK's are neither least nor opaque."""
        pictures = []
        for count in 1, 2:
            image = scenes.make_bcc(lambda *x: numpy.stack([wave(*x)] * count, axis=-1))
            volume_property = scenes.make_property(-1, 1, ((-1, 0.8), (1, 0.1)), shade=False)
            for component in range(count):
                volume_property.SetColor(component, volume_property.GetRGBTransferFunction(0))
                volume_property.SetScalarOpacity(component, volume_property.GetScalarOpacity(0))
                volume_property.SetComponentWeight(component, 1 / count)
            pictures.append(
                render(vtkBCCVolumeMapper(), image, "MinimumIntensity", volume_property))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5)
        self.assertLessEqual(numpy.abs(pictures[1].astype(int) - pictures[0]).max(), 1)

    def test_average_intensity(self):
        self.compare("AverageIntensity",
                     scenes.make_property(-1, 1, ((-1, 0.5), (1, 1)), shade=False), 0.5)

    def test_additive(self):
        self.compare("Additive",
                     scenes.make_property(-1, 1, ((-1, 0), (1, 0.03)), shade=False), 0.5)

    def test_slice(self):
        plane = vtkPlane()
        plane.SetNormal(0.5, 0.3, 1)
        volume_property = scenes.make_property(-1, 1, ((-1, 1), (1, 1)), shade=False)
        volume_property.SetSliceFunction(plane)
        self.compare("Slice", volume_property, 0.5)

    def test_isosurface(self):
        # VTK shades at the sample after a surface: it gets short steps.
        self.compare("IsoSurface", scenes.make_property(
            -1, 1, ((-1, 0.3), (1, 1)), iso_values=(-0.5, 0.3, 0.7)), 1.2, 0.006)

    def test_baseline(self):
        window = scenes.make_window(240, 240)
        for number, (kernel, mode) in enumerate(zip(
                KERNELS, ("Composite", "MaximumIntensity", "IsoSurface", "Composite"))):
            mapper = vtkBCCVolumeMapper()
            mapper.SetKernel(kernel)
            mapper.SetInputData(self.bcc)
            getattr(mapper, "SetBlendModeTo" + mode)()
            scene = scenes.Scene(mapper, scenes.make_property(
                -1, 1, OPACITIES if mode == "Composite" else ((-1, 0.3), (1, 1)),
                shade=mode != "MaximumIntensity", iso_values=(-0.5, 0.3)))
            left, bottom = number % 2 / 2, number // 2 / 2
            scene.renderer.SetViewport(left, bottom, left + 0.5, bottom + 0.5)
            scene.window.RemoveRenderer(scene.renderer)
            window.AddRenderer(scene.renderer)
        window.Render()
        scenes.check_baseline(self, window)


if __name__ == "__main__":
    unittest.main()
