# SPDX-License-Identifier: BSD-3-Clause
"""Beside a VTK that it is not made for, the package says so in a sentence."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

OTHER = """
class vtkVersion:
    @staticmethod
    def GetVTKVersion():
        return "1.2.3"
"""


def message_of_import(modules):
    """The last line that Python prints where vtkmodules has these modules alone: their names and texts."""
    with tempfile.TemporaryDirectory() as folder:
        package = pathlib.Path(folder, "vtkmodules")
        package.mkdir()
        for name, text in {"__init__": "", **modules}.items():
            (package / f"{name}.py").write_text(text)
        path = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])
        python = subprocess.run([sys.executable, "-c", "import geodesicdistance"], cwd=folder, text=True,
                                env={**os.environ, "PYTHONPATH": path}, stderr=subprocess.PIPE)
    return python.stderr.splitlines()[-1]


class WrongVTK(unittest.TestCase):
    def test_of_another_version_the_message_names_both(self):
        self.assertRegex(message_of_import({"vtkCommonCore": OTHER}),
                         r"^ImportError: This geodesicdistance is made for .*VTK \d\S*.*, "
                         r"which Python does not find \(it finds VTK 1\.2\.3\): install .*\.$")

    def test_where_there_is_none_the_message_says_what_to_install(self):
        self.assertRegex(message_of_import({}),
                         r"^ImportError: This geodesicdistance is made for .*VTK \d\S*.*, "
                         r"which Python does not find \(No module named 'vtkmodules.vtkCommonCore'\): install .*\.$")


if __name__ == "__main__":
    unittest.main()
