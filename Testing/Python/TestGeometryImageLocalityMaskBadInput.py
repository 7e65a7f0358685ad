# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import resource
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import reference, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkBox, vtkImageData, vtkPlane, vtkPlanes, vtkSphere
from vtkmodules.vtkRenderingCore import vtkCamera

from bravais import vtkGeometryImageLocalityMask, vtkGeometryImageSource
from checks import Errors, refuses
from geometry import (
    get_all_masks, get_leaf_masks, get_leaves, get_mask, make_geometry_image, pack,
    run_length_code)

NAN = math.nan


def make_mask(image, depth=3, cull=None):
    algorithm = vtkGeometryImageLocalityMask()
    algorithm.SetInputDataObject(image)
    algorithm.SetMaximumDepth(depth)
    algorithm.SetCullFunction(cull)
    return algorithm


def make_points(width=6, height=5):
    return np.random.default_rng(1).normal(size=(height, width, 3))


def make_image():
    return make_geometry_image(make_points())


def replace(image, name, values, components=1):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    array.SetNumberOfComponents(components)
    image.GetPointData().RemoveArray(name)
    image.GetPointData().AddArray(array)
    return image


class TestGeometryImageLocalityMaskBadInput(unittest.TestCase):
    def test_images_that_are_none(self):
        image = make_image()
        image.GetFieldData().RemoveArray("Lattice")
        refuses(self, make_mask(image), "tag", "GeometryImage")
        image = make_image()
        image.GetFieldData().GetAbstractArray("Lattice").SetValue(0, "BCC")
        refuses(self, make_mask(image), "GeometryImage")
        image = make_image()
        image.GetPointData().RemoveArray("Points")
        refuses(self, make_mask(image), "Points")
        empty = vtkImageData()
        empty.GetFieldData().ShallowCopy(make_image().GetFieldData())
        refuses(self, make_mask(empty), "0 x 0 x 0")
        image = make_image()
        image.SetDimensions(3, 2, 5)
        refuses(self, make_mask(image), "3 x 2 x 5")

    def test_arrays_of_other_shapes(self):
        refuses(self, make_mask(replace(make_image(), "Points", np.zeros(90, np.int32), 3)),
                "Points", "int", "float or double")
        refuses(self, make_mask(replace(make_image(), "Points", np.zeros(60), 2)), "Points", "2")
        refuses(self, make_mask(replace(make_image(), "Points", np.zeros(60), 3)), "20", "30")
        refuses(self, make_mask(replace(make_image(), "Defined", np.zeros(30))), "Defined", "double")
        refuses(self, make_mask(replace(make_image(), "Defined", np.zeros(29, np.uint8))), "29", "30")
        refuses(self, make_mask(replace(make_image(), "Defined", np.zeros(60, np.uint8), 2)), "2")

    def test_infinities(self):
        for bad in math.inf, -math.inf:
            points = make_points()
            points[2, 3, 1] = bad
            refuses(self, make_mask(make_geometry_image(points)), "(3, 2)", "inf")
            points[2, 3, 0] = NAN  # it is not used then
            algorithm = make_mask(make_geometry_image(points))
            algorithm.Update()
            self.assertEqual(get_mask(algorithm).sum(), 29)
            points[2, 3, 0] = 0
            defined = np.ones((5, 6))
            defined[2, 3] = 0
            algorithm = make_mask(make_geometry_image(points, defined))
            algorithm.Update()
            self.assertEqual(get_mask(algorithm).sum(), 29)
        points = np.sign(make_points()) * 1.7e308
        refuses(self, make_mask(make_geometry_image(points)), "box")

    def test_parameters(self):
        for depth in -1, 11, 10 ** 9:
            refuses(self, make_mask(make_image(), depth), "MaximumDepth", str(depth), "0 to 10")
        for cube in (0, 0, 0, -1), (NAN, 0, 0, 1), (0, 0, math.inf, 1), (0, 0, 0, NAN), (1, 1, 1, 1e-18):
            algorithm = make_mask(make_image())
            algorithm.SetRootCube(*cube)
            refuses(self, algorithm, "RootCube")
        algorithm = make_mask(make_image())
        algorithm.SetCamera(vtkCamera())
        for ratio in 0.0, -1.0, NAN, math.inf:
            algorithm.SetAspectRatio(ratio)
            refuses(self, algorithm, "AspectRatio")
        algorithm.SetAspectRatio(1)
        algorithm.GetCamera().SetPosition(NAN, 0, 0)
        refuses(self, algorithm, "frustum")

    def test_functions(self):
        plane, sphere, planes = vtkPlane(), vtkSphere(), vtkPlanes()
        plane.SetOrigin(NAN, 0, 0)
        refuses(self, make_mask(make_image(), cull=plane), "plane", "nan")
        sphere.SetRadius(NAN)
        refuses(self, make_mask(make_image(), cull=sphere), "vtkSphere", "nan")
        refuses(self, make_mask(make_image(), cull=planes), "vtkPlanes", "0 points")
        refuses(self, make_mask(make_image(), cull=vtkBox()), "vtkBox", "order")

    def test_collision_image(self):
        algorithm = make_mask(make_image())
        algorithm.SetInputDataObject(1, vtkImageData())
        refuses(self, algorithm, "GeometryImage")
        points = make_points()
        points[0, 0] = math.inf
        algorithm.SetInputDataObject(1, make_geometry_image(points))
        refuses(self, algorithm, "port 1", "(0, 0)")
        algorithm.SetInputDataObject(1, make_geometry_image(points * NAN))
        algorithm.Update()
        self.assertEqual(get_mask(algorithm).sum(), 0)

    def test_good_after_bad(self):
        algorithm = make_mask(make_image(), 11)
        refuses(self, algorithm, "MaximumDepth")
        self.assertEqual(algorithm.GetNumberOfNodes(), 0)
        algorithm.SetMaximumDepth(2)
        algorithm.Update()
        self.assertEqual(get_mask(algorithm).sum(), 30)
        algorithm.SetMaximumDepth(-2)
        refuses(self, algorithm, "MaximumDepth")
        self.assertEqual(algorithm.GetNumberOfLeaves(), 0)

    def test_leaves_that_there_are_not(self):
        algorithm = make_mask(make_image())
        algorithm.Update()
        array = vtkUnsignedCharArray()
        for leaf in -1, algorithm.GetNumberOfLeaves(), 10 ** 12:
            self.assertEqual(algorithm.GetLeafEncoding(leaf), -1)
            for ask in algorithm.GetLeafMask, algorithm.GetLeafCode:
                array.SetNumberOfValues(3)
                with Errors(algorithm) as errors:
                    self.assertFalse(ask(leaf, array))
                self.assertEqual(len(errors.texts), 1)
                self.assertIn(str(leaf), errors.texts[0])
                self.assertEqual(array.GetNumberOfValues(), 0)

    def test_no_array_to_write_to(self):
        algorithm = make_mask(make_image())
        algorithm.Update()
        for ask, given in ((algorithm.GetLeafMask, (0, None)), (algorithm.GetLeafCode, (0, None)),
                           (algorithm.GetLeafCells, (None,)),
                           (algorithm.IntersectWithLine, ((0, 0, 0), (1, 1, 1), None))):
            with Errors(algorithm) as errors:
                self.assertFalse(ask(*given))
            self.assertEqual(len(errors.texts), 1)
            self.assertIn("no array", errors.texts[0])

    def test_lines_that_are_not_finite(self):
        algorithm = make_mask(make_image())
        mask = vtkUnsignedCharArray()
        for bad in np.nan, np.inf:
            for line in ((bad, 0, 0), (1, 1, 1)), ((0, 0, 0), (1, 1, bad)):
                for rest in (reference(0.0), [0.0] * 3, [0] * 3), (mask,):
                    with Errors(algorithm) as errors:
                        self.assertFalse(algorithm.IntersectWithLine(*line, *rest))
                    self.assertEqual(len(errors.texts), 1)
                    self.assertIn("finite", errors.texts[0])

    def test_few_gixels(self):
        for size in (1, 1), (1, 7), (9, 1), (2, 2):
            for depth in 0, 1, 10:
                for encoding in vtkGeometryImageLocalityMask.RLE, vtkGeometryImageLocalityMask.Roaring:
                    image = make_geometry_image(make_points(*size))
                    algorithm = make_mask(image, depth)
                    algorithm.SetEncoding(encoding)
                    algorithm.Update()
                    np.testing.assert_array_equal(get_mask(algorithm), 1)
                    if size != (1, 1):  # whose cube has no edge
                        leaves = get_leaves(image, depth)[0]
                        np.testing.assert_array_equal(get_leaf_masks(algorithm)[0], leaves)
                        codes = [run_length_code(pack(m)) for m in get_all_masks(image, depth)]
                        self.assertLessEqual(
                            algorithm.GetCompressedSize(False), sum(map(len, codes)))

    def test_identical_gixels(self):
        for place in 0.0, 1e-310, 3.0, -1e30, 1e300:
            for size in (1, 1), (8, 9):
                points = np.full(size + (3,), place)
                for depth in 0, 1, 10:
                    algorithm = make_mask(make_geometry_image(points), depth)
                    algorithm.Update()
                    self.assertEqual(algorithm.GetNumberOfLeaves(), 1)
                    self.assertEqual(algorithm.GetNumberOfNodes(), depth + 1)
                    np.testing.assert_array_equal(get_mask(algorithm), 1)

    def test_gixels_closer_than_numbers_tell_apart(self):
        points = np.full((3, 3, 3), 1.0)
        points[1, 1] = np.nextafter(1, 2)
        algorithm = make_mask(make_geometry_image(points), 10)
        algorithm.Update()
        np.testing.assert_array_equal(get_mask(algorithm), 1)

    def test_undefined_gixels(self):
        for points, defined in (make_points() * NAN, None), (make_points(), np.zeros((5, 6))):
            for depth in 0, 10:
                for function in None, vtkSphere(), vtkPlane():
                    image = make_geometry_image(points, defined)
                    algorithm = make_mask(image, depth, function)
                    algorithm.Update()
                    np.testing.assert_array_equal(get_mask(algorithm), np.zeros(30))
                    self.assertEqual(algorithm.GetNumberOfNodes(), 0)
                    self.assertEqual(algorithm.GetNumberOfLeaves(), 0)
                    self.assertEqual(algorithm.GetNumberOfVisibleLeaves(), 0)
                    self.assertEqual(algorithm.GetCompressedSize(False), 0)
                    self.assertEqual(algorithm.GetUncompressedSize(False), 0)
                    t, x, gixels = reference(0.0), [0.0] * 3, [0] * 3
                    self.assertFalse(algorithm.IntersectWithLine((0, 0, 0), (1, 1, 1), t, x, gixels))

    def test_one_undefined_gixel_of_two(self):
        points = make_points(2, 1)
        algorithm = make_mask(make_geometry_image(points, np.array([[0, 255]])), 4)
        algorithm.Update()
        np.testing.assert_array_equal(get_mask(algorithm), [0, 1])
        self.assertEqual(algorithm.GetNumberOfNodes(), 5)

    def test_memory_of_deep_trees(self):
        source = vtkGeometryImageSource()
        source.SetDimensions(513, 513)
        source.Update()
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for encoding in vtkGeometryImageLocalityMask.RLE, vtkGeometryImageLocalityMask.Roaring:
            algorithm = make_mask(source.GetOutput(), 10)
            algorithm.SetEncoding(encoding)
            algorithm.Update()
            nodes = algorithm.GetNumberOfNodes()
            self.assertGreater(nodes, 500000)
            self.assertGreater(algorithm.GetUncompressedSize(False), nodes * 32000)  # 16 GB
            self.assertLess(algorithm.GetCompressedSize(False), nodes * 24)
        grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024
        self.assertLess(grown, 1000 * nodes)  # checked memory, which is several times as large, too


if __name__ == "__main__":
    unittest.main()
