# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The converter of InVesalius projects."""
import io
import plistlib
import tarfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkMetaImageReader

import examples


class TestConvertInVesalius(examples.ExampleTest):
    def write_project(self, shape):
        values = examples.make_ball()
        settings = {"matrix": {"dtype": "int16", "filename": "matrix.dat", "shape": list(shape)},
                    "spacing": list(examples.SPACING)}
        path = self.path("ball.inv3")
        with tarfile.open(path, "w:gz") as archive:
            for name, content in (("main.plist", plistlib.dumps(settings)),
                                  ("matrix.dat", values.astype("<i2").tobytes())):
                member = tarfile.TarInfo("folder/" + name)
                member.size = len(content)
                archive.addfile(member, io.BytesIO(content))
        return path, values

    def test_values(self):
        path, values = self.write_project(examples.DIMENSIONS[::-1])
        self.passes(path, self.path("ball.mhd"))
        reader = vtkMetaImageReader()
        reader.SetFileName(self.path("ball.mhd"))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions(), examples.DIMENSIONS)
        self.assertEqual(image.GetSpacing(), examples.SPACING)
        self.assertTrue((vtk_to_numpy(image.GetPointData().GetScalars()) == values.ravel()).all())

    def test_bad_input(self):
        self.refuses("none.inv3", "none.inv3", "a.mhd")
        self.refuses("[2, 3, 4]", self.write_project((2, 3, 4))[0], "a.mhd")


if __name__ == "__main__":
    examples.main()
