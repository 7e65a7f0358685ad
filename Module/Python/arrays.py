# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as lattice images, and lattice images as NumPy arrays.

Memory is shared wherever it can be: an image made from a C-contiguous array of a type VTK has is
that array's memory, and keeps the array alive; an array taken from an image is the image's memory,
and keeps that alive. Types are kept. Axes are in NumPy's order, slowest first: a volume is
`values[k, j, i]`, a picture `values[j, i]`, with y upwards as everywhere in VTK; components, where
there are several, are the last axis.

| lattice        | array                                                    | functions                |
|----------------|----------------------------------------------------------|--------------------------|
| Cartesian      | (nz, ny, nx), (ny, nx), and (..., components)            | image_from, image_to     |
| BCC            | (nk, ny, nx) or (nk, ny, nx, components)                 | bcc_from, bcc_to         |
| rank-1         | (n,), (n, components), (T, S, n), (T, S, n, components)  | rank1_from, rank1_to     |
| geometry image | (height, width, 3)                                       | geometry_from, geometry_to |

Every name ends in `_numpy`: `bravais.bcc_from_numpy(values)`. What cannot be such an image is a
ValueError or TypeError that says what was expected.
"""

import numpy
from vtkmodules.util.numpy_support import get_vtk_array_type, numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData

__all__ = [
    "bayer_thresholds",
    "bcc_from_numpy",
    "bcc_points",
    "bcc_to_numpy",
    "geometry_from_numpy",
    "geometry_to_numpy",
    "image_from_numpy",
    "image_to_numpy",
    "rank1_from_numpy",
    "rank1_to_numpy",
]


def image_from_numpy(values, spacing=(1, 1, 1), origin=(0, 0, 0), components=False, name="Scalars"):
    """A Cartesian vtkImageData of values[z, y, x] or values[y, x].

    With `components` the last axis holds the components of a point: a colour picture is
    `image_from_numpy(pixels, components=True)` of shape (ny, nx, 3).
    """
    values = _check(values)
    axes = values.ndim - bool(components)
    if axes not in (2, 3):
        raise ValueError(
            f"An array of shape {values.shape} is no image: 2 or 3 axes were expected, and one "
            "more with components=True."
        )
    return _make_image(values, values.shape[:axes], spacing, origin, name)


def image_to_numpy(image, name=None):
    """The scalars of any vtkImageData as (nz, ny, nx), or (nz, ny, nx, components) of several.

    With a name, that point array instead: `image_to_numpy(image, "Gradients")`.
    """
    return _get_values(image, None, name)


def bcc_from_numpy(values, spacing=(1, 1, 0.5), origin=(0, 0, 0), name="Scalars"):
    """A BCC volume of values[k, j, i], or values[k, j, i, component].

    Even layers k are the one coset, `values[0::2]`, and odd ones the other, shifted by half a
    spacing along x and y. The lattice is isotropic when spacing is (2 s, 2 s, s).
    """
    values = _check(values)
    if values.ndim not in (3, 4):
        raise ValueError(
            f"An array of shape {values.shape} is no BCC volume: (nk, ny, nx) or "
            "(nk, ny, nx, components) was expected."
        )
    return _tag(_make_image(values, values.shape[:3], spacing, origin, name), "BCC")


def bcc_to_numpy(image):
    """The scalars of a BCC volume as (nk, ny, nx), or (nk, ny, nx, components) of several."""
    return _get_values(image, "BCC")


def bcc_points(image):
    """World positions of a BCC volume's points, float64 of shape (nk, ny, nx, 3).

    With it any function of x, y, z is sampled:
    `x, y, z = numpy.moveaxis(bcc_points(image), -1, 0)`.
    """
    _check_tag(image, "BCC")
    extent = image.GetExtent()
    k, j, i = numpy.mgrid[
        extent[4] : extent[5] + 1, extent[2] : extent[3] + 1, extent[0] : extent[1] + 1
    ]
    index = numpy.stack([i + (k & 1) / 2, j + (k & 1) / 2, k], axis=-1)
    matrix = image.GetDirectionMatrix()
    direction = numpy.array([[matrix.GetElement(a, b) for b in range(3)] for a in range(3)])
    return (index * image.GetSpacing()) @ direction.T + image.GetOrigin()


def rank1_from_numpy(values, generator, domain=None, name="Scalars"):
    """A rank-1 image of one tile, (n,) or (n, components), or of T x S tiles, (T, S, n, ...).

    `generator` is (g1, g2): texel i is at ({i g1 / n}, {i g2 / n}) of its tile. `domain` is
    (xmin, xmax, ymin, ymax) of the whole picture, by default one unit a tile.
    """
    values = _check(values)
    if values.ndim < 1 or values.ndim > 4:
        raise ValueError(
            f"An array of shape {values.shape} is no rank-1 image: (n,), (n, components), "
            "(T, S, n) or (T, S, n, components) was expected."
        )
    shape = (1, 1, values.shape[0]) if values.ndim < 3 else values.shape[:3]
    g1, g2 = (int(g) for g in generator)
    n = shape[2]
    if n and numpy.gcd.reduce([g1, g2, n]) != 1:
        raise ValueError(f"Generator ({g1}, {g2}) does not generate {n} points.")
    if domain is None:
        domain = (0, shape[1], 0, shape[0])
    domain = numpy.array(domain, dtype=numpy.float64)
    if domain.shape != (4,) or not numpy.isfinite(domain).all() or (domain[::2] >= domain[1::2]).any():
        raise ValueError(
            f"The domain is {domain}; finite (xmin, xmax, ymin, ymax) in ascending order were expected."
        )
    image = _tag(_make_image(values, shape, (1, 1, 1), (0, 0, 0), name), "Rank1")
    _add_field(image, "Rank1.Generator", numpy.array([n, g1, g2], dtype=numpy.int64))
    _add_field(image, "Rank1.Domain", domain)
    return image


def rank1_to_numpy(image):
    """(values, generator, domain) of a rank-1 image.

    values is (T, S, n) or (T, S, n, components), generator (g1, g2), domain (xmin, xmax, ymin,
    ymax).
    """
    values = _get_values(image, "Rank1")
    fields = image.GetFieldData()
    arrays = [fields.GetArray(name) for name in ("Rank1.Generator", "Rank1.Domain")]
    if None in arrays:
        raise ValueError("The image lacks the field data Rank1.Generator or Rank1.Domain.")
    generator = tuple(int(arrays[0].GetTuple1(i)) for i in (1, 2))
    return values, generator, tuple(arrays[1].GetTuple1(i) for i in range(4))


def geometry_from_numpy(points, defined=None):
    """A geometry image of points[y, x] = (x, y, z), float32 or float64 of shape (height, width, 3).

    `defined`, of shape (height, width), is False where there is no gixel; a NaN means the same.
    """
    points = _check(points)
    if points.ndim != 3 or points.shape[2] != 3:
        raise ValueError(
            f"An array of shape {points.shape} is no geometry image: (height, width, 3) was expected."
        )
    if points.dtype not in (numpy.float32, numpy.float64):
        raise TypeError(f"Points of type {points.dtype} are no floats: float32 or float64 was expected.")
    image = _tag(
        _make_image(points, points.shape[:2], (1, 1, 1), (0, 0, 0), "Points", vectors=True),
        "GeometryImage",
    )
    if defined is not None:
        defined = numpy.asarray(defined)
        if defined.shape != points.shape[:2]:
            raise ValueError(
                f"`defined` is of shape {defined.shape}; that of the picture, {points.shape[:2]}, "
                "was expected."
            )
        array = _share((defined != 0).astype(numpy.uint8).reshape(-1))
        array.SetName("Defined")
        image.GetPointData().AddArray(array)
    return image


def geometry_to_numpy(image):
    """(points, defined) of a geometry image: (height, width, 3), and (height, width) of bool.

    defined is False where the image says so and where a coordinate is NaN.
    """
    _check_tag(image, "GeometryImage")
    data = image.GetPointData()
    array = data.GetArray("Points")
    if array is None or array.GetNumberOfComponents() != 3:
        raise ValueError("The geometry image has no point array `Points` of three components.")
    width, height, _ = image.GetDimensions()
    points = vtk_to_numpy(array).reshape(height, width, 3)
    defined = ~numpy.isnan(points).any(axis=2)
    if data.HasArray("Defined"):
        defined &= vtk_to_numpy(data.GetArray("Defined")).reshape(height, width) != 0
    return points, defined


def bayer_thresholds(dimension, log2_size, **options):
    """The ranks of a Bayer pattern's cells as (size, size) or (size, size, size), x last.

    `base_order="BCC"` chooses the other order of vtkBayerPattern in three dimensions.
    """
    from vtkmodules.vtkCommonCore import vtkIdTypeArray

    from .vtkBravais import vtkBayerPattern

    pattern = vtkBayerPattern()
    base_order = options.pop("base_order", "FCC")
    if options or base_order not in ("FCC", "BCC"):
        raise ValueError(f"base_order is {base_order!r}; FCC or BCC was expected.")
    getattr(pattern, f"SetBaseOrderTo{base_order}")()
    pattern.AddObserver("ErrorEvent", lambda *unused: None)  # the ValueError says it
    ranks = vtkIdTypeArray()
    pattern.GetThresholds(dimension, log2_size, ranks)
    if not ranks.GetNumberOfTuples():
        raise ValueError(f"There is no pattern of {dimension} dimensions and log2 size {log2_size}.")
    return vtk_to_numpy(ranks).reshape((1 << log2_size,) * dimension)


def _check(values):
    """The array itself, or what NumPy makes of it, of a type that VTK has."""
    values = numpy.asarray(values)
    if values.dtype == bool:
        values = values.astype(numpy.uint8)
    try:
        get_vtk_array_type(values.dtype)
        known = values.dtype.kind in "iuf"
    except TypeError:
        known = False
    if not known:
        raise TypeError(
            f"VTK has no arrays of type {values.dtype}; integers of 8 to 64 bits, float32 or "
            "float64 were expected."
        )
    if not values.dtype.isnative:
        values = values.astype(values.dtype.newbyteorder("="))
    return values


def _share(values):
    """A vtkDataArray over the memory of a C-contiguous array, which it keeps alive."""
    if not values.flags.writeable:  # VTK takes memory only that it might write to
        values = values.copy()
    return numpy_to_vtk(values, deep=False)


def _make_image(values, shape, spacing, origin, name, vectors=False):
    if 0 in values.shape:
        raise ValueError(f"An array of shape {values.shape} has no points.")
    dimensions = tuple(reversed(shape)) + (1,) * (3 - len(shape))
    count = int(numpy.prod(shape))
    values = numpy.ascontiguousarray(values).reshape(count, -1)
    array = _share(values if values.shape[1] > 1 or vectors else values[:, 0])
    array.SetName(name)
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    if vectors:
        image.GetPointData().SetVectors(array)
    else:
        image.GetPointData().SetScalars(array)
    return image


def _get_values(image, tag, name=None):
    if tag is not None:
        _check_tag(image, tag)
    elif image is None or not image.IsA("vtkImageData"):
        raise TypeError(f"{image!r} is no vtkImageData.")
    data = image.GetPointData()
    scalars = data.GetScalars() if name is None else data.GetArray(name)
    if scalars is None:
        raise ValueError(f"The image has no point {'scalars' if name is None else f'array {name}'}.")
    values = vtk_to_numpy(scalars)
    return values.reshape(tuple(reversed(image.GetDimensions())) + values.shape[1:])


def _tag(image, tag):
    array = vtkStringArray()
    array.SetName("Lattice")
    array.InsertNextValue(tag)
    image.GetFieldData().AddArray(array)
    return image


def _check_tag(image, tag):
    if image is None or not image.IsA("vtkImageData"):
        raise TypeError(f"{image!r} is no vtkImageData.")
    array = image.GetFieldData().GetAbstractArray("Lattice")
    if array is None or array.GetNumberOfValues() != 1 or array.GetValue(0) != tag:
        raise ValueError(f"The image is not tagged as {tag}, in the field data `Lattice`.")


def _add_field(image, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    image.GetFieldData().AddArray(array)
