# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes, windows and pictures for tests of mappers."""
import os

import numpy
import vtkmodules.vtkRenderingOpenGL2
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty,
    vtkWindowToImageFilter)

from bravais import vtkBCCLattice

BOX = (-1, 1, -1, 1, -1, 1)


def make_image(values, dimensions, bounds_min, spacing):
    """An image of an array whose last axis, if it has four, is components."""
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.SetOrigin(bounds_min)
    image.SetSpacing(spacing)
    flat = values.reshape(-1, values.shape[3]) if values.ndim == 4 else values.ravel()
    scalars = numpy_to_vtk(numpy.ascontiguousarray(flat), deep=True)
    scalars.SetName("Scalars")
    image.GetPointData().SetScalars(scalars)
    return image


def make_bcc(function, dimensions=(24, 24, 48), box=BOX, dtype=numpy.float32):
    """A BCC volume of function(x, y, z) on a box."""
    nx, ny, nk = dimensions
    spacing = ((box[1] - box[0]) / (nx - 0.5), (box[3] - box[2]) / (ny - 0.5),
               (box[5] - box[4]) / (nk - 1))
    k, j, i = numpy.meshgrid(range(nk), range(ny), range(nx), indexing="ij")
    values = function(box[0] + spacing[0] * (i + (k & 1) / 2),
                      box[2] + spacing[1] * (j + (k & 1) / 2), box[4] + spacing[2] * k)
    image = make_image(values.astype(dtype), dimensions, box[::2], spacing)
    vtkBCCLattice.Tag(image)
    return image


def make_cartesian(function, dimensions=(96, 96, 96), box=BOX, dtype=numpy.float32):
    """A Cartesian image of function(x, y, z) on a box."""
    axes = [numpy.linspace(box[2 * a], box[2 * a + 1], dimensions[a]) for a in range(3)]
    z, y, x = numpy.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    spacing = [(box[2 * a + 1] - box[2 * a]) / (dimensions[a] - 1) for a in range(3)]
    return make_image(function(x, y, z).astype(dtype), dimensions, box[::2], spacing)


def make_property(low, high, opacities, shade=True, iso_values=()):
    """A blue, white and red volume property; opacities are pairs of a scalar and an opacity."""
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(low, 0.2, 0.4, 1.0)
    colors.AddRGBPoint((low + high) / 2, 1.0, 1.0, 0.6)
    colors.AddRGBPoint(high, 1.0, 0.3, 0.1)
    function = vtkPiecewiseFunction()
    for scalar, opacity in opacities:
        function.AddPoint(scalar, opacity)
    volume_property = vtkVolumeProperty()
    volume_property.SetColor(colors)
    volume_property.SetScalarOpacity(function)
    volume_property.SetScalarOpacityUnitDistance(0.1)
    volume_property.SetShade(shade)
    volume_property.SetInterpolationTypeToLinear()
    for number, value in enumerate(iso_values):
        volume_property.GetIsoSurfaceValues().SetValue(number, value)
    return volume_property


class Scene:
    """One volume in one window, looked at from the same place as all others."""

    def __init__(self, mapper, volume_property, size=150, sample_distance=0.02):
        mapper.AutoAdjustSampleDistancesOff()
        mapper.SetSampleDistance(sample_distance)
        self.size = size
        self.volume = vtkVolume()
        self.volume.SetMapper(mapper)
        self.volume.SetProperty(volume_property)
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.renderer.SetBackground(0.1, 0.1, 0.2)
        self.window = make_window(size, size)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(2.5, 2, 4)
        camera.SetViewUp(0, 1, 0)
        self.renderer.ResetCamera(BOX)

    def look_along_z(self):
        """Parallel rays through -1 .. 1 along x and y."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, 0, 5)
        camera.SetParallelScale(1)
        self.renderer.ResetCameraClippingRange()

    def render(self):
        self.window.Render()
        return get_picture(self.window)

    def get_depth(self):
        depth = vtkFloatArray()
        self.window.GetZbufferData(0, 0, self.size - 1, self.size - 1, depth)
        return vtk_to_numpy(depth).reshape(self.size, self.size)

    def to_world(self, x, y, depth):
        """World positions of pixel centres at depths of the window."""
        matrix = self.renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            self.renderer.GetTiledAspectRatio(), -1, 1)
        entries = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        view = numpy.stack([2 * (x + 0.5) / self.size - 1, 2 * (y + 0.5) / self.size - 1,
                            2 * depth.astype(float) - 1, numpy.ones(len(x))])
        world = numpy.linalg.solve(entries, view)
        return world[:3] / world[3]


def make_window(width, height):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    return window


def grab(window):
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return grabber.GetOutput()


def to_array(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def get_picture(window):
    return to_array(grab(window))


def check_baseline(test, window, tolerance=1.0):
    """Compares the window with the test's baseline by the mean difference of 8-bit values."""
    image = grab(window)
    baseline = os.environ["BRAVAIS_BASELINE"]
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.SetFileName(
        os.path.join(os.environ["BRAVAIS_TEMPORARY"], os.path.basename(baseline)))
    writer.Write()
    test.assertTrue(os.path.exists(baseline), f"no baseline; see {writer.GetFileName()}")
    reader = vtkPNGReader()
    reader.SetFileName(baseline)
    reader.Update()
    difference = numpy.abs(to_array(image) - to_array(reader.GetOutput())).mean()
    test.assertLess(difference, tolerance, f"see {writer.GetFileName()}")
