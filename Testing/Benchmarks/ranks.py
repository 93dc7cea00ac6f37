#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures surfaces in pieces with geodesicRanksBenchmark: under mpirun the time and memory of a few
ranks (tables in Markdown), in one process what many ranks would tell each other (ranks.csv) and what
a cluster would take by that (ranks.png). README.md says what is in them."""

import argparse
import concurrent.futures
import csv
import json
import pathlib
import statistics
import subprocess
import sys

import measure

# The model of a cluster: what a step costs besides what is sent, and what a rank sends a second.
SECONDS_A_STEP = (20e-6, 100e-6)
BYTES_A_SECOND = 1e9
COLUMNS = (
    *("mesh", "source", "ranks", "faces", "largest_part", "largest_halo", "windows_propagated"),
    *("steps", "messages", "bytes", "busiest_bytes", "work_s", "busiest_s"),
)


class RanksBenchmark:
    """geodesicRanksBenchmark on the meshes of measure.py."""

    def __init__(self, arguments):
        self.program = arguments.ranks_benchmark
        self.meshes = measure.Benchmark(arguments)
        self.work = pathlib.Path(arguments.work)
        self.repeat = arguments.repeat
        self.mpirun = arguments.mpirun.split()

    def call(self, *command):
        command = [str(word) for word in command]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"{' '.join(command)}: {result.returncode}\n{result.stderr}")
        return [json.loads(line) for line in result.stdout.splitlines()]

    def counted(self, mesh, source, ranks):
        """All ranks in one process."""
        return self.call(
            *(self.program, "--mesh", self.meshes.path(mesh), "--source", source, "--pieces", ranks)
        )[0]

    def pieces(self, mesh, source, ranks):
        """Their files, made where they are not there."""
        prefix = self.work / f"{mesh.name}-{source.replace(':', '-').replace(',', '-')}-{ranks}"
        if not pathlib.Path(f"{prefix}_{ranks - 1}.piece").exists():
            self.call(
                *(self.program, "--mesh", self.meshes.path(mesh), "--source", source),
                *("--pieces", ranks, "--write", prefix),
            )
        return prefix

    def timed(self, mesh, source, ranks):
        """The ranks are processes of mpirun; the medians of the runs, a fresh mpirun each."""
        prefix = self.pieces(mesh, source, ranks)
        runs = [
            self.call(*self.mpirun, "-n", ranks, self.program, "--read", prefix)[0]
            for _ in range(self.repeat)
        ]
        return {key: statistics.median(run[key] for run in runs) for key in runs[0]}

    def side_by_side(self, mesh, source):
        """How many times as much two processes do at once that have nothing to do with each other:
        what the machine allows two ranks at best."""
        prefix = self.pieces(mesh, source, 1)
        command = [*self.mpirun, "-n", 1, self.program, "--read", prefix]
        ratios = []
        for _ in range(self.repeat):
            alone = self.call(*command)[0]["solve_s"]
            with concurrent.futures.ThreadPoolExecutor() as pool:
                both = list(pool.map(lambda _: self.call(*command)[0]["solve_s"], range(2)))
            ratios.append(2.0 * alone / max(both))
        return statistics.median(ratios)


def print_memory(benchmark, meshes, ranks):
    print("\n| mesh | faces | ranks | bytes a face, largest rank | of one rank's |\n|---|---|---|---|---|")
    for mesh in meshes:
        one = None
        for count in ranks:
            run = benchmark.timed(mesh, "vertex:0", count)
            one = one or run["bytes_per_face"]
            print(
                f"| {mesh.name} | {run['faces']:,} | {count} | {run['bytes_per_face']:.0f} "
                f"| {100 * run['bytes_per_face'] / one:.0f} % |",
                flush=True,
            )


def print_times(benchmark, meshes):
    print(
        "\n| mesh | source | one rank, s | two ranks, s | times as fast | two processes side by side "
        "| waiting, most and least | steps | MB sent |\n|---|---|---|---|---|---|---|---|---|"
    )
    for mesh in meshes:
        for source in (f"path:0,{mesh.far or mesh.faces // 4}", "vertex:0"):
            one = benchmark.timed(mesh, source, 1)
            two = benchmark.timed(mesh, source, 2)
            print(
                f"| {mesh.name} | {source} | {one['solve_s']:.2f} | {two['solve_s']:.2f} "
                f"| {one['solve_s'] / two['solve_s']:.2f} "
                f"| {benchmark.side_by_side(mesh, source):.2f} "
                f"| {100 * two['most_in_steps_s'] / two['solve_s']:.0f} and "
                f"{100 * two['least_in_steps_s'] / two['solve_s']:.0f} % "
                f"| {two['steps']:,.0f} | {two['bytes'] / 1e6:.1f} |",
                flush=True,
            )


def write_counts(benchmark, meshes, ranks, file):
    with open(file, "w", encoding="ascii", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        for mesh in meshes:
            for source in (f"path:0,{mesh.far or mesh.faces // 4}", "vertex:0"):
                for count in ranks:
                    line = {"mesh": mesh.name, "source": source.split(":")[0]}
                    line.update(benchmark.counted(mesh, source, count))
                    writer.writerow(line)
                    stream.flush()


def read_counts(file):
    with open(file, encoding="ascii", newline="") as stream:
        return [
            {key: value if key in ("mesh", "source") else float(value) for key, value in line.items()}
            for line in csv.DictReader(stream)
        ]


def seconds(line, step):
    """The model: in each step the busiest rank's work, the largest rank's bytes, and the step. One
    rank alone takes no steps."""
    if line["ranks"] == 1:
        return line["work_s"]
    return line["busiest_s"] + line["steps"] * step + line["busiest_bytes"] / BYTES_A_SECOND


def draw(file, picture):
    """Needs matplotlib (Debian: python3-matplotlib)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    lines = read_counts(file)
    figure, axes = pyplot.subplots(figsize=(8, 4.8))
    curves = list(dict.fromkeys((line["mesh"], line["source"]) for line in lines))
    for i, (mesh, source) in enumerate(curves):
        own = [line for line in lines if (line["mesh"], line["source"]) == (mesh, source)]
        work = own[0]["work_s"]
        for step, linestyle in zip(SECONDS_A_STEP, ("-", ":")):
            axes.plot(
                [line["ranks"] for line in own],
                [work / seconds(line, step) for line in own],
                color=("#0072b2", "#d55e00", "#009e73", "#999999")[i % 4],
                marker="o",
                markersize=4,
                linestyle=linestyle,
                label=f"{mesh}, {source}, {1e6 * step:.0f} us a step",
            )
    ranks = sorted({line["ranks"] for line in lines})
    axes.plot(ranks, ranks, color="#cccccc", linewidth=1, label="as many times as ranks")
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    axes.set_xticks(ranks, [f"{count:.0f}" for count in ranks])
    axes.yaxis.set_major_formatter("{x:.0f}")
    axes.set_xlabel("ranks")
    axes.set_title("Times as fast as one rank, by the model", loc="left")
    axes.grid(True, color="#dddddd", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", help="the meshes: fandisk.obj, igea.ply, ...")
    measure.add_common_options(parser)
    parser.add_argument("--ranks-benchmark", required=True, help="geodesicRanksBenchmark")
    parser.add_argument("--mpirun", default="mpirun --oversubscribe", help="how to start ranks")
    parser.add_argument("--memory", default="4.3M,13M", metavar="MESH,...", help="4.3M,13M")
    parser.add_argument("--times", default="4.3M", metavar="MESH,...", help="4.3M")
    parser.add_argument("--count", default="1.07M", metavar="MESH,...", help="1.07M")
    parser.add_argument("--ranks", default="1,2,8,64,512", metavar="N,...", help="of --count")
    parser.add_argument("--output", default=measure.HERE, help="folder of ranks.csv and ranks.png")
    parser.add_argument("--draw-only", action="store_true", help="draw what ranks.csv holds")
    arguments = parser.parse_args()
    if not arguments.folder and not arguments.draw_only:
        parser.error("the folder of the meshes is missing")
    return arguments


def chosen(arguments, names):
    return [measure.find_mesh(arguments.folder, name) for name in names.split(",") if name]


def main():
    arguments = parse()
    output = pathlib.Path(arguments.output)
    if not arguments.draw_only:
        benchmark = RanksBenchmark(arguments)
        print_memory(benchmark, chosen(arguments, arguments.memory), (1, 2, 4))
        print_times(benchmark, chosen(arguments, arguments.times))
        ranks = [int(count) for count in arguments.ranks.split(",")]
        write_counts(benchmark, chosen(arguments, arguments.count), ranks, output / "ranks.csv")
    draw(output / "ranks.csv", output / "ranks.png")


if __name__ == "__main__":
    main()
