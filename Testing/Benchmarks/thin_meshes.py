# SPDX-License-Identifier: BSD-3-Clause
"""Makes surfaces of thin triangles: strips around a cylinder and a torus, and rough terrains."""

import math
import random


def cylinder(strips=3_000, height=50.0):
    """Radius 1. Fans close its ends."""
    rims = [
        (math.cos(angle), math.sin(angle), z)
        for z in (0.0, height)
        for angle in (2.0 * math.pi * i / strips for i in range(strips))
    ]
    faces = []
    for i in range(strips):
        j = (i + 1) % strips
        faces += [(i, j, strips + j), (i, strips + j, strips + i)]
        faces += [(j, i, 2 * strips), (strips + i, strips + j, 2 * strips + 1)]
    return rims + [(0.0, 0.0, 0.0), (0.0, 0.0, height)], faces


def torus(around=20, across=500, ratio=10.0):
    """The tube's radius is 1."""
    points = []
    faces = []
    for i in range(around):
        for j in range(across):
            a = 2.0 * math.pi * i / around
            b = 2.0 * math.pi * j / across
            far = ratio + math.cos(b)
            points.append((far * math.cos(a), far * math.sin(a), math.sin(b)))
            here, next_row = i * across, (i + 1) % around * across
            k = (j + 1) % across
            faces += [(here + j, next_row + j, next_row + k), (here + j, next_row + k, here + k)]
    return points, faces


def terrain(size, deviation, spacing, seed):
    """Points of a grid, with normally distributed heights."""
    heights = random.Random(seed)
    points = [
        (spacing * i, spacing * j, heights.gauss(0.0, deviation))
        for i in range(size)
        for j in range(size)
    ]
    faces = []
    for i in range(size - 1):
        for p in range(i * size, i * size + size - 1):
            faces += [(p, p + size, p + size + 1), (p, p + size + 1, p + 1)]
    return points, faces


MAKERS = {
    "cylinder": cylinder,
    "torus": torus,
    "rough": lambda: terrain(150, 10.0, 1.0, seed=1),
    "spikes": lambda: terrain(50, 50.0, 2.0 / 49.0, seed=2),
}


def write(name, file):
    """Writes a surface of MAKERS as OBJ."""
    points, faces = MAKERS[name]()
    with open(file, "w", encoding="ascii") as obj:
        obj.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points)
        obj.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)
