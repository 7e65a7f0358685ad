#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A rank-1 texture that is larger than memory: made block by block, sampled through a cache.

    TextureOnDemand.py FILE.tif [--size PIXELS] [--points N] [--cache MEGABYTES]

writes the r-set of a zone plate of so many pixels on a side (16384), of which never more than some
rows exist at a time, looks it up along a path over the picture at many scales, and prints what it
took.
"""
import argparse
import os
import resource
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

from bravais import vtkRank1TextureFileWriter, vtkRank1TextureSampler

Pipeline = vtkStreamingDemandDrivenPipeline


class ZonePlate(VTKPythonAlgorithmBase):
    """128 + 127 cos of the squared distance from the middle, up to half a cycle a pixel."""

    def __init__(self, size):
        super().__init__(nInputPorts=0, outputType="vtkImageData")
        self.size = size

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.WHOLE_EXTENT(), (0, self.size - 1, 0, self.size - 1, 0, 0), 6)
        info.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        x0, x1, y0, y1, _, _ = (info.Get(Pipeline.UPDATE_EXTENT(), n) for n in range(6))
        x, y = (np.arange(a, b + 1, dtype=np.float32) + 0.5 - self.size / 2
                for a, b in ((x0, x1), (y0, y1)))
        scale = np.float32(np.pi / self.size)
        # The cosine of a sum from those of its terms.
        values = 128 + 127 * (np.cos(scale * y * y)[:, None] * np.cos(scale * x * x) -
                              np.sin(scale * y * y)[:, None] * np.sin(scale * x * x))
        image = vtkImageData.GetData(info)
        image.SetExtent(x0, x1, y0, y1, 0, 0)
        scalars = numpy_to_vtk(values.astype(np.uint8).ravel(), deep=True)
        image.GetPointData().SetScalars(scalars)
        return 1


def get_peak_memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--size", type=int, default=16384)
    parser.add_argument("--points", type=int, default=1000000)
    parser.add_argument("--cache", type=int, default=64)
    options = parser.parse_args()

    before = get_peak_memory()
    source = ZonePlate(options.size)
    writer = vtkRank1TextureFileWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(options.file)
    writer.SetCompression("none")
    start, processor = time.time(), time.process_time()
    if not writer.Write():
        raise SystemExit("The texture cannot be written.")
    print(f"wrote {os.path.getsize(options.file) / 2 ** 20:.1f} MB in {time.time() - start:.1f} s, "
          f"{time.process_time() - processor:.1f} s of processors, "
          f"with {get_peak_memory() - before:.1f} MB more memory")

    # A path of slow turns, and footprints of a texel to a tenth of the picture.
    along = np.linspace(0, 1, options.points)
    uv = np.c_[0.5 + 0.45 * np.cos(14 * along), 0.5 + 0.45 * np.sin(22 * along)]
    size = 1 / options.size * (0.1 * options.size) ** (0.5 - 0.5 * np.cos(50 * along))
    footprints = np.c_[size, 0 * size, 0 * size, size]
    sampler = vtkRank1TextureSampler()
    sampler.SetFileName(options.file)
    sampler.SetCacheSize(options.cache)
    values = vtkDoubleArray()
    start = time.time()
    if not sampler.Sample(numpy_to_vtk(uv), numpy_to_vtk(footprints), values):
        raise SystemExit("The texture cannot be sampled.")
    print(f"sampled {options.points} points in {time.time() - start:.2f} s: "
          f"{sampler.GetCacheHits()} hits, {sampler.GetCacheMisses()} misses, "
          f"peak of the cache {sampler.GetPeakCacheMemory() / 2 ** 20:.1f} MB, "
          f"mean {vtk_to_numpy(values).mean():.2f}")


if __name__ == "__main__":
    main()
