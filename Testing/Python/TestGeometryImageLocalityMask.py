# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hierarchy of vtkGeometryImageLocalityMask: nodes, leaves, masks and their sizes."""
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPlane

from bravais import vtkGeometryImageLocalityMask, vtkGeometryImageSource
from checks import check_progress, check_threads
from geometry import (
    decode_roaring, get_all_masks, get_leaf_masks, get_leaves, get_mask, get_used,
    make_geometry_image, pack, run_length_code)


def make_surface(shape="BumpySphere", width=33, height=29):
    source = vtkGeometryImageSource()
    getattr(source, f"SetShapeTo{shape}")()
    source.SetDimensions(width, height)
    source.Update()
    return source.GetOutput()


def make_noise(width=40, height=23, dtype=np.float64, seed=3):
    generator = np.random.default_rng(seed)
    return generator.normal(size=(height, width, 3)).astype(dtype)


def make_mask(image, depth=3, encoding="RLE", cube=None):
    algorithm = vtkGeometryImageLocalityMask()
    algorithm.SetInputDataObject(image)
    algorithm.SetMaximumDepth(depth)
    getattr(algorithm, f"SetEncodingTo{encoding}")()
    if cube:
        algorithm.SetRootCube(*cube[0], cube[1])
    algorithm.Update()
    return algorithm


def make_images():
    defined = np.random.default_rng(8).integers(0, 2, (23, 40))
    with_holes = make_noise()
    with_holes[3:9, 5:20, 1] = np.nan
    return [
        make_surface(), make_surface("Sphere", 34, 33), make_surface("Torus", 9, 60),
        make_surface("Plane", 33, 17), make_geometry_image(make_noise(dtype=np.float32)),
        make_geometry_image(with_holes, defined)]


class TestGeometryImageLocalityMask(unittest.TestCase):
    def test_defaults(self):
        algorithm = vtkGeometryImageLocalityMask()
        self.assertEqual(algorithm.GetMaximumDepth(), 5)
        self.assertEqual(algorithm.GetRootCube(), (0, 0, 0, 0))
        self.assertEqual(algorithm.GetEncodingAsString(), "RLE")
        self.assertTrue(algorithm.GetStoreInternalMasks())
        self.assertFalse(algorithm.GetRefineToGixels())
        self.assertEqual(algorithm.GetAspectRatio(), 1)
        self.assertIsNone(algorithm.GetCullFunction())
        self.assertIsNone(algorithm.GetCamera())
        self.assertEqual(algorithm.GetNumberOfNodes(), 0)
        self.assertEqual(algorithm.GetNumberOfLeaves(), 0)
        self.assertEqual(algorithm.GetCompressedSize(False), 0)
        self.assertEqual(algorithm.GetUnionSize(), 0)

    def check_hierarchy(self, image, depth, cube=None):
        expected, cells = get_leaves(image, depth, cube)
        nodes = get_all_masks(image, depth, cube)
        size = image.GetNumberOfPoints()
        for encoding in "RLE", "Roaring":
            algorithm = make_mask(image, depth, encoding, cube)
            masks, found = get_leaf_masks(algorithm)
            np.testing.assert_array_equal(found, cells)
            np.testing.assert_array_equal(masks.reshape(expected.shape), expected)
            self.assertEqual(algorithm.GetNumberOfLeaves(), len(expected))
            self.assertEqual(algorithm.GetNumberOfNodes(), len(nodes))
            byte_size = (size + 7) // 8
            self.assertEqual(algorithm.GetUncompressedSize(True), len(expected) * byte_size)
            self.assertEqual(algorithm.GetUncompressedSize(False), len(nodes) * byte_size)
            codes = [run_length_code(pack(mask)) for mask in nodes]
            leaf_codes = codes[len(nodes) - len(expected):]
            sizes = [sum(map(len, codes)), sum(map(len, leaf_codes))]
            own = [algorithm.GetCompressedSize(False), algorithm.GetCompressedSize(True)]
            if encoding == "RLE":
                self.assertEqual(own, sizes)
            else:
                self.assertLessEqual(own[0], sizes[0])
                self.assertLessEqual(own[1], sizes[1])
            self.check_codes(algorithm, expected, leaf_codes, encoding)

    def check_codes(self, algorithm, masks, leaf_codes, encoding):
        array = vtkUnsignedCharArray()
        total = 0
        for leaf, (mask, code) in enumerate(zip(masks, leaf_codes)):
            self.assertTrue(algorithm.GetLeafCode(leaf, array))
            own = vtk_to_numpy(array).tobytes()
            total += len(own)
            if algorithm.GetLeafEncoding(leaf) == algorithm.RLE:
                self.assertEqual(own, code)
            else:
                self.assertEqual(encoding, "Roaring")
                self.assertLessEqual(len(own), len(code))
                np.testing.assert_array_equal(decode_roaring(own, mask.size), mask)
        self.assertEqual(total, algorithm.GetCompressedSize(True))

    def test_hierarchies(self):
        for image in make_images():
            for depth in 0, 1, 3:
                self.check_hierarchy(image, depth)
        self.check_hierarchy(make_images()[0], 4)

    def test_root_cube(self):
        for image in make_images()[2:]:
            self.check_hierarchy(image, 3, ((-4.0, -4.0, -4.0), 8.0))
            self.check_hierarchy(image, 2, ((-0.5, -0.25, 0.0), 1.0))  # part of it
            self.check_hierarchy(image, 2, ((90.0, 90.0, 90.0), 1.0))  # nothing

    def test_cells_are_half_open(self):
        grid = np.stack(np.meshgrid(np.arange(5) / 4, np.arange(5) / 4), -1)
        points = np.concatenate((grid, np.full((5, 5, 1), 0.5)), axis=-1)
        image = make_geometry_image(points)
        algorithm = make_mask(image, 2, cube=((0.0, 0.0, 0.0), 1.0))
        self.assertEqual(algorithm.GetNumberOfLeaves(), 16)
        masks, cells = get_leaf_masks(algorithm)
        np.testing.assert_array_equal(masks.sum(axis=1), 1)
        np.testing.assert_array_equal(cells[:, 2], 2)
        mask = get_mask(algorithm).reshape(5, 5)
        np.testing.assert_array_equal(mask[:4, :4], 1)
        self.assertEqual(mask.sum(), 16)  # the cube's upper faces are not part of it

    def test_large_depth(self):
        for image in (make_images()[0], make_images()[5]):
            algorithm = make_mask(image, 10)
            expected, cells = get_leaves(image, 10)
            masks, found = get_leaf_masks(algorithm)
            np.testing.assert_array_equal(masks, expected)
            np.testing.assert_array_equal(found, cells)
            self.assertEqual(algorithm.GetNumberOfNodes(), len(get_all_masks(image, 10)))

    def test_masks_partition_the_used_gixels(self):
        for image in make_images():
            for depth in 0, 2, 7:
                masks, _ = get_leaf_masks(make_mask(image, depth))
                np.testing.assert_array_equal(masks.sum(axis=0), get_used(image))

    def test_codes_of_long_runs(self):
        # Two gixels in cells of their own, far apart in a large image: gaps of many lengths.
        for size in (65534 * 8, 65535 * 8 + 3, 65536 * 8 + 8, 65537 * 8, 3 * 65535 * 8 + 16):
            points = np.full((1, size, 3), np.nan, np.float32)
            points[0, 0] = 0
            points[0, size // 3 // 8 * 8:][:16] = 1
            points[0, -1] = 2
            image = make_geometry_image(points)
            algorithm = make_mask(image, 2)
            self.assertEqual(algorithm.GetNumberOfLeaves(), 3)
            codes = [run_length_code(pack(mask)) for mask in get_all_masks(image, 2)]
            self.assertEqual(algorithm.GetCompressedSize(False), sum(map(len, codes)))
            full = make_geometry_image(np.zeros((1, size, 3), np.float32))
            algorithm = make_mask(full, 0)
            whole = run_length_code(pack(np.ones(size, bool)))
            self.assertEqual(algorithm.GetCompressedSize(True), len(whole))
            self.assertEqual(get_mask(algorithm).sum(), size)

    def test_patterns_that_run_lengths_suit_better(self):
        # Every second gixel is in the other cell: 0x55 and 0xaa all over.
        points = np.zeros((256, 512, 3), np.float32)
        points[:, 1::2] = 1
        image = make_geometry_image(points)
        rle, roaring = make_mask(image, 1), make_mask(image, 1, "Roaring")
        self.assertEqual(rle.GetCompressedSize(True), 8)
        self.assertLessEqual(roaring.GetCompressedSize(True), 8)
        self.assertEqual(roaring.GetNumberOfExceptions(), 3)  # and the root's, which is full
        np.testing.assert_array_equal(get_leaf_masks(roaring)[0], get_leaf_masks(rle)[0])

    def test_containers_of_bits(self):
        generator = np.random.default_rng(2)
        points = np.zeros((256, 512, 3), np.float32)
        points[..., 0] = generator.integers(0, 2, (256, 512))
        image = make_geometry_image(points)
        rle, roaring = make_mask(image, 1), make_mask(image, 1, "Roaring")
        self.assertLess(roaring.GetCompressedSize(False), rle.GetCompressedSize(False))
        masks = get_leaf_masks(roaring)[0]
        np.testing.assert_array_equal(masks, get_leaf_masks(rle)[0])
        array = vtkUnsignedCharArray()
        roaring.GetLeafCode(0, array)
        np.testing.assert_array_equal(decode_roaring(vtk_to_numpy(array).tobytes(), 1 << 17), masks[0])

    def test_internal_masks_are_optional(self):
        image = make_images()[0]
        algorithm = make_mask(image)
        with_all = algorithm.GetCompressedSize(False), algorithm.GetCompressedSize(True)
        expected = get_mask(algorithm).copy()
        nodes = algorithm.GetNumberOfNodes()
        algorithm.StoreInternalMasksOff()
        algorithm.Update()
        self.assertEqual(algorithm.GetCompressedSize(True), with_all[1])
        self.assertEqual(algorithm.GetCompressedSize(False), with_all[1])
        self.assertEqual(algorithm.GetUncompressedSize(False), algorithm.GetUncompressedSize(True))
        self.assertEqual(algorithm.GetNumberOfNodes(), nodes)
        np.testing.assert_array_equal(get_mask(algorithm), expected)

    def test_hierarchy_is_kept(self):
        image = make_images()[0]
        plane = vtkPlane()
        algorithm = make_mask(image)
        algorithm.SetCullFunction(plane)
        algorithm.Update()
        made = algorithm.GetHierarchyMTime()
        for origin in (0.3, 0, 0), (-0.2, 0, 0):
            plane.SetOrigin(origin)
            algorithm.Update()
            algorithm.RefineToGixelsOn()
            algorithm.Update()
        algorithm.SetCullFunction(None)
        algorithm.Update()
        self.assertEqual(algorithm.GetHierarchyMTime(), made)
        changes = [
            lambda: algorithm.SetMaximumDepth(2), lambda: algorithm.SetEncodingToRoaring(),
            lambda: algorithm.StoreInternalMasksOff(),
            lambda: algorithm.SetRootCube(-4, -4, -4, 8),
            lambda: image.GetPointData().GetArray("Points").Modified(), image.Modified,
            lambda: algorithm.SetInputDataObject(make_images()[1])]
        for change in changes:
            change()
            algorithm.Update()
            self.assertGreater(algorithm.GetHierarchyMTime(), made)
            made = algorithm.GetHierarchyMTime()

    def test_changed_positions(self):
        image = make_geometry_image(make_noise())
        algorithm = make_mask(image)
        points = image.GetPointData().GetArray("Points")
        vtk_to_numpy(points)[:] *= [2, 0.5, 1]
        points.Modified()
        image.Modified()
        algorithm.Update()
        np.testing.assert_array_equal(get_leaf_masks(algorithm)[0], get_leaves(image, 3)[0])

    def test_output_is_the_input_and_a_mask(self):
        image = make_images()[5]
        algorithm = make_mask(image)
        output = algorithm.GetOutput()
        self.assertEqual(output.GetDimensions(), image.GetDimensions())
        data = output.GetPointData()
        for name in "Points", "Defined":  # shared, not copied
            self.assertEqual(data.GetArray(name).GetVoidPointer(0),
                             image.GetPointData().GetArray(name).GetVoidPointer(0))
        self.assertEqual(data.GetVectors().GetName(), "Points")
        self.assertEqual(data.GetArray("LocalityMask").GetDataTypeAsString(), "unsigned char")
        self.assertEqual(output.GetFieldData().GetAbstractArray("Lattice").GetValue(0),
                         "GeometryImage")
        self.assertIsNone(image.GetPointData().GetArray("LocalityMask"))
        np.testing.assert_array_equal(get_mask(algorithm), get_used(image))

    def test_pieces(self):
        source = vtkGeometryImageSource()
        source.SetDimensions(20, 30)
        algorithm = vtkGeometryImageLocalityMask()
        algorithm.SetInputConnection(source.GetOutputPort())
        plane = vtkPlane()
        plane.SetNormal(1, 2, 3)
        algorithm.SetCullFunction(plane)
        algorithm.Update()
        whole = get_mask(algorithm).reshape(30, 20).copy()
        nodes = algorithm.GetNumberOfNodes()
        self.assertNotIn(whole.mean(), (0, 1))
        for x0, x1, y0, y1 in (0, 0, 0, 29), (3, 12, 7, 7), (5, 19, 20, 29):
            algorithm.Modified()
            algorithm.UpdateExtent((x0, x1, y0, y1, 0, 0))
            self.assertEqual(algorithm.GetOutput().GetExtent(), (x0, x1, y0, y1, 0, 0))
            np.testing.assert_array_equal(
                get_mask(algorithm), whole[y0:y1 + 1, x0:x1 + 1].ravel())
            self.assertEqual(algorithm.GetNumberOfNodes(), nodes)
        covered = np.zeros(whole.shape, bool)
        for piece in range(3):
            algorithm.Modified()
            algorithm.UpdatePiece(piece, 3, 0)
            x0, x1, y0, y1, _, _ = algorithm.GetOutput().GetExtent()
            np.testing.assert_array_equal(
                get_mask(algorithm), whole[y0:y1 + 1, x0:x1 + 1].ravel())
            covered[y0:y1 + 1, x0:x1 + 1] = True
            self.assertLess(get_mask(algorithm).size, whole.size)
        self.assertTrue(covered.all())

    def test_threads(self):
        source = vtkGeometryImageSource()
        source.SetShapeToBumpySphere()
        source.SetDimensions(150, 170)
        for encoding in "RLE", "Roaring":
            algorithm = vtkGeometryImageLocalityMask()
            algorithm.SetInputConnection(source.GetOutputPort())
            getattr(algorithm, f"SetEncodingTo{encoding}")()
            plane = vtkPlane()
            algorithm.SetCullFunction(plane)
            tag = algorithm.AddObserver("StartEvent", lambda *unused: source.GetOutput().Modified())
            check_threads(self, algorithm)
            algorithm.RemoveObserver(tag)

    def test_progress(self):
        algorithm = make_mask(make_surface(width=200, height=200))
        check_progress(self, algorithm)
        algorithm.SetMaximumDepth(4)  # so that the hierarchy is made, and given up
        abort = algorithm.AddObserver("ProgressEvent", lambda *unused: algorithm.AbortExecuteOn())
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(algorithm.GetNumberOfNodes(), 0)
        algorithm.RemoveObserver(abort)
        algorithm.Modified()
        algorithm.Update()
        self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 40000)


if __name__ == "__main__":
    unittest.main()
