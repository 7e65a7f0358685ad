# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a BCC volume beside those that VTK's mapper makes of the same function on a fine grid."""
import numpy
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import scenes
from bravais import vtkBCCVolumeMapper

OPACITIES = ((-1, 0), (0, 0), (0.3, 0.8), (0.5, 0.1), (1, 0.9))


def wave(x, y, z):
    """From -1 to 1."""
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


BCC = scenes.make_bcc(wave)
CARTESIAN = scenes.make_cartesian(wave, (80, 80, 80))
plain_pictures = {}


def get_edge(mapper):
    """The average edge of the cells that VTK measures gradients by, the stand-in's in a BCC volume."""
    if isinstance(mapper, vtkBCCVolumeMapper):
        return numpy.mean((2 / 24, 2 / 24, 2 / 47))
    return CARTESIAN.GetSpacing()[0]


def make_scenes(mode, prepare=None, size=64, sample_distance=0.04, bcc=BCC, cartesian=CARTESIAN,
                opacities=None, iso_values=(-0.5, 0.3, 0.7), shade=True):
    """A scene of each mapper, VTK's first; prepare(scene, mapper, property) makes them special."""
    result = []
    for mapper, image in ((vtkOpenGLGPUVolumeRayCastMapper(), cartesian),
                          (vtkBCCVolumeMapper(), bcc)):
        mapper.SetInputData(image)
        getattr(mapper, "SetBlendModeTo" + mode)()
        iso = mode == "IsoSurface"
        volume_property = scenes.make_property(
            -1, 1, opacities or (((-1, 0.3), (1, 1)) if iso else OPACITIES),
            shade=shade, iso_values=iso_values)
        # VTK shades at the sample after a surface: it gets short steps.
        distance = 0.006 if iso and not result else sample_distance
        scene = scenes.Scene(mapper, volume_property, size=size, sample_distance=distance)
        if prepare:
            prepare(scene, mapper, volume_property)
        result.append(scene)
    return result


def compare(test, mode, tolerance, prepare=None, change=True, **options):
    """
    The mean difference of 8-bit values is less than the tolerance. That what is compared does
    something is seen by how far the picture is from that of an unprepared scene, if it is to change.
    Returns the scenes and their pictures.
    """
    pair = make_scenes(mode, prepare, **options)
    pictures = [scene.render() for scene in pair]
    test.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5, "nothing to see")
    difference = numpy.abs(pictures[1] - pictures[0]).mean()
    test.assertLess(difference, tolerance)
    if prepare and change:
        key = mode, str(options)
        if key not in plain_pictures:
            plain_pictures[key] = make_scenes(mode, **options)[1].render()
        effect = numpy.abs(pictures[1] - plain_pictures[key]).mean()
        test.assertGreater(effect, 2 * difference, "no effect")
    return pair, pictures
