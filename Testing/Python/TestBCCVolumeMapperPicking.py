# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hardware selections and pickers find volumes, the samples nearest to surfaces, and where they are."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkSelectionNode
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkPropPicker, vtkWorldPointPicker)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLHardwareSelector

import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper

RADIUS = 0.6
IMAGE = scenes.make_bcc(lambda x, y, z: x * x + y * y + z * z, (16, 16, 32))


def make_scene(mode="IsoSurface", opacity=1, size=60):
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(IMAGE)
    getattr(mapper, "SetBlendModeTo" + mode)()
    edge = RADIUS ** 2
    opacities = ((0, opacity), (3, opacity)) if mode == "IsoSurface" else (
        (0, opacity), (edge - 1e-3, opacity), (edge + 1e-3, 0), (3, 0))
    return scenes.Scene(mapper, scenes.make_property(0, 3, opacities, iso_values=(edge,)),
                        size=size, sample_distance=0.03)


def select(scene, x0, y0, x1, y1, field=vtkDataObject.FIELD_ASSOCIATION_CELLS):
    selector = vtkOpenGLHardwareSelector()
    selector.SetRenderer(scene.renderer)
    selector.SetFieldAssociation(field)
    selector.SetArea(x0, y0, x1, y1)
    selection = selector.Select()
    return [selection.GetNode(n) for n in range(selection.GetNumberOfNodes())]


def get_point(number):
    nx, ny, _ = IMAGE.GetDimensions()
    x = [0.0, 0.0, 0.0]
    vtkBCCLattice.GetPoint(IMAGE, (number % nx, number // nx % ny, number // (nx * ny)), x)
    return numpy.array(x)


def make_ball(position, radius=0.2):
    source = vtkSphereSource()
    source.SetRadius(radius)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(position)
    return actor


class TestBCCVolumeMapperPicking(unittest.TestCase):
    def test_selected_cells_are_the_nearest_samples(self):
        points = numpy.array([get_point(n) for n in range(IMAGE.GetNumberOfPoints())])
        scene = make_scene()
        picture = scene.render()
        depth = scene.get_depth()
        for x, y in ((30, 30), (20, 30), (25, 35), (30, 22)):
            self.assertLess(depth[y, x], 1)
            node, = select(scene, x, y, x, y)
            self.assertIs(node.GetProperties().Get(vtkSelectionNode.PROP()), scene.volume)
            number, = vtk_to_numpy(node.GetSelectionList())
            there = scene.to_world(numpy.array([x]), numpy.array([y]), depth[[y], [x]])[:, 0]
            distances = numpy.linalg.norm(points - there, axis=1)
            self.assertLess(distances[number], distances.min() + 1e-4)
        # The scene is as it was.
        numpy.testing.assert_array_equal(scene.render(), picture)

    def test_area(self):
        layer = IMAGE.GetSpacing()[2]
        for mode, shell in (("IsoSurface", 1.2 * layer), ("Composite", 2 * layer)):
            scene = make_scene(mode)
            node, = select(scene, 20, 20, 40, 40)
            numbers = vtk_to_numpy(node.GetSelectionList())
            radii = numpy.array([numpy.linalg.norm(get_point(n)) for n in numbers])
            self.assertGreater(len(radii), 50)
            if mode == "IsoSurface":
                self.assertGreater(radii.min(), RADIUS - shell)
            self.assertLess(numpy.median(radii), RADIUS + shell)
            self.assertEqual(select(scene, 0, 0, 3, 3), [])

    def test_points_are_the_samples(self):
        """Selections of points know the volume too, and those of a mesh beside it."""
        for mode in "IsoSurface", "Composite":
            scene = make_scene(mode)
            ball = make_ball((0.9, 0.9, 0.9))
            scene.renderer.AddActor(ball)
            scene.window.Render()
            both = [{}, {}]
            for field, found in zip((vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                     vtkDataObject.FIELD_ASSOCIATION_CELLS), both):
                for node in select(scene, 0, 0, 59, 59, field):
                    found[node.GetProperties().Get(vtkSelectionNode.PROP())] = node
            points, cells = both
            self.assertEqual(set(points), {scene.volume, ball})
            node = points[scene.volume]
            self.assertEqual(node.GetFieldType(), vtkSelectionNode.POINT)
            self.assertGreater(node.GetSelectionList().GetNumberOfTuples(), 50)
            if mode == "IsoSurface":  # The other ends a ray at the depth of the ball's points.
                numpy.testing.assert_array_equal(
                    vtk_to_numpy(node.GetSelectionList()),
                    vtk_to_numpy(cells[scene.volume].GetSelectionList()))

    def test_several_volumes_and_actors(self):
        scene, other = make_scene(), make_scene()
        other.volume.SetScale(0.4)
        other.volume.SetPosition(0.65, 0.52, 1.04)
        scene.renderer.AddVolume(other.volume)
        behind, before = make_ball((0, 0, 0)), make_ball((-0.9, -0.9, 0.9))
        scene.renderer.AddActor(behind)
        scene.renderer.AddActor(before)
        picker = vtkPropPicker()
        self.assertEqual(picker.Pick(30, 30, 0, scene.renderer), 1)
        self.assertIs(picker.GetViewProp(), other.volume)
        self.assertEqual(picker.Pick(21, 26, 0, scene.renderer), 1)
        self.assertIs(picker.GetViewProp(), scene.volume)
        props = {node.GetProperties().Get(vtkSelectionNode.PROP()) for node in
                 select(scene, 0, 0, 59, 59)}
        self.assertEqual(props, {scene.volume, other.volume, before})

    def test_where_a_surface_is(self):
        for opacity in 1, 0.3:
            scene = make_scene(opacity=opacity)
            scene.window.Render()
            picker = vtkPropPicker()
            self.assertEqual(picker.Pick(28, 31, 0, scene.renderer), 1)
            # VTK picks at a pixel's corner, and its rays go through centres.
            self.assertAlmostEqual(
                numpy.linalg.norm(picker.GetPickPosition()), RADIUS, delta=0.03)
        scene = make_scene()
        scene.window.Render()
        picker = vtkWorldPointPicker()
        picker.Pick(28, 31, 0, scene.renderer)
        self.assertAlmostEqual(numpy.linalg.norm(picker.GetPickPosition()), RADIUS, delta=0.03)

    def test_nothing_is_picked_beside_the_volume_or_where_it_is_clear(self):
        picker = vtkPropPicker()
        for mode in "IsoSurface", "Composite":
            scene = make_scene(mode)
            for x, found in ((2, 0), (48, 0), (30, 1)):
                self.assertEqual(picker.Pick(x, 30, 0, scene.renderer), found)


if __name__ == "__main__":
    unittest.main()
