#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how time and memory a face grow with the mesh (growth.csv) and draws it (growth.png)."""

import argparse
import csv
import dataclasses
import math
import pathlib

import measure

NOISE = 0.1
# Fast marching takes minutes beyond.
FAST_MARCHING_FACES = 2_000_000
COLUMNS = (
    *("mesh", "level", "faces", "exact_s", "approximate_s", "dijkstra_s", "fastmarching_s"),
    *("exact_bytes_per_face", "approximate_bytes_per_face"),
)
# Column, label, color.
TIMES = (
    ("fastmarching_s", "fast marching (ParaView)", "#999999"),
    ("dijkstra_s", "Dijkstra (VTK)", "#555555"),
    ("exact_s", "exact", "#0072b2"),
    ("approximate_s", "approximate, 0.1 %", "#d55e00"),
)
MEMORY = (
    ("exact_bytes_per_face", "exact", "#0072b2"),
    ("approximate_bytes_per_face", "approximate, 0.1 %", "#d55e00"),
)


def families(arguments):
    """Each mesh of --meshes and its subdivisions, by the names that measure.py gives the files."""
    for item in arguments.meshes.split(","):
        name, levels = item.split(":")
        mesh = measure.find_mesh(arguments.folder, name)
        for level in range(int(levels) + 1):
            faces = mesh.faces * 4**level
            if not arguments.largest or faces <= arguments.largest:
                yield dataclasses.replace(
                    mesh, levels=level, noise=NOISE if level else 0.0, faces=faces
                )


def measure_mesh(benchmark, mesh):
    """A line of the table."""
    exact = benchmark.run(mesh)
    approximate = benchmark.run(mesh, *measure.APPROXIMATE)
    peer = benchmark.run(mesh, against=["dijkstra"])
    marching = measure.Row()
    if exact["faces"] <= FAST_MARCHING_FACES:
        marching = benchmark.run(mesh, against=["fastmarching"])
    return {
        "mesh": mesh.name,
        "level": mesh.levels,
        "faces": f"{exact['faces']:.0f}",
        "exact_s": f"{exact['solve_s']:.4g}",
        "approximate_s": f"{approximate['solve_s']:.4g}",
        "dijkstra_s": f"{peer['dijkstra_s']:.4g}",
        "fastmarching_s": f"{marching['fastmarching_s']:.4g}",
        "exact_bytes_per_face": f"{exact['bytes_per_face']:.0f}",
        "approximate_bytes_per_face": f"{approximate['bytes_per_face']:.0f}",
    }


def write_table(arguments, file):
    """Measures all meshes, and writes each line as soon as it is there."""
    benchmark = measure.Benchmark(arguments)
    with open(file, "w", encoding="ascii", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for mesh in families(arguments):
            line = measure_mesh(benchmark, mesh)
            writer.writerow(line)
            stream.flush()
            print(*line.values(), flush=True)


def read_table(file):
    """The lines, with numbers for all columns but the first."""
    with open(file, encoding="ascii", newline="") as stream:
        return [
            {key: value if key == "mesh" else float(value) for key, value in line.items()}
            for line in csv.DictReader(stream)
        ]


def style(index):
    """What tells one mesh from another."""
    return {"marker": "os^Dv"[index % 5], "markersize": 5, "linestyle": ("-", "--")[index > 0]}


def plot(axes, lines, curves, scale):
    """A curve for every mesh and method; returns the meshes' names."""
    names = list(dict.fromkeys(line["mesh"] for line in lines))
    for column, _, color in curves:
        for i, name in enumerate(names):
            points = [
                (line["faces"], scale(line[column], line["faces"]))
                for line in lines
                if line["mesh"] == name and not math.isnan(line[column])
            ]
            if points:
                axes.plot(*zip(*points), color=color, linewidth=1.6, **style(i))
    axes.set_xscale("log")
    axes.set_xticks([1e4, 1e5, 1e6, 1e7], ["10,000", "100,000", "1 million", "10 million"])
    axes.set_xlabel("faces")
    axes.grid(True, which="major", color="#dddddd", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return names


def draw(file, picture):
    """Needs matplotlib (Debian: python3-matplotlib)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.lines import Line2D
    from matplotlib.ticker import LogLocator

    lines = read_table(file)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4))
    plot(left, lines, TIMES, lambda value, faces: 1e6 * value / faces)
    left.set_yscale("log")
    left.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    left.yaxis.set_major_formatter("{x:g}")
    left.minorticks_off()
    left.set_title("Microseconds a face", loc="left")
    names = plot(right, lines, MEMORY, lambda value, _: value)
    right.set_ylim(0, 1.15 * right.get_ylim()[1])
    right.minorticks_off()
    right.set_title("Bytes a face", loc="left")
    handles = [Line2D([], [], color=color, label=label) for _, label, color in TIMES]
    for i, name in enumerate(names):
        handles.append(Line2D([], [], color="black", label=name + " subdivided", **style(i)))
    figure.tight_layout(rect=(0, 0.08, 1, 1))
    figure.legend(handles=handles, frameon=False, loc="lower center", ncol=len(handles))
    figure.savefig(picture, dpi=110)


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", help="the meshes: fandisk.obj, igea.ply, ...")
    measure.add_common_options(parser)
    parser.add_argument(
        "--meshes",
        default="fandisk:5,igea:2",
        metavar="NAME:LEVELS,...",
        help="which and how often to subdivide them (fandisk:5,igea:2)",
    )
    parser.add_argument(
        "--output", default=measure.HERE, help="folder of growth.csv and growth.png (this one)"
    )
    parser.add_argument("--draw-only", action="store_true", help="draw what growth.csv holds")
    arguments = parser.parse_args()
    if not arguments.folder and not arguments.draw_only:
        parser.error("the folder of the meshes is missing")
    return arguments


def main():
    arguments = parse()
    output = pathlib.Path(arguments.output)
    if not arguments.draw_only:
        write_table(arguments, output / "growth.csv")
    draw(output / "growth.csv", output / "growth.png")


if __name__ == "__main__":
    main()
