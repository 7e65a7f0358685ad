# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geometry images and their locality masks by the definitions, slowly."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData


def make_geometry_image(points, defined=None):
    """Of an array [row, column, xyz] of any floating-point type."""
    image = vtkImageData()
    image.SetDimensions(points.shape[1], points.shape[0], 1)
    vectors = numpy_to_vtk(np.ascontiguousarray(points.reshape(-1, 3)), deep=True)
    vectors.SetName("Points")
    image.GetPointData().SetVectors(vectors)
    if defined is not None:
        array = numpy_to_vtk(np.ascontiguousarray(defined.ravel().astype(np.uint8)), deep=True)
        array.SetName("Defined")
        image.GetPointData().AddArray(array)
    lattice = vtkStringArray()
    lattice.SetName("Lattice")
    lattice.InsertNextValue("GeometryImage")
    image.GetFieldData().AddArray(lattice)
    return image


def get_points(image):
    return vtk_to_numpy(image.GetPointData().GetArray("Points")).astype(float)


def get_used(image):
    used = ~np.isnan(get_points(image)).any(axis=1)
    defined = image.GetPointData().GetArray("Defined")
    return used & (vtk_to_numpy(defined) != 0) if defined else used


def get_root_cube(image):
    points = get_points(image)[get_used(image)]
    low, high = points.min(axis=0), points.max(axis=0)
    edge = (high - low).max() * (1 + 1e-6)
    return (low + high) / 2 - edge / 2, edge


def get_cells(image, depth, cube=None):
    """Integer cell [gixel, xyz] at a depth; -1 for gixels in none."""
    corner, edge = cube if cube else get_root_cube(image)
    points, used = get_points(image), get_used(image)
    cells = np.full(points.shape, -1)
    cells[used] = np.floor((points[used] - corner) / edge * 2 ** depth)
    cells[((cells < 0) | (cells >= 2 ** depth)).any(axis=1)] = -1
    return cells


def get_leaves(image, depth, cube=None):
    """Masks [leaf, gixel] in ascending order of (x << 2D) | (y << D) | z, and these cells."""
    cells = get_cells(image, depth, cube)
    keys = np.where(cells[:, 0] < 0, -1,
                    (cells[:, 0] << 2 * depth) | (cells[:, 1] << depth) | cells[:, 2])
    found = np.unique(keys[keys >= 0])
    masks = keys[None, :] == found[:, None]
    return masks, np.array([cells[mask][0] for mask in masks]).reshape(-1, 3)


def get_all_masks(image, depth, cube=None):
    """Masks of all nodes, of depths 0 to `depth`."""
    return [mask for d in range(depth + 1) for mask in get_leaves(image, d, cube)[0]]


def pack(mask):
    return np.packbits(mask, bitorder="little").tobytes()


def run_length_code(data):
    """Two or more equal bytes: the byte twice, a 16-bit little-endian count; a lone byte: itself."""
    code = bytearray()
    place = 0
    while place < len(data):
        run = 1
        while run < 65535 and place + run < len(data) and data[place + run] == data[place]:
            run += 1
        code += bytes([data[place]]) * min(run, 2)
        if run > 1:
            code += run.to_bytes(2, "little")
        place += run
    return bytes(code)


def decode_roaring(code, size):
    """The mask of a code as RoaringCode.h describes it."""
    mask = np.zeros(max(size, 1 << 16) + (1 << 16), bool)
    place = block = 0

    def number():
        nonlocal place
        value = shift = 0
        while True:
            byte = code[place]
            place += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value
    while place < len(code):
        head = number()
        block += head >> 2
        kind = head & 3
        if kind == 2:
            bits = np.unpackbits(np.frombuffer(code, np.uint8, 8192, place), bitorder="little")
            mask[block << 16:(block + 1) << 16] = bits
            place += 8192
        else:
            count = (number() + 1) * (1 + kind)
            values = np.frombuffer(code, "<u2", count, place).astype(int) + (block << 16)
            place += 2 * count
            if kind == 0:
                mask[values] = True
            else:
                for first, length in zip(values[::2], values[1::2] - (block << 16)):
                    mask[first:first + length + 1] = True
        block += 1
    assert not mask[size:].any()
    return mask[:size]


def get_leaf_masks(algorithm):
    """What a vtkGeometryImageLocalityMask has, [leaf, gixel], and the cells."""
    masks = []
    array = vtkUnsignedCharArray()
    for leaf in range(algorithm.GetNumberOfLeaves()):
        assert algorithm.GetLeafMask(leaf, array)
        masks.append(vtk_to_numpy(array).copy())
    cells = vtkIdTypeArray()
    algorithm.GetLeafCells(cells)
    return np.array(masks), vtk_to_numpy(cells).reshape(-1, 3) if masks else np.zeros((0, 3))


def get_mask(algorithm):
    return vtk_to_numpy(algorithm.GetOutput().GetPointData().GetArray("LocalityMask"))
