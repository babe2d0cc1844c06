#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
# Copyright (c) 2026 The Frame_fields authors
"""Turns what bench_frame_fields wrote with --benchmark_out=FILE.json into FILE.svg, a plot of time over size for each
shape and solver, and FILE.html, the tables of the manual and one that compares with the targets. Of several repetitions
the median counts. Needs Debian's python3-matplotlib."""

import argparse
import collections
import json
import pathlib
import statistics

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

PATCHES = {"quilt": "72 patches", "fan": "5 patches", "star": "1 patch", "flange": "a CAD part"}
WHOLE, PLAIN = "whole_pipeline", "plain_orthogonal_field"

Run = collections.namedtuple("Run", "function shape size solver threads")


class Figures:
    """The medians of all benchmarks that were run."""

    def __init__(self, benchmarks):
        values = collections.defaultdict(lambda: collections.defaultdict(list))
        self.errors = {}
        for entry in benchmarks:
            run = Run(*entry["run_name"].split("/")[:4], int(entry["run_name"].split("threads:")[1].split("/")[0]))
            if entry.get("error_occurred"):
                self.errors[run] = entry["error_message"]
            elif entry["run_type"] == "iteration":
                for key in ("real_time", "cpu_time", "faces", "share_outside_solvers"):
                    values[run][key].append(entry[key])
        self.medians = {run: {key: statistics.median(list_) for key, list_ in keys.items()}
                        for run, keys in values.items()}

    def value(self, key, function, shape, size, solver, threads=1):
        return self.medians.get(Run(function, shape, size, solver, threads), {}).get(key)

    def seconds(self, *run):
        return scaled(self.value("cpu_time", *run), 1e-3)

    def wall_seconds(self, *run):
        return scaled(self.value("real_time", *run), 1e-3)

    def names(self, field):
        return list(dict.fromkeys(getattr(run, field) for run in self.medians))

    def sizes(self, shape):
        return list(dict.fromkeys(run.size for run in self.medians if run.shape == shape))


def scaled(value, factor):
    return None if value is None else factor * value


def quotient(a, b):
    return None if a is None or not b else a / b


def text(value, digits=2):
    return "" if value is None else f"{value:.{digits}g}" if abs(value) < 10 else f"{value:.0f}"


def label(solver):
    return solver.replace("_", " with ")


def html_table(header, rows):
    lines = ["<table>", "<tr>" + "".join(f"<th>{cell}</th>" for cell in header) + "</tr>"]
    lines += ["<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows]
    return "\n".join(lines + ["</table>"])


def time_table(figures):
    """Seconds of the whole for each solver, and what else is said of the default one."""
    solvers = figures.names("solver")
    rows = []
    for shape in figures.names("shape"):
        for size in figures.sizes(shape):
            def whole(solver, shape=shape, size=size):
                return figures.seconds(WHOLE, shape, size, solver)
            if not any(whole(solver) for solver in solvers):
                continue
            faces = next(filter(None, (figures.value("faces", WHOLE, shape, size, solver) for solver in solvers)))
            plain = figures.seconds(PLAIN, shape, size, "Eigen")
            two_threads = quotient(figures.wall_seconds(WHOLE, shape, size, "Eigen", 1),
                                   figures.wall_seconds(WHOLE, shape, size, "Eigen", 2))
            rows.append([f"{shape}, {PATCHES[shape]}", f"{faces:,.0f}", *(text(whole(solver)) for solver in solvers),
                         text(quotient(whole("Eigen"), plain)),
                         text(scaled(figures.value("share_outside_solvers", WHOLE, shape, size, "Eigen"), 100)),
                         text(two_threads)])
    header = ["shape", "faces", *map(label, solvers), "ratio to the plain field", "% outside the solvers",
              "speedup by two threads"]
    return html_table(header, rows)


def stage_table(figures):
    """Milliseconds of the stages with the default solver."""
    functions = [name for name in figures.names("function") if name not in (WHOLE, PLAIN)]
    rows = []
    for shape in figures.names("shape"):
        for size in figures.sizes(shape):
            milliseconds = [figures.value("cpu_time", name, shape, size, "Eigen") for name in functions]
            if any(milliseconds):
                rows.append([shape, size, *(text(value) for value in milliseconds)])
    return html_table(["shape", "faces", *functions], rows)


def targets(figures):
    """Each target as a name, the value reached and the bound; the last field says whether less is better."""
    def seconds_per_face(shape, size, solver):
        return quotient(figures.seconds(WHOLE, shape, size, solver), figures.value("faces", WHOLE, shape, size, solver))

    def growth(shape, solver):
        return quotient(seconds_per_face(shape, "2M", solver), seconds_per_face(shape, "33K", solver))

    for shape, bound, stretch in (("quilt", 0.36, 0.28), ("fan", 0.50, 0.32)):
        seconds = figures.seconds(WHOLE, shape, "33K", "Eigen")
        yield f"{shape} of 33K faces, seconds", seconds, bound, True
        yield f"{shape} of 33K faces, seconds, stretch", seconds, stretch, True
        yield (f"{shape} of 33K faces, times the plain field",
               quotient(seconds, figures.seconds(PLAIN, shape, "33K", "Eigen")), 3, True)
    for shape, size, solver in (("quilt", "33K", "Eigen"), ("fan", "33K", "Eigen"), ("quilt", "2M", "Eigen"),
                                ("star", "2M", "Automatic_Cholmod"), ("star", "2M", "Automatic_Amgcl")):
        yield (f"{shape} of {size} faces, {label(solver)}, % outside the solvers",
               scaled(figures.value("share_outside_solvers", WHOLE, shape, size, solver), 100), 25, True)
    yield "quilt of 2M faces, seconds", figures.seconds(WHOLE, "quilt", "2M", "Eigen"), 30, True
    yield "quilt, growth of the time per face from 33K to 2M", growth("quilt", "Eigen"), 1.5, True
    for solver in ("Automatic_Cholmod", "Automatic_Amgcl"):
        yield f"star of 2M faces, {label(solver)}, seconds", figures.seconds(WHOLE, "star", "2M", solver), 90, True
        yield f"star, {label(solver)}, growth of the time per face from 33K to 2M", growth("star", solver), 2.5, True
    for size in figures.sizes("quilt"):
        yield (f"quilt of {size} faces, speedup by two threads",
               quotient(figures.wall_seconds(WHOLE, "quilt", size, "Eigen", 1),
                        figures.wall_seconds(WHOLE, "quilt", size, "Eigen", 2)), 1.7, False)


def target_table(figures):
    rows = []
    for name, value, bound, is_upper in targets(figures):
        if value is not None:
            is_met = value <= bound if is_upper else value >= bound
            rows.append([name, text(value, 3), f"{'at most' if is_upper else 'at least'} {bound}",
                         "met" if is_met else "not met"])
    return html_table(["target", "reached", "bound", ""], rows)


def plot(figures, path):
    shapes = [shape for shape in PATCHES if shape in figures.names("shape") and shape != "flange"]
    figure, axes = plt.subplots(1, len(shapes), figsize=(3.4 * len(shapes), 3.4), sharey=True, squeeze=False,
                                constrained_layout=True)
    for axis, shape in zip(axes[0], shapes):
        for function, solver, style in ((PLAIN, "Eigen", "k:"), *((WHOLE, s, "o-") for s in figures.names("solver"))):
            points = [(figures.value("faces", function, shape, size, solver),
                       figures.seconds(function, shape, size, solver)) for size in figures.sizes(shape)]
            points = [point for point in points if None not in point]
            name = "plain field, Eigen" if function == PLAIN else label(solver)
            axis.loglog(*zip(*points), style, markersize=3, label=name) if points else None
        axis.set_title(f"{shape}, {PATCHES[shape]}")
        axis.set_xlabel("faces")
        axis.grid(True, linewidth=0.3)
    axes[0][0].set_ylabel("seconds")
    axes[0][0].legend(frameon=False, fontsize="small")
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("json", nargs="+", type=pathlib.Path, help="the results; the tables take the name of the first")
    arguments = parser.parse_args()

    benchmarks = []
    for path in arguments.json:
        benchmarks += json.loads(path.read_text(encoding="utf-8"))["benchmarks"]
    figures = Figures(benchmarks)
    tables = [time_table(figures), stage_table(figures), target_table(figures)]
    arguments.json[0].with_suffix(".html").write_text("\n\n".join(tables) + "\n", encoding="utf-8")
    plot(figures, arguments.json[0].with_suffix(".svg"))
    print(tables[-1])
    for run, message in figures.errors.items():
        print("failed:", "/".join(map(str, run)), message)


if __name__ == "__main__":
    main()
