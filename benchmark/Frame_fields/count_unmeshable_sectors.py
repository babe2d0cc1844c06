#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
# Copyright (c) 2026 The Frame_fields authors
"""Runs cad_frame_field on all OFF files of a folder with features at several angles, without and with the repair of the
matching, and adds up what is unmeshable, what misses its natural index, and what is singular."""

import argparse
import json
import pathlib
import subprocess
import tempfile


def report_of(program, model, angle, *options):
    """The JSON report of one run, or None if the program refuses the model."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        command = [program, model, "--feature-angle", str(angle), "--no-baseline", "--quiet", "--report", path,
                   *options]
        if subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode:
            return None
        return json.loads(path.read_text(encoding="utf-8"))


def figures_of(report):
    interior = report["index_histogram"]["interior"]
    return {
        "sharp corners": report["sharp_corners"],
        "unmeshable sectors": report["unmeshable_after"],
        "sharp corners without their natural index": report["unnatural_corners"],
        "interior singularities": sum(number for index, number in interior.items() if index != "0"),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--feature-angles", nargs="+", type=float, default=[20, 30, 40, 60], metavar="DEGREES")
    arguments = parser.parse_args()

    runs, refused, without_repair, with_repair = 0, set(), {}, {}
    for model in sorted(arguments.folder.glob("*.off")):
        for angle in arguments.feature_angles:
            reports = [report_of(arguments.program, model, angle, *options) for options in (["--no-repair"], [])]
            if None in reports:
                refused.add(model.name)
                continue
            runs += 1
            for totals, report in zip((without_repair, with_repair), reports):
                for name, number in figures_of(report).items():
                    totals[name] = totals.get(name, 0) + number

    print(f"{runs} runs; refused: {', '.join(sorted(refused)) or 'none'}")
    print("| | without repair | with repair |\n|---|---|---|")
    for name, number in without_repair.items():
        print(f"| {name} | {number} | {with_repair[name]} |")


if __name__ == "__main__":
    main()
