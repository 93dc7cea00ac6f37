# SPDX-License-Identifier: BSD-3-Clause
"""What the distance from a sphere's north pole to its south pole must be, for the checks of what is
installed."""

import math


def of_pole_to_pole(radius, theta_resolution, phi_resolution):
    """Least and largest distance on vtkSphereSource's polyhedron from pole to pole.

    A meridian's edges are one path on the surface. No path is shorter than a half circle on the
    largest sphere inside: put onto it by central projection, a path gets no longer. Every face lies
    outside the sphere that is smaller by the cosines of half the steps along and across meridians.
    """
    step = math.pi / (phi_resolution - 1)
    meridian = (phi_resolution - 1) * 2 * radius * math.sin(step / 2)
    inside = radius * math.cos(step / 2) * math.cos(math.pi / theta_resolution)
    return math.pi * inside, meridian
