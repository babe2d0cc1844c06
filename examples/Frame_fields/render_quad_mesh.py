#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Renders quadrangle meshes written by the program cad_quad_mesh (VTK XML PolyData) to a PNG picture.

    xvfb-run -a /usr/bin/python3 render_quad_mesh.py QUADS.vtp OUT.png --view 30 40 --view 210 -20

Needs Debian's python3-vtk9 and python3-numpy, and xvfb where there is no display. z is up. Each mesh is shown in each
view, and in a close-up of each place given by --focus; several meshes stand below one another, or with --beside beside
one another, with a title each.
"""

import argparse

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from render_frame_field import FEATURE, View, configured, poly_data, swatch, text, tubes, view_of_everything, \
    write_picture

SURFACE, EDGE, INVERTED = (0.86, 0.89, 0.93), (0.36, 0.42, 0.50), (0.90, 0.10, 0.10)
# By valence; any other one has the last colour.
INTERIOR = {3: ("valence 3", (0.85, 0.05, 0.08)), 5: ("valence 5", (0.10, 0.25, 0.95)),
            None: ("other valence", (0.95, 0.60, 0.0))}
ON_FEATURE = ("irregular on features", (0.0, 0.60, 0.35))


class QuadMesh:
    """The arrays of a file of quadrangles."""

    def __init__(self, path):
        reader = configured(vtk.vtkXMLPolyDataReader(), FileName=path)
        reader.Update()
        self.data = reader.GetOutput()
        if not self.data.GetNumberOfPolys():
            raise SystemExit(f"no faces in {path}")
        self.points = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        self.verts = vtk_to_numpy(self.data.GetVerts().GetConnectivityArray())
        self.features = vtk_to_numpy(self.data.GetLines().GetConnectivityArray()).reshape(-1, 2)
        self.quads = vtk_to_numpy(self.data.GetPolys().GetConnectivityArray()).reshape(-1, 4)

        def cell_data(name):
            return vtk_to_numpy(self.data.GetCellData().GetArray(name))

        self.valence = cell_data("valence")[:len(self.verts)]
        self.is_on_feature = cell_data("on_feature")[:len(self.verts)] == 1
        self.scaled_jacobian = cell_data("scaled_jacobian")[-len(self.quads):]
        self.patch = cell_data("patch")[-len(self.quads):]
        self.diagonal = np.linalg.norm(np.ptp(self.points, axis=0))
        self.edges = np.unique(np.sort(np.concatenate(
            [self.quads[:, [k - 1, k]] for k in range(4)]), axis=1), axis=0)
        lengths = np.linalg.norm(self.points[self.edges[:, 0]] - self.points[self.edges[:, 1]], axis=1)
        self.edge_length = np.median(lengths)

    def irregular_groups(self):
        """(label, colour, points) of each kind of irregular vertices."""
        inside = ~self.is_on_feature
        for valence, (label, colour) in INTERIOR.items():
            mask = self.valence == valence if valence else ~np.isin(self.valence, [key for key in INTERIOR if key])
            yield label, colour, self.points[self.verts[inside & mask]]
        yield *ON_FEATURE, self.points[self.verts[self.is_on_feature]]


# ---------------------------------------------------------------- what to draw

def surface_actor(points, quads, colour):
    mapper = configured(vtk.vtkPolyDataMapper(), InputData=poly_data(points, polygons=quads), ScalarVisibility=False)
    # Edges that lie in the surface are drawn in front of it.
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1)
    actor = configured(vtk.vtkActor(), Mapper=mapper)
    configured(actor.GetProperty(), Color=colour, Ambient=0.4, Diffuse=0.65, Interpolation=0)
    return actor


def line_actor(points, edges, colour, width):
    mapper = configured(vtk.vtkPolyDataMapper(), InputData=poly_data(points, lines=edges), ScalarVisibility=False)
    actor = configured(vtk.vtkActor(), Mapper=mapper)
    configured(actor.GetProperty(), Color=colour, LineWidth=width, Lighting=False)
    return actor


def ball_actor(points, radius, colour):
    ball = configured(vtk.vtkSphereSource(), Radius=radius, ThetaResolution=20, PhiResolution=20)
    glyph = configured(vtk.vtkGlyph3D(), InputData=poly_data(points), SourceConnection=ball.GetOutputPort(),
                       Scaling=False)
    mapper = configured(vtk.vtkPolyDataMapper(), InputConnection=glyph.GetOutputPort(), ScalarVisibility=False)
    actor = configured(vtk.vtkActor(), Mapper=mapper)
    configured(actor.GetProperty(), Color=colour, Ambient=0.45, Diffuse=0.6, Specular=0.3)
    return actor


def scene(mesh, view, background, line_width=1, ball_size=None):
    """The radius of the balls is in percent of half the height of the view; by default it follows from the edges."""
    renderer = configured(vtk.vtkRenderer(), Background=background)
    is_inverted = ~(mesh.scaled_jacobian > 0)
    for mask, colour in ((~is_inverted, SURFACE), (is_inverted, INVERTED)):
        if mask.any():
            renderer.AddActor(surface_actor(mesh.points, mesh.quads[mask], colour))
    renderer.AddActor(line_actor(mesh.points, mesh.edges, EDGE, line_width))
    if len(mesh.features):
        renderer.AddActor(tubes(mesh.points, mesh.features, 0.0022 * view.reach * 2, FEATURE))
    # Larger than thin features, and on coarse meshes no larger than a part of an edge.
    radius = min(0.022 * view.reach, max(0.2 * mesh.edge_length, 0.009 * view.reach))
    radius = ball_size * view.reach / 100 if ball_size else radius
    for _, colour, points in mesh.irregular_groups():
        if len(points):
            renderer.AddActor(ball_actor(points, radius, colour))
    view.apply_to(renderer, 4 * mesh.diagonal)
    return renderer


def add_legend(renderer, mesh, size):
    entries = [("feature edge", FEATURE)]
    entries += [(f"{label}: {len(points)}", colour) for label, colour, points in mesh.irregular_groups()
                if len(points)]
    number_of_inverted = int((~(mesh.scaled_jacobian > 0)).sum())
    if number_of_inverted:
        entries.append((f"inverted quadrangle: {number_of_inverted}", INVERTED))
    for line, (label, colour) in enumerate(reversed(entries)):
        y = size * (1 + 1.6 * line)
        renderer.AddActor2D(swatch(size, y, size, colour))
        renderer.AddActor2D(text(label, 2.5 * size, y, size))


def close_up(mesh, focus, main_view):
    """A view of a place along the mean normal of the quadrangles that are near it and seen in the main view."""
    place, radius = np.array(focus[:3]), focus[3]
    corners = mesh.points[mesh.quads]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    distance = np.linalg.norm(corners.mean(axis=1) - place, axis=1)
    near = (distance < max(radius, 1.01 * distance.min())) & (normals @ main_view.toward > 0)
    toward = normals[near].sum(axis=0) if near.any() else main_view.toward
    length = np.linalg.norm(toward)
    return View(place, 2 * toward / (length or 1) + main_view.toward, main_view.up, radius)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", metavar="QUADS.vtp ... OUT.png", help="meshes, and the picture to write")
    parser.add_argument("--title", action="append", default=[], help="of the next mesh; can be given several times")
    parser.add_argument("--beside", action="store_true", help="a column for each mesh instead of a row")
    parser.add_argument("--size", nargs=2, type=int, default=[900, 900], metavar=("W", "H"), help="of each view")
    parser.add_argument("--view", nargs=2, type=float, action="append", metavar=("AZIMUTH", "ELEVATION"),
                        help="degrees; can be given several times; default: 30 40")
    parser.add_argument("--focus", nargs=4, type=float, action="append", default=[],
                        metavar=("X", "Y", "Z", "RADIUS"), help="a close-up; can be given several times")
    parser.add_argument("--zoom", type=float, default=1.0)
    options = parser.parse_args()
    if len(options.files) < 2:
        parser.error("a mesh and a picture are needed")
    return options


def scenes_of(mesh, title, options, row, number_of_rows):
    width, height = options.size
    main_views = [view_of_everything(mesh, *view, width / height, options.zoom)
                  for view in options.view or [(30.0, 40.0)]]
    views = [(view, (1, 1, 1)) for view in main_views]
    views += [(close_up(mesh, focus, main_views[0]), (0.97, 0.97, 0.97)) for focus in options.focus]
    font = max(12, height // 45)
    for column, (view, background) in enumerate(views):
        renderer = scene(mesh, view, background)
        place, counts = (column, row), (len(views), number_of_rows)
        (x, y), (columns, rows) = (place[::-1], counts[::-1]) if options.beside else (place, counts)
        renderer.SetViewport(x / columns, 1 - (y + 1) / rows, (x + 1) / columns, 1 - y / rows)
        if column == 0:
            caption = f"{title}: {len(mesh.quads)} quadrangles" if title else f"{len(mesh.quads)} quadrangles"
            renderer.AddActor2D(text(caption, font, height - 2.2 * font, int(1.2 * font), bold=True))
            add_legend(renderer, mesh, font)
        yield renderer


def main():
    options = arguments()
    *models, picture = options.files
    titles = options.title + [""] * (len(models) - len(options.title))
    renderers = []
    for row, (model, title) in enumerate(zip(models, titles)):
        renderers += scenes_of(QuadMesh(model), title, options, row, len(models))
    counts = [len(renderers) // len(models), len(models)]
    columns, rows = counts[::-1] if options.beside else counts
    write_picture(renderers, [options.size[0] * columns, options.size[1] * rows], picture)


if __name__ == "__main__":
    main()
