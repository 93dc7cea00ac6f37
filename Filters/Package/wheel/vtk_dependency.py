# SPDX-License-Identifier: BSD-3-Clause
"""The wheel's dependencies, for scikit-build-core: vtk in the very version that it is built for.

That is known where vtk-sdk is installed for the build. Another VTK comes from the system's packages, of which pip does
not know; the package checks its version when it is imported.
"""

import importlib.metadata
import re


def dynamic_metadata(field, settings):
    try:
        sdk = importlib.metadata.version("vtk-sdk")
    except importlib.metadata.PackageNotFoundError:
        return ["numpy"]
    return ["numpy", "vtk==" + re.match(r"\d+\.\d+\.\d+", sdk).group()]
