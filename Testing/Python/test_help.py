# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's help has a page for each filter of the menu, with its picture, the paper and its properties.

usage: python3 test_help.py FILE.qch XML...
"""

import re
import sqlite3
import sys
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

HELP, FILES = sys.argv[1], sys.argv[2:]
del sys.argv[1:]


def content():
    """The files in Qt's help by their names."""
    with sqlite3.connect(HELP) as database:
        rows = database.execute(
            "SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON FileNameTable.FileId = FileDataTable.Id")
        return {name: zlib.decompress(data[4:]) for name, data in rows if name}


class Help(unittest.TestCase):
    def setUp(self):
        self.files = content()
        found = [proxy for file in FILES for proxy in ElementTree.parse(file).getroot().iter("SourceProxy")]
        self.filters = {proxy.get("name"): proxy for proxy in found if proxy.find("Hints/ShowInMenu") is not None}

    def test_has_a_page_for_each_filter(self):
        self.assertEqual(len(self.filters), 5)
        pages = {name for name in self.files if name.endswith(".html")}
        self.assertEqual(pages, {f"filters.{name}.html" for name in self.filters})

    def test_pages_have_pictures_the_paper_and_all_properties(self):
        for name, proxy in self.filters.items():
            text = self.files[f"filters.{name}.html"].decode()
            for picture in re.findall(r'<img src="([^"]+)"', text):
                self.assertTrue(self.files[picture].startswith(b"\x89PNG"))
            self.assertIn("<img ", text)
            self.assertEqual(text.count("Bommes"), 1)
            self.assertNotIn("*", text)
            labels = [proxy.get("label"), "Source Type", "Barrier Array Name"]
            for child in proxy:
                if child.tag.endswith("Property") and child.get("is_internal") != "1" and child.get("label", "").strip():
                    labels.append(child.get("label"))
            for label in labels:
                self.assertIn(label, text)

    def test_a_description_of_each_property_is_there(self):
        for name in self.filters:
            rows = re.findall(r"<tr>.*?</tr>", self.files[f"filters.{name}.html"].decode(), re.DOTALL)[1:]
            self.assertGreater(len(rows), 5)
            for row in rows:
                self.assertRegex(row, r"<p>[A-Z]")


if __name__ == "__main__":
    unittest.main()
