# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script of Documentation/paraview.md, as it stands there."""
import os
import pathlib
import re
import unittest

import views

PAGE = pathlib.Path(__file__).parents[2] / "Documentation/paraview.md"


class TestDocumentation(unittest.TestCase):
    def test_script(self):
        (script,) = re.findall(r"(?:^    .*\n)+", PAGE.read_text(encoding="utf-8"), re.M)
        picture = os.path.join(os.environ["BRAVAIS_TEMPORARY"], "wavelet.png")
        script = re.sub("^    ", "", script, flags=re.M).replace("wavelet.png", picture)
        exec(script.replace("BravaisPlugin.so", os.environ["BRAVAIS_PLUGIN"]), {})
        pixels = views.read_picture(picture)
        self.assertGreater(views.get_shown(pixels).mean(), 0.05)
        self.assertGreater(pixels[views.get_shown(pixels)].std(), 5)


if __name__ == "__main__":
    views.run()
