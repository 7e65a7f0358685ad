# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkSMPTools

from bravais import (
    vtkOIIOImageReader, vtkRank1TextureFileWriter, vtkRank1TexturePyramid, vtkRank1TextureSampler)
from checks import Errors, PieceSource, make_image


def make_picture(width, height, components=1, dtype=np.uint8, seed=2):
    values = np.random.default_rng(seed).integers(0, 250, (1, height, width, components))
    return (values[..., 0] if components == 1 else values).astype(dtype)


def make_points(count=400):
    generator = np.random.default_rng(4)
    return generator.uniform(-1.5, 2.5, (count, 2)), \
        2.0 ** generator.uniform(-9, 1, (count, 1)) * generator.normal(0, 1, (count, 4))


def sample(sampler, uv, footprints):
    result = vtkDoubleArray()
    assert sampler.Sample(numpy_to_vtk(uv, deep=True), numpy_to_vtk(footprints, deep=True), result)
    return vtk_to_numpy(result).copy()


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def path(self, name="a.tif"):
        return str(self.folder / name)

    def writer(self, image, name="a.tif", **properties):
        writer = vtkRank1TextureFileWriter()
        if isinstance(image, np.ndarray):
            image = make_image(image)
        if image.IsA("vtkImageData"):
            writer.SetInputData(image)
        else:
            writer.SetInputConnection(image.GetOutputPort())
        writer.SetFileName(self.path(name))
        for key, value in properties.items():
            getattr(writer, "Set" + key)(value)
        return writer

    def write(self, *arguments, **properties):
        self.assertTrue(self.writer(*arguments, **properties).Write())

    def sampler(self, name="a.tif", **properties):
        sampler = vtkRank1TextureSampler()
        sampler.SetFileName(self.path(name))
        for key, value in properties.items():
            getattr(sampler, "Set" + key)(value)
        return sampler


class TestRank1TextureFile(Folder):
    def check_against_pyramid(self, image, name="a.tif", limit=64, **properties):
        self.write(image, name, MemoryLimit=limit, **properties)
        pyramid = vtkRank1TexturePyramid()
        pyramid.SetInputData(make_image(image) if isinstance(image, np.ndarray) else image)
        pyramid.SetKindToRSet()
        pyramid.SetFilterToBox()
        for key, value in properties.items():
            getattr(pyramid, "Set" + key)(value)
        memory = vtkRank1TextureSampler()
        memory.SetInputConnection(pyramid.GetOutputPort())
        file = self.sampler(name)
        self.assertTrue(file.IsRSet())
        self.assertEqual(file.GetNumberOfLevels(), memory.GetNumberOfLevels())
        self.assertEqual(file.GetNumberOfComponents(), memory.GetNumberOfComponents())
        uv, footprints = make_points()
        for mode in range(4):
            for level_filter in range(2):
                for sampler in memory, file:
                    sampler.SetInterpolation(mode)
                    sampler.SetLevelFilter(level_filter)
                np.testing.assert_array_equal(
                    sample(file, uv, footprints), sample(memory, uv, footprints))

    def test_the_file_is_the_pyramid(self):
        for tiles, n in ((4, 4), 64), ((8, 2), 37), ((3, 5), 256), ((1, 1), 1000), ((2, 4), 1):
            self.check_against_pyramid(make_picture(61, 43), NumberOfPoints=n, Tiles=tiles)

    def test_types_and_components(self):
        for name, dtype, components in (
                ("a.tif", np.uint8, 4), ("a.tif", np.uint16, 3), ("a.tif", np.float32, 1),
                ("a.exr", np.float32, 3), ("a.tif", np.uint8, 6)):
            self.check_against_pyramid(make_picture(40, 30, components, dtype), name,
                                       NumberOfPoints=80, Tiles=(4, 2))

    def test_parameters(self):
        image = make_image(make_picture(50, 40, 2), (0.5, 2, 1), (3, 4, 5))
        for boundary in range(3):
            for layout in range(2):
                self.check_against_pyramid(image, NumberOfPoints=50, Tiles=(2, 4), Layout=layout,
                                           BoundaryMode=boundary)
        self.check_against_pyramid(image, NumberOfPoints=50, Tiles=(2, 4), Generator=(1, 7))

    def test_blocks_of_rows_make_no_difference(self):
        # 1 MB is some 160 rows; cells of the coarsest members reach over more.
        picture = make_picture(800, 700, 2, np.float32)
        self.check_against_pyramid(picture, limit=1, NumberOfPoints=10, Tiles=(8, 4))

    def test_doubles_become_floats(self):
        picture = np.random.default_rng(2).normal(0, 1, (1, 30, 30))
        self.write(picture, NumberOfPoints=64, Tiles=(4, 4))
        doubles = sample(self.sampler(), *make_points())
        self.write(picture.astype(np.float32), "b.tif", NumberOfPoints=64, Tiles=(4, 4))
        np.testing.assert_allclose(doubles, sample(self.sampler("b.tif"), *make_points()),
                                   atol=1e-6)

    def test_default_tiles_make_as_many_texels_as_pixels(self):
        for width, height, tiles in (512, 256, (8, 4)), (64, 64, (1, 1)), (10, 10, (1, 1)), \
                (1024, 128, (16, 2)):
            self.write(make_picture(width, height))
            counts = [0, 0]
            self.sampler().GetNumberOfMembers(counts)
            self.assertEqual(tuple(2 ** (count - 1) for count in counts), tiles)

    def test_rows_are_asked_for_in_blocks(self):
        source = PieceSource(make_image(make_picture(600, 900, 3, np.float32)))
        self.write(source, NumberOfPoints=1024, Tiles=(16, 16), MemoryLimit=1)
        rows = [extent[3] - extent[2] + 1 for extent in source.asked]
        self.assertLess(max(rows), 160)  # 1 MB is 145; the largest cells reach over some 30
        self.assertGreater(len(rows), 40)

    def test_file_is_an_image_of_tiles(self):
        self.write(make_picture(64, 64), NumberOfPoints=256, Tiles=(4, 4), Compression="none")
        reader = vtkOIIOImageReader()
        reader.SetFileName(self.path())
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (16 * 7, 16 * 7, 1))
        self.assertIn("n g1 g2 256 ", reader.GetOutput().GetFieldData().GetAbstractArray(
            "ImageDescription").GetValue(0))
        # At most four times the texels of the base, and a header.
        self.assertLess(os.path.getsize(self.path()), 4 * 16 * 256 + 2000)

    def test_threads(self):
        uv, footprints = make_points(30000)
        contents, results = [], []
        for threads in 1, 2:
            vtkSMPTools.Initialize(threads)
            self.write(make_picture(200, 100, 3), NumberOfPoints=256, Tiles=(8, 8))
            reader = vtkOIIOImageReader()
            reader.SetFileName(self.path())
            reader.Update()
            contents.append(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).tobytes())
            results.append(sample(self.sampler(CacheSize=1), uv, footprints).tobytes())
        vtkSMPTools.Initialize(0)
        self.assertEqual(contents[0], contents[1])
        self.assertEqual(results[0], results[1])

    def test_the_cache_is_bounded(self):
        self.write(make_picture(1024, 1024, 12), NumberOfPoints=4096, Compression="none")
        size = os.path.getsize(self.path())
        self.assertGreater(size, 12 << 20)
        uv, _ = make_points(50000)
        fine = np.zeros((len(uv), 4))
        results = []
        for megabytes in 10, 64:
            sampler = self.sampler(CacheSize=megabytes)
            results.append(sample(sampler, uv, fine))
            tile = 4096 * 12
            tiles = 16 * 16
            # Threads may each have a tile more in hand.
            self.assertLess(sampler.GetPeakCacheMemory(), (megabytes << 20) + 64 * tile)
            self.assertLessEqual(sampler.GetCacheMemory(), (megabytes << 20) + 64 * tile)
            self.assertGreater(sampler.GetCacheHits(), 0)
            if megabytes == 10:
                self.assertGreater(sampler.GetCacheMisses(), 2 * tiles)
            else:
                self.assertEqual(sampler.GetCacheMisses(), tiles)
                sampler.ResetStatistics()
                sample(sampler, uv, fine)
                self.assertEqual(sampler.GetCacheMisses(), 0)
                self.assertGreater(sampler.GetCacheHits(), 0)
        np.testing.assert_array_equal(*results)

    def test_progress_and_abort(self):
        writer = self.writer(make_picture(300, 200), NumberOfPoints=64, Tiles=(8, 8))
        amounts = []
        tag = writer.AddObserver(
            "ProgressEvent", lambda *unused: amounts.append(writer.GetProgress()))
        self.assertTrue(writer.Write())
        writer.RemoveObserver(tag)
        self.assertEqual(amounts, sorted(amounts))
        self.assertEqual(amounts[-1], 1)
        self.assertGreater(len(amounts), 8)
        os.remove(self.path())
        tag = writer.AddObserver(
            "ProgressEvent", lambda *unused: writer.SetAbortExecute(writer.GetProgress() > 0.5))
        self.assertFalse(writer.Write())
        writer.RemoveObserver(tag)
        self.assertEqual(os.listdir(self.folder), [])
        self.assertTrue(writer.Write())


class TestRank1TextureFileBadInput(Folder):
    def refuses(self, algorithm, action, *words):
        before = sorted(os.listdir(self.folder))
        with Errors(algorithm) as errors:
            self.assertFalse(action())
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def refuses_to_write(self, writer, *words):
        self.refuses(writer, writer.Write, *words)

    def refuses_to_sample(self, sampler, *words):
        uv, footprints = (numpy_to_vtk(a, deep=True) for a in make_points())
        self.refuses(sampler, lambda: sampler.Sample(uv, footprints, vtkDoubleArray()), *words)

    def test_parameters(self):
        picture = make_picture(8, 8)
        self.refuses_to_write(vtkRank1TextureFileWriter(), "no input")
        for properties, word in (
                (dict(FileName=""), "FileName is not set"),
                (dict(NumberOfPoints=-1), "NumberOfPoints is -1"),
                (dict(Tiles=(0, 4)), "Tiles are 0 x 4"),
                (dict(NumberOfPoints=12, Generator=(4, 6)), "(4, 6) makes 6 points"),
                (dict(NumberOfPoints=2 ** 28, Tiles=(2 ** 17, 2 ** 11), Generator=(1, 3)),
                 "an image of"),
                (dict(Compression="nonsense"), "Compression is 'nonsense'"),
                (dict(FileName=self.path("a.png")), "no tiles"),
                (dict(FileName=self.path("a.nonsense")), "no format"),
                (dict(FileName=self.path("none/a.tif")), "cannot be written")):
            self.refuses_to_write(self.writer(picture, **properties), word)

    def test_images(self):
        self.refuses_to_write(self.writer(make_picture(8, 8, 1, np.int32)), "of type int")
        self.refuses_to_write(self.writer(np.zeros((2, 8, 8), np.uint8)), "8 x 8 x 2")
        image = make_image(make_picture(8, 8))
        image.GetPointData().Initialize()
        self.refuses_to_write(self.writer(image), "point scalars")
        self.refuses_to_write(self.writer(make_picture(8, 8), "a.exr"), "uint8")

    def test_files_that_are_no_texture(self):
        self.refuses_to_sample(self.sampler(), "a.tif", "does not exist")
        Path(self.path()).write_bytes(b"")
        self.refuses_to_sample(self.sampler(), "a.tif", "empty")
        writer = self.writer(make_picture(64, 64), "b.tif", Tiles=(2, 2), NumberOfPoints=256)
        self.assertTrue(writer.Write())
        content = Path(self.path("b.tif")).read_bytes()
        Path(self.path()).write_bytes(content.replace(b"rank-1 r-set 1", b"something else"))
        self.refuses_to_sample(self.sampler(), "a.tif", "48 x 48 pixels is no r-set")
        Path(self.path()).write_bytes(content.replace(b"tiles 2 2", b"tiles 3 2"))
        self.refuses_to_sample(self.sampler(), "a.tif", "48 x 48 pixels is no r-set")

    def test_truncated_files(self):
        self.write(make_picture(256, 256), Compression="none")
        content = Path(self.path()).read_bytes()
        Path(self.path()).write_bytes(content[:len(content) // 2])
        self.refuses_to_sample(self.sampler(), "a.tif", "truncated")

    def test_a_failure_leaves_an_older_file(self):
        self.write(make_picture(64, 64))
        before = Path(self.path()).read_bytes()
        self.refuses_to_write(self.writer(make_picture(8, 8, 1, np.int32)), "of type int")
        self.assertEqual(Path(self.path()).read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
