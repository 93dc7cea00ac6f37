#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures with geodesicBenchmark and prints tables in Markdown. README.md explains their columns."""

import argparse
import dataclasses
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

import thin_meshes

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE / "data"
APPROXIMATE = ("--relative-error", "0.001")
REFINED = ("--refine", "0.001")


@dataclasses.dataclass(frozen=True)
class Mesh:
    """A file of the folder of meshes, or one made from it by subdivision and noise; or without a
    file a mesh of thin_meshes."""

    name: str
    file: str
    levels: int = 0
    noise: float = 0.0
    # About; 0 where it is not known.
    faces: int = 0
    # A vertex far from vertex 0; 0 where none is known.
    far: int = 0


MESHES = {
    mesh.name: mesh
    for mesh in (
        Mesh("plane", str(DATA / "plane.vtp"), faces=422),
        Mesh("fandisk", "fandisk.obj", faces=12_946, far=3_000),
        Mesh("beetle-alt", "beetle-alt.obj", faces=38_656, far=9_000),
        Mesh("bunny", "stanford-bunny.obj", faces=69_451, far=17_000),
        Mesh("nefertiti", "nefertiti.obj", faces=99_938, far=25_000),
        Mesh("igea", "igea.ply", faces=268_686, far=67_000),
        Mesh("1.07M", "igea.ply", 1, 0.1, faces=1_074_744, far=270_000),
        Mesh("4.3M", "igea.ply", 2, 0.1, faces=4_298_976),
        Mesh("6.4M", "nefertiti.obj", 3, faces=6_396_032),
        Mesh("9.9M", "beetle-alt.obj", 4, faces=9_895_936),
        Mesh("13M", "fandisk.obj", 5, 0.1, faces=13_256_704),
        Mesh("cylinder", "", faces=12_000),
        Mesh("torus", "", faces=20_000),
        Mesh("rough", "", faces=44_402),
        Mesh("spikes", "", faces=4_802),
    )
}
# Curves in place of a vertex, as in the paper.
SOURCES = {
    "plane": f"curve:{DATA / 'plane-curve.vtp'}",
    "fandisk": f"curve:{DATA / 'fandisk-curve.vtp'}",
    "beetle-alt": "boundary",
    "6.4M": f"path:0,{MESHES['nefertiti'].far}",
    "9.9M": "boundary",
}
SMALL = ("fandisk", "beetle-alt", "bunny", "nefertiti", "igea", "1.07M")
# All windows of larger meshes are not kept at once.
ENVELOPE_FACES = 2_000_000
LARGE = ("igea", "1.07M", "4.3M", "6.4M", "9.9M", "13M")


class Row(dict):
    """Numbers by name; those that were not measured are NaN."""

    def __missing__(self, key):
        return math.nan


def summary(runs):
    """The medians of the runs' numbers. Memory is the largest, which only a process's first run,
    before any memory is kept for later, shows in full."""
    row = Row()
    for key, value in runs[0].items():
        if isinstance(value, (int, float)):
            row[key] = statistics.median(run[key] for run in runs)
    row["bytes_per_face"] = max(
        (run["peak_rss_bytes"] - run["loaded_rss_bytes"]) / run["faces"] for run in runs
    )
    return row


class Benchmark:
    """geodesicBenchmark, a fresh process for every call of run()."""

    def __init__(self, arguments):
        self.program = arguments.benchmark
        self.folder = pathlib.Path(arguments.folder)
        self.work = pathlib.Path(arguments.work)
        self.repeat = arguments.repeat
        self.log = arguments.log
        usage = subprocess.run([self.program, "--help"], capture_output=True, text=True, check=True)
        self.peers = usage.stdout.split()[-1].split(",")

    def call(self, *arguments, processes=1):
        """What so many processes print that run side by side; None where one of them fails."""
        command = [str(self.program), *map(str, arguments)]
        pipe = subprocess.PIPE
        started = [
            subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) for _ in range(processes)
        ]
        output = ""
        for process in started:
            lines, errors_of_it = process.communicate()
            if process.returncode != 0:
                print(f"{' '.join(command)}: {process.returncode}\n{errors_of_it}", file=sys.stderr)
                output = None
            output = None if output is None else output + lines
        return output

    def path(self, mesh):
        """The mesh's file, made where it is not there."""
        source = self.folder / mesh.file
        if mesh.file and mesh.levels == 0:
            return source
        noise = f"-noise{mesh.noise:g}" if mesh.noise else ""
        name = f"{source.stem}-{mesh.levels}{noise}.ply" if mesh.file else f"{mesh.name}.obj"
        file = self.work / name
        if not file.exists():
            self.work.mkdir(parents=True, exist_ok=True)
            partial = file.with_name("partial-" + name)
            if not mesh.file:
                thin_meshes.write(mesh.name, partial)
            elif self.subdivide(mesh, source, partial) is None:
                sys.exit(f"{file} cannot be made")
            partial.rename(file)
        return file

    def subdivide(self, mesh, source, file):
        return self.call(
            *("--mesh", source, "--subdivide", mesh.levels, "--noise", mesh.noise),
            *("--write", file, "--repeat", 0),
        )

    def run(self, mesh, *arguments, against=(), repeat=None, threads=1, processes=1):
        """What one process measures, or several side by side; an empty row where one fails."""
        against = [peer for peer in against if peer in self.peers]
        arguments = [
            *("--mesh", self.path(mesh), "--threads", threads),
            *("--repeat", repeat or self.repeat, *arguments),
            *(("--against", ",".join(against)) if against else ()),
        ]
        printed = self.call(*arguments, processes=processes) or ""
        runs = [json.loads(line) for line in printed.splitlines()]
        if self.log:
            with open(self.log, "a", encoding="ascii") as log:
                log.writelines(json.dumps(run) + "\n" for run in runs)
        return summary(runs) if runs else Row()


def number(value, digits=2):
    return "-" if math.isnan(value) else f"{value:.{digits}f}"


def seconds(value):
    return "-" if math.isnan(value) else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def error(value):
    return "-" if math.isnan(value) else f"{value:.3g}"


def count(value):
    return "-" if math.isnan(value) else f"{value:,.0f}"


def print_table(title, columns, rows):
    """Prints each row as soon as it is there."""
    print(f"\n### {title}\n\n| {' | '.join(columns)} |\n|{'---|' * len(columns)}", flush=True)
    for row in rows:
        print(f"| {' | '.join(row)} |", flush=True)


def small(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            exact = benchmark.run(mesh, against=["dijkstra"])
            far = mesh.far or int(exact["faces"]) // 4
            path = benchmark.run(mesh, "--source", f"path:0,{far}", against=["dijkstra"])
            approximate = benchmark.run(mesh, *APPROXIMATE, against=["dijkstra"])
            update = benchmark.run(mesh, "--update", against=["dijkstra"])
            refined = benchmark.run(mesh, *REFINED, against=["dijkstra"])
            marching = benchmark.run(mesh, against=["dijkstra", "fastmarching"])
            yield (
                mesh.name,
                count(exact["faces"]),
                seconds(exact["dijkstra_s"]),
                number(exact["solve_s"] / exact["dijkstra_s"]),
                number(path["solve_s"] / path["dijkstra_s"]),
                number(approximate["solve_s"] / approximate["dijkstra_s"]),
                number(exact["build_s"] / exact["dijkstra_s"]),
                number(update["update_s"] / update["dijkstra_s"]),
                number((refined["solve_s"] + refined["refine_s"]) / refined["dijkstra_s"]),
                number(marching["fastmarching_s"] / marching["dijkstra_s"]),
                number(exact["bytes_per_face"], 0),
                number(approximate["bytes_per_face"], 0),
                number(refined["bytes_per_face"], 0),
            )

    columns = ("mesh", "faces", "D, s", "exact / D", "path / D", "approximate / D", "build / D")
    columns += ("Update / D", "refined / D", "fast marching / D", "exact, bytes a face")
    columns += ("approximate, bytes a face", "refined, bytes a face")
    print_table("Time over Dijkstra's", columns, rows())


def errors(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            exact = benchmark.run(mesh)
            other = benchmark.run(
                mesh, *APPROXIMATE, "--error", against=["dijkstra", "fastmarching"]
            )
            yield (
                *(mesh.name, count(exact["faces"]), seconds(exact["solve_s"])),
                *(seconds(other["solve_s"]), error(other["max_relative_error"])),
                *(seconds(other["dijkstra_s"]), error(other["dijkstra_max_relative_error"])),
                seconds(other["fastmarching_s"]),
                error(other["fastmarching_max_relative_error"]),
            )

    columns = ("mesh", "faces", "exact, s", "approximate, s", "error", "Dijkstra, s", "error")
    print_table("Error beside time", (*columns, "fast marching, s", "error"), rows())


def large(benchmark, meshes, arguments):
    reference = next((mesh for mesh in meshes if mesh.name == "igea"), meshes[0])
    meshes = [reference] + [mesh for mesh in meshes if mesh is not reference]
    modes = {"exact": (), "approximate": APPROXIMATE}

    def rows():
        first = {}
        for mesh in meshes:
            cells = []
            for mode, options in modes.items():
                run = benchmark.run(mesh, *options)
                micro = 1e6 * run["solve_s"] / run["faces"]
                first.setdefault(mode, micro)
                cells += [seconds(run["solve_s"]), number(micro), number(micro / first[mode])]
                cells += [number(run["bytes_per_face"], 0)]
                if arguments.envelope:
                    windows = benchmark.run(mesh, *options, "--envelope", repeat=1)
                    cells += [number(windows["windows_per_edge"])]
            yield (mesh.name, count(run["faces"]), *cells)

    columns = ["mesh", "faces"]
    for mode in modes:
        columns += [f"{mode}, s", "us a face", f"over {reference.name}'s", "bytes a face"]
        columns += ["windows an edge"] if arguments.envelope else []
    print_table("Large meshes", columns, rows())


def work_of_mesh(run):
    """What a refined field takes beside the solve."""
    return run["refine_s"] + run["without_reach_s"]


# What threads are measured with: options, and the seconds of a run.
THREADED = {
    "exact": ((), lambda run: run["solve_s"]),
    "approximate": (APPROXIMATE, lambda run: run["solve_s"]),
    "exact, refined: solve": (REFINED, lambda run: run["solve_s"]),
    "refinement, build, output": ((*REFINED, "--update"), work_of_mesh),
}


def rounds(benchmark, mesh, options, variants):
    """A row a round of each variant, which is how many threads and processes. They take turns, as
    the speed of a machine changes with time."""
    rows = {variant: [] for variant in variants}
    for _ in range(benchmark.repeat):
        for n, processes in variants:
            how = {"threads": n, "processes": processes, "repeat": 2}
            rows[n, processes].append(benchmark.run(mesh, *options, against=["dijkstra"], **how))
    return rows


def gain(first, other, seconds_of, processes=1):
    """How many times as fast the others are, from pairs of one round."""
    ratios = [seconds_of(a) / seconds_of(b) for a, b in zip(first, other)]
    return number(processes * statistics.median(ratios))


def threads(benchmark, meshes, arguments):
    numbers = [int(text) for text in arguments.threads.split(",")]
    alone = [(n, 1) for n in numbers]
    beside = [(1, n) for n in numbers[1:]]

    def rows():
        for mesh in meshes:
            for what, (options, seconds_of) in THREADED.items():
                measured = rounds(benchmark, mesh, options, alone + beside)
                first = measured[alone[0]]
                cells = []
                for variant in alone:
                    own = measured[variant]
                    over = [seconds_of(run) / run["dijkstra_s"] for run in own]
                    cells += [seconds(statistics.median(map(seconds_of, own)))]
                    cells += [number(statistics.median(over)), gain(first, own, seconds_of)]
                    cells += [number(max(run["bytes_per_face"] for run in own), 0)]
                for variant in beside:
                    cells += [gain(first, measured[variant], seconds_of, variant[1])]
                yield (mesh.name, what, *cells)

    columns = ["mesh", "what"]
    for n in numbers:
        columns += [f"threads: {n}, s", "/ D", "times as fast", "bytes a face"]
    columns += [f"{n} processes side by side" for n in numbers[1:]]
    print_table("Threads", columns, rows())


MODEL = (2, 4, 8, 16)


def model(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            for source in ("vertex:0", *([f"path:0,{mesh.far}"] if mesh.far else [])):
                for mode, options in {"exact": (), "approximate": APPROXIMATE}.items():
                    numbers = ",".join(map(str, MODEL))
                    run = benchmark.run(mesh, *options, "--source", source, "--model", numbers)
                    gains = (number(run[f"model_{n}"], 1) for n in MODEL)
                    yield (
                        *(mesh.name, source.split(":")[0], mode),
                        *(number(100 * run["serial_share"], 1) + " %", *gains),
                    )

    columns = ("mesh", "source", "mode", "outside of tasks", *map(str, MODEL))
    print_table("Threads: what more would give", columns, rows())


def approximation(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            sources = ["vertex:0"] + ([SOURCES[mesh.name]] if mesh.name in SOURCES else [])
            for source in sources:
                for epsilon in (0, 1e-4, 1e-3, 1e-2, 1e-1):
                    options = ("--source", source, "--relative-error", epsilon)
                    time = benchmark.run(mesh, *options, against=["dijkstra"])
                    truth = benchmark.run(mesh, *options, "--error", "--envelope", repeat=1)
                    yield (
                        *(mesh.name, source.split("/")[-1]),
                        *(f"{epsilon:g}", seconds(time["solve_s"])),
                        number(time["solve_s"] / time["dijkstra_s"]),
                        error(truth["relative_error_bound"]),
                        error(truth["max_relative_error"]),
                        number(truth["windows_per_edge"]),
                    )

    columns = ("mesh", "source", "requested", "time, s", "/ D", "reported", "measured")
    print_table("Approximation", (*columns, "windows an edge"), rows())


def paper(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            source = ("--source", SOURCES.get(mesh.name, "vertex:0"))
            cells = []
            for options in ((), APPROXIMATE):
                run = benchmark.run(mesh, *source, *options)
                windows = Row()
                if run["faces"] < ENVELOPE_FACES:
                    windows = benchmark.run(mesh, *source, *options, "--envelope", repeat=1)
                cells += [seconds(run["solve_s"]), number(windows["windows_per_edge"])]
                cells += [number(run["windows_propagated"] / run["edges"])]
            truth = benchmark.run(mesh, *source, *APPROXIMATE, "--error", repeat=1)
            yield (mesh.name, count(run["faces"]), *cells, error(truth["max_relative_error"]))

    columns = ["mesh", "faces"]
    for mode in ("exact", "0.1 %"):
        columns += [f"{mode}, s", "windows an edge", "made"]
    print_table("Table 1 of the paper", (*columns, "largest error"), rows())


def windows(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            final = benchmark.run(mesh, "--envelope", repeat=1)
            runs = [
                benchmark.run(mesh, "--relative-error", epsilon, against=["dijkstra"])
                for epsilon in (0, 1e-3, 1e-2)
            ]
            refined = benchmark.run(mesh, *REFINED)
            made = [run["windows_propagated"] / run["edges"] for run in runs]
            over = [run["solve_s"] / run["dijkstra_s"] for run in runs]
            yield (
                *(mesh.name, count(final["faces"]), number(final["windows_per_edge"])),
                *(number(made[0]), number(final["windows_propagated_per_envelope"])),
                *(number(over[0]), number(made[1]), number(over[1])),
                *(number(made[2]), number(over[2]), count(refined["output_cells"])),
                number(refined["refine_s"] / refined["solve_s"]),
            )

    columns = ["mesh", "faces", "windows an edge", "exact: made", "made / windows", "/ D"]
    columns += ["0.1 %: made", "/ D", "1 %: made", "/ D"]
    columns += ["faces refined", "refinement / solve"]
    print_table("Windows made", columns, rows())


def cgal(benchmark, meshes, _):
    def rows():
        for mesh in meshes:
            run = benchmark.run(mesh, "--error", against=["dijkstra", "cgal"])
            yield (
                *(mesh.name, count(run["faces"]), seconds(run["solve_s"])),
                *(seconds(run["cgal_s"]), number(run["cgal_s"] / run["solve_s"], 1)),
                error(run["cgal_max_relative_error"]),
            )

    if "cgal" not in benchmark.peers:
        print("\nCGAL is not built in: no table of it.", flush=True)
        return
    columns = ("mesh", "faces", "exact, s", "CGAL, s", "CGAL / exact", "largest difference")
    print_table("CGAL's exact solver", columns, rows())


# The function of each table and the meshes in it.
TABLES = {
    "small": (small, SMALL),
    "errors": (errors, SMALL),
    "large": (large, LARGE),
    "threads": (threads, ("igea", "1.07M", "4.3M")),
    "model": (model, ("igea", "1.07M")),
    "approximation": (approximation, SMALL[:-1]),
    "paper": (paper, ("plane", "fandisk", "beetle-alt", "6.4M", "9.9M")),
    "windows": (windows, (*SMALL[:-1], "cylinder", "torus", "rough", "spikes")),
    "cgal": (cgal, ("bunny",)),
}


def find_mesh(folder, name):
    """A mesh by the name that it has here, else a file of the folder."""
    if name in MESHES:
        return MESHES[name]
    for file in sorted(pathlib.Path(folder).glob(name + ".*")):
        return Mesh(name, file.name)
    sys.exit(f"{folder} has no mesh {name}; known besides its files: {', '.join(MESHES)}")


def machine():
    """What it runs on."""

    def field(file, key):
        with open(file, encoding="utf-8") as lines:
            found = [line.split(":")[1].strip() for line in lines if line.startswith(key)]
        return found[0] if found else "unknown"

    memory = int(field("/proc/meminfo", "MemTotal").split()[0]) / 2**20
    load = os.getloadavg()[0]
    return (
        f"{field('/proc/cpuinfo', 'model name')}, {os.cpu_count()} cores, {memory:.0f} GiB; "
        f"load at the start {load:.2f}"
    )


def add_common_options(parser):
    parser.add_argument(
        "--benchmark",
        default=HERE.parents[1] / "build" / "bin" / "geodesicBenchmark",
        help="the program (build/bin/geodesicBenchmark)",
    )
    parser.add_argument(
        "--work",
        default=HERE.parents[1] / "build" / "benchmark-meshes",
        help="folder of the meshes that are made from them (build/benchmark-meshes)",
    )
    parser.add_argument("--repeat", type=int, default=5, help="runs of which the median counts (5)")
    parser.add_argument(
        "--largest", type=int, metavar="FACES", help="leave out meshes with more faces"
    )
    parser.add_argument("--log", help="append the benchmark's JSON lines to this file")


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="the meshes: fandisk.obj, igea.ply, ...")
    add_common_options(parser)
    parser.add_argument("--table", choices=TABLES, help="this one only")
    parser.add_argument(
        "--only", metavar="NAME,NAME...", help="these meshes in place of each table's own"
    )
    parser.add_argument("--threads", default="1,2", help="numbers of threads to compare (1,2)")
    parser.add_argument(
        "--envelope", action="store_true", help="windows an edge of large meshes, too (memory!)"
    )
    return parser.parse_args()


def main():
    arguments = parse()
    benchmark = Benchmark(arguments)
    print(f"{machine()}; medians of {arguments.repeat} runs", flush=True)
    for name, (table, own) in TABLES.items():
        names = arguments.only.split(",") if arguments.only else own
        meshes = [find_mesh(arguments.folder, name) for name in names]
        meshes = [m for m in meshes if not arguments.largest or m.faces <= arguments.largest]
        if meshes and arguments.table in (None, name):
            table(benchmark, meshes, arguments)


if __name__ == "__main__":
    main()
