# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What TestPictures runs by any number of processes: pictures of a BCC volume.

    mpirun -np 4 pvbatch --symmetric pictures.py <folder>

writes <picture>.png and, of every process, points.<process>.txt, how many points it has had.
"""
import os
import sys

import views
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

views.load_plugin()
folder = sys.argv[1]
os.environ["BRAVAIS_TEMPORARY"] = folder
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()

source = simple.BCCVolumeSource(Dimensions=[24, 24, 48])
filtered = simple.BCCPrefilter(Input=source)
tiny = simple.BCCVolumeSource(Dimensions=[2, 2, 2])
view = views.make_view(120)
view.UseFXAA = 0  # ParaView smooths pictures of several processes only.
view.CameraPosition = [2.5, -4, 3]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]


def show(proxy):
    result = simple.Show(proxy, view)
    result.SetRepresentationType("BCC Volume")
    simple.ColorBy(result, ("POINTS", "Scalars"))
    result.ScalarOpacityUnitDistance = 0.1
    return result


display = show(source)
colors = simple.GetColorTransferFunction("Scalars")
opacity = simple.GetOpacityTransferFunction("Scalars")


def take(name, mode, opacities, **properties):
    display.BCCBlendMode = mode
    # Whatever ParaView has scaled them to:
    colors.RGBPoints = [0, 0.2, 0.4, 1, 0.5, 1, 1, 0.6, 1, 1, 0.3, 0.1]
    opacity.Points = [number for point in opacities for number in (*point, 0.5, 0)]
    for key, value in properties.items():
        setattr(display, key, value)
    views.take_picture(view, name)


OPAQUE = (0, 1), (1, 1)
MILKY = (0, 0), (0.4, 0), (0.6, 0.3), (0.7, 0), (1, 0.3)
take("Composite", "Composite", MILKY, BCCShade=1)
take("Cropped", "Composite", MILKY, UseCropping=1, CroppingScale=[0.6, 0.6, 0.6])
take("Projection", "Composite", MILKY, BCCPrefilter="Projection", UseCropping=0)
take("Surface", "Isosurface", OPAQUE, BCCIsosurfaceValues=[0.5], BCCPrefilter="Quasi-interpolation")
take("SurfaceSteps", "Isosurface", OPAQUE, BCCSampleDistance=0.2)
take("SurfaceKernel", "Isosurface", OPAQUE, BCCKernel="bcc8, quintic", BCCSampleDistance=0)
image = source.GetClientSideObject().GetOutputDataObject(0)
with open(os.path.join(folder, f"points.{rank}.txt"), "w") as file:
    file.write(str(image.GetNumberOfPoints()))

display.BCCSliceFunction.Normal = [0.3, 1, 0.2]
take("Slice", "Slice", OPAQUE, BCCShade=0)
take("Maximum", "Maximum intensity", OPAQUE)

simple.Hide(source, view)
display = show(filtered)
take("Filtered", "Isosurface", OPAQUE, BCCIsosurfaceValues=[0.5], BCCPrefilter="None",
     BCCShade=1)
simple.Hide(filtered, view)
display = show(tiny)  # of which most processes have nothing
take("Tiny", "Composite", ((0, 0.1), (1, 0.2)))

for other in simple.GetViews():
    simple.Delete(other)
