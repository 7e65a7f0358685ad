# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes for the examples: from files, from Debian packages, and a generated one."""
import pathlib
import tarfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDistancePolyDataFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import debian

BUNNY = "glmark2-data", "usr/share/glmark2/models/bunny.obj"
ARCHIVE = "libcgal-demo", "usr/share/doc/libcgal-dev/data.tar.gz"
ARCHIVED = "armadillo", "bull", "fandisk", "homer", "man"
READERS = {".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader,
           ".vtp": vtkXMLPolyDataReader}


def make(points, triangles):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtk(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    mesh.SetPolys(cells)
    return mesh


def get_arrays(mesh):
    """Points and triangles."""
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(mesh)
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    triangulate.Update()
    output = triangulate.GetOutput()
    return (vtk_to_numpy(output.GetPoints().GetData()).astype(float),
            vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def read_off(path):
    lines = (line.split("#")[0] for line in pathlib.Path(path).read_text().splitlines())
    words = " ".join(lines).split()
    points, triangles = int(words[1]), int(words[2])
    if words[0] != "OFF" or words[4 + 3 * points] != "3":
        raise SystemExit(f"{path} is no OFF file of triangles.")
    places = np.array(words[4:4 + 3 * points], float).reshape(-1, 3)
    cells = np.array(words[4 + 3 * points:][:4 * triangles], int).reshape(-1, 4)
    return make(places, cells[:, 1:])


def read(path):
    """A mesh of a file: .obj, .off, .ply, .stl or .vtp."""
    ending = pathlib.Path(path).suffix.lower()
    if ending == ".off":
        return read_off(path)
    if ending not in READERS:
        raise SystemExit(f"{path}: the ending is none of .off, {', '.join(READERS)}.")
    reader = READERS[ending]()
    reader.SetFileName(str(path))
    reader.Update()
    if not reader.GetOutput().GetNumberOfPoints():
        raise SystemExit(f"{path} cannot be read.")
    return reader.GetOutput()


def fetch(name, folder):
    """The path of bunny (Debian's glmark2-data), or armadillo, bull, fandisk, homer or man
    (libcgal-demo), unpacked into a folder."""
    if name == "bunny":
        return debian.fetch(*BUNNY, folder)
    if name not in ARCHIVED:
        raise SystemExit(f"{name} is none of bunny, {', '.join(ARCHIVED)}.")
    path = pathlib.Path(folder) / f"{name}.off"
    if not path.exists():
        archive = debian.fetch(*ARCHIVE, folder)
        if not archive:
            return None
        with tarfile.open(archive) as files:
            path.write_bytes(files.extractfile(f"data/meshes/{name}.off").read())
    return path


def generate():
    """A ball with six horns and a dent, of a few thousand triangles."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(96)
    sphere.SetPhiResolution(64)
    sphere.Update()
    points, triangles = get_arrays(sphere.GetOutput())
    points *= 2
    horns = np.array([(1, 1, 0), (-1, 1, 0), (0, -1, 1), (0, -1, -1), (1, 0, 1), (-1, 0, -1)])
    cosines = points @ (horns / np.sqrt(2)).T
    radius = 1 + 0.8 * np.exp(25 * (cosines - 1)).sum(axis=1) - 0.3 * np.exp(
        8 * (points[:, 2] - 1))
    return make((points * radius[:, None]).astype(np.float32), triangles)


def sample(mesh, count):
    """Points spread evenly over a mesh by chance."""
    points, triangles = get_arrays(mesh)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    generator = np.random.default_rng(1)
    chosen = np.searchsorted(np.cumsum(areas) / areas.sum(), generator.random(count))
    chosen = chosen.clip(0, len(triangles) - 1)
    r, s = np.sqrt(generator.random(count))[:, None], generator.random(count)[:, None]
    return (1 - r) * a[chosen] + r * (1 - s) * b[chosen] + r * s * c[chosen]


def get_distances(points, mesh):
    """How far points are from a mesh."""
    probe = make(points, [(0, 0, 0)])
    distance = vtkDistancePolyDataFilter()
    distance.SetInputData(0, probe)
    distance.SetInputData(1, mesh)
    distance.SignedDistanceOff()
    distance.ComputeSecondDistanceOff()
    distance.Update()
    return vtk_to_numpy(distance.GetOutput().GetPointData().GetArray("Distance"))


def get_error(mesh, other, count=50000):
    """Symmetric root mean square distance of two meshes, as a part of the first one's diagonal: the
    larger of those from points of each to the other."""
    points = get_arrays(mesh)[0]
    diagonal = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    return max(np.sqrt(np.mean(get_distances(sample(a, count), b) ** 2))
               for a, b in ((mesh, other), (other, mesh))) / diagonal
