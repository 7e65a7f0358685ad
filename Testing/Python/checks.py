# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of several filters check in the same way."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkSMPTools, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkBCCLattice


class Errors:
    """Collects the errors of an algorithm, and keeps them and the pipeline's off the screen."""

    def __init__(self, algorithm):
        self.algorithm = algorithm
        self.texts = []

    def __enter__(self):
        def collect(caller, event, text):
            self.texts.append(text)
        collect.CallDataType = "string0"
        self.tag = self.algorithm.AddObserver("ErrorEvent", collect)
        self.former = vtkOutputWindow.GetInstance()
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, *unused):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        vtkOutputWindow.SetInstance(self.former)
        self.algorithm.RemoveObserver(self.tag)


def refuses(test, algorithm, *words):
    """One error that has all these words in it, and an output without points or arrays."""
    with Errors(algorithm) as errors:
        algorithm.Update()
    test.assertEqual(len(errors.texts), 1, errors.texts)
    for word in words:
        test.assertIn(word, errors.texts[0])
    output = algorithm.GetOutputDataObject(0)
    test.assertEqual(output.GetNumberOfPoints(), 0)
    test.assertEqual(output.GetPointData().GetNumberOfArrays(), 0)


def make_image(array, spacing=(1, 1, 1), origin=(0, 0, 0), name="values", start=(0, 0, 0)):
    """A vtkImageData of a numpy array [z, y, x] or [z, y, x, component]."""
    image = vtkImageData()
    n = array.shape[2::-1]
    image.SetExtent([start[a // 2] + (n[a // 2] - 1) * (a % 2) for a in range(6)])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    flat = array.reshape(-1) if array.ndim == 3 else array.reshape(-1, array.shape[3])
    scalars = numpy_to_vtk(np.ascontiguousarray(flat), deep=True)
    scalars.SetName(name)
    image.GetPointData().SetScalars(scalars)
    return image


def to_numpy(image, name=None):
    """The scalars, or an array, as [z, y, x] or [z, y, x, component]."""
    data = image.GetPointData()
    array = data.GetArray(name) if name else data.GetScalars()
    values = vtk_to_numpy(array)
    return values.reshape(image.GetDimensions()[::-1] + values.shape[1:])


def get_points(image):
    """World positions of a BCC volume's points, [z, y, x, 3], by the formula of the lattice."""
    e = image.GetExtent()
    k, j, i = np.meshgrid(*(np.arange(e[a], e[a + 1] + 1) for a in (4, 2, 0)), indexing="ij")
    half = 0.5 * (k % 2)
    return np.stack((i + half, j + half, k), -1) * image.GetSpacing() + image.GetOrigin()


def make_pieces(whole):
    """Extents of pieces, thin ones and ones that start at odd layers among them."""
    x0, x1, y0, y1, z0, z1 = whole
    mid = (z0 + z1) // 2 | 1
    return [
        (x0, x1, y0, y1, z0 + 1, z1), (x0, x1, y0, y1, z0, z0), (x0, x1, y0, y1, z1, z1),
        (x0 + 1, x1 - 1, y0 + 2, y1 - 1, mid, mid), (x1, x1, y0, y0, z0, z1),
        (x0 + 2, x0 + 3, y0, y1, mid - 1, mid + 1)]


def check_pieces(test, algorithm):
    """Each piece, computed alone, is that piece of the whole, bit for bit."""
    algorithm.Update()
    whole = algorithm.GetOutput().GetExtent()
    expected = to_numpy(algorithm.GetOutput()).copy()
    for piece in make_pieces(whole):
        algorithm.Modified()
        algorithm.UpdateExtent(piece)
        output = algorithm.GetOutput()
        test.assertEqual(output.GetExtent(), piece)
        test.assertTrue(vtkBCCLattice.IsBCC(output))
        x0, x1, y0, y1, z0, z1 = (p - whole[a // 2 * 2] for a, p in enumerate(piece))
        part = expected[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1]
        test.assertEqual(to_numpy(output).tobytes(), part.tobytes(), piece)


def check_threads(test, algorithm):
    """One thread gives what two give, bit for bit."""
    results = []
    for threads in 1, 2:
        vtkSMPTools.Initialize(threads)
        algorithm.Modified()
        algorithm.Update()
        results.append(to_numpy(algorithm.GetOutput()).tobytes())
    vtkSMPTools.Initialize(0)
    test.assertEqual(*results)


def check_progress(test, algorithm):
    """Progress rises to 1; an abort at a half leaves nothing, and the next update all.

    One thread does it, since progress is reported by the calling thread alone, which may get little
    of the work where others are quicker.
    """
    vtkSMPTools.Initialize(1)
    amounts = []
    tag = algorithm.AddObserver(
        "ProgressEvent", lambda *unused: amounts.append(algorithm.GetProgress()))
    algorithm.Modified()
    algorithm.Update()
    algorithm.RemoveObserver(tag)
    test.assertEqual(amounts, sorted(amounts))
    test.assertEqual(amounts[-1], 1)
    test.assertGreater(len(set(amounts)), 3)

    def abort(*unused):
        algorithm.SetAbortExecute(algorithm.GetProgress() >= 0.5)
    tag = algorithm.AddObserver("ProgressEvent", abort)
    algorithm.Modified()
    algorithm.Update()
    algorithm.RemoveObserver(tag)
    test.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
    algorithm.Update()
    test.assertGreater(algorithm.GetOutput().GetNumberOfPoints(), 0)
    vtkSMPTools.Initialize(0)
