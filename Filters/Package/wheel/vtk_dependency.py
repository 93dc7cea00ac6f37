# SPDX-License-Identifier: BSD-3-Clause
"""The wheel's dependencies, for scikit-build-core: vtk in the very version that it is built for.

vtk-sdk, or an installed vtk, tells which that is. Of a VTK that pip does not know, as Debian 13's, the package checks
the version when it is imported.
"""

import importlib.metadata
import re


def dynamic_metadata(field, settings):
    for name in ("vtk-sdk", "vtk"):
        try:
            version = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
        return ["numpy", "vtk==" + re.match(r"\d+\.\d+\.\d+", version).group()]
    return ["numpy"]
