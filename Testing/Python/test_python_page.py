# SPDX-License-Identifier: BSD-3-Clause
"""The lines of Examples/Python.md run as they stand, in an empty folder.

usage: python3 test_python_page.py EXAMPLES WITH_PYVISTA, 0: the blocks that need no PyVista, 1: the one that does
"""

import importlib.util
import math
import os
import pathlib
import re
import sys
import tempfile

import numpy

page = (pathlib.Path(sys.argv[1]) / "Python.md").resolve().read_text()
blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
assert len(blocks) == 4
names = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    if sys.argv[2] == "0":
        for block in blocks[:3]:
            exec(block, names)
        assert math.isclose(names["distances"][1], math.sqrt(6))
        assert sorted(names["lines"]["GeodesicDistance"]) == [0.5, 1]
        assert math.isclose(max(names["ways"]["GeodesicDistance"]), math.sqrt(6))
        assert names["table"].shape == (2, 2)
        assert [list(distances) for distances in names["several"]][0] == list(names["distances"])
        assert all(map(math.isclose, names["single"], map(math.sqrt, (6, 2, 2))))
        assert list(names["ids"]) == [0, 1, 2, 3]
        assert all(map(math.isclose, names["radii"][1:], map(math.sqrt, (6, 2, 2))))
        assert all(map(math.isclose, names["along_seam"][[0, 2, 1]], (0, math.sqrt(2), math.sqrt(8))))
        assert names["stops"].shape == (5, 3) and names["stops"][0].tolist() == [-1, 0, 0]
        steps = names["surface"].matrix(0, names["stops"])[:, 0]
        assert all(map(math.isclose, steps, math.sqrt(6) - 0.5 * numpy.arange(5)))
        ends = names["surface"].matrix(5, names["stops"])[:, 0]
        assert numpy.allclose(names["from_stops"]["GeodesicDistance"], ends, rtol=1e-12)
        assert all(map(math.isclose, names["relative"], names["distances"] / math.sqrt(4 * math.sqrt(3))))
        half = 2 * math.sqrt(3)  # the area of the upper pyramid, of which the loop cuts off the tip
        assert abs(names["left"] - 0.4**2 * half) < 1e-8 and abs(names["right"] - (2 - 0.4**2) * half) < 1e-8
    elif importlib.util.find_spec("pyvista"):
        exec(blocks[3], names)
        assert 1 < names["mesh"].point_data["distance"].max() < math.pi / 2
        assert "GeodesicDistance" in names["refined"].point_data
    else:
        print("Skipped: this Python has no pyvista")
        sys.exit(77)
    os.chdir("/")
