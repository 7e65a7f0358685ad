# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What `import bravais` gives: names, constants, help, and examples of classes that can be typed."""
import importlib
import inspect
import pydoc
import re
import subprocess
import sys
import unittest

import bravais


def get_classes():
    return {name: value for name, value in vars(bravais).items()
            if name.startswith("vtk") and inspect.isclass(value)}


class TestPackage(unittest.TestCase):
    def test_help_lists_everything(self):
        text = pydoc.render_doc(bravais, renderer=pydoc.plaintext)
        for module in "arrays", "pictures", "pipeline":
            for name in importlib.import_module("bravais." + module).__all__:
                self.assertRegex(text, rf"\b{name}\b")
                self.assertTrue(inspect.getdoc(getattr(bravais, name)), name)
                self.assertIn(name, dir(bravais))
        self.assertGreater(len(get_classes()), 20)
        for name in get_classes():
            self.assertRegex(text, rf"\n +{name} +\w+")

    def test_constants(self):
        self.assertEqual((bravais.BCC4, bravais.BCC7, bravais.BCC8, bravais.BCC12), (4, 7, 8, 12))
        self.assertRegex(bravais.__version__, r"^\d+\.\d+\.\d+$")
        with self.assertRaises(AttributeError):
            bravais.nothing

    def test_numpy_is_loaded_when_used(self):
        code = "import sys, bravais; assert 'numpy' not in sys.modules; bravais.bcc_from_numpy"
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_examples_of_classes(self):
        """Every class whose documentation has an example makes objects and calls methods that are."""
        checked = 0
        for name, kind in get_classes().items():
            example = kind.__doc__.partition("Example:")[2].partition("@sa")[0]
            for variable, called in re.findall(r"(\w+) = (vtk\w+)\(\)", example):
                made = getattr(bravais, called, None)
                for method in re.findall(rf"\b{variable}\.(\w+)\(", example) if made else ():
                    self.assertTrue(hasattr(made, method), f"{name}: {called}.{method}")
                    checked += 1
            self.assertIsNone(re.search(r"vtk\w+\(\w+=", example), name)
        self.assertGreater(checked, 40)


if __name__ == "__main__":
    unittest.main()
