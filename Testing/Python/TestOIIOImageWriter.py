# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import itertools
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingSources import vtkImageMandelbrotSource
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

from bravais import vtkOIIOImageReader, vtkOIIOImageWriter
from checks import Errors, make_image, to_numpy

# What can be stored without loss: extension, types, numbers of components.
LOSSLESS = [
    (".exr", (np.uint32, np.float32), (1, 2, 3, 4, 7)),
    (".tif", (np.uint8, np.int8, np.uint16, np.int16, np.uint32, np.int32, np.float32, np.float64),
     (1, 2, 3, 4, 5)),
    (".png", (np.uint8, np.uint16), (1, 2, 3, 4)),
    (".ppm", (np.uint8,), (1, 3)),
    (".bmp", (np.uint8,), (1, 3, 4)),
    (".tga", (np.uint8,), (1, 3, 4)),
    (".sgi", (np.uint8, np.uint16), (1, 3, 4)),
    (".dpx", (np.uint8, np.uint16), (3, 4)),
    (".fits", (np.uint8, np.int16, np.int32, np.float32, np.float64), (1, 3))]


class TestOIIOImageWriter(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def path(self, name):
        return str(self.folder / name)

    def writer(self, image, name, **properties):
        writer = vtkOIIOImageWriter()
        writer.SetInputData(make_image(image) if isinstance(image, np.ndarray) else image)
        writer.SetFileName(self.path(name))
        for key, value in properties.items():
            getattr(writer, "Set" + key)(value)
        return writer

    def write(self, *arguments, **properties):
        writer = self.writer(*arguments, **properties)
        writer.Write()
        self.assertEqual(writer.GetErrorCode(), 0)

    def read(self, name):
        reader = vtkOIIOImageReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        return reader.GetOutput()

    def refuses(self, writer, *words):
        """One error that has all these words in it, and no file."""
        before = sorted(os.listdir(self.folder))
        with Errors(writer) as errors:
            writer.Write()
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        self.assertNotEqual(writer.GetErrorCode(), 0)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def make_picture(self, components, dtype):
        info = np.iinfo(dtype) if np.issubdtype(dtype, np.integer) else None
        generator = np.random.default_rng(3)
        shape = (1, 66, 71, components)
        values = (generator.integers(info.min, info.max, shape, dtype, True) if info
                  else generator.normal(0, 1e4, shape).astype(dtype))
        return values[..., 0] if components == 1 else values

    def test_round_trips(self):
        for extension, types, numbers in LOSSLESS:
            for dtype in types:
                for components in numbers:
                    values = self.make_picture(components, dtype)
                    name = "a" + extension
                    self.write(values, name)
                    result = to_numpy(self.read(name))
                    self.assertEqual(result.dtype, dtype, name)
                    np.testing.assert_array_equal(result, values, f"{name} {dtype} {components}")

    def test_what_is_accepted_comes_back(self):
        names = "bmp dpx exr fits gif hdr ico iff jp2 jpg pgm png ppm rla sgi tga tif webp zfile"
        lossy = "gif", "hdr", "jpg", "webp"
        types = "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64"
        y, x = np.mgrid[0:20, 0:25]
        accepted = set()
        for name, dtype, count in itertools.product(names.split(), types.split(), range(1, 6)):
            info = np.iinfo(dtype) if "int" in dtype else None
            ramps = ((x + y + 7)[..., None] * np.arange(1, 3 * count, 3) % 100).astype(dtype)
            noise = np.random.default_rng(4).uniform(0, 1, ramps.shape)
            noise = (noise * (info.max if info else 1)).astype(dtype)
            soft = (10 + (x + y)[..., None] + 4 * np.arange(count)).astype(dtype)
            for values in (soft,) if name in lossy else (ramps, noise, noise[:1], noise[:1, :1]):
                values = values[None, ..., 0] if count == 1 else values[None]
                writer = self.writer(values, "a." + name)
                with Errors(writer) as errors:
                    writer.Write()
                if errors.texts:
                    self.assertEqual(len(errors.texts), 1, errors.texts)
                    self.assertEqual(os.listdir(self.folder), [])
                    continue
                result = to_numpy(self.read("a." + name))
                os.remove(self.path("a." + name))
                self.assertEqual(result.dtype, dtype)
                accepted.add(name)
                np.testing.assert_allclose(
                    result.astype(float), values.astype(float), rtol=0,
                    atol=6 if name in lossy else 0, err_msg=f"{name} {dtype} {count}")
        self.assertGreater(len(accepted), 14, accepted)

    def test_what_does_not_come_back_is_refused(self):
        for name, dtype, components, word in (
                ("a.rla", np.uint8, 1, "rla"), ("a.rla", np.uint32, 3, "rla"),
                ("a.rla", np.float32, 5, "rla"), ("a.gif", np.uint8, 4, "gif"),
                ("a.webp", np.uint8, 4, "webp")):
            self.refuses(self.writer(self.make_picture(components, dtype), name), word)
        double = self.make_picture(3, np.float64)
        self.refuses(self.writer(double[:, :1], "a.tif"), "double", "x 1 ")
        self.refuses(self.writer(double, "a.tif", TileSize=(16, 16)), "double", "TileSize")

    def test_double_of_more_rows_than_are_read_together(self):
        values = np.random.default_rng(3).normal(size=(1, 17, 70000))
        self.write(values, "a.tif")
        np.testing.assert_array_equal(to_numpy(self.read("a.tif")), values)

    def test_hdr_keeps_a_byte_of_each_colour(self):
        values = np.exp(np.random.default_rng(3).uniform(-9, 9, (1, 20, 30, 3))).astype(np.float32)
        self.write(values, "a.hdr")
        result = to_numpy(self.read("a.hdr"))
        largest = values.max(-1, keepdims=True)
        self.assertLess((abs(result - values) / largest).max(), 1 / 128)
        self.assertGreater(values.max() / values.min(), 1e7)

    def test_floats_of_high_range_and_special_ones(self):
        values = np.array([[[0, -0.0, 1e-38, 3e38, np.inf, -np.inf, np.nan, 1e-45]]], np.float32)
        for name in "a.exr", "a.tif":
            self.write(values, name)
            self.assertEqual(to_numpy(self.read(name)).tobytes(), values.tobytes())

    def test_every_half(self):
        bits = np.arange(65536, dtype=np.uint16)
        halves = bits.view(np.float16)
        finite = halves[~np.isnan(halves)]
        values = np.resize(finite, (1, 256, 256)).astype(np.float32)
        self.write(values, "a.exr", ScalarType=vtkOIIOImageWriter.Half)
        image = self.read("a.exr")
        self.assertEqual(to_numpy(image).tobytes(), values.tobytes())
        data = image.GetFieldData()
        self.assertEqual(data.GetAbstractArray("FileScalarType").GetValue(0), "half")

    def test_half_rounds_to_nearest(self):
        values = np.random.default_rng(3).normal(0, 1, (1, 40, 50)).astype(np.float32)
        self.write(values, "a.exr", ScalarType=vtkOIIOImageWriter.Half)
        np.testing.assert_array_equal(
            to_numpy(self.read("a.exr")), values.astype(np.float16).astype(np.float32))

    def test_half_is_kept_where_nothing_is_lost(self):
        def file_type(name):
            data = self.read(name).GetFieldData()
            return data.GetAbstractArray("FileScalarType").GetValue(0)
        values = np.linspace(0, 1, 17, dtype=np.float32).reshape(1, 1, 17)
        self.write(values, "a.exr")
        self.assertEqual(file_type("a.exr"), "float")
        self.write(values, "a.exr", ScalarType=vtkOIIOImageWriter.Half)
        image = self.read("a.exr")
        self.write(image, "b.exr")
        self.assertEqual(file_type("b.exr"), "half")
        self.write(image, "b.tif")  # has no half
        self.assertEqual(file_type("b.tif"), "float")
        np.testing.assert_array_equal(to_numpy(self.read("b.tif")), to_numpy(image))
        self.write(image, "b.exr", ScalarType=vtkOIIOImageWriter.Input)
        self.assertEqual(file_type("b.exr"), "float")
        image.GetPointData().GetScalars().SetValue(3, 0.1)  # is no half
        self.write(image, "b.exr")
        self.assertEqual(file_type("b.exr"), "float")

    def test_vtks_readers_see_the_same_picture(self):
        values = self.make_picture(3, np.uint8)
        self.write(values, "a.png")
        reader = vtkPNGReader()
        reader.SetFileName(self.path("a.png"))
        reader.Update()
        np.testing.assert_array_equal(to_numpy(reader.GetOutput()), values)
        ramp = np.broadcast_to(np.linspace(0, 255, 64)[:, None], (1, 64, 64)).astype(np.uint8)
        self.write(ramp, "a.jpg")
        reader = vtkJPEGReader()
        reader.SetFileName(self.path("a.jpg"))
        reader.Update()
        self.assertLess(abs(to_numpy(reader.GetOutput()).astype(int) - ramp).max(), 8)

    def test_tiles_and_compression(self):
        values = self.make_picture(3, np.uint8)
        for name, compression in (("a.tif", "lzw"), ("a.tif", "zip"), ("a.tif", "packbits"),
                                  ("a.tif", "none"), ("a.exr", "piz"), ("a.exr", "zip"),
                                  ("a.exr", "none")):
            for tile in (0, 0), (16, 48), (128, 128):
                expected = values.astype(np.float32) if name == "a.exr" else values
                self.write(expected, name, Compression=compression, TileSize=tile)
                image = self.read(name)
                np.testing.assert_array_equal(to_numpy(image), expected)
                data = image.GetFieldData()
                self.assertEqual(data.GetAbstractArray("compression").GetValue(0), compression)
        sizes = []
        for quality in 30, 95:
            self.write(values, "a.jpg", Compression=f"jpeg:{quality}")
            sizes.append((self.folder / "a.jpg").stat().st_size)
        self.assertLess(2 * sizes[0], sizes[1])

    def test_slices_are_asked_for_one_by_one(self):
        source = vtkImageMandelbrotSource()
        source.SetWholeExtent(2, 21, 1, 15, 0, 3)
        asked = []
        source.AddObserver("StartEvent", lambda *unused: asked.append(source.GetUpdateExtent()))
        writer = vtkOIIOImageWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFilePrefix(self.path("s"))
        writer.SetFilePattern("%s%d.exr")
        writer.Write()
        self.assertEqual(asked, [(2, 21, 1, 15, k, k) for k in range(4)])
        source.UpdateWholeExtent()
        for k in range(4):
            np.testing.assert_array_equal(to_numpy(self.read(f"s{k}.exr"))[0],
                                          to_numpy(source.GetOutput())[k])

    def test_types_and_components_that_a_format_lacks(self):
        for name, dtype, components, word in (
                ("a.png", np.float32, 3, "float"), ("a.jpg", np.uint16, 3, "uint16"),
                ("a.exr", np.uint8, 3, "uint8"), ("a.hdr", np.uint8, 3, "uint8"),
                ("a.tif", np.int64, 1, "int64"), ("a.fits", np.int8, 1, "int8"),
                ("a.jpg", np.uint8, 4, "4 components"), ("a.png", np.uint8, 5, "5 components"),
                ("a.dpx", np.uint8, 1, "1 components"), ("a.ico", np.uint8, 3, "3 components")):
            self.refuses(self.writer(self.make_picture(components, dtype), name), word)
        self.refuses(self.writer(self.make_picture(1, np.uint8), "a.png",
                                 ScalarType=vtkOIIOImageWriter.Half), "half")

    def test_names_and_formats(self):
        values = self.make_picture(1, np.uint8)
        for name in "a", "a.nonsense", "a.null", "a.term":
            self.refuses(self.writer(values, name), name, "no format")
        self.refuses(self.writer(values, "none/a.png"), "none/a.png", "cannot be written")
        writer = self.writer(values, "a.png")
        writer.SetFileName(None)
        self.refuses(writer, "FileName is not set")

    def test_tiles_and_compressions_that_a_format_lacks(self):
        values = self.make_picture(1, np.uint8)
        self.refuses(self.writer(values, "a.png", TileSize=(16, 16)), "TileSize is 16, 16", "png")
        for tile in (-1, 16), (16, 0):
            self.refuses(self.writer(values, "a.tif", TileSize=tile), f"TileSize is {tile[0]}")
        for name in "a.tif", "a.png":
            self.refuses(self.writer(values, name, Compression="dwaa:45"), "Compression is 'dwaa'")
        self.refuses(self.writer(values.astype(np.float32), "a.exr", Compression="nonsense"),
                     "Compression is 'nonsense'")

    def test_images_that_cannot_be_written(self):
        self.refuses(vtkOIIOImageWriter(), "no input")
        image = make_image(self.make_picture(1, np.uint8))
        image.GetPointData().Initialize()
        self.refuses(self.writer(image, "a.png"), "0 point scalars")
        self.refuses(self.writer(vtkImageData(), "a.png"), "0 point")
        self.refuses(self.writer(np.zeros((3, 4, 5), np.uint8), "a.png"), "3 slices")

    def test_a_failure_leaves_an_older_file(self):
        values = self.make_picture(3, np.uint8)
        self.write(values, "a.png")
        self.refuses(self.writer(self.make_picture(3, np.float32), "a.png"), "float")
        np.testing.assert_array_equal(to_numpy(self.read("a.png")), values)


if __name__ == "__main__":
    unittest.main()
