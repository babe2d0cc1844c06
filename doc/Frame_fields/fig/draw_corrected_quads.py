#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws quad meshes with and without the correction of sharp corners, and plots their numbers of irregular vertices,
beside this script.

    xvfb-run -a /usr/bin/python3 draw_corrected_quads.py CAD_FRAME_FIELD CAD_QUAD_MESH MESHES [PICTURE...]

MESHES is the folder meshes of CGAL's data. Needs Debian's python3-vtk9, python3-numpy, python3-pil and
python3-matplotlib. The target `figures` runs it.
"""
import argparse
import pathlib
import tempfile

import matplotlib
import numpy as np

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

import draw_fields  # noqa: E402
from draw_fields import CLASSICAL, FLANGE, FOLDER, MODELS, draw, from_above, from_side, render  # noqa: E402

import draw_quads  # noqa: E402
import planar_models as planar  # noqa: E402

SMOOTHEST, REPAIRED, OURS = "smoothest field", "indices repaired", "this package"
# The smoothest field, also with indices that the flow on the matching repaired, and the field of this package.
OPTIONS = {SMOOTHEST: CLASSICAL, REPAIRED: ["--support", "none"], OURS: []}


class Computer(draw_quads.Computer):
    """Runs the programs."""

    def __init__(self, field_program, program, meshes, folder):
        super().__init__(program, None, meshes, folder)
        self.fields = draw_fields.Computer(field_program, meshes, folder + "/fields")
        self.fields.folder.mkdir()

    def irregular(self, model, *options):
        return number_of_irregular(self.quads(model, *options)[1])

    def panel(self, title, model, view, *options):
        """The title has a place for the number of irregular vertices; filled patches have another colour."""
        vtp, report = self.quads(model, *options)
        filled = [number for number, patch in enumerate(report["patch_list"]) if patch["way"] != "certified_map"]
        return draw_quads.Panel(vtp, title.format(number_of_irregular(report)), view, filled)

    def pair(self, model, view, *options):
        return [self.panel(title + ": {} irregular", model, view, *options, *OPTIONS[title])
                for title in (SMOOTHEST, OURS)]


def number_of_irregular(report):
    return report["quality"]["irregular_vertices"] + report["quality"]["irregular_feature_sectors"]


def close_up(place, toward, reach):
    """Of what is within `reach` of a place, seen from a direction."""
    up = np.array([0, 1.0, 0]) if toward == (0, 0, 1) else render.VERTICAL

    def view(_, aspect):
        return render.View(np.array(place, dtype=float), np.array(toward, dtype=float), up, reach)
    return view


# ---------------------------------------------------------------- the pictures

def draw_flange(computer):
    draw("flange_quads", [computer.pair(FLANGE, from_side(30, 40, 1.05), "--quads", "6000")], (600, 450), 1, 1.1)


def draw_shark(computer):
    draw("shark_quads", [computer.pair("mech-holes-shark", from_side(60, 25, 1.0), "--quads", "4000")], (600, 400), 1,
         1.3)


def draw_fields_and_quads(computer):
    """Grooves of the flange with corners of 8 degrees, and a rib whose sides run out at 18 degrees."""
    view, rows = close_up((-43, 0, 10), (-0.3, -0.5, 1), 22), []
    for title in (SMOOTHEST, OURS):
        vtp, _ = computer.fields.field(FLANGE, "--features", str(FLANGE.with_suffix(".feat")), *OPTIONS[title],
                                       spacing=2.2)
        rows.append([draw_fields.Panel(vtp, title, view),
                     computer.panel("quads: {} irregular in all", FLANGE, view, "--edge-length", "2.5",
                                    *OPTIONS[title])])
    draw("fields_and_quads", rows, (540, 380), 0.4, 1.6)


def draw_corrected(computer):
    """Models from the data folder of CGAL, with numbers of quads."""
    tiles = []
    for name, number in (("fandisk", 1500), ("anchor_dense", 1500), ("boeing", 2500), ("fandisk_large", 4000),
                         ("ALSTOM_TEST4", 700), ("mpi_triang", 900), ("tripod", 400), ("double-torus-3-holes", 400)):
        if not computer.has(name):
            continue
        view, size = from_side(*MODELS[name]), ("--quads", str(number))
        tiles += [computer.panel(name + ", before: {}", name, view, *size, *CLASSICAL),
                  computer.panel("after: {}", name, view, *size)]
    draw("corrected_quads", [tiles[i:i + 4] for i in range(0, len(tiles), 4)], (300, 250), 1, 2)


def draw_sharp_corners(computer):
    """A plane sector, and extremely sharp corners: a crescent with two tips of 8 degrees, and four cusps."""
    rows = []
    for model, view, *size in ((planar.sector(25, 34), from_above(), "--edge-length", "0.045"),
                               (planar.crescent(8, 160), from_above((-0.72, 0.27, 0), 0.36), "--edge-length", "0.04"),
                               (planar.astroid(120), from_above(), "--edge-length", "0.045")):
        rows.append([computer.panel(title + ": {} irregular", model, view, *size, *options)
                     for title, options in ((SMOOTHEST, CLASSICAL), (REPAIRED, OPTIONS[REPAIRED]), ("rings(4)", []),
                                            ("radius()", ["--support", "radius"]))])
    draw("sharp_corner_quads", rows, (330, 270), 1, 1.6)


def draw_extremely_sharp(computer):
    """Corners of the flange of 2.2 degrees, where a boss touches the border of the plate, and of 3 degrees."""
    rows = [computer.pair(FLANGE, view, "--edge-length", "1")
            for view in (close_up((62.5, 29.3, 10), (0, 0, 1), 4.2), close_up((41, -8.5, 25), (0.6, -1, 0.4), 5))]
    draw("extremely_sharp_quads", rows, (500, 300), 1, 1.6)


def plot_irregular(computer):
    """Irregular vertices of quads from each field."""
    names = [name for name in ("mech-holes-shark", "boeing", "fandisk", "anchor_dense", "turbine", "couplingdown",
                               "fandisk_large", "hand", "mpi_triang", "ALSTOM_TEST4", "oblong", "rotor")
             if computer.has(name)]
    counts = [[computer.irregular(model, *options) for options in OPTIONS.values()] for model in (FLANGE, *names)]
    for name, count in zip(("flange", *names), counts):
        print(name, *count)
    figure, axis = plt.subplots(figsize=(9, 3.2), constrained_layout=True)
    for number, (label, colour) in enumerate(zip(OPTIONS, ("0.65", "tab:orange", "tab:blue"))):
        places = [place + 0.29 * (number - 1) for place in range(len(counts))]
        bars = axis.bar(places, [count[number] for count in counts], 0.27, color=colour, label=label)
        axis.bar_label(bars, fontsize="xx-small")
    axis.set_xticks(range(len(counts)), ["flange", *names], rotation=30, ha="right")
    axis.set_yscale("log")
    axis.set_ylabel("irregular vertices")
    axis.legend(frameon=False)
    figure.savefig(FOLDER / "irregular_vertices.svg", metadata={"Date": None})


PICTURES = {"flange_quads": draw_flange, "shark_quads": draw_shark, "fields_and_quads": draw_fields_and_quads,
            "corrected_quads": draw_corrected, "sharp_corner_quads": draw_sharp_corners,
            "extremely_sharp_quads": draw_extremely_sharp, "irregular_vertices": plot_irregular}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("field_program")
    parser.add_argument("program")
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("pictures", nargs="*", default=list(PICTURES), help=", ".join(PICTURES))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        computer = Computer(arguments.field_program, arguments.program, arguments.meshes.resolve(), folder)
        for picture in arguments.pictures:
            PICTURES[picture](computer)


if __name__ == "__main__":
    main()
