# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of rank-1 images share."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkRank1ImageResample
from checks import make_image

TYPES = [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64,
         np.float32, np.float64]


def make_picture(shape, dtype=np.float64, **geometry):
    """Noise of 0 to 120 and its image, of shape (rows, columns) or (rows, columns, components)."""
    values = np.random.default_rng(7).integers(0, 120, shape).astype(dtype)
    return values, make_image(values[None], **geometry)


def resample(image, n=0, tiles=(1, 1), generator=(0, 0), filter=vtkRank1ImageResample.Automatic,
             boundary=vtkRank1ImageResample.Periodic):
    algorithm = vtkRank1ImageResample()
    algorithm.SetInputDataObject(image)
    algorithm.SetNumberOfPoints(n)
    algorithm.SetTiles(tiles)
    algorithm.SetGenerator(generator)
    algorithm.SetFilter(filter)
    algorithm.SetBoundaryMode(boundary)
    return algorithm


def get_marks(image):
    """Tag, generator and domain of an image."""
    data = image.GetFieldData()
    return (data.GetAbstractArray("Lattice").GetValue(0),
            tuple(int(v) for v in vtk_to_numpy(data.GetArray("Rank1.Generator"))),
            tuple(float(v) for v in vtk_to_numpy(data.GetArray("Rank1.Domain"))))


def make_rank1(values, generator, tiles=(1, 1), domain=(0, 1, 0, 1)):
    """A rank-1 image of values [tile along v, tile along u, texel (, component)]."""
    n, g1, g2 = generator
    image = vtkImageData()
    image.SetDimensions(n, *tiles)
    values = np.asarray(values)
    flat = values.reshape((n * tiles[0] * tiles[1],) + values.shape[3:])
    scalars = numpy_to_vtk(np.ascontiguousarray(flat), deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    tag = vtkStringArray()
    tag.SetName("Lattice")
    tag.InsertNextValue("Rank1")
    numbers = vtkTypeInt64Array()
    numbers.SetName("Rank1.Generator")
    corners = vtkDoubleArray()
    corners.SetName("Rank1.Domain")
    for number in generator:
        numbers.InsertNextValue(number)
    for corner in domain:
        corners.InsertNextValue(corner)
    for array in tag, numbers, corners:
        image.GetFieldData().AddArray(array)
    return image


def get_places(generator, tiles=(1, 1), domain=(0, 1, 0, 1)):
    """World x, y of the texels, [tile along v, tile along u, texel, 2]."""
    n, g1, g2 = generator
    points = np.outer(np.arange(n), (g1, g2)) % n / n
    v, u = np.meshgrid(np.arange(tiles[1]), np.arange(tiles[0]), indexing="ij")
    places = (np.stack((u, v), -1)[:, :, None] + points) / tiles
    return places * (domain[1] - domain[0], domain[3] - domain[2]) + (domain[0], domain[2])
