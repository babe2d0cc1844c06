# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Plots over a set of models how many corners cannot be meshed before and after, and the time that it takes."""
import json
import subprocess

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

matplotlib.rcParams["svg.hashsalt"] = "frame fields"
BEFORE, AFTER = "#db5c0a", "#00809e"
BINS = [(0, 0), (1, 1), (2, 3), (4, 7), (8, 15), (16, 31), (32, 63), (64, 127), (128, 10**9)]
NUMBER_OF_RUNS = 3


def reports(computer):
    """The report of the fastest of some runs for every model that the program takes."""
    path = computer.folder / "report.json"
    for model in sorted(computer.meshes.iterdir()):
        runs = []
        for _ in range(NUMBER_OF_RUNS):
            run = subprocess.run([computer.program, str(model), "--quiet", "--report", str(path)], check=False,
                                 capture_output=True)
            if run.returncode:
                break
            runs.append(json.loads(path.read_text(encoding="utf-8")))
        if runs:
            yield min(runs, key=lambda report: report["seconds"]["total"])


def label(low, high):
    return str(low) if low == high else f"\u2265{low}" if high == 10**9 else f"{low}\u2013{high}"


def plot_models(computer, picture):
    found = list(reports(computer))
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2), constrained_layout=True)
    for shift, key, colour, words in ((-0.2, "unmeshable_before", BEFORE, "classical field"),
                                      (0.2, "unmeshable_after", AFTER, "this package")):
        counts = [report[key] for report in found]
        bars = [sum(low <= count <= high for count in counts) for low, high in BINS]
        left.bar([place + shift for place in range(len(BINS))], bars, 0.4, color=colour,
                 label=f"{words}: {sum(counts):,} in all")
    left.set_xticks(range(len(BINS)), [label(*b) for b in BINS], fontsize="small")
    left.set_xlabel("unmeshable corners of a model")
    left.set_ylabel("models")
    left.legend(frameon=False)

    times = [1000 * report["seconds"]["total"] / report["faces_after_split"] for report in found]
    sizes = [report["faces_after_split"] for report in found]
    right.loglog(sizes, times, "o", color=AFTER, markersize=3.5, alpha=0.7)
    right.set_xlabel("faces of the model")
    right.set_ylabel("seconds per 1000 faces")
    figure.savefig(picture, metadata={"Date": None})
    before, after = (sum(report[key] for report in found) for key in ("unmeshable_before", "unmeshable_after"))
    seconds = sum(report["seconds"]["total"] for report in found)
    print(f"{len(found)} models, {sum(sizes)} faces, {before} unmeshable before, {after} after, {seconds:.2f} seconds, "
          f"median {sorted(times)[len(times) // 2]:.5f} seconds per 1000 faces")
