#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
# Copyright (c) 2026 The Frame_fields authors
"""Plots the mean rotation and the curl of fields of several models before and after relaxation, with uniform and with
geometric edge weights, as cad_frame_field --verbose reports them. Needs Debian's python3-matplotlib."""

import argparse
import json
import math
import pathlib
import subprocess
import tempfile

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

VARIANTS = {
    "orthogonal": ["--no-relaxation"],
    "relaxed": [],
    "relaxed, geometric weights": ["--edge-weights", "geometric"],
}


def quality_of(program, model, options):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        subprocess.run([program, model, "--verbose", "--no-baseline", "--report", path, *options], check=True,
                       stdout=subprocess.DEVNULL)
        return json.loads(path.read_text(encoding="utf-8"))["quality"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("picture")
    parser.add_argument("models", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()

    qualities = {variant: [quality_of(arguments.program, model, options) for model in arguments.models]
                 for variant, options in VARIANTS.items()}
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), constrained_layout=True)
    for axis, key, label, factor in ((axes[0], "mean_rotation", "mean rotation, degrees", math.degrees(1)),
                                     (axes[1], "curl", "curl", 1)):
        for k, (variant, values) in enumerate(qualities.items()):
            places = [place + 0.27 * (k - 1) for place in range(len(values))]
            axis.bar(places, [factor * value[key] for value in values], 0.25, label=variant)
        axis.set_xticks(range(len(arguments.models)), [model.stem for model in arguments.models], rotation=35,
                        ha="right")
        axis.set_ylabel(label)
    axes[1].legend(frameon=False, fontsize="small", loc="upper left")
    figure.savefig(arguments.picture, metadata={"Date": None})


if __name__ == "__main__":
    main()
