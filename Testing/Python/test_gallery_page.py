# SPDX-License-Identifier: BSD-3-Clause
"""The gallery's page has a section for each script, whose lines stand in the script, and pictures that are small.

usage: python3 test_gallery_page.py EXAMPLES
"""

import pathlib
import re
import sys
import unittest

EXAMPLES = pathlib.Path(sys.argv.pop()).resolve()
PAGE = (EXAMPLES / "README.md").read_text()
SHARED = {"all", "look", "scan", "small_png"}
KILOBYTE = 1000


def sections():
    """By the name of its script, each section's text."""
    parts = re.split(r"^## .*$", PAGE, flags=re.MULTILINE)[1:]
    return {match[1]: part for part in parts if (match := re.search(r"\]\(gallery/(\w+)\.py\)", part))}


class Page(unittest.TestCase):
    def test_it_has_a_section_for_each_script(self):
        scripts = {script.stem for script in (EXAMPLES / "gallery").glob("*.py")} - SHARED
        self.assertEqual(set(sections()), scripts)

    def test_each_section_has_the_picture_of_its_script(self):
        for name, text in sections().items():
            self.assertEqual(re.findall(r"\(gallery/(\w+)\.png\)", text), [name])
            self.assertTrue((EXAMPLES / "gallery" / f"{name}.png").is_file())

    def test_the_lines_that_it_shows_are_those_of_the_script(self):
        for name, text in sections().items():
            blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
            self.assertTrue(blocks, name)
            for block in blocks:
                self.assertIn(block, (EXAMPLES / "gallery" / f"{name}.py").read_text())

    def test_links_within_the_page_lead_to_its_headings(self):
        headings = {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")
                    for heading in re.findall(r"^## (.*)$", PAGE, re.MULTILINE)}
        self.assertLessEqual(set(re.findall(r"\]\(#([\w-]+)\)", PAGE)), headings)

    def test_pictures_are_small(self):
        sizes = {file.name: file.stat().st_size for file in (EXAMPLES / "gallery").glob("*.png")}
        self.assertEqual([name for name, size in sizes.items() if size > 100 * KILOBYTE], [])
        self.assertLess(sum(sizes.values()), 1500 * KILOBYTE)


if __name__ == "__main__":
    unittest.main()
