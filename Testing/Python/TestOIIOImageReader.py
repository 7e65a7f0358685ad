# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import struct
import tempfile
import unittest
import zlib
from pathlib import Path

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkIOImage import (
    vtkImageReader2Factory, vtkJPEGReader, vtkJPEGWriter, vtkPNGReader, vtkPNGWriter, vtkTIFFReader,
    vtkTIFFWriter)

from bravais import vtkOIIOImageReader, vtkOIIOImageWriter
from checks import Errors, check_pieces, make_image, refuses, to_numpy


def make_picture(shape=(1, 37, 53, 3), dtype=np.uint8, seed=7):
    values = np.random.default_rng(seed).integers(0, 100, shape).astype(dtype)
    return values[..., 0] if shape[3] == 1 else values


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def path(self, name):
        return str(self.folder / name)

    def reader(self, name):
        reader = vtkOIIOImageReader()
        reader.SetFileName(self.path(name))
        return reader

    def read(self, name):
        reader = self.reader(name)
        reader.Update()
        return reader.GetOutput()

    def write(self, values, name, **properties):
        writer = vtkOIIOImageWriter()
        writer.SetInputData(make_image(values) if isinstance(values, np.ndarray) else values)
        writer.SetFileName(self.path(name))
        for key, value in properties.items():
            getattr(writer, "Set" + key)(value)
        writer.Write()
        self.assertEqual(writer.GetErrorCode(), 0)


class TestOIIOImageReader(Folder):
    def test_pictures_of_vtks_writers_stand_as_in_vtks_readers(self):
        upright = vtkTIFFReader()
        upright.SetOrientationType(4)  # else it has the file's first row below, unlike the others
        for name, writer, reader in (("a.png", vtkPNGWriter(), vtkPNGReader()),
                                     ("a.jpg", vtkJPEGWriter(), vtkJPEGReader()),
                                     ("a.tif", vtkTIFFWriter(), upright)):
            for components in 1, 3:
                values = make_picture((1, 24, 31, components))
                values[:, :12] //= 4  # up is not down
                writer.SetInputData(make_image(values))
                writer.SetFileName(self.path(name))
                writer.Write()
                if reader is upright and components == 3:
                    break
                reader.SetFileName(self.path(name))
                reader.Modified()
                reader.Update()
                own = self.read(name)
                self.assertEqual(own.GetExtent(), reader.GetOutput().GetExtent())
                self.assertEqual(own.GetSpacing(), (1, 1, 1))
                self.assertEqual(own.GetOrigin(), (0, 0, 0))
                # Two decoders of JPEG may round differently.
                difference = (to_numpy(own).astype(int) - to_numpy(reader.GetOutput())).ravel()
                self.assertLessEqual(abs(difference).max(), 2 if name == "a.jpg" else 0, name)
                if name != "a.jpg":
                    np.testing.assert_array_equal(to_numpy(own), values)

    def test_rows_can_be_left_as_the_file_has_them(self):
        values = make_picture()
        self.write(values, "a.png")
        reader = self.reader("a.png")
        reader.FileLowerLeftOn()
        reader.Update()
        np.testing.assert_array_equal(to_numpy(reader.GetOutput()), values[:, ::-1])

    def test_a_file_whose_rows_go_up_needs_no_turning(self):
        values = np.arange(6, dtype=np.uint8)
        tags = [(256, 4, 2), (257, 4, 3), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8),
                (274, 3, 4), (277, 3, 1), (278, 4, 3), (279, 4, 6)]
        (self.folder / "a.tif").write_bytes(
            struct.pack("<2sHI", b"II", 42, 16) + values.tobytes() + bytes(2) +
            struct.pack("<H", len(tags)) + b"".join(
                struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags) + bytes(4))
        image = self.read("a.tif")
        np.testing.assert_array_equal(to_numpy(image), values.reshape(1, 3, 2))
        self.assertIsNone(image.GetFieldData().GetAbstractArray("Orientation"))

    def test_colours_and_opacity_are_those_of_the_file(self):
        values = make_picture((1, 9, 11, 4))
        writer = vtkPNGWriter()
        writer.SetInputData(make_image(values))
        writer.SetFileName(self.path("a.png"))
        writer.Write()
        np.testing.assert_array_equal(to_numpy(self.read("a.png")), values)

    def test_pieces(self):
        values = np.concatenate([make_picture((1, 40, 70, 2), np.float32)] * 2, -1)
        for tile in (0, 0), (16, 32):
            for name in "a.exr", "a.tif":
                self.write(values, name, TileSize=tile)
                reader = self.reader(name)
                reader.Update()
                for piece in (0, 69, 0, 39, 0, 0), (0, 69, 7, 7, 0, 0), (33, 33, 39, 39, 0, 0), \
                        (15, 16, 0, 39, 0, 0), (31, 64, 8, 30, 0, 0):
                    reader.Modified()
                    reader.UpdateExtent(piece)
                    self.assertEqual(reader.GetOutput().GetExtent(), piece)
                    np.testing.assert_array_equal(
                        to_numpy(reader.GetOutput()),
                        values[:, piece[2]:piece[3] + 1, piece[0]:piece[1] + 1], (name, tile))

    def test_series_of_files_is_a_volume(self):
        values = make_picture((4, 9, 11, 3))
        writer = vtkOIIOImageWriter()
        writer.SetInputData(make_image(values))
        writer.SetFilePrefix(self.path("slice"))
        writer.SetFilePattern("%s-%02d.png")
        writer.Write()
        names = vtkStringArray()
        for k in range(4):
            names.InsertNextValue(self.path(f"slice-{k:02}.png"))
        reader = vtkOIIOImageReader()
        reader.SetFileNames(names)
        check_pieces(self, reader, bcc=False)
        reader.UpdateWholeExtent()
        np.testing.assert_array_equal(to_numpy(reader.GetOutput()), values)
        pattern = vtkOIIOImageReader()
        pattern.SetFilePrefix(self.path("slice"))
        pattern.SetFilePattern("%s-%02d.png")
        pattern.SetDataExtent(0, 0, 0, 0, 1, 3)
        pattern.Update()
        np.testing.assert_array_equal(to_numpy(pattern.GetOutput()), values[1:])
        self.write(values[:1, :5], "slice-02.png")
        pattern.Modified()
        refuses(self, pattern, "Slice 2", "11 x 5 pixels")

    def test_channels_with_names(self):
        # OpenEXR has names for channels and a type for each.
        write_exr(self.path("a.exr"), 3, 2, {
            "B": "f", "G": "f", "R": "f", "Z": "f", "N.Z": "f", "N.X": "f", "N.Y": "f", "id": "I"})
        image = self.read("a.exr")
        data = image.GetPointData()
        self.assertEqual(data.GetScalars().GetName(), "Scalars")
        names = {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}
        self.assertEqual(set(names), {"Scalars", "Z", "N", "id"})

        def components(array):
            return [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]
        self.assertEqual(components(names["Scalars"]), ["R", "G", "B"])
        self.assertEqual(components(names["N"]), ["N.X", "N.Y", "N.Z"])
        self.assertEqual(names["id"].GetDataTypeAsString(), "unsigned int")
        # Channel c of pixel p is 10 p + c, c in the alphabet's order.
        order = sorted(["B", "G", "R", "Z", "N.Z", "N.X", "N.Y", "id"])
        for array in names.values():
            for component in range(array.GetNumberOfComponents()):
                name = array.GetComponentName(component)
                column = [array.GetComponent(p, component) for p in (3, 4, 5, 0, 1, 2)]
                self.assertEqual(column, [10 * p + order.index(name) for p in range(6)])

    def test_window_of_a_larger_picture_is_at_its_place(self):
        write_exr(self.path("a.exr"), 3, 2, {"Y": "f"}, window=(4, 5), display=(20, 10))
        image = self.read("a.exr")
        self.assertEqual(image.GetDimensions(), (3, 2, 1))
        self.assertEqual(image.GetOrigin(), (4, 10 - 5 - 2, 0))

    def test_metadata_become_field_data(self):
        image = make_image(make_picture())
        for name, value in ("Artist", "Anna"), ("Copyright", "nobody"):
            array = vtkStringArray()
            array.SetName(name)
            array.InsertNextValue(value)
            image.GetFieldData().AddArray(array)
        for name in "a.tif", "a.exr":
            image.GetPointData().GetScalars()
            source = make_image(make_picture(dtype=np.float32))
            source.GetFieldData().DeepCopy(image.GetFieldData())
            self.write(source, name)
            data = self.read(name).GetFieldData()
            self.assertEqual(data.GetAbstractArray("Artist").GetValue(0), "Anna")
            self.assertEqual(data.GetAbstractArray("Copyright").GetValue(0), "nobody")
            self.assertEqual(data.GetAbstractArray("FileScalarType").GetValue(0), "float")
            self.assertEqual(data.GetAbstractArray("FileFormat").GetValue(0),
                             "tiff" if name == "a.tif" else "openexr")

    def test_images_and_levels_of_a_file(self):
        self.write(make_picture(), "a.tif")
        reader = self.reader("a.tif")
        self.assertEqual(reader.GetNumberOfSubImages(), 1)
        self.assertEqual(reader.GetNumberOfMipLevels(), 1)
        pages = make_picture((3, 8, 9, 1))
        writer = vtkTIFFWriter()
        writer.SetInputData(make_image(pages))
        writer.SetFileName(self.path("pages.tif"))
        writer.Write()
        reader = self.reader("pages.tif")
        self.assertEqual(reader.GetNumberOfSubImages(), 3)
        for page in range(3):
            reader.SetSubImage(page)
            reader.Update()
            # The writer turns single slices only.
            np.testing.assert_array_equal(to_numpy(reader.GetOutput())[0], pages[page][::-1])
        reader.SetSubImage(3)
        refuses(self, reader, "no SubImage 3")
        reader.SetSubImage(0)
        reader.SetMipLevel(1)
        refuses(self, reader, "MipLevel 1")

    def test_vtk_finds_the_reader(self):
        self.write(make_picture(dtype=np.float32), "a.exr")
        self.assertEqual(vtkOIIOImageReader().CanReadFile(self.path("a.exr")), 2)
        self.assertEqual(vtkOIIOImageReader().CanReadFile(self.path("none.exr")), 0)
        self.assertEqual(vtkOIIOImageReader().CanReadFile(__file__), 0)
        for extension in ".exr", ".tif", ".tiff", ".png", ".jpg", ".hdr":
            self.assertIn(extension, vtkOIIOImageReader().GetFileExtensions().split())
        vtkImageReader2Factory.RegisterReader(vtkOIIOImageReader())
        found = vtkImageReader2Factory.CreateImageReader2(self.path("a.exr"))
        self.assertIsInstance(found, vtkOIIOImageReader)


class TestOIIOImageReaderBadInput(Folder):
    def test_names(self):
        refuses(self, vtkOIIOImageReader(), "FileName is not set")
        refuses(self, self.reader("none.png"), "none.png", "does not exist")
        refuses(self, self.reader(""), "folder")
        (self.folder / "a.null").write_bytes(b"x")
        refuses(self, self.reader("a.null"), "a.null", "cannot be opened")

    def test_files_that_are_no_images(self):
        for name, content in ("a.png", b""), ("b.png", b"no picture"), ("c", bytes(500)):
            (self.folder / name).write_bytes(content)
            refuses(self, self.reader(name), name, "empty" if not content else "cannot be opened")
            self.assertEqual(vtkOIIOImageReader().CanReadFile(self.path(name)), 0)

    def test_truncated_files(self):
        values = make_picture((1, 120, 130, 3))
        for name in ("a.exr", "a.tif", "a.png", "a.jpg", "a.hdr", "a.ppm", "a.bmp", "a.tga", "a.sgi",
                     "a.webp"):
            floats = name in ("a.exr", "a.hdr")
            self.write(values.astype(np.float32) if floats else values, name)
            content = (self.folder / name).read_bytes()
            for share in 0.02, 0.5, 0.93:
                (self.folder / name).write_bytes(content[:int(share * len(content))])
                refuses(self, self.reader(name), name)

    def test_truncated_strips(self):
        for type in np.uint8, np.uint16, np.float32:
            for compression in "none", "zip", "lzw":
                self.write(make_picture((1, 120, 130, 3)).astype(type), "a.tif",
                           Compression=compression)
                content = (self.folder / "a.tif").read_bytes()
                for share in 0.02, 0.5, 0.93:
                    (self.folder / "a.tif").write_bytes(content[:int(share * len(content))])
                    refuses(self, self.reader("a.tif"), "a.tif", "rows")

    def test_truncated_tiles(self):
        self.write(make_picture((1, 120, 130, 3)), "a.tif", TileSize=(16, 16))
        content = (self.folder / "a.tif").read_bytes()
        (self.folder / "a.tif").write_bytes(content[:len(content) // 2])
        refuses(self, self.reader("a.tif"), "a.tif", "rows")

    def test_a_single_row_of_doubles(self):
        tags = [(256, 3, 2), (257, 3, 1), (258, 3, 64), (259, 3, 1), (262, 3, 1), (273, 4, 134),
                (277, 3, 1), (278, 3, 1), (279, 4, 16), (339, 3, 3)]
        (self.folder / "a.tif").write_bytes(struct.pack("<2sHIH", b"II", 42, 8, len(tags)) + b"".join(
            struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags) + bytes(4) +
            struct.pack("<2d", 1.5, 2.5))
        refuses(self, self.reader("a.tif"), "2 x 1 pixels of 1 channels of 64 bits")

    def test_header_of_more_pixels_than_the_file_can_hold(self):
        for width, height in (40000, 25000), (2 ** 31 - 1, 2 ** 31 - 1), (100000, 100000):
            header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
            png = b"\x89PNG\r\n\x1a\n" + b"".join(
                struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data))
                for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(bytes(999))),
                                   (b"IEND", b"")))
            (self.folder / "a.png").write_bytes(png)
            words = (["40000 x 25000 pixels", f"{len(png)} bytes long"] if width == 40000 else [])
            refuses(self, self.reader("a.png"), "a.png", *words)
        (self.folder / "a.ppm").write_bytes(b"P6 40000 25000 255\n" + bytes(1000))
        refuses(self, self.reader("a.ppm"), "40000 x 25000 pixels")
        bmp = struct.pack("<2sIHHIIIIHHIIIIII", b"BM", 1000, 0, 0, 54, 40, 40000, 25000, 1, 24, 0, 0,
                          2835, 2835, 0, 0)
        (self.folder / "a.bmp").write_bytes(bmp + bytes(1000))
        refuses(self, self.reader("a.bmp"), "40000 x 25000 pixels")
        tags = [(256, 4, 40000), (257, 4, 25000), (258, 3, 8), (259, 3, 1), (262, 3, 1),
                (273, 4, 8), (277, 3, 1), (278, 4, 25000), (279, 4, 10 ** 9)]
        tif = struct.pack("<2sHIH", b"II", 42, 8, len(tags)) + b"".join(
            struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags) + bytes(4)
        (self.folder / "a.tif").write_bytes(tif)
        refuses(self, self.reader("a.tif"), "40000 x 25000 pixels")
        write_exr(self.path("a.exr"), 2, 2, {"Y": "f"}, claim=(40000, 25000))
        with open(self.path("a.exr"), "ab") as file:
            file.write(bytes(200000))  # a place for each row
        refuses(self, self.reader("a.exr"), "40000 x 25000 pixels")

    def test_an_error_empties_an_earlier_output(self):
        self.write(make_picture(), "a.png")
        reader = self.reader("a.png")
        reader.Update()
        self.assertGreater(reader.GetOutput().GetNumberOfPoints(), 0)
        reader.SetFileName(self.path("b.png"))
        refuses(self, reader, "b.png")
        reader.SetFileName(self.path("a.png"))
        reader.Update()
        self.assertGreater(reader.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(reader.GetErrorCode(), 0)


class TestOIIOImageReaderProgress(Folder):
    def test_progress_and_abort(self):
        self.write(make_picture((1, 96, 40, 3)), "a.tif", TileSize=(16, 16))
        reader = self.reader("a.tif")
        amounts = []
        tag = reader.AddObserver(
            "ProgressEvent", lambda *unused: amounts.append(reader.GetProgress()))
        reader.Update()
        reader.RemoveObserver(tag)
        self.assertEqual(amounts, sorted(amounts))
        self.assertEqual(amounts[-1], 1)
        self.assertGreater(len(set(amounts)), 4)
        tag = reader.AddObserver(
            "ProgressEvent", lambda *unused: reader.SetAbortExecute(reader.GetProgress() > 0.4))
        reader.Modified()
        reader.Update()
        reader.RemoveObserver(tag)
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 96 * 40)


def write_exr(name, width, height, channels, window=(0, 0), display=None, claim=None):
    """An OpenEXR file, not compressed. Channel c of pixel p is 10 p + c.

    `channels` are the names and "f" or "I"; they are sorted as the format asks for.
    """
    def attribute(key, kind, content):
        return key.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(content)) + \
            content
    ordered = sorted(channels.items())
    x, y = window
    wide, high = claim or (width, height)
    whole = display or (wide, high)
    listed = b"".join(key.encode() + b"\0" + struct.pack("<IIII", 2 if kind == "f" else 0, 0, 1, 1)
                      for key, kind in ordered) + b"\0"
    head = struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", listed) + \
        attribute("compression", "compression", b"\0") + \
        attribute("dataWindow", "box2i", struct.pack("<4i", x, y, x + wide - 1, y + high - 1)) + \
        attribute("displayWindow", "box2i", struct.pack("<4i", 0, 0, whole[0] - 1, whole[1] - 1)) + \
        attribute("lineOrder", "lineOrder", b"\0") + \
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) + \
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)) + \
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    rows = [struct.pack("<iI", y + row, 4 * width * len(ordered)) + b"".join(
        struct.pack("<" + kind, 10 * (row * width + column) + index)
        for index, (key, kind) in enumerate(ordered) for column in range(width))
        for row in range(height)]
    start = len(head) + 8 * height
    offsets = [start + sum(map(len, rows[:row])) for row in range(height)]
    Path(name).write_bytes(head + struct.pack(f"<{height}Q", *offsets) + b"".join(rows))


if __name__ == "__main__":
    unittest.main()
