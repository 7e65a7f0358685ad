# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What TestProcesses runs by any number of processes: filters' output.

    mpirun -np 4 pvbatch --symmetric processes.py <folder>

writes <filter>.<process>.npz into the folder.
"""
import os
import sys

import numpy
import views
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

views.load_plugin()
folder = sys.argv[1]
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()


def keep(algorithm, name, array=None):
    """Each process's piece of the output, and where it lies in the whole."""
    algorithm.UpdatePipeline()
    image = algorithm.GetClientSideObject().GetOutputDataObject(0)
    data = image.GetPointData()
    scalars = data.GetArray(array) if array else data.GetScalars()
    if scalars is not None:
        values = vtk_to_numpy(scalars).reshape(image.GetDimensions()[::-1] + (-1,))
        path = os.path.join(folder, f"{name}.{rank}.npz")
        numpy.savez(path, extent=image.GetExtent(), values=values)


source = simple.BCCVolumeSource(Dimensions=[20, 18, 37])
keep(source, "BCCVolumeSource")
keep(simple.BCCPrefilter(Input=source), "BCCPrefilter")
for kernel in "bcc4, linear", "bcc7, quartic", "bcc8, quintic", "bcc12, tri-cubic":
    keep(simple.BCCVolumeToImage(Input=source, Kernel=kernel), "BCCVolumeToImage" + kernel[:4])
wavelet = simple.Wavelet(WholeExtent=[-10, 10, -9, 9, -8, 8])
keep(simple.ImageToBCCVolume(Input=wavelet, Mode="Subset"), "ImageToBCCVolumeSubset")
keep(simple.ImageToBCCVolume(Input=wavelet), "ImageToBCCVolume")
keep(simple.OrderedDither(Input=wavelet, NumberOfLevels=4, InputRange=[37, 277]), "OrderedDither")
picture = simple.Wavelet(WholeExtent=[-10, 10, -9, 9, 0, 0])
rank1 = simple.Rank1ImageResample(Input=picture, Tiles=[2, 2])
keep(rank1, "Rank1ImageResample")
keep(simple.Rank1ImageReconstruct(Input=rank1, OutputDimensions=[40, 30]), "Rank1ImageReconstruct")
torus = simple.GeometryImageSource(Shape="Torus", Dimensions=[33, 33])
keep(torus, "GeometryImageSource", "Points")
mask = simple.GeometryImageLocalityMask(Input=torus)
mask.CullFunction = "Sphere"
keep(mask, "GeometryImageLocalityMask", "LocalityMask")
