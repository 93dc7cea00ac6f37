# SPDX-License-Identifier: BSD-3-Clause
"""The methods of Surface as functions of a surface, for one question each."""

import inspect

from .surface import METHODS, Surface

OF_SURFACE = {name: parameter for name, parameter in inspect.signature(Surface).parameters.items() if name != "surface"}


def _function(method):
    """A function that makes a Surface of its first argument, and asks it."""
    def function(surface, *arguments, **options):
        for name in options:
            if name not in function.__signature__.parameters:
                raise TypeError(f"{method.__name__}() has no property {name}.")
        own = {name: options.pop(name) for name in OF_SURFACE if name in options}
        return method(Surface(surface, **own), *arguments, **options)

    function.__name__ = function.__qualname__ = method.__name__
    function.__doc__ = inspect.getdoc(method)
    self, *others = inspect.signature(method).parameters.values()
    function.__signature__ = inspect.Signature(
        [self.replace(name="surface"), *others, *OF_SURFACE.values()])
    return function


distance, field, contour, paths, matrix, farthest_points = map(_function, METHODS)
