# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests in ParaView share: the plugin, pictures as arrays, and their difference."""
import os
import unittest

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

simple._DisableFirstRenderCameraReset()


def load_plugin():
    simple.LoadPlugin(os.environ["BRAVAIS_PLUGIN"], remote=False, ns=vars(simple))


def run():
    """Runs the tests of the program, and ends it where ParaView can clear up."""
    success = unittest.main(exit=False).result.wasSuccessful()
    for view in simple.GetViews():
        simple.Delete(view)
    if not success:
        raise SystemExit("Some tests failed.")


def make_view(size=200):
    view = simple.CreateView("RenderView")
    view.ViewSize = [size, size]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.2, 0.3]
    return view


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[..., :3].astype(float)


def take_picture(view, name):
    """The view as an array of numbers 0 to 255, kept as name.png too."""
    path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], name + ".png")
    simple.Render(view)
    simple.SaveScreenshot(path, view)
    return read_picture(path)


def get_shown(picture):
    """Which pixels are not the background, the first pixel's colour."""
    return numpy.abs(picture - picture[0, 0]).max(axis=2) > 10


def differ(a, b):
    """Mean difference of two pictures over the pixels where either shows something."""
    shown = get_shown(a) | get_shown(b)
    return numpy.abs(a - b)[shown].mean() if shown.any() else 0.0
