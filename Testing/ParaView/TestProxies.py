# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every proxy of the plugin is created, updated with its defaults, documented and in the menu."""
import glob
import os
import unittest
import xml.etree.ElementTree as ElementTree

import bravais
import views
from paraview import servermanager, simple

views.load_plugin()


def read_proxies(group):
    """The XML elements of the plugin's proxies of a group, by name."""
    found = {}
    for path in sorted(glob.glob(os.path.join(os.environ["BRAVAIS_XML"], "*.xml"))):
        for element in ElementTree.parse(path).getroot().findall(f"ProxyGroup[@name='{group}']/*"):
            if element.tag.endswith("Proxy"):
                found[element.get("name")] = element
    return found


def make_input(name):
    """What a filter of that name is for."""
    if name in ("BCCPrefilter", "BCCVolumeToImage"):
        return simple.BCCVolumeSource(Dimensions=[8, 8, 16])
    if name.startswith("GeometryImage"):
        return simple.GeometryImageSource(Dimensions=[17, 17])
    if name.startswith("Rank1"):
        picture = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, 0, 0])
        makes = name in ("Rank1ImageResample", "Rank1TexturePyramid")
        return picture if makes else simple.Rank1ImageResample(Input=picture)
    if name == "PolyDataToGeometryImage":
        return simple.Sphere()
    return simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])


class TestProxies(unittest.TestCase):
    def test_there_are_some(self):
        self.assertIn("BCCVolumeSource", read_proxies("sources"))
        self.assertIn("BCCVolumeToImage", read_proxies("filters"))
        self.assertIn("BCCVolumeRepresentation", read_proxies("representations"))

    def test_sources(self):
        for name in read_proxies("sources"):
            with self.subTest(name):
                if not name.endswith("Reader"):
                    source = getattr(simple, name)()
                    source.UpdatePipeline()
                    self.assertGreater(source.GetDataInformation().GetNumberOfPoints(), 0)

    def test_readers_and_writers(self):
        picture = simple.Wavelet(WholeExtent=[-5, 5, -4, 4, 0, 0])
        surface = simple.GeometryImageSource(Dimensions=[9, 9])
        names = set(read_proxies("writers"))
        names.remove("Rank1TextureFileWriter")  # TestRank1 tests it; ParaView has no reader of it
        for source, ending, kind in (picture, "exr", "OIIOImage"), (surface, "gim", "GeometryImage"):
            with self.subTest(kind):
                path = os.path.join(os.environ["BRAVAIS_TEMPORARY"], f"file.{ending}")
                simple.SaveData(path, proxy=source)
                reader = getattr(simple, kind + "Reader")(FileName=path)
                reader.UpdatePipeline()
                self.assertEqual(
                    reader.GetDataInformation().GetNumberOfPoints(),
                    source.GetDataInformation().GetNumberOfPoints(),
                )
                names.remove(kind + "Writer")
                # The file's name is enough for ParaView to choose the reader.
                self.assertEqual(simple.OpenDataFile(path).GetXMLName(), kind + "Reader")
        self.assertFalse(names, "each writer is tested")

    def test_filters(self):
        for name in read_proxies("filters"):
            with self.subTest(name):
                algorithm = getattr(simple, name)(Input=make_input(name))
                algorithm.UpdatePipeline()
                self.assertGreater(algorithm.GetDataInformation().GetNumberOfPoints(), 0)

    def test_are_in_the_menu(self):
        for group in "sources", "filters":
            for name, element in read_proxies(group).items():
                with self.subTest(name):
                    if name.endswith("Reader"):
                        self.assertTrue(element.find("Hints/ReaderFactory").get("extensions"))
                        continue
                    menu = element.find("Hints/ShowInMenu")
                    self.assertEqual(menu.get("category"), "Bravais")
                    self.assertTrue(element.get("label"))

    def test_are_documented(self):
        for group in "sources", "filters", "representations", "writers":
            for name, element in read_proxies(group).items():
                self.assertTrue(element.findtext("Documentation", "").strip(), name)
                for part in element:
                    if part.tag.endswith("Property"):
                        text = part.findtext("Documentation", "").strip()
                        self.assertTrue(text, f"{name}.{part.get('name')}")

    def test_values_can_be_set_and_are_heard(self):
        """Each property with an enumeration takes all of its values, and each changes the object."""
        for group in "sources", "filters":
            for name, element in read_proxies(group).items():
                if name.endswith("Reader"):
                    continue
                algorithm = (
                    getattr(simple, name)()
                    if group == "sources"
                    else getattr(simple, name)(Input=make_input(name))
                )
                client = algorithm.SMProxy.GetClientSideObject()
                self.assertIsInstance(client, getattr(bravais, element.get("class")))
                for part in element.findall("IntVectorProperty[EnumerationDomain]"):
                    getter = getattr(client, "Get" + part.get("command")[3:])
                    for entry in part.findall("EnumerationDomain/Entry"):
                        with self.subTest(f"{name}.{part.get('name')} = {entry.get('text')}"):
                            setattr(algorithm, part.get("name"), entry.get("text"))
                            self.assertEqual(getter(), int(entry.get("value")))


if __name__ == "__main__":
    assert servermanager.ActiveConnection
    views.run()
