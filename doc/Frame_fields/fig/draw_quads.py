#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Makes quad meshes with the program cad_quad_mesh and draws them beside this script.

    xvfb-run -a /usr/bin/python3 draw_quads.py PROGRAM MESHES [PICTURE...]

MESHES is the folder meshes of CGAL's data. Needs Debian's python3-vtk9, python3-numpy, python3-pil and
python3-matplotlib. The target `figures` runs it.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy as np
import vtk

from draw_fields import CLASSICAL, FLANGE, LABEL_SIZE, draw, from_above, from_side, render  # sets the path of scripts

import planar_models as planar
import render_quad_mesh as render_quads

FILLED = (0.98, 0.80, 0.45)
SMOOTHEST, OURS = "smoothest field", "this package"


class Panel:
    """A quad mesh with a label below it. The view is a function of the mesh and the aspect ratio."""

    def __init__(self, path, label, view, filled=()):
        self.mesh, self.label, self.view, self.filled = render_quads.QuadMesh(str(path)), label, view, filled

    def renderer(self, aspect, size, line_width, ball_size):
        view = self.view(self.mesh, aspect)
        result = render_quads.scene(self.mesh, view, (1, 1, 1), line_width, ball_size)
        is_filled = np.isin(self.mesh.patch, self.filled)
        if is_filled.any():
            result.AddActor(render_quads.surface_actor(self.mesh.points, self.mesh.quads[is_filled], FILLED))
        label = render.text(self.label, size[0] / 2, 6, LABEL_SIZE)
        label.GetTextProperty().SetJustificationToCentered()
        result.AddActor2D(label)
        return result


class Computer:
    """Runs the program."""

    def __init__(self, program, meshes, folder):
        self.program, self.meshes, self.folder, self.number = program, meshes, pathlib.Path(folder), 0

    def quads(self, model, *options):
        """The VTP file of the quads of a model, which is a file or a plane model, and the report."""
        self.number += 1
        base = self.folder / f"{self.number}"
        if isinstance(model, planar.Model):
            path = base.with_suffix(".off")
            model.write(path)
            features = base.with_suffix(".feat")
            features.write_text("".join("%d %d\n" % edge for edge in model.features), encoding="ascii")
        else:
            path = model if isinstance(model, pathlib.Path) else self.meshes / (model + ".off")
            features = path.with_suffix(".feat")
        if features.exists():
            options += ("--features", str(features))
        vtp, report = base.with_suffix(".vtp"), base.with_suffix(".json")
        subprocess.run([self.program, str(path), "--quiet", "-o", str(vtp), "--report", str(report), *options],
                       check=True)
        return vtp, json.loads(report.read_text(encoding="utf-8"))

    def panel(self, title, model, view, *options):
        """With the number of irregular vertices, and the filled patches in another colour."""
        vtp, report = self.quads(model, *options)
        quality = report["quality"]
        irregular = quality["irregular_vertices"] + quality["irregular_feature_sectors"]
        filled = [number for number, patch in enumerate(report["patch_list"]) if patch["way"] != "certified_map"]
        label = f"{title}: {irregular} irregular" if irregular else title
        return Panel(vtp, label, view, filled)

    def pair(self, model, view, *options):
        return [self.panel(SMOOTHEST, model, view, *options, *CLASSICAL), self.panel(OURS, model, view, *options)]


# ---------------------------------------------------------------- the pictures

def draw_flange(computer):
    draw("flange_quads", [computer.pair(FLANGE, from_side(30, 40, 1.05), "--quads", "6000")], (600, 450), 1, 1.1)


def draw_shark(computer):
    draw("shark_quads", [computer.pair("mech-holes-shark", from_side(60, 25, 1.0), "--quads", "4000")], (600, 400), 1,
         1.3)


PICTURES = {"flange_quads": draw_flange, "shark_quads": draw_shark}


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
