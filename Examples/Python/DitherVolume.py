#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""An MRI volume at 4 levels, rendered by VTK: as it is, rounded, and dithered in 2D and 3D.

    DitherVolume.py FOLDER [--download] [--size PIXELS]

writes dither-volume.png to FOLDER. --download takes the head of Debian's mricron-data (Colin 27);
without it a head-like volume is generated.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkVolume, vtkVolumeProperty)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import debian
import pictures
from bravais import vtkOrderedDither

HEAD = "mricron-data", "usr/share/mricron/templates/ch2.nii.gz"
RANGE = 25, 220  # above the background's noise, up to what is nearly the brightest
LEVELS = 4
PATTERNS = {"rounded": (2, 0), "2D pattern": (2, 3), "3D pattern": (3, 3)}
DEPTH = 12.0  # optical depth of the volume's diagonal at the highest scalar


def read_head(path):
    reader = vtkNIFTIImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[::-1]), image.GetSpacing()


def generate():
    """A skull of soft edges round a brain that is denser at its base."""
    z, y, x = np.mgrid[-1:1:48j, -1:1:64j, -1:1:64j]
    radius = np.sqrt((x / 0.7) ** 2 + (y / 0.9) ** 2 + (z / 0.85) ** 2)
    skull = 156 * np.exp(-((radius - 0.88) / 0.06) ** 2)
    tissue = (138 - 65 * z) / (1 + np.exp((radius - 0.97) / 0.02))
    ventricles = 39 * np.exp(-((np.abs(x) - 0.15) ** 2 / 0.02 + y ** 2 / 0.1 + z ** 2 / 0.04))
    return np.clip(tissue + skull - ventricles - 80, 0, 255).astype(np.uint8), (4, 4, 4 * 63 / 47)


def to_volume(array, spacing):
    image = vtkImageData()
    image.SetDimensions(array.shape[::-1])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(array.ravel(), deep=True))
    return image


def quantize(image, dimensionality, log2_size):
    dither = vtkOrderedDither()
    dither.SetInputData(image)
    dither.SetInputRange(RANGE)
    dither.SetNumberOfLevels(LEVELS)
    dither.SetDimensionality(dimensionality)
    dither.SetPatternLog2Size(log2_size)
    dither.Update()
    return dither.GetOutput()


def make_renderer(image, lo, hi, viewport):
    """A haze whose density is proportional to the scalar above lo."""
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(min(image.GetSpacing()) / 2)
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(lo, 1.0, 0.8, 0.6)
    colors.AddRGBPoint(hi, 1.0, 1.0, 0.9)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(lo, 0.0)
    opacity.AddPoint(hi, 0.05)
    properties = vtkVolumeProperty()
    properties.SetColor(colors)
    properties.SetScalarOpacity(opacity)
    properties.SetScalarOpacityUnitDistance(image.GetLength() / DEPTH * 0.05)
    properties.SetInterpolationTypeToLinear()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(properties)
    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    renderer.SetBackground(0.1, 0.12, 0.15)
    renderer.AddVolume(volume)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1, -1.3, 0.5)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.45)
    return renderer


def get_error(original, image, block=4):
    """Root mean square of how far the means of cubes of so many points are off, in levels."""
    levels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(original.shape)
    wanted = (np.clip(original, *RANGE) - RANGE[0]) / (RANGE[1] - RANGE[0]) * (LEVELS - 1)
    n = [size // block for size in original.shape]
    difference = (levels - wanted)[tuple(slice(size * block) for size in n)]
    means = difference.reshape(n[0], block, n[1], block, n[2], block).mean(axis=(1, 3, 5))
    return np.sqrt((means ** 2).mean())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--download", action="store_true")
    parser.add_argument("--size", type=int, default=280)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    path = debian.fetch(*HEAD, options.folder / "data") if options.download else None
    array, spacing = read_head(path) if path else generate()
    original = to_volume(array, spacing)
    images = [quantize(original, *arguments) for arguments in PATTERNS.values()]
    renderers = [make_renderer(original, *RANGE, (0, 0.5, 0.5, 1))]
    for image, viewport in zip(images, ((0.5, 0.5, 1, 1), (0, 0, 0.5, 0.5), (0.5, 0, 1, 0.5))):
        renderers.append(make_renderer(image, 0, LEVELS - 1, viewport))
    n = options.size
    picture = pictures.render(renderers, (2 * n, 2 * n))
    panels = picture.astype(float).reshape(2, n, 2, n, 3).swapaxes(1, 2).reshape(4, n, n, 3)
    print("Root mean square error of   means of 4 x 4 x 4 points (levels)   pixels (of 255)")
    for name, image, panel in zip(PATTERNS, images, panels[1:]):
        difference = np.sqrt(((panel - panels[0]) ** 2).mean())
        print(f"{name:10} {get_error(array, image):53.4f} {difference:17.2f}")
    pictures.write(options.folder / "dither-volume.png", picture)


main()
