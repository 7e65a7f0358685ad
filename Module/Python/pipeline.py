# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's algorithms as one call: inputs and settings in, the output back, errors as exceptions."""

import os

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .vtkBravais import vtkRank1TextureSampler

__all__ = ["apply", "rank1_sample"]


def apply(algorithm, *inputs, **settings):
    """The output of an algorithm, which is a class or an object of any vtkAlgorithm.

    `apply(bravais.vtkImageToBCCVolume, image, SampleRatio=0.7)` makes the filter, calls
    SetSampleRatio(0.7), gives it the image, updates it and returns what its first port puts out.
    Inputs are data objects or other algorithms, one a port. A text that names an enumeration's value
    chooses that: `Function="Gaussian"` calls SetFunctionToGaussian(). A writer writes its file. A
    ValueError says which setting there is not, a RuntimeError what VTK reported.
    """
    if isinstance(algorithm, type):
        algorithm = algorithm()
    for name, value in settings.items():
        _set(algorithm, name, value)
    steps = [algorithm, *(data for data in inputs if _is_algorithm(data))]
    with _Errors(*steps, *(step.GetExecutive() for step in steps)):
        for port, data in enumerate(inputs):
            if _is_algorithm(data):
                algorithm.SetInputConnection(port, data.GetOutputPort())
            else:
                algorithm.SetInputDataObject(port, data)
        if hasattr(algorithm, "Write"):
            algorithm.Write()
        else:
            algorithm.Update()
    return algorithm.GetOutputDataObject(0) if algorithm.GetNumberOfOutputPorts() else None


def rank1_sample(texture, uv, footprints=None, **settings):
    """Filtered look-ups of vtkRank1TextureSampler in a rank-1 image, a pyramid or a file's name.

    `uv` is (..., 2), the picture being [0, 1]^2. `footprints` of pixels are du/dx, dv/dx, du/dy,
    dv/dy, (..., 4) or (4,) for all points; None stands for points. The result is float64 of shape
    (...), or (..., components) where there are several. Settings as in `apply`.
    """
    uv = numpy.ascontiguousarray(uv, dtype=numpy.float64)
    sampler = vtkRank1TextureSampler()
    if isinstance(texture, (str, os.PathLike)):
        sampler.SetFileName(str(texture))
    else:
        sampler.SetInputData(texture)
    for name, value in settings.items():
        _set(sampler, name, value)
    if footprints is not None:
        footprints = numpy.ascontiguousarray(footprints, dtype=numpy.float64)
        footprints = numpy_to_vtk(footprints.reshape(-1, footprints.shape[-1]))
    values = vtkDoubleArray()
    with _Errors(sampler):
        sampler.Sample(numpy_to_vtk(uv.reshape(-1, uv.shape[-1])), footprints, values)
    components = values.GetNumberOfComponents()
    return vtk_to_numpy(values).reshape(uv.shape[:-1] + ((components,) if components > 1 else ()))


def _is_algorithm(data):
    return isinstance(data, vtkAlgorithm)


def _set(algorithm, name, value):
    if isinstance(value, str) and hasattr(algorithm, f"Set{name}To{value}"):
        getattr(algorithm, f"Set{name}To{value}")()
    elif hasattr(algorithm, f"Set{name}"):
        getattr(algorithm, f"Set{name}")(value)
    else:
        raise ValueError(f"{algorithm.GetClassName()} has no Set{name}.")


class _Errors:
    """Collects what objects report instead of printing it, and raises the first."""

    def __init__(self, *sources):
        self.sources = sources
        self.texts = []

    def __enter__(self):
        @calldata_type(VTK_STRING)
        def hear(_object, _event, text):
            self.texts.append(text.partition("): ")[2].strip() or text.strip())

        self.tags = [source.AddObserver("ErrorEvent", hear) for source in self.sources]

    def __exit__(self, kind, *unused):
        for source, tag in zip(self.sources, self.tags):
            source.RemoveObserver(tag)
        if self.texts and kind is None:
            raise RuntimeError(self.texts[0])
