# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes from files, and on the BCC lattice."""
import os
import tempfile

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkImagingCore import vtkImageMask
from vtkmodules.vtkImagingMorphological import vtkImageConnectivityFilter, vtkImageDilateErode3D
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader, vtkNrrdReader
from vtkmodules.vtkIOLegacy import vtkStructuredPointsReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkParallelCore import vtkDummyController

from bravais import vtkBCCLattice, vtkImageToBCCVolume

READERS = {
    ".vti": vtkXMLImageDataReader,
    ".mhd": vtkMetaImageReader,
    ".mha": vtkMetaImageReader,
    ".nii": vtkNIFTIImageReader,
    ".nii.gz": vtkNIFTIImageReader,
    ".nrrd": vtkNrrdReader,
    ".nhdr": vtkNrrdReader,
    ".vtk": vtkStructuredPointsReader,
}


class VolumeError(Exception):
    """One clear sentence for the user."""


class Errors:
    """Keeps what VTK reports off the screen; raises the first error as a VolumeError."""

    def __init__(self, subject=""):
        self.subject = subject

    def __enter__(self):
        self.window = vtkStringOutputWindow()
        self.former = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self.window

    def __exit__(self, kind, *unused):
        vtkOutputWindow.SetInstance(self.former)
        _, found, text = self.window.GetOutput().partition("ERROR: ")
        if found and kind is None:
            text = text.split("\n\n")[0].split("): ", 1)[-1].strip()
            raise VolumeError(self.subject + text)


def update(reader, path):
    """Some readers only warn of a file that ends too early, and MetaIO writes to stderr itself."""
    stderr = os.dup(2)
    with tempfile.TemporaryFile() as complaints:
        os.dup2(complaints.fileno(), 2)
        try:
            with Errors(f"{path}: ") as window:
                reader.Update()
        finally:
            os.dup2(stderr, 2)
            os.close(stderr)
        complaints.seek(0)
        text = window.GetOutput() + complaints.read().decode(errors="replace")
    if any(sign in text for sign in ("Error reading", "failed", "not read completely")):
        raise VolumeError(f"{path}: is truncated or damaged")


def read_volume(path):
    """The volume of a file: three dimensions and one scalar a point."""
    if not os.path.isfile(path):
        raise VolumeError(f"{path}: there is no such file")
    endings = [ending for ending in READERS if path.lower().endswith(ending)]
    if not endings:
        raise VolumeError(
            f"{path}: unknown type; expected .vti, .mhd, .mha, .nii, .nii.gz, .nrrd, .nhdr or "
            "legacy .vtk")
    reader = READERS[endings[-1]]()
    if hasattr(reader, "SetController"):  # the parallel one stands in for vtkNrrdReader
        reader.SetController(vtkDummyController())
    reader.SetFileName(path)
    update(reader, path)
    image = reader.GetOutput()
    if min(image.GetDimensions()) < 2:
        raise VolumeError(f"{path}: has {' x '.join(map(str, image.GetDimensions()))} points; "
                          "a volume has at least 2 along each axis")
    data = image.GetPointData()
    if not data.GetScalars() and data.GetNumberOfArrays() > 0:
        data.SetActiveScalars(data.GetArrayName(0))
    scalars = data.GetScalars()
    if not scalars or scalars.GetNumberOfTuples() < image.GetNumberOfPoints():
        raise VolumeError(f"{path}: has no values at its points")
    if scalars.GetNumberOfComponents() != 1:
        raise VolumeError(
            f"{path}: has {scalars.GetNumberOfComponents()} values a point; expected one")
    return image


def isolate_largest(image, threshold):
    """The lowest value everywhere but in and about the largest region above the threshold."""
    low, high = image.GetScalarRange()
    regions = vtkImageConnectivityFilter()
    regions.SetInputData(image)
    regions.SetScalarRange(threshold, high)
    regions.SetExtractionModeToLargestRegion()
    regions.SetLabelModeToConstantValue()
    regions.SetLabelConstantValue(1)
    regions.SetLabelScalarTypeToUnsignedChar()
    region = vtkImageDilateErode3D()
    region.SetInputConnection(regions.GetOutputPort())
    region.SetDilateValue(1)
    region.SetErodeValue(0)
    region.SetKernelSize(5, 5, 5)
    mask = vtkImageMask()
    mask.SetInputData(0, image)
    mask.SetInputConnection(1, region.GetOutputPort())
    mask.SetMaskedOutputValue(low)
    with Errors():
        mask.Update()
    return mask.GetOutput()


def resample_to_bcc(image, ratio):
    """The volume on an isotropic BCC lattice; itself if it is on a BCC lattice already."""
    if vtkBCCLattice.IsBCC(image):
        return image
    to_bcc = vtkImageToBCCVolume()
    to_bcc.SetInputData(image)
    to_bcc.SetSampleRatio(ratio)
    with Errors():
        to_bcc.Update()
    return to_bcc.GetOutput()
