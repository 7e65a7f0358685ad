# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of progressive pictures share."""
import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import scenes
from bravais import vtkBCCVolumeMapper

SIZE = 61  # No multiple of a block.


def wave(x, y, z):
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


VOLUME = scenes.make_bcc(wave, (12, 12, 24))


def make_scene(blend="MaximumIntensity", pattern="None", size=SIZE):
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(VOLUME)
    mapper.SetKernelToBCC4()
    getattr(mapper, f"SetBlendModeTo{blend}")()
    getattr(mapper, f"SetJitterPatternTo{pattern}")()
    volume_property = scenes.make_property(
        -1, 1, ((-1, 0), (0, 0), (0.3, 0.8), (0.5, 0.1), (1, 0.9)) if blend == "Composite" else
        ((-1, 0.3), (1, 1)), shade=blend == "IsoSurface", iso_values=(-0.5, 0.3))
    plane = vtkPlane()
    plane.SetNormal(0.5, 0.3, 1)
    volume_property.SetSliceFunction(plane)
    return scenes.Scene(mapper, volume_property, size, sample_distance=0.06)


def add_sphere(scene, x=0.3, opacity=1):
    """A sphere partly before the volume and partly in it."""
    source = vtkSphereSource()
    source.SetRadius(0.5)
    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    actor.GetMapper().SetInputConnection(source.GetOutputPort())
    actor.SetPosition(x, 0.3, 1)
    actor.GetProperty().SetOpacity(opacity)
    scene.renderer.AddActor(actor)
    return actor


def refine(scene, mappers=None):
    """Renders until all is complete: the number of passes."""
    mappers = mappers or [scene.volume.GetMapper()]
    for passes in range(1, 200):
        scene.window.Render()
        if all(mapper.GetProgressComplete() for mapper in mappers):
            return passes
    return None


def completes(test, scene, size=4):
    """As many passes as cells, one event, and the picture that is drawn at once."""
    mapper = scene.volume.GetMapper()
    mapper.ProgressiveRefinementOff()
    plain = scene.render()
    test.assertTrue(mapper.GetProgressComplete())
    test.assertGreater(plain.std(axis=(0, 1)).max(), 3, "nothing to see")
    events = []
    tag = mapper.AddObserver(
        mapper.ProgressCompleteEvent, lambda *unused: events.append(number))
    mapper.ProgressiveRefinementOn()
    mapper.SetProgressivePatternSize(size)
    for number in range(size * size):
        picture = scene.render()
        test.assertEqual(mapper.GetProgressComplete(), number == size * size - 1)
        if number == 0:
            test.assertGreater(numpy.abs(picture - plain).max(), 0)
    numpy.testing.assert_array_equal(picture, plain)
    number += 1
    numpy.testing.assert_array_equal(scene.render(), plain)
    test.assertTrue(mapper.GetProgressComplete())
    mapper.RemoveObserver(tag)
    test.assertEqual(events, [size * size - 1])
