#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Plots the results of compare_quad_meshers.py: irregular vertices, scaled Jacobians, features, seconds and failures.

    /usr/bin/python3 plot_quad_comparison.py comparison.json comparison.svg

Needs Debian's python3-matplotlib.
"""

import argparse
import json
import pathlib

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402


def is_measured(row):
    return not row["failure"] and "empty" not in row["measures"]["flaws"]


def number_of_faults(row):
    """Inverted and flipped faces, and corners lost or collapsed."""
    keys = ("scaled_jacobian_nonpositive", "flipped_faces", "corners_lost", "sharp_lost", "sharp_collapsed")
    return sum(row["measures"][key] for key in keys)


PANELS = (
    ("irregular vertices", lambda row: row["measures"]["irregular_interior"]
     + row["measures"]["irregular_feature_sectors"], "linear"),
    ("mean scaled Jacobian", lambda row: row["measures"].get("scaled_jacobian_mean", 0), "linear"),
    ("least scaled Jacobian", lambda row: row["measures"].get("scaled_jacobian_min", 0), "linear"),
    ("features kept, %", lambda row: 100 * (1 - row["measures"]["feature_lost"]), "linear"),
    ("inverted, flipped,\ncorners lost", number_of_faults, "symlog"),
    ("CPU seconds", lambda row: row["seconds"], "log"),
)


def plot(rows, path):
    """A panel for each measure, a group of bars for each model, a cross for what failed."""
    models = list(dict.fromkeys(row["model"] for row in rows))
    meshers = list(dict.fromkeys(row["mesher"] for row in rows))
    width = 0.8 / len(meshers)
    figure, axes = plt.subplots(len(PANELS), 1, sharex=True, constrained_layout=True,
                                figsize=(max(6, 0.35 * len(models) * max(2, len(meshers)) ** 0.5 + 2), 10))
    for axis, (label, value_of, scale) in zip(axes, PANELS):
        for number, mesher in enumerate(meshers):
            colour = plt.get_cmap("tab10")(number % 10)
            of_mesher = [row for row in rows if row["mesher"] == mesher]
            places = {row["model"]: models.index(row["model"]) + (number - (len(meshers) - 1) / 2) * width
                      for row in of_mesher}
            measured = [row for row in of_mesher if is_measured(row)]
            failed = [places[row["model"]] for row in of_mesher if not is_measured(row)]
            axis.bar([places[row["model"]] for row in measured], [value_of(row) for row in measured], 0.9 * width,
                     color=colour, label=mesher if axis is axes[0] else None)
            axis.plot(failed, [0.04] * len(failed), "x", color=colour, markersize=5,
                      transform=axis.get_xaxis_transform())
        axis.set_ylabel(label, fontsize="small")
        axis.set_yscale(scale)
        axis.grid(axis="y", linewidth=0.3)
        axis.set_axisbelow(True)
    axes[-1].set_xticks(range(len(models)), models, rotation=35, ha="right", fontsize="small")
    axes[0].legend(loc="lower left", bbox_to_anchor=(0, 1.02), ncols=min(len(meshers), 4), frameon=False,
                   fontsize="small", title="a cross: no mesh", title_fontsize="small", alignment="left")
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    options = parser.parse_args()
    plot(json.loads(options.results.read_text(encoding="utf-8")), options.picture)


if __name__ == "__main__":
    main()
