# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's XML files, held against the classes: every parameter is there, with its default."""
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

import bravais

FOLDER = pathlib.Path(__file__).parents[2] / "Module/ParaView/Plugin/XML"

# What has no place in a panel: objects made in a program, and what other parameters stand for.
LEFT_OUT = {
    "vtkBCCVolumeSource": {"ImplicitFunction"},
    "vtkGeometryImageLocalityMask": {"AspectRatio", "Camera"},
    "vtkImageToBCCVolume": {"Interpolator"},
}
# Classes that are no step of a pipeline, or are a representation.
NO_PROXY = {
    "vtkBCCInterpolator", "vtkBCCLattice", "vtkBCCVolumeMapper", "vtkBayerPattern",
    "vtkRank1Lattice", "vtkRank1TextureSampler", "vtkRank1TexturedPolyDataMapper",
}


def read_proxies():
    for path in sorted(FOLDER.glob("*.xml")):
        for element in ElementTree.parse(path).getroot().findall("ProxyGroup/*"):
            kind = getattr(bravais, element.get("class", ""), None)
            if kind:
                yield kind, element


def get_parameters(kind):
    """What a class adds to its superclass: names X with SetX and GetX."""
    inherited = set(dir(kind.__mro__[1]))
    own = {name for name in dir(kind) if name not in inherited}
    return {name[3:] for name in own if re.match(r"Set[A-Z]", name) and "Get" + name[3:] in own}


class TestParaViewXML(unittest.TestCase):
    def test_every_class_has_one(self):
        classes = {name for name in vars(bravais) if name.startswith("vtk") and
                   isinstance(getattr(bravais, name), type)}
        proxies = {kind.__name__ for kind, _ in read_proxies()}
        self.assertEqual(classes - proxies, NO_PROXY)

    def test_every_parameter_is_there(self):
        for kind, element in read_proxies():
            commands = {part.get("command") for part in element}
            missing = {name for name in get_parameters(kind) if f"Set{name}" not in commands}
            with self.subTest(kind.__name__):
                self.assertEqual(missing, LEFT_OUT.get(kind.__name__, set()))

    def test_commands_are_methods(self):
        for kind, element in read_proxies():
            for part in element:
                if part.get("command"):
                    self.assertTrue(hasattr(kind, part.get("command")), part.get("command"))

    def test_defaults(self):
        compared = 0
        for kind, element in read_proxies():
            made = kind()
            for part in element:
                default, command = part.get("default_values"), part.get("command", "")
                if default is None or not hasattr(made, "Get" + command[3:]):
                    continue
                value = getattr(made, "Get" + command[3:])()
                values = value if isinstance(value, tuple) else (value,)
                with self.subTest(f"{kind.__name__}.{command}"):
                    if isinstance(value, str):
                        self.assertEqual(default, value)
                    else:
                        self.assertEqual(tuple(map(float, default.split())), tuple(map(float, values)))
                compared += 1
        self.assertGreater(compared, 60)


if __name__ == "__main__":
    unittest.main()
