#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a volume on the body-centred cubic lattice, reconstructed by a box-spline."""
import argparse
import math
import os
import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401  for --interactive
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the renderer
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
    vtkVolume, vtkVolumeProperty, vtkWindowToImageFilter)

from bravais import vtkBCCVolumeMapper
from volumes import Errors, VolumeError, isolate_largest, read_volume, resample_to_bcc

KERNELS = {"bcc4": 4, "bcc7": 7, "bcc8": 8, "bcc12": 12}
PREFILTERS = {"none": 0, "quasi-interpolation": 1, "interpolation": 2, "projection": 3}
SKIN = (0.93, 0.71, 0.58)
BONE = (0.96, 0.91, 0.80)


def number(text):
    value = float(text)
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text} is not a finite number")
    return value


def positive(text):
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text} is not positive")
    return value


def pixels(text):
    value = int(text)
    if not 1 <= value <= 8192:
        raise argparse.ArgumentTypeError(f"{text} is not between 1 and 8192")
    return value


def numbers(text):
    return [number(part) for part in text.split(",")]


def parse_command_line():
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("volume", help="file: .vti, .mhd, .nii, .nii.gz, .nrrd or legacy .vtk")
    add("-i", "--isovalue", type=numbers, metavar="V,...",
        help="values to show; by default the middle of the volume's range. Negative: -i=-300,300")
    add("--isolate", type=number, metavar="V", help="keep only the largest region above this value")
    add("-m", "--mode", choices=["isosurface", "composite", "mip"], default="isosurface")
    add("-s", "--size", type=pixels, nargs=2, default=[600, 600], metavar=("W", "H"),
        help="width and height of the picture (600 600)")
    add("-o", "--output", default="volume.png", help="picture to write, a PNG (%(default)s)")
    add("--interactive", action="store_true", help="open a window instead of writing a picture")
    sampling = parser.add_argument_group("sampling").add_argument
    sampling("-r", "--ratio", type=number, default=1.0,
             help="BCC samples per sample of the file (%(default)s)")
    sampling("-k", "--kernel", choices=KERNELS, default="bcc7", help="box-spline (%(default)s)")
    sampling("-p", "--prefilter", choices=PREFILTERS, default="quasi-interpolation",
             help="samples to coefficients (%(default)s)")
    view = parser.add_argument_group("view").add_argument
    axes = {"type": number, "nargs": 3, "metavar": tuple("XYZ")}
    view("--from", dest="eye", default=[0.55, -1, 0.35], **axes,
         help="direction from the volume to the eye (0.55 -1 0.35)")
    view("--up", default=[0, 0, 1], **axes, help="direction that is up (0 0 1)")
    view("--focus", default=[0.5, 0.5, 0.5], **axes,
         help="middle of the picture, in fractions of the box")
    view("--crop", type=number, nargs=6, default=[0, 1, 0, 1, 0, 1],
         metavar=("X0", "X1", "Y0", "Y1", "Z0", "Z1"),
         help="part to draw, in fractions of the box")
    view("--zoom", type=positive, default=1.0, help="magnification; at 1 all is seen (1)")
    return parser.parse_args()


def find_isovalues(image, values):
    low, high = image.GetScalarRange()
    for value in values or []:
        if not low <= value <= high:
            raise VolumeError(
                f"isovalue {value:g} is outside the volume's values, {low:g} to {high:g}")
    return sorted(values) if values else [(low + high) / 2]


def make_property(mode, values, low, high, unit_distance):
    """Surfaces or layers at the values, from skin to bone, only the highest opaque; or greys."""
    colors = vtkColorTransferFunction()
    opacities = vtkPiecewiseFunction()
    appearance = vtkVolumeProperty()
    if mode == "mip":
        colors.AddRGBPoint(low, 0, 0, 0)
        colors.AddRGBPoint(high, 1, 1, 1)
        opacities.AddPoint(low, 0)
        opacities.AddPoint(high, 1)
    else:
        below = 0.0
        opacities.AddPoint(low, 0)
        for place, value in enumerate(values):
            t = place / (len(values) - 1) if len(values) > 1 else 1
            color = [(1 - t) * s + t * b for s, b in zip(SKIN, BONE)]
            opacity = 0.3 if place < len(values) - 1 else 1.0
            former = values[place - 1] if place else low
            after = values[place + 1] if place < len(values) - 1 else high
            ramp = 0.15 * min(after - value, value - former) if mode == "composite" else 0
            opacities.AddPoint(value - ramp, below if ramp else opacity)
            opacities.AddPoint(value + ramp, opacity)
            if place == 0:
                colors.AddRGBPoint(low, *color)
            colors.AddRGBPoint(value - ramp, *color)
            colors.AddRGBPoint(value + ramp, *color)
            appearance.GetIsoSurfaceValues().SetValue(place, value)
            below = opacity if mode == "isosurface" else 0.1 * opacity
            if place < len(values) - 1 and ramp:
                opacities.AddPoint(value + 3 * ramp, below)
    appearance.SetColor(colors)
    appearance.SetScalarOpacity(opacities)
    appearance.SetScalarOpacityUnitDistance(unit_distance)
    appearance.SetInterpolationTypeToLinear()
    appearance.SetShade(mode != "mip")
    appearance.SetAmbient(0.16)
    appearance.SetDiffuse(0.85)
    appearance.SetSpecular(0.22)
    appearance.SetSpecularPower(24)
    return appearance


def make_volume(image, values, options):
    edge = math.prod(image.GetSpacing()) ** (1 / 3)
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(image)
    mapper.SetKernel(KERNELS[options.kernel])
    mapper.SetPrefilter(PREFILTERS[options.prefilter])
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.5 * edge)
    {"isosurface": mapper.SetBlendModeToIsoSurface, "composite": mapper.SetBlendModeToComposite,
     "mip": mapper.SetBlendModeToMaximumIntensity}[options.mode]()
    box = mapper.GetBounds()
    if options.crop != [0, 1, 0, 1, 0, 1]:
        mapper.SetCroppingRegionPlanes([
            box[p // 2 * 2] + c * (box[p // 2 * 2 + 1] - box[p // 2 * 2])
            for p, c in enumerate(options.crop)])
        mapper.SetCroppingRegionFlagsToSubVolume()
        mapper.CroppingOn()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(make_property(options.mode, values, *image.GetScalarRange(), edge))
    return volume, box


def add_light(renderer, position, intensity, color):
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(position)
    light.SetIntensity(intensity)
    light.SetColor(color)
    renderer.AddLight(light)


def look(renderer, box, options):
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(20)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(options.eye)
    camera.SetViewUp(options.up)
    renderer.ResetCamera(box)
    shift = [(options.focus[a] - 0.5) * (box[2 * a + 1] - box[2 * a]) for a in range(3)]
    camera.SetPosition([p + s for p, s in zip(camera.GetPosition(), shift)])
    camera.SetFocalPoint([p + s for p, s in zip(camera.GetFocalPoint(), shift)])
    camera.Zoom(options.zoom)
    renderer.ResetCameraClippingRange(box)


def make_window(volume, box, options):
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.05, 0.06, 0.09)
    renderer.SetBackground2(0.22, 0.27, 0.36)
    renderer.AutomaticLightCreationOff()
    add_light(renderer, (-0.6, 0.7, 1.0), 1.05, (1.0, 0.97, 0.92))
    add_light(renderer, (1.0, 0.1, 0.7), 0.45, (0.85, 0.92, 1.0))
    renderer.AddVolume(volume)
    look(renderer, box, options)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(not options.interactive)
    window.SetMultiSamples(0)
    window.SetSize(options.size)
    window.AddRenderer(renderer)
    return window


def write_picture(window, path):
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(path)
    with Errors(f"{path}: "):
        writer.Write()


def interact(window, title):
    interactor = vtkRenderWindowInteractor()
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.SetRenderWindow(window)
    window.SetWindowName(title)
    window.Render()
    interactor.Start()


def main():
    options = parse_command_line()
    try:
        image = read_volume(options.volume)
        values = find_isovalues(image, options.isovalue)
        if options.isolate is not None:
            image = isolate_largest(image, options.isolate)
        image = resample_to_bcc(image, options.ratio)
        if sys.platform == "linux" and not os.environ.get("DISPLAY"):
            raise VolumeError("there is no display; DISPLAY=:1 or xvfb-run may help")
        volume, box = make_volume(image, values, options)
        window = make_window(volume, box, options)
        with Errors():
            window.Render()
        if options.interactive:
            interact(window, options.volume)
        else:
            write_picture(window, options.output)
            size = " x ".join(map(str, image.GetDimensions()))
            print(f"{options.output}: {size} samples, {options.kernel}")
    except VolumeError as error:
        sys.exit(f"BCCVolumeViewer.py: error: {error}")


if __name__ == "__main__":
    main()
