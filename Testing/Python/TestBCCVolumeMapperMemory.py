# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coefficients are held once, bricks take little beside them, and half floats err as they tell."""
import unittest

import numpy

import scenes
from bravais import vtkBCCVolumeMapper


def wave(x, y, z):
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


def make_scene(image=None, prepare=None, size=48, high=1):
    mapper = vtkBCCVolumeMapper()
    mapper.SetKernelToBCC4()
    mapper.SetInputData(image or scenes.make_bcc(wave))
    if prepare:
        prepare(mapper)
    return scenes.Scene(mapper, scenes.make_property(
        -high, high, ((-high, 0), (0, 0), (high, 0.9)), shade=False), size=size)


class TestBCCVolumeMapperMemory(unittest.TestCase):
    def observe(self, scene):
        """The errors of two frames, and the picture."""
        errors = []

        def observer(caller, event, text):
            errors.append(text)
        observer.CallDataType = "string0"
        tag = scene.volume.GetMapper().AddObserver("ErrorEvent", observer)
        scene.render()
        picture = scene.render()
        scene.volume.GetMapper().RemoveObserver(tag)
        return errors, picture

    def check_refused(self, scene, *words):
        errors, picture = self.observe(scene)
        self.assertEqual(len(errors), 1, errors)
        for word in words:
            self.assertIn(word, errors[0])
        self.assertEqual(picture.std(axis=(0, 1)).max(), 0)

    def check_shown(self, scene):
        errors, picture = self.observe(scene)
        self.assertEqual(errors, [])
        self.assertGreater(picture.std(axis=(0, 1)).max(), 5)
        return picture

    def test_bricks_take_less_than_a_fiftieth(self):
        image = scenes.make_bcc(wave, (80, 80, 160))
        for half in (False, True):
            scene = make_scene(image)
            mapper = scene.volume.GetMapper()
            mapper.SetHalfFloatCoefficients(half)
            for mode in ("Composite", "MaximumIntensity"):
                getattr(mapper, "SetBlendModeTo" + mode)()
                self.check_shown(scene)
                self.assertGreater(mapper.GetBrickMemory(), 0)
                self.assertLess(mapper.GetBrickMemory(), 0.02 * mapper.GetCoefficientMemory())
            # Once, with the halo of two texels on every side of both cosets.
            texels = 84 * 84 * 168
            self.assertEqual(mapper.GetCoefficientMemory(), texels * (2 if half else 4))

    def test_half_floats_err_no_more_than_they_tell(self):
        image = scenes.make_bcc(wave)
        for kernel in (4, 7, 12):
            scene = make_scene(image)
            mapper = scene.volume.GetMapper()
            mapper.SetKernel(kernel)
            expected = self.check_shown(scene)
            self.assertEqual(mapper.GetCoefficientError(), 0)
            mapper.HalfFloatCoefficientsOn()
            picture = self.check_shown(scene)
            error = mapper.GetCoefficientError()
            self.assertGreater(error, 0)
            # 2^-11 of the largest number; of 1 and a little more between 1 and 2.
            self.assertLess(error, 2 ** -10)
            self.assertLess(numpy.abs(picture - expected).mean(), 0.2)
            self.assertGreater(numpy.abs(picture - expected).max(), 0)
            mapper.EmptySpaceSkippingOff()
            numpy.testing.assert_array_equal(scene.render(), picture)
            mapper.HalfFloatCoefficientsOff()
            numpy.testing.assert_array_equal(scene.render(), expected)
        self.assertEqual(mapper.GetCoefficientError(), 0)

    def test_what_half_floats_hold(self):
        image = scenes.make_bcc(lambda x, y, z: 1000 + 30 * wave(x, y, z))
        self.check_refused(make_scene(image, lambda m: m.HalfFloatCoefficientsOn(), high=1030),
                           "HalfFloatCoefficients", "1/512")
        image = scenes.make_bcc(lambda x, y, z: numpy.round(100 * wave(x, y, z)))
        scene = make_scene(image, lambda m: m.SetPrefilterToNone(), high=100)
        scene.volume.GetMapper().HalfFloatCoefficientsOn()
        self.check_shown(scene)
        self.assertEqual(scene.volume.GetMapper().GetCoefficientError(), 0)  # small integers

    def test_half_floats_hold_no_large_numbers(self):
        self.check_refused(make_scene(scenes.make_bcc(lambda x, y, z: 1e6 * wave(x, y, z)),
                                      lambda m: m.HalfFloatCoefficientsOn(), high=1e6), "inf")

    def test_memory_limit(self):
        # 28 x 28 texels in 2 x 28 slices, of 4 bytes.
        for kib, half, shown in ((160, False, False), (180, False, True), (80, True, False),
                                 (90, True, True)):
            scene = make_scene()
            mapper = scene.volume.GetMapper()
            mapper.SetHalfFloatCoefficients(half)
            mapper.SetMaxMemoryFraction(1)
            mapper.SetMaxMemoryInBytes(kib * 1024)
            if shown:
                self.check_shown(scene)
                mapper.SetMaxMemoryFraction(0.5)
            self.check_refused(scene, "MaxMemoryInBytes", str(28 * 28 * 56 * (2 if half else 4)))
            mapper.SetMaxMemoryInBytes(1 << 30)
            self.check_shown(scene)


if __name__ == "__main__":
    unittest.main()
