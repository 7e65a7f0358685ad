# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which leaves and gixels a volume meets, against tests of every gixel and every leaf."""
import itertools
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkDoubleArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkBox, vtkCone, vtkCylinder, vtkImplicitBoolean, vtkPlane, vtkPlanes, vtkQuadric, vtkSphere)
from vtkmodules.vtkCommonTransforms import vtkPerspectiveTransform, vtkTransform
from vtkmodules.vtkRenderingCore import vtkCamera

from bravais import vtkGeometryImageLocalityMask, vtkGeometryImageSource
from geometry import (
    get_leaf_masks, get_leaves, get_mask, get_points, get_root_cube, get_used, make_geometry_image)

DEPTH = 3


def make_image():
    generator = np.random.default_rng(4)
    points = generator.uniform(-1, 1, (31, 37, 3))
    points[::7, ::3] = np.nan
    return make_geometry_image(points, generator.integers(0, 8, (31, 37)))


def make_surface(shape="BumpySphere", size=(61, 50)):
    source = vtkGeometryImageSource()
    getattr(source, f"SetShapeTo{shape}")()
    source.SetDimensions(size)
    source.Update()
    return source.GetOutput()


def make_planes(normals, origins):
    planes = vtkPlanes()
    points, array = vtkPoints(), vtkDoubleArray()
    points.SetDataTypeToDouble()
    array.SetNumberOfComponents(3)
    for normal, origin in zip(normals, origins):
        points.InsertNextPoint(origin)
        array.InsertNextTuple3(*normal)
    planes.SetPoints(points)
    planes.SetNormals(array)
    return planes


def make_frustum(camera, aspect):
    equations = [0.0] * 24
    camera.GetFrustumPlanes(aspect, equations)
    planes = vtkPlanes()
    planes.SetFrustumPlanes(equations)
    return planes


def make_camera(seed=0):
    generator = np.random.default_rng(seed)
    camera = vtkCamera()
    camera.SetPosition(*generator.uniform(-2, 2, 3))
    camera.SetFocalPoint(*generator.uniform(-0.6, 0.6, 3))
    camera.SetViewAngle(generator.uniform(10, 50))
    camera.SetClippingRange(0.5, 3)
    return camera


def make_functions():
    """Functions that cells are tested for."""
    generator = np.random.default_rng(6)
    functions = []
    for n in range(3):
        plane = vtkPlane()
        plane.SetNormal(*generator.normal(size=3))
        plane.SetOrigin(*generator.uniform(-0.5, 0.5, 3))
        sphere = vtkSphere()
        sphere.SetCenter(*generator.uniform(-1, 1, 3))
        sphere.SetRadius(generator.uniform(0.05, 1.2))
        box = vtkBox()
        low = generator.uniform(-1, 0.5, 3)
        high = low + generator.uniform(0.01, 1, 3)
        box.SetBounds(*np.stack((low, high), 1).ravel())
        functions += [plane, sphere, box, make_frustum(make_camera(n), 1.5),
                      make_planes(generator.normal(size=(70, 3)), generator.normal(size=(70, 3)))]
    whole, nothing = vtkSphere(), vtkSphere()
    whole.SetRadius(9)
    nothing.SetCenter(9, 9, 9)
    return functions + [whole, nothing]


def make_transforms():
    turn = vtkTransform()
    turn.RotateWXYZ(40, 1, 2, 3)
    stretch = vtkTransform()
    stretch.Translate(0.1, -0.2, 0.3)
    stretch.RotateWXYZ(70, 1, -2, 0.5)
    stretch.Scale(2, 0.6, -1.3)
    flat = vtkTransform()
    flat.Scale(1, 1, 0)
    return [turn, stretch, stretch.GetInverse(), flat]


def evaluate(function, image):
    """Which used gixels are inside."""
    values = np.array([function.FunctionValue(x) if not np.isnan(x).any() else 1
                       for x in get_points(image)])
    return (values < 0) & get_used(image)


def run(image, function, refine=False, internal=True, encoding="RLE"):
    algorithm = vtkGeometryImageLocalityMask()
    algorithm.SetInputDataObject(image)
    algorithm.SetMaximumDepth(DEPTH)
    algorithm.SetCullFunction(function)
    algorithm.SetRefineToGixels(refine)
    algorithm.SetStoreInternalMasks(internal)
    getattr(algorithm, f"SetEncodingTo{encoding}")()
    algorithm.Update()
    return algorithm


class TestGeometryImageLocalityMaskQueries(unittest.TestCase):
    def check(self, image, function):
        """The mask holds what is inside, is made of whole leaves, and refines to what is inside."""
        inside = evaluate(function, image)
        leaves = get_leaves(image, DEPTH)[0]
        algorithm = run(image, function)
        mask = get_mask(algorithm).copy()
        self.assertTrue(set(np.unique(mask)) <= {0, 1})
        self.assertFalse((inside & (mask == 0)).any())
        seen = [(mask[leaf] != 0) for leaf in leaves]
        self.assertTrue(all(part.all() or not part.any() for part in seen))
        self.assertEqual(algorithm.GetNumberOfVisibleLeaves(), sum(part.all() for part in seen))
        for internal, encoding in ((True, "Roaring"), (False, "RLE")):
            again = run(image, function, False, internal, encoding)
            np.testing.assert_array_equal(get_mask(again), mask)
            refined = run(image, function, True, internal, encoding)
            np.testing.assert_array_equal(get_mask(refined), inside)
        return mask, leaves

    def test_functions(self):
        for image in make_image(), make_surface():
            for function in make_functions():
                self.check(image, function)

    def test_transforms(self):
        image = make_image()
        for function, transform in itertools.product(make_functions()[:5], make_transforms()):
            function.SetTransform(transform)
            self.check(image, function)

    def test_other_functions_take_leaves_with_a_gixel_inside(self):
        cylinder, cone, quadric, union = vtkCylinder(), vtkCone(), vtkQuadric(), vtkImplicitBoolean()
        cylinder.SetRadius(0.4)
        cone.SetAngle(20)
        quadric.SetCoefficients(1, -1, 0.5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, -0.1)
        for function in make_functions()[:3]:
            union.AddFunction(function)
        projective = make_functions()[1]
        perspective = vtkPerspectiveTransform()
        perspective.Perspective(60, 1, 1, 5)
        projective.SetTransform(perspective)
        flat = vtkBox()
        flat.SetBounds(-1, 1, -1, 1, 0.1, 0.1)
        flat.SetTransform(make_transforms()[0])
        image = make_image()
        for function in cylinder, cone, quadric, union, projective, flat:
            mask, leaves = self.check(image, function)
            inside = evaluate(function, image)
            expected = np.any([leaf * inside[leaf].any() for leaf in leaves], axis=0)
            np.testing.assert_array_equal(mask, expected)

    def get_boxes(self, image):
        corner, edge = get_root_cube(image)
        cells = get_leaves(image, DEPTH)[1]
        low = corner + cells * (edge / 2 ** DEPTH)
        return low, low + edge / 2 ** DEPTH

    def check_leaves(self, image, function, meets):
        leaves = get_leaves(image, DEPTH)[0]
        expected = leaves[meets].any(axis=0) if meets.any() else np.zeros(leaves.shape[1])
        np.testing.assert_array_equal(get_mask(run(image, function)), expected)

    def test_leaves_are_those_whose_cells_meet_the_volume(self):
        image = make_image()
        low, high = self.get_boxes(image)
        for function in make_functions():
            if isinstance(function, vtkPlane):
                normal, origin = np.array(function.GetNormal()), function.GetOrigin()
                nearest = np.where(normal > 0, low, high)
                meets = (nearest - origin) @ normal < 0
            elif isinstance(function, vtkPlanes):
                meets = np.ones(len(low), bool)
                for n in range(function.GetNumberOfPlanes()):
                    normal = np.array(function.GetPlane(n).GetNormal())
                    nearest = np.where(normal > 0, low, high)
                    meets &= (nearest - function.GetPlane(n).GetOrigin()) @ normal < 0
            elif isinstance(function, vtkSphere):
                nearest = np.clip(function.GetCenter(), low, high)
                meets = np.linalg.norm(nearest - function.GetCenter(), axis=1) < function.GetRadius()
            else:
                bounds = np.array(function.GetBounds())
                meets = ((low < bounds[1::2]) & (high > bounds[::2])).all(axis=1)
            self.check_leaves(image, function, meets)

    def test_leaves_of_turned_and_stretched_spheres(self):
        image = make_surface("Sphere")
        low, high = self.get_boxes(image)
        steps = np.linspace(0, 1, 25)
        grid = np.stack(np.meshgrid(steps, steps, steps), -1).reshape(-1, 3)
        sphere = vtkSphere()
        sphere.SetCenter(0.3, 0.5, -0.2)
        sphere.SetRadius(0.45)
        for transform in make_transforms()[:3]:
            matrix = transform.GetMatrix()
            m = np.array([[matrix.GetElement(r, c) for c in range(4)] for r in range(4)])
            sphere.SetTransform(transform)
            mask = get_mask(run(image, sphere)) != 0
            taken = []
            for leaf, a, b in zip(get_leaves(image, DEPTH)[0], low, high):
                points = a + grid * (b - a)
                distance = np.linalg.norm(
                    points @ m[:3, :3].T + m[:3, 3] - sphere.GetCenter(), axis=1).min()
                taken.append(mask[leaf].all())
                if distance < 0.45:
                    self.assertTrue(taken[-1])
                elif distance > 0.45 + 0.05:  # more than the grid's step
                    self.assertFalse(taken[-1])
            self.assertNotIn(sum(taken), (0, len(taken)))

    def test_strictly_inside(self):
        plane_image = make_surface("Plane", (5, 5))
        plane = vtkPlane()
        plane.SetNormal(1, 0, 0)
        mask = get_mask(run(plane_image, plane, True)).reshape(5, 5)
        np.testing.assert_array_equal(mask, [[1, 1, 0, 0, 0]] * 5)
        box = vtkBox()
        box.SetBounds(-0.5, 0.5, -1, 1, 0, 0)
        self.check(plane_image, box)
        mask = get_mask(run(plane_image, box, True)).reshape(5, 5)
        np.testing.assert_array_equal(mask[1:4], [[0, 0, 1, 0, 0]] * 3)
        self.assertEqual(mask.sum(), 3)

    def test_camera(self):
        image = make_surface()
        algorithm = vtkGeometryImageLocalityMask()
        algorithm.SetInputDataObject(image)
        algorithm.SetMaximumDepth(DEPTH)
        for seed, aspect in (1, 0.5), (2, 2.0), (3, 1.0):
            camera = make_camera(seed)
            algorithm.SetCamera(camera)
            algorithm.SetAspectRatio(aspect)
            for refine in False, True:
                algorithm.SetRefineToGixels(refine)
                algorithm.Update()
                expected = get_mask(run(image, make_frustum(camera, aspect), refine))
                np.testing.assert_array_equal(get_mask(algorithm), expected)
        before = get_mask(algorithm).copy()
        camera.Azimuth(40)  # the camera's own change is noticed
        algorithm.Update()
        expected = get_mask(run(image, make_frustum(camera, 1.0), True))
        np.testing.assert_array_equal(get_mask(algorithm), expected)
        self.assertTrue((before != expected).any())

    def test_collisions(self):
        a, b = make_surface("BumpySphere"), make_surface("Torus", (40, 30))
        points = vtk_to_numpy(b.GetPointData().GetArray("Points"))
        points += [1.4, 0.3, 0.2]
        algorithm = vtkGeometryImageLocalityMask()
        algorithm.SetInputDataObject(0, a)
        algorithm.SetInputDataObject(1, b)
        algorithm.SetMaximumDepth(DEPTH)
        algorithm.Update()
        (low, high), (other_low, other_high) = self.get_boxes(a), self.get_boxes(b)
        meets = ((low[:, None] < other_high) & (other_low < high[:, None])).all(axis=2).any(axis=1)
        leaves = get_leaves(a, DEPTH)[0]
        np.testing.assert_array_equal(get_mask(algorithm), leaves[meets].any(axis=0))
        self.assertEqual(algorithm.GetNumberOfVisibleLeaves(), meets.sum())
        self.assertNotIn(meets.mean(), (0, 1))
        algorithm.RefineToGixelsOn()
        algorithm.Update()
        x = get_points(a)[:, None]
        expected = ((other_low <= x) & (x < other_high)).all(axis=2).any(axis=1)
        np.testing.assert_array_equal(get_mask(algorithm), expected)
        points += 9
        b.GetPointData().GetArray("Points").Modified()
        b.Modified()
        algorithm.Update()
        self.assertEqual(get_mask(algorithm).sum(), 0)

    def test_sizes_of_visible_masks(self):
        image = make_surface()
        for encoding in "RLE", "Roaring":
            algorithm = run(image, None, encoding=encoding)
            self.assertLess(algorithm.GetVisibleSize(), 9)  # the root's
            self.assertLessEqual(algorithm.GetUnionSize(), algorithm.GetVisibleSize())
            sphere = vtkSphere()
            sphere.SetCenter(1, 0, 0)
            algorithm = run(image, sphere, False, False, encoding)
            masks, code, total = get_leaf_masks(algorithm)[0], vtkUnsignedCharArray(), 0
            mask = get_mask(algorithm)
            for n, leaf in enumerate(masks):
                if mask[leaf != 0].all():
                    algorithm.GetLeafCode(n, code)
                    total += code.GetNumberOfValues()
            self.assertEqual(algorithm.GetVisibleSize(), total)
            self.assertLess(algorithm.GetUnionSize(), total)

    def test_times(self):
        algorithm = run(make_surface(), make_functions()[0])
        for time in algorithm.GetCullTime(), algorithm.GetUnionTime():
            self.assertGreater(time, 0)
            self.assertLess(time, 60)

    def get_triangles(self, image):
        points, used = get_points(image), get_used(image)
        width, height, _ = image.GetDimensions()
        triangles = []
        for row, column in itertools.product(range(height - 1), range(width - 1)):
            a = row * width + column
            b, c, d = a + 1, a + width, a + width + 1
            corners = [g for g in (a, b, d, c) if used[g]]
            if len(corners) == 3:
                triangles.append(corners)
            elif len(corners) == 4:
                ad = np.linalg.norm(points[d] - points[a]) <= np.linalg.norm(points[c] - points[b])
                triangles += [(a, b, d), (a, d, c)] if ad else [(a, b, c), (b, d, c)]
        return np.array(triangles)

    def test_lines(self):
        generator = np.random.default_rng(9)
        surface = make_surface("BumpySphere", (21, 17))
        holes = make_geometry_image(
            get_points(surface).reshape(17, 21, 3), generator.integers(0, 6, (17, 21)))
        for image in surface, holes:
            triangles, points = self.get_triangles(image), get_points(image)
            algorithm = run(image, None)
            low, high = self.get_boxes(image)
            leaves = get_leaves(image, DEPTH)[0]
            hits = 0
            for p, q in generator.normal(size=(40, 2, 3)):
                # Moeller and Trumbore's test, of all triangles at once.
                a, e, f = (points[triangles[:, 0]], points[triangles[:, 1]] - points[triangles[:, 0]],
                           points[triangles[:, 2]] - points[triangles[:, 0]])
                normal = np.cross(q - p, f)
                determinant = (e * normal).sum(axis=1)
                with np.errstate(divide="ignore", invalid="ignore"):
                    u = ((p - a) * normal).sum(axis=1) / determinant
                    v = np.cross(p - a, e) @ (q - p) / determinant
                    t = (np.cross(p - a, e) * f).sum(axis=1) / determinant
                    good = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)
                found, x, gixels = reference(0.0), [0.0] * 3, [0] * 3
                self.assertEqual(algorithm.IntersectWithLine(p, q, found, x, gixels), good.any())
                if good.any():
                    hits += 1
                    self.assertAlmostEqual(found, t[good].min(), 12)
                    np.testing.assert_allclose(x, p + float(found) * (q - p), atol=1e-12)
                    first = np.argmin(np.where(good, t, 2))
                    self.assertEqual(sorted(gixels), sorted(triangles[first]))
                mask = vtkUnsignedCharArray()
                with np.errstate(divide="ignore"):
                    ends = np.stack(((low - p) / (q - p), (high - p) / (q - p)))
                meets = (np.maximum(ends.min(axis=0).max(axis=1), 0)
                         <= np.minimum(ends.max(axis=0).min(axis=1), 1))
                self.assertEqual(algorithm.IntersectWithLine(p, q, mask), meets.sum())
                expected = leaves[meets].any(axis=0) if meets.any() else np.zeros(leaves.shape[1])
                np.testing.assert_array_equal(vtk_to_numpy(mask), expected)
            self.assertGreater(hits, 10)

    def test_lines_in_planes_of_cells(self):
        image = make_surface("Plane", (9, 9))
        algorithm = run(image, None)
        t, x, gixels = reference(0.0), [0.0] * 3, [0] * 3
        self.assertTrue(algorithm.IntersectWithLine((0, 0, 1), (0, 0, -1), t, x, gixels))
        self.assertEqual((float(t), x), (0.5, [0, 0, 0]))
        self.assertIn(40, gixels)
        self.assertFalse(algorithm.IntersectWithLine((0, 0, 1), (0, 0, 0.1), t, x, gixels))
        self.assertFalse(algorithm.IntersectWithLine((2, 0, 1), (2, 0, -1), t, x, gixels))
        mask = vtkUnsignedCharArray()
        self.assertEqual(algorithm.IntersectWithLine((-2, -0.9, 0), (2, -0.9, 0), mask), 8)


if __name__ == "__main__":
    unittest.main()
