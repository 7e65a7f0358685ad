# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of several filters check in the same way."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDataArray, vtkLogger, vtkOutputWindow, vtkSMPTools, vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm, vtkStreamingDemandDrivenPipeline as Pipeline)
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase

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


def make_volume(array, type=None, **geometry):
    """A BCC volume of a numpy array, of a VTK scalar type that need not be the array's own."""
    image = make_image(array, **geometry)
    if type is not None:
        scalars = vtkDataArray.CreateDataArray(type)
        scalars.DeepCopy(image.GetPointData().GetScalars())
        scalars.SetName(image.GetPointData().GetScalars().GetName())
        image.GetPointData().SetScalars(scalars)
    vtkBCCLattice.Tag(image)
    return image


class PieceSource(VTKPythonAlgorithmBase):
    """Hands out an image, and of it only the extents that it is asked for, which it notes."""

    alive = []  # VTK does not keep the Python half

    def __init__(self, image):
        super().__init__(nInputPorts=0, outputType="vtkImageData")
        self.image = image
        self.asked = []
        PieceSource.alive.append(self)

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.WHOLE_EXTENT(), self.image.GetExtent(), 6)
        info.Set(vtkDataObject.SPACING(), self.image.GetSpacing(), 3)
        info.Set(vtkDataObject.ORIGIN(), self.image.GetOrigin(), 3)
        matrix = self.image.GetDirectionMatrix()
        direction = [matrix.GetElement(n // 3, n % 3) for n in range(9)]
        info.Set(vtkDataObject.DIRECTION(), direction, 9)
        scalars = self.image.GetPointData().GetScalars()
        vtkDataObject.SetPointDataActiveScalarInfo(
            info, scalars.GetDataType(), scalars.GetNumberOfComponents())
        info.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        extent = [info.Get(Pipeline.UPDATE_EXTENT(), n) for n in range(6)]
        self.asked.append(extent)
        part = vtkImageData()
        part.DeepCopy(self.image)
        part.Crop(extent)
        vtkImageData.GetData(info).ShallowCopy(part)
        return 1


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


def modify(algorithm):
    """Makes an algorithm and those before it forget their outputs."""
    algorithm.Modified()
    if algorithm.GetNumberOfInputPorts() and algorithm.GetNumberOfInputConnections(0):
        modify(algorithm.GetInputAlgorithm())


def make_pieces(whole):
    """Extents of pieces, thin ones and ones that start at odd layers among them."""
    x0, x1, y0, y1, z0, z1 = whole
    mid = (z0 + z1) // 2 | 1
    return [
        (x0, x1, y0, y1, z0 + 1, z1), (x0, x1, y0, y1, z0, z0), (x0, x1, y0, y1, z1, z1),
        (x0 + 1, x1 - 1, y0 + 2, y1 - 1, mid, mid), (x1, x1, y0, y0, z0, z1),
        (x0 + 2, x0 + 3, y0, y1, mid - 1, mid + 1)]


def check_pieces(test, algorithm, bcc=True):
    """Each piece, computed alone, is that piece of the whole, bit for bit, in all its arrays."""
    algorithm.Update()
    whole = algorithm.GetOutput().GetExtent()
    data = algorithm.GetOutput().GetPointData()
    names = [data.GetArrayName(n) for n in range(data.GetNumberOfArrays())]
    test.assertGreater(len(names), 0)
    expected = [to_numpy(algorithm.GetOutput(), name).copy() for name in names]
    for piece in make_pieces(whole):
        modify(algorithm)
        algorithm.UpdateExtent(piece)
        output = algorithm.GetOutput()
        test.assertEqual(output.GetExtent(), piece)
        test.assertEqual(vtkBCCLattice.IsBCC(output), bcc)
        x0, x1, y0, y1, z0, z1 = (p - whole[a // 2 * 2] for a, p in enumerate(piece))
        for name, values in zip(names, expected):
            part = values[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1]
            test.assertEqual(to_numpy(output, name).tobytes(), part.tobytes(), (name, piece))


def check_numbered_pieces(test, algorithm, count):
    """Pieces by number, as MPI ranks ask for them, are parts of the whole and cover it."""
    modify(algorithm)
    algorithm.Update()
    whole = to_numpy(algorithm.GetOutput()).copy()
    start = algorithm.GetOutput().GetExtent()[::2]
    covered = np.zeros(whole.shape[:3], bool)
    for piece in range(count):
        modify(algorithm)
        test.assertTrue(algorithm.UpdatePiece(piece, count, 0))
        output = algorithm.GetOutput()
        test.assertLess(output.GetNumberOfPoints(), covered.size)
        if output.GetNumberOfPoints():
            x, y, z = np.array(output.GetExtent()).reshape(3, 2) - np.array(start)[:, None]
            part = np.s_[z[0]:z[1] + 1, y[0]:y[1] + 1, x[0]:x[1] + 1]
            np.testing.assert_array_equal(to_numpy(output), whole[part])
            covered[part] = True
    test.assertTrue(covered.all())


def check_blocks(test, make, images):
    """Each block of a vtkMultiBlockDataSet becomes what it does alone."""
    blocks = vtkMultiBlockDataSet()
    for number, image in enumerate(images):
        blocks.SetBlock(number, image)
    algorithm = make()
    algorithm.SetInputDataObject(blocks)
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0)
    test.assertEqual(output.GetNumberOfBlocks(), len(images))
    for number, image in enumerate(images):
        alone = make()
        alone.SetInputDataObject(image)
        alone.Update()
        found, expected = output.GetBlock(number), alone.GetOutput()
        test.assertEqual(found.GetExtent(), expected.GetExtent())
        test.assertEqual(found.GetSpacing(), expected.GetSpacing())
        test.assertEqual(found.GetOrigin(), expected.GetOrigin())
        np.testing.assert_array_equal(to_numpy(found), to_numpy(expected))


def check_threads(test, algorithm):
    """One thread gives what two give, and all ways of threading that there are, bit for bit."""
    results = []
    default = vtkSMPTools.GetBackend()
    for backend in "Sequential", "STDThread", "TBB":  # those of VTK's packages
        if vtkSMPTools.SetBackend(backend):
            for threads in 1, 2:
                vtkSMPTools.Initialize(threads)
                algorithm.Modified()
                algorithm.Update()
                data = algorithm.GetOutput().GetPointData()
                results.append([to_numpy(algorithm.GetOutput(), data.GetArrayName(n)).tobytes()
                                for n in range(data.GetNumberOfArrays())])
    vtkSMPTools.SetBackend(default)
    vtkSMPTools.Initialize(0)
    test.assertGreaterEqual(len(results), 4)
    for result in results[1:]:
        test.assertEqual(result, results[0])


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
