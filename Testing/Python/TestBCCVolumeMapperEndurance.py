# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""
Many frames of changing data, kernels, sizes and modes take no more memory, and OpenGL has nothing to
object to. The number of frames may be given: `python3 TestBCCVolumeMapperEndurance.py 10000`.
"""
import ctypes
import gc
import os
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLHardwareSelector

import scenes
from bravais import vtkBCCVolumeMapper

MODES = ("Composite", "IsoSurface", "MaximumIntensity")
KERNELS = (7, 12)
frames = 120

GL_DEBUG_OUTPUT = 0x92E0
GL_DEBUG_OUTPUT_SYNCHRONOUS = 0x8242
GL_DEBUG_TYPES = {0x824C: "error", 0x824E: "undefined behavior"}


class DebugLog:
    """What OpenGL objects to in the current context."""

    def __init__(self):
        library = ctypes.CDLL("libGL.so.1")
        self.get_error = library.glGetError
        find = library.glXGetProcAddressARB
        find.restype = ctypes.c_void_p
        self.get_log = ctypes.CFUNCTYPE(
            ctypes.c_uint, ctypes.c_uint, ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p,
            ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p)(
                find(b"glGetDebugMessageLog"))
        library.glEnable(GL_DEBUG_OUTPUT)
        library.glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS)
        self.library = library

    def take(self):
        """The messages since the last call."""
        messages = []
        kind, length = ctypes.c_uint(), ctypes.c_int()
        text = ctypes.create_string_buffer(4096)
        while self.get_log(1, len(text), None, ctypes.byref(kind), None, None,
                           ctypes.byref(length), text):
            if kind.value in GL_DEBUG_TYPES:
                messages.append(f"{GL_DEBUG_TYPES[kind.value]}: {text.value.decode()}")
        return messages


def make_values(dimensions, phase, dtype=numpy.float32):
    return scenes.make_bcc(
        lambda x, y, z: 40 + 30 * numpy.sin(3 * x + phase) * numpy.cos(2 * y - z),
        dimensions, dtype=dtype)


def make_scene(kernel=7, mode="Composite"):
    mapper = vtkBCCVolumeMapper()
    mapper.SetKernel(kernel)
    mapper.SetInputData(make_values((8, 8, 16), 0))
    getattr(mapper, "SetBlendModeTo" + mode)()
    volume_property = scenes.make_property(
        0, 80, ((0, 0), (30, 0.1), (80, 1)), iso_values=(35, 50))
    volume_property.SetSliceFunction(vtkPlane())
    return scenes.Scene(mapper, volume_property, size=32, sample_distance=0.1)


def get_memory():
    """Resident bytes."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def vary(scene, number):
    """Everything changes, with periods that have no common factor."""
    mapper = scene.volume.GetMapper()
    mapper.SetKernel(KERNELS[number % 2])
    getattr(mapper, "SetBlendModeTo" + MODES[number % 3])()
    mapper.SetPrefilter(number % 5 % 2)
    if number % 5 == 0:
        values = vtk_to_numpy(mapper.GetInput().GetPointData().GetScalars())
        values[:] = values[::-1].copy()
        mapper.GetInput().GetPointData().GetScalars().Modified()
        mapper.GetInput().Modified()
    elif number % 5 == 1:
        n = 6 + number % 4
        mapper.SetInputData(make_values((n, n + 1, 2 * n), number % 11,
                                        (numpy.float32, numpy.int16, numpy.float64)[number % 7 % 3]))
    scene.window.SetSize(24 + 8 * (number % 4), 32)
    scene.volume.GetProperty().GetScalarOpacity().AddPoint(30, 0.1 + number % 7 / 10)
    if number % 41 == 40:
        scene.volume.ReleaseGraphicsResources(scene.window)
    if number % 149 == 148:
        scene.window.Finalize()
    scene.window.Render()


class TestBCCVolumeMapperEndurance(unittest.TestCase):
    def test_memory_does_not_grow(self):
        scene = make_scene()
        warm = 60  # by then each shader has been made
        for number in range(warm):
            vary(scene, number)
        before = get_memory()
        for number in range(warm, warm + frames):
            vary(scene, number)
        growth = get_memory() - before
        print(f"{frames} frames: {growth / 1024:.0f} KiB more than {before / 1048576:.0f} MiB")
        # Allocators and drivers keep a little; a volume's coefficients are some 20 KiB.
        self.assertLess(growth, 8 * 1048576)

    def test_opengl_has_nothing_to_object_to(self):
        for kernel, mode in ((7, "Composite"), (12, "IsoSurface"), (4, "Slice")):
            scene = make_scene(kernel, mode)
            scene.window.Render()
            scene.window.MakeCurrent()
            log = DebugLog()
            log.library.glBindTexture(0x1234, 0)  # an error that it has to see
            self.assertEqual(len(log.take()), 1)
            self.assertEqual(log.get_error(), 0x0500)

            mapper = scene.volume.GetMapper()
            selector = vtkOpenGLHardwareSelector()
            selector.SetRenderer(scene.renderer)
            selector.SetFieldAssociation(1)
            selector.SetArea(0, 0, 31, 31)
            mask = vtkImageData()
            mask.CopyStructure(mapper.GetInput())
            mask.AllocateScalars(3, 1)
            mask.GetPointData().GetScalars().Fill(1)
            for step in (lambda: None, mapper.AnalyticGradientsOff, mapper.UseJitteringOn,
                         selector.Select, mapper.CroppingOn, lambda: mapper.SetMaskInput(mask),
                         mapper.RenderToImageOn, mapper.RenderToImageOff,
                         lambda: mapper.SetInputData(make_values((5, 6, 7), 1)),
                         lambda: scene.volume.ReleaseGraphicsResources(scene.window)):
                step()
                scene.window.Render()
                self.assertEqual(log.take(), [], f"bcc{kernel}, {mode}")
                self.assertEqual(log.get_error(), 0)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        frames = int(sys.argv.pop())
    unittest.main()
