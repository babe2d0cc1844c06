#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Makes quad meshes with the program cad_quad_mesh and maps with the example frame_field_seamless_map, and draws them
beside this script.

    xvfb-run -a /usr/bin/python3 draw_quads.py CAD_QUAD_MESH FRAME_FIELD_SEAMLESS_MAP MESHES [PICTURE...]

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
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

# It adds the folder of the renderers to the path.
from draw_fields import FLANGE, LABEL_SIZE, draw, from_side, render  # noqa: E402

import planar_models as planar  # noqa: E402
import render_quad_mesh as render_quads  # noqa: E402
from seamless_maps import SeamlessMap  # noqa: E402

FILLED, LAYOUT, BORDER = (0.98, 0.80, 0.45), (0.85, 0.25, 0.05), (0.15, 0.20, 0.30)
BLOCKS = ((0.70, 0.82, 0.94), (0.98, 0.85, 0.70), (0.78, 0.91, 0.75), (0.90, 0.80, 0.93), (0.98, 0.93, 0.68),
          (0.75, 0.91, 0.91), (0.95, 0.78, 0.80), (0.86, 0.86, 0.86), (0.85, 0.90, 0.65), (0.80, 0.78, 0.92),
          (0.92, 0.86, 0.78))


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


class BlockPanel(Panel):
    """A quad mesh in blocks: neighbors that have different numbers of blocks, and mostly different colours."""

    def renderer(self, aspect, size, line_width, ball_size):
        result = super().renderer(aspect, size, line_width, ball_size)
        mesh = self.mesh
        block = vtk_to_numpy(mesh.data.GetCellData().GetArray("block"))[-len(mesh.quads):]
        for number, colour in enumerate(BLOCKS):
            mask = block * 7 % len(BLOCKS) == number
            if mask.any():
                result.AddActor(render_quads.surface_actor(mesh.points, mesh.quads[mask], colour))
        sides = np.concatenate([mesh.quads[:, [k - 1, k]] for k in range(4)])
        edges, edge_of = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True)
        least, greatest = np.full(len(edges), len(block)), np.full(len(edges), -1)
        np.minimum.at(least, edge_of.ravel(), np.tile(block, 4))
        np.maximum.at(greatest, edge_of.ravel(), np.tile(block, 4))
        borders = edges[least < greatest]
        result.AddActor(render.tubes(mesh.points, borders, 0.0022 * self.view(mesh, aspect).reach, BORDER))
        return result


class MapPanel:
    """A seamless map as a checkerboard with squares of `square` units, or its motorcycle graph."""

    def __init__(self, seamless_map, label, view, square=0):
        self.map, self.label, self.view, self.square = seamless_map, label, view, square

    def renderer(self, aspect, size, _, ball_size):
        view = self.view(self.map, aspect)
        result = render.configured(vtk.vtkRenderer(), Background=(1, 1, 1))
        result.AddActor(self.checkerboard() if self.square else
                        render_quads.surface_actor(self.map.points, self.map.triangles, render_quads.SURFACE))
        unit = view.reach / 100
        if len(self.map.features):
            result.AddActor(render.tubes(self.map.points, self.map.features, 0.44 * unit, render.FEATURE))
        if not self.square:
            lines = self.map.motorcycle_graph()
            ends = np.cumsum([0] + [len(line) for line in lines])
            result.AddActor(render.tubes(np.concatenate(lines), [np.arange(*pair) for pair in zip(ends, ends[1:])],
                                         0.3 * unit, LAYOUT))
        for quads, (_, colour) in render_quads.INTERIOR.items():
            vertices = [vertex for vertex, quarters in self.map.singularities if quarters == quads]
            if quads and vertices:
                result.AddActor(render_quads.ball_actor(self.map.points[vertices], ball_size * unit, colour))
        view.apply_to(result, 4 * np.linalg.norm(np.ptp(self.map.points, axis=0)))
        label = render.text(self.label, size[0] / 2, 6, LABEL_SIZE)
        label.GetTextProperty().SetJustificationToCentered()
        result.AddActor2D(label)
        return result

    def checkerboard(self):
        """A texture of 2 x 2 squares with lines between them, repeated."""
        corners = self.map.points[self.map.triangles].reshape(-1, 3)
        data = render.poly_data(corners, polygons=np.arange(len(corners)).reshape(-1, 3))
        places = self.map.uv.reshape(-1, 2) / (2 * self.square)
        data.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
        pixels = np.full((256, 256, 3), 255, dtype=np.uint8)
        pixels[:128, :128] = pixels[128:, 128:] = (176, 200, 226)
        for line in (0, 128):
            for place in range(line - 5, line + 5):
                pixels[place], pixels[:, place] = (70, 90, 115), (70, 90, 115)
        image = render.configured(vtk.vtkImageData(), Dimensions=(256, 256, 1))
        image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
        mapper = render.configured(vtk.vtkPolyDataMapper(), InputData=data, ScalarVisibility=False)
        texture = render.configured(vtk.vtkTexture(), InputData=image, Repeat=True, Interpolate=True, Mipmap=True)
        actor = render.configured(vtk.vtkActor(), Mapper=mapper, Texture=texture)
        render.configured(actor.GetProperty(), Ambient=0.4, Diffuse=0.65)
        return actor


class Computer:
    """Runs the programs."""

    def __init__(self, program, map_program, meshes, folder):
        self.program, self.map_program, self.meshes = program, map_program, meshes
        self.folder, self.number = pathlib.Path(folder), 0

    def seamless_map(self, name):
        path = self.folder / (name + ".obj")
        with path.open("w") as out:
            subprocess.run([self.map_program, self.meshes / (name + ".off")], check=True, stdout=out)
        return SeamlessMap(path)

    def has(self, name):
        """Whether there is a model of this name; says so if not."""
        is_there = (self.meshes / (name + ".off")).exists()
        if not is_there:
            print(f"There is no {name} in {self.meshes}: left out.")
        return is_there

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


# ---------------------------------------------------------------- the pictures

# Names of models, from where they are seen (azimuth and elevation), and the number of quads.
GALLERY = (("couplingdown", (30, 50), 3500), ("anchor_dense", (30, 40), 2500), ("pinion", (-50, 30), 1500),
           ("rotor", (30, 40), 1200), ("tripod", (30, 40), 800), ("turbine", (30, 40), 4000))


def draw_gallery(computer):
    panels = []
    for name, view, number in GALLERY:
        vtp, report = computer.quads(name, "--quads", str(number))
        panels.append(Panel(vtp, f"{name}: {report['quads']} quads", from_side(*view)))
    draw("quad_gallery", [panels[:3], panels[3:]], (400, 330), 1, 1.6)


def draw_sizes(computer):
    """One size, sizes by the bends of the surface, and sizes by the gaps between features."""
    panels = []
    for title, options in (("one size", []), ("chord height", ["--chord-height", "0.05"]),
                           ("three edges across gaps", ["--edges-across-gap", "3", "--min-edge-length", "1"])):
        vtp, report = computer.quads(FLANGE, "--edge-length", "6", *options)
        panels.append(Panel(vtp, f"{title}: {report['quads']} quads", from_side(30, 40, 1.05)))
    draw("quad_sizes", [panels], (500, 400), 1, 1.1)


def draw_blocks(computer):
    """Blocks that meet along whole sides, along whole sides between features, and with T-junctions."""
    panels = []
    for kind in ("whole-sides", "by-patch", "t-junctions"):
        vtp, report = computer.quads("rotor", "--blocks", kind)
        panels.append(BlockPanel(vtp, f"{kind}: {report['blocks']} blocks", from_side(30, 40)))
    draw("quad_blocks", [panels], (400, 330), 1, 1.6)


def draw_stages(computer):
    """The map, the T-mesh and the quads of a model."""
    seamless, view = computer.seamless_map("anchor_dense"), from_side(30, 40)
    quads, _ = computer.quads("anchor_dense")
    draw("quad_stages", [[MapPanel(seamless, "seamless map", view, 1), MapPanel(seamless, "T-mesh", view),
                          Panel(quads, "quads", view)]], (400, 330), 1, 1.6)


def draw_maps(computer):
    models = [(computer.seamless_map(name), name, from_side(*view)) for name, view in (("fandisk", (30, 40)),
                                                                                       ("rotor", (30, 40)))]
    draw("seamless_map", [[MapPanel(seamless, name, view, 1 + (name == "fandisk")) for seamless, name, view in models]],
         (600, 430), 1, 1.4)
    draw("t_mesh", [[MapPanel(seamless, name, view) for seamless, name, view in models]], (600, 430), 1, 1.4)


PICTURES = {"quad_gallery": draw_gallery, "quad_sizes": draw_sizes, "quad_stages": draw_stages, "maps": draw_maps,
            "quad_blocks": draw_blocks}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("map_program", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("pictures", nargs="*", default=list(PICTURES), help=", ".join(PICTURES))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        computer = Computer(arguments.program, arguments.map_program.resolve(), arguments.meshes.resolve(), folder)
        for picture in arguments.pictures:
            PICTURES[picture](computer)


if __name__ == "__main__":
    main()
