# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of volumes: cut, rendered one by one, and blended front to back."""
import itertools

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkExtentTranslator

import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper


def split(extent, counts):
    """The extents of counts[0] x counts[1] x counts[2] pieces, neighbours of which share a layer."""
    axes = []
    for axis, count in enumerate(counts):
        low, high = extent[2 * axis], extent[2 * axis + 1]
        cuts = [low + (high - low) * n // count for n in range(count + 1)]
        axes.append(list(zip(cuts[:-1], cuts[1:])))
    return [x + y + z for x, y, z in itertools.product(*axes)]


def split_as_pipeline(extent, piece, count):
    """The extent of a numbered piece, without ghosts."""
    translator = vtkExtentTranslator()
    result = [0] * 6
    translator.PieceToExtentThreadSafe(piece, count, 0, extent, result, 3, 0)
    return result


def hold(whole, own, ghosts):
    """A piece of an image with so many ghosts, without the marks of one."""
    extent = whole.GetExtent()
    held = [max(own[n] - ghosts, extent[n]) if n % 2 == 0 else min(own[n] + ghosts, extent[n])
            for n in range(6)]
    piece = vtkImageData()
    piece.DeepCopy(whole)
    piece.Crop(held)
    return piece


def cut(whole, own, ghosts):
    """A marked piece of an image."""
    piece = hold(whole, own, ghosts)
    vtkBCCLattice.MarkPiece(piece, whole.GetExtent(), own)
    scalars = whole.GetPointData().GetScalars()
    for component in range(scalars.GetNumberOfComponents()):
        vtkBCCLattice.MarkWholeRange(piece, "Scalars", component, scalars.GetRange(component))
    return piece


def make_scene(image, mode, volume_property, prepare=None, size=40, sample_distance=0.06):
    """A scene on a transparent background; prepare(scene, mapper) makes it special."""
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(image)
    getattr(mapper, "SetBlendModeTo" + mode)()
    scene = scenes.Scene(mapper, volume_property, size=size, sample_distance=sample_distance)
    scene.window.SetAlphaBitPlanes(1)
    scene.renderer.SetBackground(0, 0, 0)
    scene.renderer.SetBackgroundAlpha(0)
    if prepare:
        prepare(scene, mapper)
    scene.renderer.ResetCameraClippingRange(scenes.BOX)
    return scene


def take(scene):
    """Red, green and blue times alpha, and alpha, from 0 to 255."""
    scene.window.Render()
    colors = vtkFloatArray()
    last = scene.size - 1
    scene.window.GetRGBAPixelData(0, 0, last, last, 0, colors)
    return 255 * vtk_to_numpy(colors).reshape(scene.size, scene.size, 4).astype(float)


def sort(extents, image, eye):
    """Front to back. Pieces of a grid of equal boxes are so by their middles' distances."""
    def measure(extent):
        middle = [image.GetOrigin()[a] + image.GetSpacing()[a] * sum(extent[2 * a:2 * a + 2]) / 2
                  for a in range(3)]
        return numpy.linalg.norm(numpy.subtract(middle, eye))
    return sorted(extents, key=measure)


def blend(pictures):
    """Pictures front to back."""
    result = numpy.zeros_like(pictures[0])
    for picture in pictures:
        result += (1 - result[..., 3:] / 255) * picture
    return result
