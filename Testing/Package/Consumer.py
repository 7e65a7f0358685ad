# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import sys

import bravais
from bravais import vtkBCCLattice
import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

assert bravais.__file__.startswith(sys.argv[1]), bravais.__file__
image = vtkImageData()
image.SetDimensions(39, 39, 78)
vtkBCCLattice.Tag(image)
assert vtkBCCLattice.IsBCC(image)
values = numpy.arange(24.0).reshape(4, 3, 2)
assert (bravais.bcc_to_numpy(bravais.bcc_from_numpy(values)) == values).all()
volume = bravais.apply(bravais.vtkBCCVolumeSource, Dimensions=(2, 2, 4))
assert bravais.isosurface(volume, 0.5).GetMapper().IsA("vtkBCCVolumeMapper")
assert {"render", "rank1_sample"} < set(dir(bravais))
