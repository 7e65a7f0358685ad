# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The geometry images that the examples share: files, meshes that become some, and made ones."""
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import bravais
import debian
import meshes

BUNNY = "glmark2-data", "usr/share/glmark2/models/bunny.obj"  # Stanford's


def read(path, size):
    """A geometry image file, or a closed mesh as one of so many gixels along each side."""
    if pathlib.Path(path).suffix in (".obj", ".off", ".ply", ".stl", ".vtp"):
        reader = bravais.vtkPolyDataToGeometryImage()
        reader.SetDimensions(size, size)
        reader.SetInputData(meshes.read(path))
    else:
        reader = bravais.vtkGeometryImageReader()
        reader.SetFileName(str(path))
    reader.Update()
    if not reader.GetOutput().GetNumberOfPoints():
        raise SystemExit(f"{path} cannot be read as a geometry image.")
    return reader.GetOutput()


def make(shape, width, height):
    source = bravais.vtkGeometryImageSource()
    getattr(source, f"SetShapeTo{shape}")()
    source.SetDimensions(width, height)
    source.Update()
    return source.GetOutput()


def fetch_bunny(folder, size):
    """Stanford's bunny, out of a Debian package; None, with a message, if it cannot be had."""
    path = debian.fetch(*BUNNY, pathlib.Path(folder))
    return read(path, size) if path else None


def get_points(image):
    """Positions [row, column, xyz]."""
    points = vtk_to_numpy(image.GetPointData().GetArray("Points"))
    width, height, _ = image.GetDimensions()
    return points.reshape(height, width, 3)


def get_mask(image):
    mask = vtk_to_numpy(image.GetPointData().GetArray("LocalityMask"))
    width, height, _ = image.GetDimensions()
    return mask.reshape(height, width)


def get_box(image):
    """Lower and upper corner of the used gixels."""
    points = get_points(image).reshape(-1, 3)
    used = ~np.isnan(points).any(axis=1)
    return points[used].min(axis=0), points[used].max(axis=0)
