# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/volume-mapper.md has each property, no other, and tests that are there."""
import os
import re
import unittest

import numpy
from vtkmodules.vtkRenderingCore import vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper, vtkVolumeMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import comparison

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = os.path.join(HERE, "..", "..", "Documentation", "volume-mapper.md")
CLASSES = (vtkVolumeMapper, vtkGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper,
           vtkVolumeProperty)


def get_properties(cls):
    """What it has setters for itself; SetXToY() is one for X."""
    names = [name[3:] for name in vars(cls) if name.startswith("Set")]
    return {name for name in names if not any(name.startswith(other + "To") for other in names)}


def read_tables():
    """Of each section: property, text and tests of the rows."""
    with open(PAGE, encoding="utf-8") as file:
        sections = re.split(r"^## ", file.read(), flags=re.M)[1:]
    return {section.split("\n", 1)[0]: re.findall(
        r"^\| (\w+) \| (.*) \| (.*) \|$", section, flags=re.M)[1:] for section in sections}


class TestBCCVolumeMapperTable(unittest.TestCase):
    def test_every_property_has_a_row(self):
        tables = read_tables()
        for cls in CLASSES:
            names = [row[0] for row in tables[cls.__name__]]
            self.assertEqual(len(set(names)), len(names))
            self.assertEqual(set(names), get_properties(cls), cls.__name__)

    def test_every_row_has_tests(self):
        for rows in read_tables().values():
            for name, text, tests in rows:
                for test in tests.split(", "):
                    path = os.path.join(HERE, f"TestBCCVolumeMapper{test}.py")
                    self.assertTrue(os.path.exists(path), f"{name}: {test}")
                self.assertRegex(text, r"^(yes|no|as with VTK|likewise|kept|see)\b", name)

    def test_what_vtk_does_not_look_at_changes_nothing(self):
        def change(scene, mapper, volume_property):
            mapper.SetMinimumImageSampleDistance(3)
            mapper.SetMaximumImageSampleDistance(5)
            mapper.SetMaxMemoryFraction(0.5)
            mapper.SetReportProgress(False)
        plain = [scene.render() for scene in comparison.make_scenes("Composite")]
        for scene, picture in zip(comparison.make_scenes("Composite", change), plain):
            numpy.testing.assert_array_equal(scene.render(), picture)

    def test_interpolation_type(self):
        def change(scene, mapper, volume_property):
            volume_property.SetInterpolationTypeToNearest()
        picture = comparison.make_scenes("Composite", change)[1].render()
        plain = comparison.make_scenes("Composite")[1].render()
        self.assertLess(numpy.abs(picture - plain).mean(), 1.0)

    def test_shared_depth_texture(self):
        first, second = (comparison.make_scenes("Composite")[1] for _ in range(2))
        plain = first.render()
        second.window.RemoveRenderer(second.renderer)
        second.volume.GetMapper().SetSharedDepthTexture(first.volume.GetMapper().GetDepthTexture())
        first.renderer.RemoveVolume(first.volume)
        first.renderer.AddVolume(second.volume)
        numpy.testing.assert_array_equal(first.render(), plain)


if __name__ == "__main__":
    unittest.main()
