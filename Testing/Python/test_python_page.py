# SPDX-License-Identifier: BSD-3-Clause
"""The lines of Examples/Python.md run as they stand, in an empty folder.

usage: python3 test_python_page.py EXAMPLES BLOCK, the first block being number 0
"""

import importlib.util
import math
import os
import pathlib
import re
import sys
import tempfile

page = (pathlib.Path(sys.argv[1]) / "Python.md").resolve().read_text()
blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
assert len(blocks) == 2
names = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    if sys.argv[2] == "0":
        exec(blocks[0], names)
        assert math.isclose(names["distances"][1], math.sqrt(6))
        assert sorted(names["lines"]["GeodesicDistance"]) == [0.5, 1]
        assert math.isclose(max(names["ways"]["GeodesicDistance"]), math.sqrt(6))
        assert names["table"].shape == (2, 2)
        assert [list(distances) for distances in names["several"]][0] == list(names["distances"])
        assert all(map(math.isclose, names["single"], map(math.sqrt, (6, 2, 2))))
        assert list(names["ids"]) == [0, 1, 2, 3]
        assert all(map(math.isclose, names["radii"][1:], map(math.sqrt, (6, 2, 2))))
        assert all(map(math.isclose, names["along"][[0, 2, 1]], (0, math.sqrt(2), math.sqrt(8))))
    elif importlib.util.find_spec("pyvista"):
        exec(blocks[1], names)
        assert 1 < names["mesh"].point_data["distance"].max() < math.pi / 2
        assert "GeodesicDistance" in names["refined"].point_data
    else:
        print("Skipped: this Python has no pyvista")
        sys.exit(77)
    os.chdir("/")
