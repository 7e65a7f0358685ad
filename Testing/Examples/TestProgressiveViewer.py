# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewers that refine, C++ and Python, without a window: what they print and draw after the
mouse has dragged."""
import os

import examples


class TestProgressiveViewer(examples.ExampleTest):
    def refines(self, *arguments):
        text = self.passes("--size", 100, "--output", "passes.png", *arguments)
        self.assertIn("the last picture is the plain one", text)
        self.assertEqual(text.count("complete"), 1)
        picture = examples.read_picture(self.path("passes.png"))
        self.assertEqual(picture.shape[0], 100)
        return text, picture.reshape(100, -1, 100, 3).swapaxes(0, 1)

    def test_passes_after_a_drag(self):
        text, panels = self.refines()
        self.assertIn("16 passes", text)
        self.assertEqual(len(panels), 3)
        errors = [abs(panel - panels[2]).mean() for panel in panels[:2]]
        self.assertGreater(errors[1], 0)
        self.assertLess(errors[1], 0.8 * errors[0])

    def test_blocks(self):
        text, panels = self.refines("--block", 2)
        self.assertIn("4 passes", text)
        self.assertEqual(len(panels), 2)

    def test_composite(self):
        _, haze = self.refines("--composite")
        _, surface = self.refines()
        self.assertGreater(abs(haze[2] - surface[2]).mean(), 5)

    def test_bad_input(self):
        unwritable = self.path("none/a.png")
        for word, arguments in (("--block", ["--block", 3, "--output", self.path("a.png")]),
                                (unwritable, ["--size", 20, "--output", unwritable])):
            result = self.run_example(*arguments)
            self.assertGreater(result.returncode, 0)
            self.assertIn(word, result.stderr)
            self.assertNotIn("Traceback", result.stderr)
            self.assertNotIn("ERROR", result.stderr)
            self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    examples.main()
