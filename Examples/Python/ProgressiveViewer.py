#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume that is coarse while the mouse drags it, and completes when the mouse rests.

    ProgressiveViewer.py [--block 2|4|8] [--size PIXELS] [--composite] [--output PICTURE]

opens a window. With --output no window is opened: the mouse drags once, and the picture shows the
passes 1, 4 and 16 (of blocks of 4 x 4 pixels) that follow, side by side.
"""
import argparse
import time

import numpy as np
import vtkmodules.vtkInteractionStyle
import vtkmodules.vtkRenderingOpenGL2
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume,
    vtkVolumeProperty, vtkWindowToImageFilter)

import pictures
from bravais import vtkBCCVolumeMapper, vtkBCCVolumeSource


def make_volume(composite):
    """The Marschner-Lobb signal: its surface at 1/2, or all of it as a haze."""
    source = vtkBCCVolumeSource()
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(0.01)
    if composite:
        mapper.SetJitterPatternToBayer()
    else:
        mapper.SetBlendModeToIsoSurface()
    look = vtkVolumeProperty()
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0.2, 0.15, 0.3, 0.7)
    colors.AddRGBPoint(0.5, 0.9, 0.75, 0.4)
    colors.AddRGBPoint(0.8, 0.7, 0.15, 0.1)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.4 if composite else 0, 0 if composite else 1)
    opacity.AddPoint(0.8 if composite else 1, 0.9 if composite else 1)
    look.SetColor(colors)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(0.1)
    look.ShadeOn()
    look.GetIsoSurfaceValues().SetValue(0, 0.5)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look)
    return volume


class Viewer:
    """A window in which the passes follow each other, a timer's tick at a time."""

    def __init__(self, volume, size, block, off_screen):
        self.mapper = volume.GetMapper()
        self.mapper.SetProgressivePatternSize(block)
        renderer = vtkRenderer()
        renderer.AddVolume(volume)
        renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.SetWindowName("Bravais: progressive refinement")
        self.window.SetOffScreenRendering(off_screen)
        self.window.SetSize(size, size)
        self.window.AddRenderer(renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        style = vtkmodules.vtkInteractionStyle.vtkInteractorStyleTrackballCamera()
        self.interactor.SetInteractorStyle(style)
        style.AddObserver("StartInteractionEvent", self.on_start)
        self.interactor.AddObserver("TimerEvent", self.on_timer)
        self.mapper.AddObserver(vtkBCCVolumeMapper.ProgressCompleteEvent, self.on_complete)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(1.2, -3, 2.2)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        camera.Zoom(1.3)

    def on_start(self, *unused):
        self.mapper.ProgressiveRefinementOn()

    def on_timer(self, *unused):
        if not self.mapper.GetProgressComplete():
            self.window.Render()

    def on_complete(self, *unused):
        print("complete")

    def run(self):
        self.interactor.Initialize()
        self.window.Render()
        self.interactor.CreateRepeatingTimer(10)
        self.interactor.Start()

    def drag(self):
        """As the user does: press and move."""
        self.interactor.SetEventInformation(100, 100)
        self.interactor.InvokeEvent("LeftButtonPressEvent")
        self.interactor.SetEventInformation(130, 105)
        self.interactor.InvokeEvent("MouseMoveEvent")

    def rest(self):
        """VTK draws when a button is released: that is the second pass."""
        self.interactor.InvokeEvent("LeftButtonReleaseEvent")

    def grab(self):
        capture = vtkWindowToImageFilter()
        capture.SetInput(self.window)
        capture.ReadFrontBufferOff()
        capture.ShouldRerenderOff()
        capture.Update()
        return pictures.to_array(capture.GetOutput())


def measure(what):
    start = time.process_time()
    what()
    return time.process_time() - start


def write_passes(viewer, path):
    viewer.interactor.Initialize()
    viewer.window.Render()  # makes everything ready
    plain = measure(viewer.window.Render)
    viewer.drag()
    shown = [viewer.grab()]
    times = [measure(viewer.rest)]
    while not viewer.mapper.GetProgressComplete():
        times.append(measure(viewer.on_timer))
        if len(times) + 1 in (4, 16):
            shown.append(viewer.grab())
    last = viewer.grab()
    viewer.mapper.ProgressiveRefinementOff()
    viewer.window.Render()
    same = np.array_equal(viewer.grab(), last)
    print(f"{len(times) + 1} passes of {1000 * np.mean(times):.1f} ms, at once {1000 * plain:.1f} ms;"
          f" the last picture {'is' if same else 'is not'} the plain one")
    pictures.write(path, np.hstack(shown))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--block", type=int, default=4, choices=(2, 4, 8))
    parser.add_argument("--size", type=int, default=500)
    parser.add_argument("--composite", action="store_true")
    parser.add_argument("--output")
    arguments = parser.parse_args()
    viewer = Viewer(make_volume(arguments.composite), arguments.size, arguments.block,
                    bool(arguments.output))
    if arguments.output:
        write_passes(viewer, arguments.output)
    else:
        viewer.run()


if __name__ == "__main__":
    main()
