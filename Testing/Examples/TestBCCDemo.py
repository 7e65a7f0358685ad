# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo: its pictures, and the errors in its table."""
import re

import examples

PICTURES = ("outer-bcc7", "composite-bcc7", "inner-bcc7", "inner-trilinear", "detail-bcc7",
            "detail-trilinear", "marschner-lobb-bcc12", "marschner-lobb-bcc8",
            "marschner-lobb-bcc7", "marschner-lobb-trilinear", "marschner-lobb-bcc7-projection",
            "marschner-lobb-fine")


class TestBCCDemo(examples.ExampleTest):
    def test_pictures_and_table(self):
        ball = examples.write_volumes(self.folder)[0]
        text = self.passes(ball, "--inner", 60, "--outer", 30, "--isolate", 20, "-s", 60, "-o",
                           "pictures", "--detail-zoom", 2)
        for picture in PICTURES:
            self.shows(f"pictures/{picture}.png", (60, 60), 0.02)
        self.shows("pictures/inner-side-by-side.png", (120, 60), 0.02)
        self.shows("pictures/detail-side-by-side.png", (120, 60), 0.02)
        self.shows("pictures/marschner-lobb.png", (120, 60))
        errors = dict(re.findall(r"^marschner-lobb-(\S+) .* (0\.\d+)$", text, re.M))
        for name, error in (("bcc12", 0.0199), ("bcc8", 0.0091), ("bcc7", 0.0092),
                            ("trilinear", 0.0170), ("bcc12-projection", 0.0003),
                            ("bcc8-projection", 0.0013), ("bcc7-projection", 0.0012)):
            self.assertAlmostEqual(float(errors[name]), error, delta=0.0001)

    def test_bad_input(self):
        self.refuses("there is no such file", "none.vti")
        self.refuses("nan", "none.vti", "--inner", "nan")


if __name__ == "__main__":
    examples.main()
