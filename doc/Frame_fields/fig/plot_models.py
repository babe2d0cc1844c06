# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Histograms over a set of models: corners that cannot be meshed before and after, and the time that it takes."""
import json
import math
import subprocess

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

matplotlib.rcParams["svg.hashsalt"] = "frame fields"
BEFORE, AFTER = "#db5c0a", "#00809e"
BINS = [(0, 0), (1, 1), (2, 3), (4, 7), (8, 15), (16, 31), (32, 63), (64, 127), (128, 10**9)]
SIZES = [("less than 100 faces", 0, "#b9dbe3"), ("100 to 1,000", 100, "#6db3c4"), ("1,000 to 10,000", 1000, AFTER),
         ("more", 10000, "#003a48")]
BARS_PER_DECADE = 6
NUMBER_OF_RUNS = 3


def fastest_report(computer, model, *options):
    """The report of the fastest of some runs, or nothing if the program does not take the model."""
    path, found = computer.folder / "report.json", []
    for _ in range(NUMBER_OF_RUNS):
        run = subprocess.run([computer.program, str(model), "--quiet", "--report", str(path), *options], check=False,
                             capture_output=True)
        if run.returncode:
            return None
        found.append(json.loads(path.read_text(encoding="utf-8")))
    return min(found, key=lambda report: report["seconds"]["total"])


def label(low, high):
    return str(low) if low == high else f"\u2265 {low}" if high == 10**9 else f"{low}\u2013{high}"


def plot_corners(axes, reports):
    for shift, key, colour, words in ((-0.2, "unmeshable_before", BEFORE, "classical field"),
                                      (0.2, "unmeshable_after", AFTER, "this package")):
        counts = [report[key] for report in reports]
        bars = [sum(low <= count <= high for count in counts) for low, high in BINS]
        places = axes.bar([place + shift for place in range(len(BINS))], bars, 0.4, color=colour,
                          label=f"{words}: {sum(counts):,} in all")
        axes.bar_label(places, [str(bar) if bar else "" for bar in bars], fontsize="x-small")
    axes.margins(y=0.1)
    axes.set_xticks(range(len(BINS)), [label(*b) for b in BINS], fontsize="small")
    axes.set_xlabel("unmeshable corners of a model")
    axes.set_ylabel("models")
    axes.legend(frameon=False)


def plot_times(axes, reports):
    times = [1000 * report["seconds"]["total"] / report["faces_after_split"] for report in reports]
    first, last = (f(BARS_PER_DECADE * math.log10(g(times))) for f, g in ((math.floor, min), (math.ceil, max)))
    edges = [10 ** (k / BARS_PER_DECADE) for k in range(first, last + 1)]
    ends = [low for _, low, _ in SIZES[1:]] + [math.inf]
    groups = [[time for time, report in zip(times, reports) if low <= report["faces_after_split"] < end]
              for (_, low, _), end in zip(SIZES, ends)]
    axes.hist(groups, edges, stacked=True, color=[colour for _, _, colour in SIZES],
              label=[words for words, _, _ in SIZES], edgecolor="white", linewidth=0.5)
    axes.set_xscale("log")
    axes.set_xlabel("seconds per 1000 faces")
    axes.set_ylabel("models")
    axes.legend(frameon=False, fontsize="small")
    return sorted(times)[len(times) // 2]


def plot_models(computer, picture):
    found = [fastest_report(computer, model) for model in sorted(computer.meshes.iterdir())]
    reports = [report for report in found if report]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2), width_ratios=(3, 2), constrained_layout=True)
    plot_corners(left, reports)
    median = plot_times(right, reports)
    figure.savefig(picture, metadata={"Date": None})
    before, after = (sum(report[key] for report in reports) for key in ("unmeshable_before", "unmeshable_after"))
    faces, seconds = sum(r["faces_after_split"] for r in reports), sum(r["seconds"]["total"] for r in reports)
    print(f"{len(reports)} models, {faces} faces, {before} unmeshable before, {after} after, {seconds:.2f} seconds, "
          f"median {median:.5f} seconds per 1000 faces")
