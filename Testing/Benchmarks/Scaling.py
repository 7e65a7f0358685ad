# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""How time and memory of a BCC volume's picture are shared by processes.

    mpirun -np 2 pvbatch --symmetric Scaling.py [--dimensions 512 512 1024] [--pieces 16]

makes an isosurface's picture of a vtkBCCVolumeSource of that size, and prints times, processor
times of all threads, and every process's points at once and peak of resident memory. Without
--pieces ParaView shows the volume, each process its part. With it each process makes and renders
its share of so many slabs one after the other, so that none ever has more than one of them, and the
pictures are blended front to back. The picture's digest is the same for any number of processes and
slabs. BRAVAIS_PLUGIN is the plugin's path, and the package bravais is that of the same build.
"""
import argparse
import hashlib
import os
import resource
import time

import numpy
from bravais import vtkBCCLattice, vtkBCCVolumeMapper, vtkBCCVolumeSource
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume)

COLOR = 0.9, 0.8, 0.5
EYE = 2.5, -4, 3
controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def get_peak():
    """The most memory that this process has had so far, in MiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def gather(array):
    """Every process's array, on all of them."""
    mine = numpy_to_vtk(numpy.ascontiguousarray(array, numpy.float32).ravel(), deep=True)
    everything = vtkFloatArray()
    controller.AllGather(mine, everything)
    return vtk_to_numpy(everything).reshape((count,) + numpy.shape(array))


class Clock:
    """Seconds of steps that may come several times."""

    def __init__(self):
        self.seconds = {}

    def measure(self, name, step):
        if name.startswith("*"):  # done together
            controller.Barrier()
        start = numpy.array([time.perf_counter(), time.process_time()])
        result = step()
        end = numpy.array([time.perf_counter(), time.process_time()])
        self.seconds[name] = self.seconds.get(name, 0) + end - start
        return result

    def tell(self):
        for name, seconds in self.seconds.items():
            everything = gather(seconds)
            if rank == 0:
                print(f"{name.strip('*'):<24} {everything[:, 0].max():7.2f} s, processor time "
                      f"{everything[:, 1].max():7.2f} s of the busiest process, "
                      f"{everything[:, 1].sum():7.2f} s of all", flush=True)


def show(dimensions, size, clock):
    """ParaView's picture of all pieces; the points of this process, with ghosts."""
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(os.environ["BRAVAIS_PLUGIN"], remote=False, ns=vars(simple))
    source = simple.BCCVolumeSource(Dimensions=dimensions)
    view = simple.CreateView("RenderView")
    view.ViewSize = [size, size]
    view.OrientationAxesVisibility = view.UseColorPaletteForBackground = view.UseFXAA = 0
    view.Background = [0, 0, 0]
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = EYE, [0, 0, 0], [0, 0, 1]
    display = simple.Show(source, view)
    display.SetRepresentationType("BCC Volume")
    simple.ColorBy(display, ("POINTS", "Scalars"))
    simple.GetColorTransferFunction("Scalars").RGBPoints = [0, *COLOR, 1, *COLOR]
    simple.GetOpacityTransferFunction("Scalars").Points = [0, 1, 0.5, 0, 1, 1, 0.5, 0]
    display.BCCBlendMode, display.BCCIsosurfaceValues, display.BCCShade = "Isosurface", [0.5], 1
    clock.measure("*source and first frame", lambda: simple.Render(view))
    view.CameraViewUp = [0, 0.01, 1]
    clock.measure("*next frame", lambda: simple.Render(view))
    view.CameraViewUp = [0, 0, 1]
    window = view.GetRenderWindow()
    simple.Render(view)
    pixels = vtkFloatArray()
    window.GetRGBAPixelData(0, 0, size - 1, size - 1, 0, pixels)
    points = source.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()
    picture = vtk_to_numpy(pixels)[:].reshape(size, size, 4).copy()
    simple.Delete(view)
    return picture, points


def make_scene(mapper, size):
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0, *COLOR)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().ShadeOn()
    volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.5)
    renderer = vtkRenderer()
    renderer.SetBackgroundAlpha(0)
    renderer.AddVolume(volume)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange((-1, 1, -1, 1, -1, 1))
    return window


def stream(dimensions, slabs, size, clock):
    """The picture of slabs that are made one at a time; the most points that this process has had."""
    whole = [n for d in dimensions for n in (0, d - 1)]
    cuts = [(dimensions[2] - 1) * n // slabs for n in range(slabs + 1)]
    # Front to back, as the eye is above: each process has slabs that follow one another.
    mine = list(reversed(range(slabs)))[slabs * rank // count:slabs * (rank + 1) // count]
    source = vtkBCCVolumeSource()
    source.SetDimensions(dimensions)
    mapper = vtkBCCVolumeMapper()
    mapper.SetBlendModeToIsoSurface()
    window = make_scene(mapper, size)
    picture = numpy.zeros((size, size, 4), numpy.float32)
    points = 0
    source.UpdateInformation()
    spacing = source.GetOutputInformation(0).Get(source.GetOutput().SPACING())
    ghosts = mapper.GetNumberOfGhostLevels(spacing)
    for slab in mine:
        own = whole[:4] + [cuts[slab], cuts[slab + 1]]
        held = whole[:4] + [max(own[4] - ghosts, 0), min(own[5] + ghosts, whole[5])]
        clock.measure("source", lambda: source.UpdateExtent(held))
        image = source.GetOutput()
        vtkBCCLattice.MarkPiece(image, whole, own)
        vtkBCCLattice.MarkWholeRange(image, "Scalars", 0, (0, 1))
        points = max(points, image.GetNumberOfPoints())
        mapper.SetInputDataObject(image)
        clock.measure("prefilter and rays", window.Render)
        pixels = vtkFloatArray()
        window.GetRGBAPixelData(0, 0, size - 1, size - 1, 0, pixels)
        behind = vtk_to_numpy(pixels).reshape(size, size, 4)
        picture += (1 - picture[..., 3:]) * behind
    pictures = clock.measure("*blending", lambda: gather(picture))
    result = numpy.zeros_like(picture)
    for one in pictures:
        result += (1 - result[..., 3:]) * one
    return result, points


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--dimensions", type=int, nargs=3, default=[512, 512, 1024])
    parser.add_argument("--pieces", type=int, default=0)
    parser.add_argument("--size", type=int, default=400)
    arguments = parser.parse_args()
    def make(dimensions, clock):
        if arguments.pieces:
            return stream(dimensions, arguments.pieces, arguments.size, clock)
        return show(dimensions, arguments.size, clock)

    make([24, 24, 48], Clock())  # compiles shaders
    before = get_peak()
    clock = Clock()
    picture, points = clock.measure("*all", lambda: make(arguments.dimensions, clock))
    clock.tell()
    rows = gather(numpy.array([before, get_peak(), points / 1e6]))
    if rank == 0:
        for number, (first, peak, held) in enumerate(rows):
            print(f"process {number}: {held:9.3f} million points at once, "
                  f"peak {peak:6.0f} MiB, {first:4.0f} before")
        levels = numpy.round(255 * picture[..., :3]).astype(numpy.uint8)
        shown = (levels.max(axis=2) > 0).mean()
        print(f"surface on {100 * shown:.1f} % of the pixels, "
              f"digest {hashlib.sha1(levels.tobytes()).hexdigest()[:12]}")


main()
