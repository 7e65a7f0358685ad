# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes are shaded by the scene's lights, on normals that do not depend on the volume's box."""
import math
import unittest

import numpy
from vtkmodules.vtkRenderingCore import vtkLight

import comparison
import scenes
from bravais import vtkBCCVolumeMapper


def make_light(kind, position, color=(1, 1, 1), intensity=1, cone=None, attenuation=None):
    light = vtkLight()
    getattr(light, "SetLightTypeTo" + kind)()
    light.SetPosition(position)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(color)
    light.SetIntensity(intensity)
    if cone:
        light.PositionalOn()
        light.SetConeAngle(cone)
        light.SetAttenuationValues(attenuation or (1, 0, 0))
    return light


LIGHTS = {
    "none": (),
    "headlight": (("Headlight", (0, 0, 1), (1, 0.8, 0.6)),),
    "dim headlight": (("Headlight", (0, 0, 1), (1, 1, 1), 0.4),),
    "camera light": (("CameraLight", (1, 1, 1)),),
    "two": (("SceneLight", (3, 3, 3), (1, 0.5, 0.2)), ("SceneLight", (-3, 1, 2), (0, 0.5, 1))),
    "headlight and another": (("Headlight", (0, 0, 1)), ("SceneLight", (-3, 1, 2), (0, 0.5, 1))),
    "positional": (("SceneLight", (2, 2, 2), (1, 1, 1), 1, 180, (0.2, 0.1, 0.1)),),
    "spot": (("SceneLight", (2, 2, 2), (1, 1, 1), 1, 20),),
    "positional, then others": (
        ("SceneLight", (2, 2, 2), (1, 0, 0), 1, 180), ("SceneLight", (-3, 1, 2), (0, 1, 0)),
        ("SceneLight", (0, -3, 2), (0, 0, 1)))}


def set_lights(scene, name):
    scene.renderer.RemoveAllLights()
    scene.renderer.SetAutomaticLightCreation(False)
    for light in LIGHTS[name]:
        scene.renderer.AddLight(make_light(*light))


def ball(x, y, z):
    return x * x + y * y + z * z


def make_ball(image):
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(image)
    mapper.SetBlendModeToIsoSurface()
    return scenes.Scene(mapper, scenes.make_property(0, 3, ((0, 1), (3, 1)), iso_values=(0.36,)),
                        size=64, sample_distance=0.05)


class TestBCCVolumeMapperLights(unittest.TestCase):
    def test_lights_are_as_with_vtk(self):
        for mode, names in (("Composite", LIGHTS), ("IsoSurface", ("two", "spot"))):
            pair = comparison.make_scenes(mode)
            seen = []
            for name in names:
                with self.subTest(name, mode=mode):
                    for scene in pair:
                        set_lights(scene, name)
                    # VTK's own mapper takes no notice of changed lights.
                    pair[0].volume.GetMapper().Modified()
                    pictures = [scene.render() for scene in pair]
                    self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 1.2)
                    self.assertFalse(any((pictures[1] == other).all() for other in seen))
                    seen.append(pictures[1])

    def test_lights_on_differences(self):
        """With VTK's gradients, on normals that follow the box and the direction matrix, too."""
        pair = comparison.make_scenes("Composite", size=40)
        pair[1].volume.GetMapper().AnalyticGradientsOff()
        for scene in pair:
            set_lights(scene, "two")
        difference = numpy.abs(pair[1].render() - pair[0].render())
        self.assertLess(difference.mean(), 1.6)
        box = scenes.make_bcc(ball, (40, 20, 30), (-2, 2, -1, 1, -0.75, 0.75))
        box.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        box.SetOrigin(1, -2, -0.75)
        for name in "two", "positional":
            scene = make_ball(box)
            set_lights(scene, name)
            exact = scene.render()
            self.assertGreater(exact.std(axis=(0, 1)).max(), 10)
            scene.volume.GetMapper().AnalyticGradientsOff()
            self.assertLess(numpy.abs(scene.render() - exact).mean(), 0.5, name)

    def test_lights_may_change(self):
        """What comes after other lights looks as if there had been none of them."""
        scene = comparison.make_scenes("Composite")[1]
        for name in ("positional", "two", "headlight", "none", "headlight and another"):
            set_lights(scene, name)
            fresh = comparison.make_scenes("Composite")[1]
            set_lights(fresh, name)
            difference = numpy.abs(scene.render() - fresh.render())
            self.assertLessEqual(difference.max(), 1, name)

    def test_materials(self):
        def prepare(scene, mapper, volume_property):
            volume_property.SetAmbient(0.3)
            volume_property.SetDiffuse(0.5)
            volume_property.SetSpecular(0.6)
            volume_property.SetSpecularPower(20)
            scene.renderer.TwoSidedLightingOff()
        for mode in "Composite", "IsoSurface":
            comparison.compare(self, mode, 1.2, prepare)

    def test_normals_do_not_depend_on_the_box(self):
        cube = scenes.make_bcc(ball, (20, 20, 40))
        box = scenes.make_bcc(ball, (40, 20, 30), (-2, 2, -1, 1, -0.75, 0.75))
        for name in "headlight", "two", "positional":
            pictures = []
            for image in cube, box:
                scene = make_ball(image)
                set_lights(scene, name)
                pictures.append(scene.render())
            self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
            self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 0.1, name)

    def test_normals_follow_the_direction_matrix_and_the_volume(self):
        upright = scenes.make_bcc(ball, (20, 20, 40))
        turned = upright.NewInstance()
        turned.DeepCopy(upright)
        cosine, sine = math.cos(0.8), math.sin(0.8)
        turned.SetDirectionMatrix(cosine, -sine, 0, sine, cosine, 0, 0, 0, 1)
        turned.SetOrigin(-cosine + sine, -sine - cosine, -1)
        for name in "headlight", "two", "positional":
            pictures = []
            for image, angle in (upright, 0), (turned, 0), (upright, 50), (turned, -20):
                scene = make_ball(image)
                scene.volume.RotateWXYZ(angle, 1, 2, 3)
                set_lights(scene, name)
                pictures.append(scene.render())
            for picture in pictures[1:]:
                self.assertLess(numpy.abs(picture - pictures[0]).mean(), 0.1, name)


if __name__ == "__main__":
    unittest.main()
