# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""An MRI of a brain, read by ParaView, resampled, and shown on the BCC lattice.

The picture is compared with ParaView's own of the same isosurface, from the Cartesian samples, and
with a baseline.
"""
import gzip
import os
import shutil
import unittest

import views
from paraview import simple

views.load_plugin()
simple.LoadPlugin(os.environ["BRAVAIS_NIFTI_PLUGIN"], remote=False, ns=vars(simple))


class TestBrain(unittest.TestCase):
    def test_isosurface(self):
        path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], "brain.nii")
        with gzip.open(os.environ["BRAVAIS_BRAIN"]) as packed, open(path, "wb") as file:
            shutil.copyfileobj(packed, file)  # ParaView's reader takes no .nii.gz
        brain = simple.NIfTIVolumereader(FileName=path)
        brain.UpdatePipeline()
        name = brain.PointData[0].Name
        bounds = brain.GetDataInformation().GetBounds()
        # A quarter of the samples is enough for a small picture.
        volume = simple.ImageToBCCVolume(Input=brain, SampleRatio=0.25)
        pictures = []
        for source, kind in (brain, "Volume"), (volume, "BCC Volume"):
            view = views.make_view()
            display = simple.Show(source, view)
            display.SetRepresentationType(kind)
            simple.ColorBy(display, ("POINTS", name))
            prefix = "BCC" if kind == "BCC Volume" else ""
            setattr(display, prefix + "BlendMode", "Isosurface")
            setattr(display, prefix + "IsosurfaceValues", [60])
            setattr(display, prefix + "Shade", 1)
            simple.GetColorTransferFunction(name).RGBPoints = [0, 0.9, 0.7, 0.6, 255, 0.9, 0.7, 0.6]
            view.CameraFocalPoint = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
            view.CameraPosition = [view.CameraFocalPoint[0] - 270, bounds[3] + 70, bounds[5] + 170]
            view.CameraViewUp = [0, 0, 1]
            pictures.append(views.take_picture(view, "Brain" + prefix))
        self.assertGreater(views.get_shown(pictures[1]).mean(), 0.1)
        # Normals differ: the one picture shows every voxel, the other is smooth.
        self.assertLess(views.differ(*pictures), 30)
        overlap = views.get_shown(pictures[0]) == views.get_shown(pictures[1])
        self.assertGreater(overlap.mean(), 0.97)
        path = os.path.join(os.environ["BRAVAIS_BASELINES"], "TestBrain.png")
        self.assertLess(views.differ(pictures[1], views.read_picture(path)), 2)


if __name__ == "__main__":
    views.run()
