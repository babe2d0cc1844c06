#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs quad meshers on all models of a folder, measures what they make, and writes a table and a plot.

    /usr/bin/python3 compare_quad_meshers.py MESHERS.json MODELS OUT [--size FACTOR] [--timeout S]

MESHERS.json is a list of objects. The first one of this list is this package, run from the root of its sources:

    [{"name": "Frame_fields",
      "command": "build/release/bin/cad_quad_mesh {model} --features {features} --edge-length {edge_length} --threads 1
                  --quiet -o {output}"},
     {"name": "another one", "version": "1.0", "command": "mesher {model} -n {quads} -o {output}"}]

(A command is one line.) A program whose name has a / is searched from the folder in which this script is called; each
one runs in a folder of its own. {model} is an OFF or OBJ file of MODELS. {features} has two of its vertex numbers a
line: MODEL.feat beside the model, or else the edges of 40 degrees or more (--feature-angle). {edge_length} is FACTOR
times the mean edge length of the model, {quads} the number of quads of that size. {output} is the OBJ file to write, or
an OFF file with "format": "off". A mesher of several steps is a shell script. Only the output counts: measure_quads.py
measures all of them alike.

OUT gets comparison.md, comparison.json, the meshes and, with Debian's python3-matplotlib, comparison.svg. Needs
python3-scipy.
"""

import argparse
import json
import os
import pathlib
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

from measure_quads import measure
from polygon_meshes import mean_edge_length, read_features, read_mesh, sharp_edges, triangulated

PLACEHOLDERS = ("model", "features", "output", "quads", "edge_length")


class Model:
    """A model, its features, and the size of quads asked for."""

    def __init__(self, path, folder, size, feature_angle):
        self.path, self.name = path.resolve(), path.stem
        self.mesh = read_mesh(path)
        self.features_path = path.with_suffix(".feat").resolve()
        if not self.features_path.exists():
            self.features_path = folder / (path.stem + ".feat")
            edges = sharp_edges(*self.mesh, feature_angle)
            self.features_path.write_text("".join(f"{a} {b}\n" for a, b in edges), encoding="ascii")
        self.features = read_features(self.features_path)
        self.edge_length = size * mean_edge_length(*self.mesh)
        corners = self.mesh[0][triangulated(self.mesh[1])[0]]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        self.number_of_quads = max(1, round(areas.sum() / self.edge_length ** 2))


class Mesher:
    """A program of the list."""

    def __init__(self, description):
        self.name, self.version = description["name"], description.get("version", "")
        self.format = description.get("format", "obj")
        self.words = shlex.split(description["command"])
        if "/" in self.words[0]:
            self.words[0] = str(pathlib.Path(self.words[0]).resolve())

    def command(self, model, output):
        values = {"model": model.path, "features": model.features_path, "output": output,
                  "quads": model.number_of_quads, "edge_length": repr(model.edge_length)}
        return [replaced(word, values) for word in self.words]

    def run(self, model, output, timeout):
        """What became of it (an empty text if all went well), and the seconds of all its processes."""
        output.unlink(missing_ok=True)
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile() as messages:
            before = seconds_of_children()
            with subprocess.Popen(self.command(model, output), cwd=folder, stdout=messages, stderr=messages,
                                  start_new_session=True) as process:
                outcome = outcome_of(process, timeout)
            return outcome or ("" if output.exists() else "no output"), seconds_of_children() - before


def replaced(word, values):
    for key in PLACEHOLDERS:
        word = word.replace("{" + key + "}", str(values[key]))
    return word


def outcome_of(process, timeout):
    deadline = time.monotonic() + timeout
    try:
        process.wait(timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return f"more than {timeout:g} s" if time.monotonic() >= deadline else "killed"
    if process.returncode < 0:
        return signal.Signals(-process.returncode).name
    return f"exit code {process.returncode}" if process.returncode else ""


def seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def result_of(mesher, model, folder, timeout):
    """One row: the failure or the measures."""
    output = folder / f"{model.name}.{mesher.name.replace(' ', '_').replace('/', '_')}.{mesher.format}"
    failure, seconds = mesher.run(model, output, timeout)
    row = {"model": model.name, "mesher": mesher.name, "version": mesher.version, "seconds": seconds,
           "failure": failure}
    if not failure:
        try:
            row["measures"] = measure(model.mesh, model.features, read_mesh(output))
        except (ValueError, IndexError) as error:
            row["failure"] = f"cannot be read: {error}"
    return row


# ---------------------------------------------------------------- the tables

def flaw_names(measures):
    return ", ".join(f"{flaw.replace('_', ' ')} {measures[flaw]}" if flaw in measures else flaw
                     for flaw in measures["flaws"])


def cell(row):
    """What the table of all models says about one mesh."""
    if row["failure"]:
        return f"failed: {row['failure']}"
    measures = row["measures"]
    if "empty" in measures["flaws"]:
        return "failed: empty"
    parts = [f"{measures['quads']:,} q", f"irregular {measures['irregular_interior']} + "
             f"{measures['irregular_feature_sectors']}",
             f"SJ {measures.get('scaled_jacobian_min', 0):.2f} / {measures.get('scaled_jacobian_mean', 0):.2f}"]
    if measures["feature_lost"] > 0.0005:
        parts.append(f"features lost {100 * measures['feature_lost']:.1f} %")
    return ", ".join(parts) + f", {row['seconds']:.1f} s" + (f"; **{flaw_names(measures)}**" if measures["flaws"]
                                                              else "")


def is_measured(row):
    return not row["failure"] and "empty" not in row["measures"]["flaws"]


TOTALS = ("mesher", "models", "failed", "flawless", "quads", "irregular inside", "on features", "SJ <= 0", "flipped",
          "corners lost", "sharp corners lost", "collapsed", "wrong topology", "not quads", "least SJ",
          "mean SJ", "features lost", "CPU s")


def totals(rows):
    """Sums over the rows of one mesher; the mean scaled Jacobian is that of all quads, the part of the features that is
    lost the mean over models."""
    measured = [row["measures"] for row in rows if is_measured(row)]

    def total(*keys):
        return sum(measures[key] for measures in measured for key in keys)

    kept = ("components", "euler_characteristic", "border_loops")
    is_wrong = [any(measures[key] != measures[key + "_of_model"] for key in kept) or measures["non_manifold_edges"]
                or measures["non_manifold_vertices"] for measures in measured]
    quads = total("quads")
    mean = sum(measures.get("scaled_jacobian_mean", 0) * measures["quads"] for measures in measured) / max(quads, 1)
    least = min((measures.get("scaled_jacobian_min", 0) for measures in measured), default=0)
    lost = 100 * total("feature_lost") / max(len(measured), 1)
    return (rows[0]["mesher"] + (f" ({rows[0]['version']})" if rows[0]["version"] else ""), len(rows),
            len(rows) - len(measured), sum(not measures["flaws"] for measures in measured), f"{quads:,}",
            total("irregular_interior"), total("irregular_feature_sectors"), total("scaled_jacobian_nonpositive"),
            total("flipped_faces"), total("corners_lost"), total("sharp_lost"), total("sharp_collapsed"),
            sum(map(bool, is_wrong)), total("triangles", "other_polygons"), f"{least:.3f}", f"{mean:.3f}",
            f"{lost:.1f} %", f"{sum(row['seconds'] for row in rows):.1f}")


def markdown_table(head, lines):
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in (head, ["---"] * len(head), *lines)) + "\n"


def markdown_of(rows):
    meshers = list(dict.fromkeys(row["mesher"] for row in rows))
    models = list(dict.fromkeys(row["model"] for row in rows))
    of_mesher = {name: [row for row in rows if row["mesher"] == name] for name in meshers}
    by_name = {(row["model"], row["mesher"]): row for row in rows}
    return (markdown_table(TOTALS, [totals(of_mesher[name]) for name in meshers]) + "\n"
            + markdown_table(["model", *meshers], [[model, *(cell(by_name[model, name]) for name in meshers)]
                                                   for model in models])
            + "\nSJ: the least and the mean scaled Jacobian. Bold: why a mesh is not flawless.\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshers", type=pathlib.Path)
    parser.add_argument("models", type=pathlib.Path, help="a folder of .off and .obj files")
    parser.add_argument("out", type=pathlib.Path, help="the folder for the results")
    parser.add_argument("--size", type=float, default=1.0, metavar="FACTOR")
    parser.add_argument("--timeout", type=float, default=60.0, metavar="S", help="wall-clock seconds a mesh")
    parser.add_argument("--feature-angle", type=float, default=40.0, metavar="DEG")
    options = parser.parse_args()
    meshers = [Mesher(description) for description in json.loads(options.meshers.read_text(encoding="utf-8"))]
    paths = sorted(path for path in options.models.iterdir() if path.suffix.lower() in (".off", ".obj"))
    if not paths:
        parser.error(f"no .off or .obj file in {options.models}")
    folder = options.out.resolve()
    folder.mkdir(parents=True, exist_ok=True)

    rows = []
    for path in paths:
        model = Model(path, folder, options.size, options.feature_angle)
        for mesher in meshers:
            rows.append(result_of(mesher, model, folder, options.timeout))
            print(f"{model.name}, {mesher.name}: {cell(rows[-1])}", flush=True)
    (folder / "comparison.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    (folder / "comparison.md").write_text(markdown_of(rows), encoding="utf-8")
    try:
        from plot_quad_comparison import plot
    except ImportError:
        print("there is no plot, since Matplotlib was not found", file=sys.stderr)
    else:
        plot(rows, folder / "comparison.svg")


if __name__ == "__main__":
    main()
