# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings that VTK's mapper crashes at or draws nothing for get one error, or work."""
import math
import unittest

import numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkStringOutputWindow, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkSphere
from vtkmodules.vtkRenderingCore import vtkLight

import scenes
from bravais import vtkBCCVolumeMapper

IMAGE = scenes.make_bcc(lambda x, y, z: numpy.sqrt(x * x + y * y + z * z), (8, 8, 16))


def make_labels(label):
    mask = vtkImageData()
    mask.SetDimensions(4, 4, 4)
    mask.SetOrigin(-1, -1, -1)
    mask.SetSpacing(2 / 3, 2 / 3, 2 / 3)
    mask.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    mask.GetPointData().GetScalars().Fill(label)
    return mask


class TestBCCVolumeMapperBadSettings(unittest.TestCase):
    def setUp(self):
        self.mapper = vtkBCCVolumeMapper()
        self.mapper.SetInputData(IMAGE)
        self.errors = []

        def observe(caller, event, text):
            self.errors.append(text)
        observe.CallDataType = "string0"
        self.mapper.AddObserver("ErrorEvent", observe)
        self.property = scenes.make_property(0, 1.7, ((0, 1), (1.7, 0.2)), iso_values=(0.5,))
        self.scene = scenes.Scene(self.mapper, self.property, size=50, sample_distance=0.1)
        self.shader = self.scene.volume.GetShaderProperty()
        self.others = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.others)

    def tearDown(self):
        vtkOutputWindow.SetInstance(None)

    def is_empty(self):
        return self.scene.render().std(axis=(0, 1)).max() == 0

    def check_refused(self, *words):
        """One error in three frames, without a picture, and none of other objects."""
        self.errors.clear()
        for _ in range(3):
            self.assertTrue(self.is_empty())
        self.assertEqual(len(self.errors), 1, self.errors)
        for word in words:
            self.assertIn(word, self.errors[0])
        self.assertEqual(self.others.GetOutput(), "")

    def check_shown(self):
        self.errors.clear()
        self.assertFalse(self.is_empty())
        self.assertEqual(self.errors, [])

    def test_shader_that_does_not_compile(self):
        for mode in ("Composite", "IsoSurface", "MaximumIntensity"):
            for to_image in (False, True):
                getattr(self.mapper, "SetBlendModeTo" + mode)()
                self.mapper.SetRenderToImage(to_image)
                self.shader.AddFragmentShaderReplacement(
                    "//VTK::Base::Exit", True, "//VTK::Base::Exit\n  not_declared = 1;", False)
                self.check_refused("does not compile", "not_declared")
                self.shader.ClearAllFragmentShaderReplacements()
                if not to_image:  # which shows nothing in the window
                    self.check_shown()

    def test_replacements_after_vtks(self):
        self.shader.AddFragmentShaderReplacement(
            "g_dataPos += g_dirStep;", False, "g_dataPos += not_there;", True)
        self.check_refused("does not compile", "not_there")
        # Any change has it reported anew.
        self.mapper.SetSampleDistance(0.05)
        self.check_refused("does not compile", "not_there")

    def test_vertex_shader_and_linking(self):
        self.shader.AddVertexShaderReplacement(
            "//VTK::Base::Dec", True, "//VTK::Base::Dec\nvec3 broken(;", False)
        self.check_refused("does not compile")
        self.shader.ClearAllVertexShaderReplacements()
        self.shader.AddFragmentShaderReplacement(
            "//VTK::Base::Dec", True, "//VTK::Base::Dec\nfloat nowhere();", False)
        self.shader.AddFragmentShaderReplacement(
            "//VTK::Base::Exit", True, "//VTK::Base::Exit\n  g_fragColor.r = nowhere();", False)
        self.check_refused("does not compile", "nowhere")
        self.shader.ClearAllFragmentShaderReplacements()
        self.check_shown()

    def test_slice_function(self):
        self.mapper.SetBlendModeToSlice()
        self.check_refused("SliceFunction", "vtkPlane")
        self.property.SetSliceFunction(vtkSphere())
        self.mapper.Modified()
        self.check_refused("SliceFunction", "vtkPlane")

    def test_blend_mode(self):
        self.mapper.SetBlendMode(7)
        self.check_refused("BlendMode is 7")
        self.mapper.SetBlendModeToAdditive()
        self.check_shown()

    def test_dependent_components(self):
        self.property.IndependentComponentsOff()
        self.check_refused("IndependentComponents", "1 component")

    def test_second_axis_of_transfer_functions(self):
        self.property.SetTransferFunctionMode(1)
        self.mapper.SetTransfer2DYAxisArray("Other")
        self.check_refused("Transfer2DYAxisArray", "Other")

    def test_lights(self):
        self.check_shown()
        for number in range(6):  # and the renderer's own
            light = vtkLight()
            light.SetPosition(number, 1, 2)
            self.scene.renderer.AddLight(light)
        self.check_refused("7 lights")
        light.SwitchOff()
        self.check_shown()

    def test_sample_distances(self):
        for distance in (0.0, -1.0, math.nan, math.inf, 1e-30):
            self.mapper.SetSampleDistance(distance)
            self.check_refused(f"SampleDistance is {distance:g}")
            self.mapper.AutoAdjustSampleDistancesOn()  # where it is not asked for
            self.check_shown()
            self.mapper.AutoAdjustSampleDistancesOff()
        self.mapper.SetSampleDistance(0.1)
        self.mapper.SetImageSampleDistance(math.nan)
        self.check_refused("ImageSampleDistance is nan")
        self.mapper.SetImageSampleDistance(51)
        self.check_refused("ImageSampleDistance is 51", "50 x 50")
        self.mapper.SetImageSampleDistance(1)
        self.check_shown()

    def test_sample_distances_by_the_spacing(self):
        """Layers next to each other in a wide volume."""
        flat = vtkImageData()
        flat.ShallowCopy(IMAGE)
        flat.SetSpacing(1, 1, 1e-8)
        self.mapper.SetInputData(flat)
        self.mapper.AutoAdjustSampleDistancesOn()
        self.check_refused("sample distance by the input's spacing is 1e-08")
        self.mapper.AutoAdjustSampleDistancesOff()
        self.check_shown()
        self.mapper.LockSampleDistanceToInputSpacingOn()
        self.check_shown()
        self.mapper.SetSampleDistance(math.nan)
        self.check_refused("sample distance by the input's spacing is nan")

    def test_sample_distances_are_the_inputs(self):
        """As VTK has them, however large the volume is in the world."""
        self.scene.volume.SetScale(1e7)
        self.scene.renderer.ResetCamera()
        self.check_shown()

    def test_isovalues(self):
        self.mapper.SetBlendModeToIsoSurface()
        self.property.GetIsoSurfaceValues().SetValue(1, math.nan)
        self.check_refused("IsoSurfaceValues is nan")
        self.property.GetIsoSurfaceValues().SetNumberOfContours(1)
        self.check_shown()

    def test_mask_without_labels(self):
        self.mapper.SetMaskInput(vtkImageData())
        self.check_refused("mask")

    def test_masks_that_come_late_and_change(self):
        self.check_shown()
        first = self.scene.render()
        self.mapper.SetMaskInput(make_labels(0))  # a label map, after a frame without
        numpy.testing.assert_array_equal(self.scene.render(), first)
        self.mapper.SetMaskTypeToBinary()
        self.assertTrue(self.is_empty())
        self.mapper.SetMaskInput(make_labels(255))
        numpy.testing.assert_array_equal(self.scene.render(), first)
        self.property.SetAmbient(0.5)
        self.assertFalse(self.is_empty())
        self.mapper.SetMaskTypeToLabelMap()
        self.assertFalse(self.is_empty())
        self.mapper.SetMaskInput(None)
        self.property.SetAmbient(scenes.make_property(0, 1, ()).GetAmbient())
        numpy.testing.assert_array_equal(self.scene.render(), first)
        self.mapper.SetMaskInput(make_labels(0))
        numpy.testing.assert_array_equal(self.scene.render(), first)
        self.assertEqual(self.errors, [])


if __name__ == "__main__":
    unittest.main()
