# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A trace and state files, of both kinds, show the same picture when they are replayed."""
import os
import unittest

import views
from paraview import simple, smtrace

views.load_plugin()


def build():
    source = simple.BCCVolumeSource(Function="Gaussian", Dimensions=[16, 16, 32])
    view = views.make_view()
    display = simple.Show(source, view)
    display.SetRepresentationType("BCC Volume")
    simple.ColorBy(display, ("POINTS", "Scalars"))
    return view


def set_up(view):
    """What only states keep: a trace has what functions do, not which properties Python sets."""
    source, = simple.GetSources().values()
    display = simple.GetDisplayProperties(source, view)
    display.BCCBlendMode = "Isosurface"
    display.BCCIsosurfaceValues = [0.4]
    display.BCCShade = 1
    display.BCCKernel = "bcc8, quintic"
    view.ViewSize = [200, 200]
    view.CameraPosition = [1, -3, 2]
    view.CameraFocalPoint = [0, 0, 0]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.2, 0.3]


def forget():
    for view in simple.GetViews():
        simple.Delete(view)
    for source in list(simple.GetSources().values()):
        simple.Delete(source)


class TestState(unittest.TestCase):
    def setUp(self):
        view = build()
        set_up(view)
        self.expected = views.take_picture(view, "StateBefore")
        self.assertGreater(views.get_shown(self.expected).mean(), 0.02)

    def tearDown(self):
        forget()

    def check(self, name):
        view, = simple.GetViews()
        self.assertEqual(views.differ(views.take_picture(view, name), self.expected), 0)
        source, = simple.GetSources().values()
        display = simple.GetDisplayProperties(source, view)
        self.assertEqual(display.Representation, "BCC Volume")
        self.assertEqual(display.BCCKernel, "bcc8, quintic")

    def test_state_files(self):
        for name in "state.pvsm", "state.py":
            with self.subTest(name):
                path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], name)
                simple.SaveState(path)
                forget()
                simple.LoadState(path)
                self.check(name)

    def test_trace(self):
        forget()
        smtrace.start_trace()
        build()
        text = smtrace.stop_trace()
        forget()
        self.assertIn("BCCVolumeSource", text)
        exec(text, {})
        display = simple.GetDisplayProperties()
        self.assertEqual(display.Representation, "BCC Volume")
        set_up(simple.GetActiveView())
        self.check("trace")


if __name__ == "__main__":
    views.run()
