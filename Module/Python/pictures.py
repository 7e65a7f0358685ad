# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of volumes and surfaces in few lines, without a window on the screen.

A picture is an array of bytes, `pixels[y, x]` or `pixels[y, x, RGB]`, with y upwards as everywhere
in VTK, so that `numpy.hstack` puts two of them side by side.
"""

import math

import numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

from .arrays import image_from_numpy, image_to_numpy
from .pipeline import apply
from .vtkBravais import vtkBCCLattice, vtkBCCVolumeMapper, vtkOIIOImageReader

__all__ = ["grab", "isosurface", "make_window", "read_picture", "render", "surface", "write_picture"]


def isosurface(volume, value, color=(0.93, 0.8, 0.68)):
    """A vtkVolume that shows where a vtkImageData has a value.

    A BCC volume is drawn by vtkBCCVolumeMapper, any other by VTK's own mapper, which is trilinear;
    both step by half the edge of a cube with one sample in it.
    """
    _check(volume, "vtkImageData")
    if not (volume.GetPointData().GetScalars() or volume.GetCellData().GetScalars()):
        raise ValueError("The volume has no scalars.")
    if math.isnan(value):
        raise ValueError(f"The value is {value}; a number was expected.")
    bcc = vtkBCCLattice.IsBCC(volume)
    mapper = vtkBCCVolumeMapper() if bcc else vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(volume)
    mapper.SetBlendModeToIsoSurface()
    mapper.AutoAdjustSampleDistancesOff()
    edge = math.prod(volume.GetSpacing()) ** (1 / 3)
    mapper.SetSampleDistance(0.5 * edge)
    colors = vtkColorTransferFunction()
    for end in volume.GetScalarRange():
        colors.AddRGBPoint(end, *color)
    result = vtkVolume()
    result.SetMapper(mapper)
    look = result.GetProperty()
    look.SetColor(colors)
    look.GetIsoSurfaceValues().SetValue(0, value)
    look.SetInterpolationTypeToLinear()
    look.SetScalarOpacityUnitDistance(edge)  # for other blend modes
    look.ShadeOn()
    look.SetAmbient(0.16)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.22)
    look.SetSpecularPower(24)
    return result


def surface(mesh, color=(0.93, 0.8, 0.68)):
    """A vtkActor that shows a vtkPolyData in one colour, smoothly shaded, or its scalars in greys.

    A color of None stands for the scalars, lowest dark and highest light, without shading.
    """
    _check(mesh, "vtkPolyData")
    if color is None:
        return _make_grey(mesh)
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetSpecular(0.2)
    actor.GetProperty().SetSpecularPower(24)
    return actor


def _check(data, kind):
    if not isinstance(data, vtkObject):
        raise ValueError(f"{data!r:.80} is no {kind}.")
    if not data.IsA(kind):
        raise ValueError(f"{data.GetClassName()} is no {kind}.")


def _make_grey(mesh):
    if not (mesh.GetPointData().GetScalars() or mesh.GetCellData().GetScalars()):
        raise ValueError("The mesh has no scalars, and no colour is given.")
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarRange(mesh.GetScalarRange())
    greys = vtkColorTransferFunction()
    for value, grey in zip(mesh.GetScalarRange(), (0.1, 1.0)):
        greys.AddRGBPoint(value, grey, grey, grey)
    mapper.SetLookupTable(greys)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def make_window(*props, size=(400, 400), position=(0.55, -1, 0.35), up=(0, 0, 1), zoom=1.0):
    """An off-screen vtkRenderWindow with props in it, all seen from the direction `position`.

    Two lights move with the camera, `window.GetRenderers().GetFirstRenderer().GetActiveCamera()`.
    """
    for prop in props:
        _check(prop, "vtkProp")
    if min(size) < 1:
        raise ValueError(f"The size is {tuple(size)}; a width and a height of 1 or more were expected.")
    if not 0 < numpy.abs(position).max() < math.inf:
        raise ValueError(f"The position is {tuple(position)}; a direction was expected.")
    if not 0 < zoom < math.inf:
        raise ValueError(f"The zoom is {zoom}; a positive number was expected.")
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.05, 0.06, 0.09)
    renderer.SetBackground2(0.22, 0.27, 0.36)
    renderer.TwoSidedLightingOn()
    renderer.AutomaticLightCreationOff()
    _add_light(renderer, (-0.6, 0.7, 1.0), 1.05, (1.0, 0.97, 0.92))
    _add_light(renderer, (1.0, 0.1, 0.7), 0.45, (0.85, 0.92, 1.0))
    for prop in props:
        renderer.AddViewProp(prop)
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(20)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(position)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(size)
    window.AddRenderer(renderer)
    return window


def _add_light(renderer, position, intensity, color):
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(position)
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(intensity)
    light.SetColor(color)
    renderer.AddLight(light)


def grab(window):
    """What a vtkRenderWindow shows since it was last rendered: bytes [y, x, RGB]."""
    _check(window, "vtkRenderWindow")
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    capture.ShouldRerenderOff()
    capture.Update()
    return image_to_numpy(capture.GetOutput())[0].copy()


def render(*props, **options):
    """A picture of props, vtkVolume or vtkActor, bytes [y, x, RGB]. Options are make_window's.

    With a window in their place, `render(window)`, that is drawn once more.
    """
    given = len(props) == 1 and isinstance(props[0], vtkRenderWindow)
    window = props[0] if given else make_window(*props, **options)
    window.Render()
    return grab(window)


def read_picture(path):
    """The pixels [y, x] or [y, x, RGB] of a picture file that OpenImageIO reads."""
    return image_to_numpy(apply(vtkOIIOImageReader, FileName=str(path)))[0]


def write_picture(path, pixels):
    """Writes pixels [y, x] or [y, x, RGB] as a PNG; what are no bytes is rounded and clamped to 0..255.

    A NaN becomes 0. Grey and opacity, and RGBA, are pixels too.
    """
    pixels = numpy.asarray(pixels)
    if pixels.ndim not in (2, 3) or pixels.ndim == 3 and pixels.shape[2] > 4:
        raise ValueError(f"An array of shape {pixels.shape} is no picture: [y, x] or [y, x, RGB] was expected.")
    if pixels.dtype != numpy.uint8:
        pixels = numpy.clip(numpy.rint(numpy.nan_to_num(pixels)), 0, 255).astype(numpy.uint8)
    writer = vtkPNGWriter()
    writer.SetInputData(image_from_numpy(pixels, components=pixels.ndim == 3))
    writer.SetFileName(str(path))
    writer.SetCompressionLevel(9)
    writer.AddObserver("ErrorEvent", lambda *unused: None)  # the error code says it
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"{path} cannot be written.")
