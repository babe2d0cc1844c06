#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Computes fields with the program cad_frame_field and draws them with their streamlines, beside this script. Prints
the table of the README.

    xvfb-run -a /usr/bin/python3 draw_fields.py PROGRAM MESHES [PICTURE...]

MESHES is the folder meshes of CGAL's data. Needs Debian's python3-vtk9, python3-numpy, python3-pil and
python3-matplotlib. The target `figures` runs it.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

FOLDER = pathlib.Path(__file__).resolve().parent
EXAMPLES = FOLDER.parents[2] / "examples/Frame_fields"
sys.path += [str(FOLDER), str(EXAMPLES)]

import planar_models as planar  # noqa: E402
import render_frame_field as render  # noqa: E402
from ellipsoid import ellipsoid  # noqa: E402
from plot_models import fastest_report, plot_models  # noqa: E402

FLANGE = EXAMPLES / "data/flange.off"
CLASSICAL = ["--support", "none", "--no-repair", "--no-relaxation"]
LABEL_SIZE = 17


class Panel:
    """A field with a label below it. The view is a function of the field and the aspect ratio."""

    def __init__(self, path, label, view):
        self.field, self.label, self.view = render.Field(str(path)), label, view

    def renderer(self, aspect, size, line_width, ball_size):
        surface = render.poly_data(self.field.points, polygons=self.field.triangles)
        view = self.view(self.field, aspect)
        result = render.scene(self.field, surface, view, 1, line_width, ball_size)
        label = render.text(self.label, size[0] / 2, 6, LABEL_SIZE)
        label.GetTextProperty().SetJustificationToCentered()
        result.AddActor2D(label)
        return result


def from_above(centre=None, reach=None):
    """Of plane models: all of them, or what is within `reach` of a point."""
    def view(field, aspect):
        low, high = field.points.min(axis=0), field.points.max(axis=0)
        middle = (low + high) / 2 if centre is None else np.array(centre)
        half = reach or max((high - low)[:2] / 2 / [aspect, 1]) * 1.3
        return render.View(middle - [0, 0.13 * half, 0], np.array([0, 0, 1.0]), np.array([0, 1.0, 0]), half)
    return view


def from_side(azimuth, elevation, zoom=0.92):
    def view(field, aspect):
        result = render.view_of_everything(field, azimuth, elevation, aspect, zoom)
        result.centre = result.centre - 0.06 * result.reach * result.up
        return result
    return view


def draw(name, rows, size, line_width, ball_size):
    """Draws rows of panels of `size` pixels each."""
    width, height = size[0] * len(rows[0]), size[1] * len(rows)
    renderers = []
    for i, row in enumerate(rows):
        for j, panel in enumerate(row):
            renderer = panel.renderer(size[0] / size[1], size, line_width, ball_size)
            renderer.SetViewport(j / len(row), 1 - (i + 1) / len(rows), (j + 1) / len(row), 1 - i / len(rows))
            renderers.append(renderer)
    path = str(FOLDER / (name + ".png"))
    render.write_picture(renderers, (width, height), path)
    picture = Image.open(path).convert("RGB")
    picture.quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(path, optimize=True)


class Computer:
    """Runs the program."""

    def __init__(self, program, meshes, folder):
        self.program, self.meshes, self.folder, self.number = program, meshes, pathlib.Path(folder), 0

    def field(self, model, *options, spacing):
        """The VTP file of the field of a model, which is a file or a plane model, and its report."""
        self.number += 1
        base = self.folder / f"{self.number}"
        if isinstance(model, planar.Model):
            path = base.with_suffix(".off")
            model.write(path)
            if model.features:
                features = base.with_suffix(".feat")
                features.write_text("".join("%d %d\n" % edge for edge in model.features), encoding="ascii")
                options += ("--features", str(features))
            model = path
        vtp, report = base.with_suffix(".vtp"), base.with_suffix(".json")
        subprocess.run([self.program, str(model), "--quiet", "--vtp", str(vtp), f"--streamlines={spacing}", "--report",
                        str(report), *options], check=True)
        return vtp, json.loads(report.read_text(encoding="utf-8"))

    def field_with_indices(self, model, four_times_index, spacing):
        """The field with indices asked for at the first vertices."""
        targets = self.folder / "targets.txt"
        targets.write_text("".join("%d %d\n" % target for target in enumerate(four_times_index)), encoding="ascii")
        return self.field(model, "--index-targets", str(targets), spacing=spacing)[0]


# ---------------------------------------------------------------- the pictures

def draw_sharp_corner(computer):
    rows = [[], []]
    for label, options in (("classical field", CLASSICAL), ("this package", [])):
        rows[0].append(Panel(computer.field(planar.sector(25, 34), *options, spacing=0.03)[0], label, from_above()))
        star, report = computer.field(computer.meshes / "star.off", *options, spacing=0)
        rows[1].append(Panel(star, f"{label}: {report['unmeshable_after']} unmeshable", from_side(40, 25)))
    draw("sharp_corner", rows, (500, 300), 0.4, 3)


def draw_strategies(computer):
    model, view = planar.sector(20, 24), from_above()
    panels = [Panel(computer.field(model, *options, spacing=0.025)[0], label, view)
              for label, options in (("none(): the classical field", CLASSICAL), ("local()", ["--support", "local"]),
                                     ("rings(4)", []), ("component()", ["--support", "component"]))]
    draw("strategies", [panels[:2], panels[2:]], (500, 240), 0.4, 3.5)


def draw_index_gallery(computer):
    def name(index):
        return "I = " + {-2: "\u22121/2", -1: "\u22121/4", 0: "0", 1: "1/4", 2: "1/2"}[index]

    view = from_above()
    constrained = [Panel(computer.field(planar.sector(degrees, 14), *options, spacing=0.075)[0], name(index), view)
                   for index, degrees, options in ((2, 25, CLASSICAL), (1, 90, []), (0, 180, []), (-1, 270, []),
                                                   (-2, 360, []))]
    inside = [Panel(computer.field_with_indices(planar.polygon(4 - index, 14), [index], 0.085), name(index), view)
              for index in (2, 1, 0, -1, -2)]
    draw("index_gallery", [constrained, inside], (220, 250), 0.7, 4)


def draw_extremely_sharp(computer):
    rows = []
    for model, spacing, view in ((planar.crescent(8, 160), 0.01, from_above((-0.72, 0.27, 0), 0.36)),
                                 (planar.astroid(120), 0.035, from_above())):
        rows.append([])
        for label, options in (("classical field", CLASSICAL),
                               ("radius()", ["--support", "radius", "--edge-weights", "geometric"])):
            vtp, report = computer.field(model, *options, spacing=spacing)
            rows[-1].append(Panel(vtp, f"{label}: {report['unmeshable_after']} unmeshable", view))
    draw("extremely_sharp_corners", rows, (500, 330), 0.3, 2.5)


def draw_flange(computer):
    """The whole flange, and the side of one of its ribs, with a corner of 40 degrees."""
    features = "--features", str(FLANGE.with_suffix(".feat"))

    def close(field, aspect):
        return render.View(np.array([4, -31, 14.5]), np.array([3.4, -0.9, 0.6]), render.VERTICAL, 10.5)

    for name, when, options in (("flange_baseline", "classical field", CLASSICAL), ("flange", "this package", [])):
        vtp, report = computer.field(FLANGE, *features, *options, spacing=0)
        near = computer.field(FLANGE, *features, *options, spacing=0.9)[0]
        draw(name, [[Panel(vtp, f"{when}: {report['unmeshable_after']} unmeshable", from_side(30, 40, 1.05)),
                     Panel(near, "a corner of 40 degrees", close)]], (600, 450), 0.3, 2)


def draw_closed_surfaces(computer):
    model = ellipsoid((3, 2, 1), 30)
    for name, vtp in (("sphere", computer.field(ellipsoid((1, 1, 1), 30), spacing=0.06)[0]),
                      ("ellipsoid", computer.field(model, "--curvature-weight", "0.1", spacing=0.1)[0]),
                      ("given_singularities", computer.field_with_indices(model, [1, 1, 1, 1, 2, 2], 0.1))):
        draw(name, [[Panel(vtp, "", from_side(20, 35))]], (600, 380), 0.25, 1.8)


# Names of CGAL's meshes, and from where they are seen: azimuth and elevation in degrees.
MODELS = {"mech-holes-shark": (60, 25), "boeing": (30, 40), "cheese": (30, 40), "fandisk_large": (30, 40),
          "ALSTOM_TEST4": (110, 25), "mpi_triang": (30, 40), "star": (40, 25), "tripod": (30, 40),
          "double-torus-3-holes": (30, 60), "fandisk": (30, 40), "anchor_dense": (30, 40), "couplingdown": (30, 50),
          "pinion": (-50, 30)}


def draw_cad_models(computer):
    paths = {"flange": (FLANGE, (30, 40))}
    paths.update({name: (computer.meshes / (name + ".off"), view) for name, view in MODELS.items()})
    tiles = []
    for name, (model, view) in paths.items():
        features = model.with_suffix(".feat")
        features = ["--features", str(features)] if features.exists() else []
        for when, options in ((f"{name}, before", CLASSICAL), ("after", [])):
            vtp, report = computer.field(model, *options, *features, spacing=0)
            tiles.append(Panel(vtp, f"{when}: {report['unmeshable_after']}", from_side(*view)))
    draw("cad_models", [tiles[i:i + 4] for i in range(0, len(tiles), 4)], (300, 250), 0.3, 2.5)


def print_table(computer):
    """The lines of the table of the README."""
    names = ("mech-holes-shark", "boeing", "cheese", "fandisk_large", "hand", "anchor_dense", "fandisk")
    for model in [FLANGE, *(computer.meshes / (name + ".off") for name in names)]:
        report = fastest_report(computer, model, "--threads", "1")
        print(f"| {model.stem} | {report['faces_after_split']:,} | {report['unmeshable_before']} | "
              f"{report['unmeshable_after']} | {report['seconds']['total']:.3f} |")


PICTURES = {"sharp_corner": draw_sharp_corner, "strategies": draw_strategies, "index_gallery": draw_index_gallery,
            "extremely_sharp_corners": draw_extremely_sharp, "cad_models": draw_cad_models,
            "flange": draw_flange, "closed_surfaces": draw_closed_surfaces,
           "model_set": lambda computer: plot_models(computer, FOLDER / "model_set.svg"),
           "table": print_table}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("pictures", nargs="*", default=list(PICTURES), help=", ".join(PICTURES))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        computer = Computer(arguments.program, arguments.meshes, folder)
        for picture in arguments.pictures:
            PICTURES[picture](computer)


if __name__ == "__main__":
    main()
