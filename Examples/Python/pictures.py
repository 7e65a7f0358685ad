# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as numpy arrays [row, column] or [row, column, RGB], the first row at the top."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkImageReader2Factory, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter


def to_image(array):
    """A vtkImageData, whose first row is at the bottom."""
    image = vtkImageData()
    image.SetDimensions(array.shape[1], array.shape[0], 1)
    flat = np.ascontiguousarray(array[::-1]).reshape((-1,) + array.shape[2:])
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def to_array(image):
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    width, height, _ = image.GetDimensions()
    return values.reshape((height, width) + values.shape[1:])[::-1]


def read(path):
    reader = vtkImageReader2Factory.CreateImageReader2(str(path))
    if not reader:
        raise SystemExit(f"{path} is no picture that VTK reads.")
    reader.SetFileName(str(path))
    reader.Update()
    return to_array(reader.GetOutput())[..., :3]


def write(path, array):
    writer = vtkPNGWriter()
    writer.SetInputData(to_image(array))
    writer.SetFileName(str(path))
    writer.SetCompressionLevel(9)
    writer.AddObserver("ErrorEvent", lambda *unused: None)  # the error code says it
    writer.Write()
    if writer.GetErrorCode():
        raise SystemExit(f"{path} cannot be written.")
    print(path)


def render(renderers, size):
    """What renderers with viewports show in an off-screen window of so many columns and rows."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    return capture(window)


def capture(window):
    """What a window shows."""
    window.Render()
    reader = vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.Update()
    return to_array(reader.GetOutput())
