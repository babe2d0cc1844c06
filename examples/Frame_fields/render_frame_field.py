#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Renders a frame field written by the Frame_fields example programs (VTK XML PolyData) to a PNG picture.

    xvfb-run -a /usr/bin/python3 render_frame_field.py FIELD.vtp OUT.png --focus-sharpest

Needs Debian's python3-vtk9 and python3-numpy, and xvfb where there is no display. z is up. The second
viewport shows a close-up of a place given by --focus, or of a sharp corner chosen by --focus-sharpest. The
field is drawn as streamlines if the file has some (cad_frame_field --streamlines), and as crosses otherwise.
"""

import argparse
import sys
from collections import defaultdict

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

SURFACE, FEATURE, FOCUS = (0.98, 0.97, 0.94), (0.13, 0.13, 0.15), (0.1, 0.1, 0.1)
BRANCH_U, BRANCH_V = (0.00, 0.50, 0.62), (0.86, 0.36, 0.04)
CORNER, POSITIVE, NEGATIVE, UNMESHABLE = (0.98, 0.73, 0.0), (0.85, 0.05, 0.08), (0.10, 0.25, 0.95), (0.95, 0.0, 0.75)
FEWEST_FOCUS_FACES = 20
VERTICAL = np.array([0.0, 0.0, 1.0])


def configured(vtk_object, **settings):
    """Calls vtk_object.SetName(value) for every setting Name=value, and returns the object."""
    for name, value in settings.items():
        getattr(vtk_object, "Set" + name)(value)
    return vtk_object


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


# ---------------------------------------------------------------- the field

class Field:
    """The arrays of a field file, and the neighbours of its faces across edges that are not features."""

    def __init__(self, path):
        reader = configured(vtk.vtkXMLPolyDataReader(), FileName=path)
        reader.Update()
        data = reader.GetOutput()
        if not data.GetNumberOfPolys():
            raise SystemExit(f"no faces in {path}")

        def cells(kind, size):
            return vtk_to_numpy(kind.GetConnectivityArray()).reshape(-1, size)

        self.points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        self.verts = cells(data.GetVerts(), 1)[:, 0]
        self.features, self.streamlines = self.lines_of(data)
        self.triangles = cells(data.GetPolys(), 3)

        def of_verts(name):
            return vtk_to_numpy(data.GetCellData().GetArray(name))[:len(self.verts)]

        def of_faces(name):
            return vtk_to_numpy(data.GetCellData().GetArray(name))[-len(self.triangles):].copy()

        self.index = of_verts("index")
        self.sharp, self.interior = of_verts("sharp_corner") == 1, of_verts("interior") == 1
        self.u, self.v = of_faces("u"), of_faces("v")
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        self.centroids = (a + b + c) / 3
        self.area_vectors = np.cross(b - a, c - a) / 2
        self.normals = unit(self.area_vectors)
        self.diagonal = np.linalg.norm(np.ptp(self.points, axis=0))
        self.neighbours = self.find_neighbours()
        self.give_branches_consistent_names()

    @staticmethod
    def lines_of(data):
        """Feature edges as pairs of points, and for both branch pairs a list of streamlines."""
        ends = vtk_to_numpy(data.GetLines().GetOffsetsArray())
        lines = np.split(vtk_to_numpy(data.GetLines().GetConnectivityArray()), ends[1:-1])
        kinds = data.GetCellData().GetArray("streamline")
        first = data.GetNumberOfVerts()
        kinds = vtk_to_numpy(kinds)[first:first + len(ends) - 1] if kinds else np.zeros(len(ends) - 1)
        features = [line for line, kind in zip(lines, kinds) if kind == 0]
        return (np.array(features, dtype=np.int64).reshape(-1, 2),
                [[line for line, kind in zip(lines, kinds) if kind == pair] for pair in (1, 2)])

    def find_neighbours(self):
        features = {frozenset(edge) for edge in self.features.tolist()}
        faces_at = defaultdict(list)
        for face, (a, b, c) in enumerate(self.triangles.tolist()):
            for edge in (frozenset((a, b)), frozenset((b, c)), frozenset((c, a))):
                if edge not in features:
                    faces_at[edge].append(face)
        neighbours = [[] for _ in self.triangles]
        for edge, faces in faces_at.items():
            for face in faces:
                neighbours[face] += [(other, edge) for other in faces if other != face]
        return neighbours

    def give_branches_consistent_names(self):
        """Swaps u and v where that makes the colours of neighbouring crosses agree; singularities leave seams."""
        unseen = set(range(len(self.triangles)))
        while unseen:
            queue = [unseen.pop()]
            for face in queue:
                for other, _ in self.neighbours[face]:
                    if other in unseen:
                        unseen.remove(other)
                        queue.append(other)
                        dots = np.abs(np.stack([self.u[face], self.v[face]])
                                      @ np.stack([self.u[other], self.v[other]]).T)
                        if dots[0, 1] + dots[1, 0] > dots[0, 0] + dots[1, 1]:
                            self.u[other], self.v[other] = self.v[other].copy(), self.u[other].copy()

    def patch(self, seeds, through=None):
        """The faces reached from `seeds` without crossing a feature; only across edges at vertex `through` if given."""
        reached, stack = set(seeds), list(seeds)
        while stack:
            for other, edge in self.neighbours[stack.pop()]:
                if other not in reached and (through is None or through in edge):
                    reached.add(other)
                    stack.append(other)
        return sorted(reached)


# ---------------------------------------------------------------- where to look

class View:
    """A parallel camera: `toward` points from `centre` to the viewer; `reach` is half the height that is seen."""

    def __init__(self, centre, toward, up, reach):
        self.centre, self.toward, self.reach = centre, unit(toward), reach
        self.right = unit(np.cross(up, self.toward))
        self.up = np.cross(self.toward, self.right)

    def apply_to(self, renderer, distance):
        configured(renderer.GetActiveCamera(), ParallelProjection=True, FocalPoint=self.centre,
                   Position=self.centre + distance * self.toward, ViewUp=self.up, ParallelScale=self.reach,
                   ClippingRange=(0.01 * distance, 2 * distance))


def view_of_everything(field, azimuth, elevation, aspect, zoom):
    azimuth, elevation = np.radians([azimuth, elevation])
    toward = np.array([np.cos(elevation) * np.sin(azimuth), -np.cos(elevation) * np.cos(azimuth), np.sin(elevation)])
    view = View(np.zeros(3), toward, VERTICAL, 1)
    axes = np.stack([view.right, view.up])
    shadow = field.points @ axes.T
    low, high = shadow.min(axis=0), shadow.max(axis=0)
    depth = field.points.mean(axis=0) @ view.toward
    view.centre = (low + high) / 2 @ axes + depth * view.toward
    view.reach = max((high - low) / 2 / [aspect, 1]) * 1.08 / zoom
    return view


class Sector:
    """A fan of faces around a sharp corner, cut off by feature edges."""

    def __init__(self, field, tip, fan):
        self.tip = field.points[tip]
        arms = [unit(field.points[[p for p in field.triangles[f] if p != tip]] - self.tip) for f in fan]
        self.angle = sum(np.arccos(np.clip(a @ b, -1, 1)) for a, b in arms)
        self.normal = unit(field.area_vectors[fan].sum(axis=0))
        self.bisector = unit(sum(a + b for a, b in arms))
        self.patch = field.patch(fan)

    def fills(self, field, radius):
        """Whether its patch has enough faces near the corner and is nearly as large there as a straight wedge."""
        near = [f for f in self.patch if np.linalg.norm(field.centroids[f] - self.tip) < radius]
        area = np.linalg.norm(field.area_vectors[near], axis=1).sum()
        return len(near) >= FEWEST_FOCUS_FACES and 0.6 < area / (self.angle / 2 * radius ** 2) < 1.4


def sharp_sectors(field):
    incident = defaultdict(list)
    for face, triangle in enumerate(field.triangles.tolist()):
        for p in triangle:
            incident[p].append(face)
    for tip in sorted(set(field.verts[field.sharp].tolist())):
        faces = set(incident[tip])
        while faces:
            fan = field.patch([min(faces)], through=tip)
            faces -= set(fan)
            yield Sector(field, tip, fan)


def half_way(normal, main_view):
    """Close-ups look nearly along the normal, but from the side of the main view, so that the relief shows."""
    return unit(3 * normal + main_view.toward)


def view_of_place(field, place, radius, main_view):
    """Faces the sharpest corner at that place, or else the nearest face; of those that the main view faces."""
    corners = [s for s in sharp_sectors(field)
               if np.linalg.norm(s.tip - place) < 0.25 * radius and s.normal @ main_view.toward > 0.25]
    if corners:
        normal = min(corners, key=lambda s: s.angle).normal
    else:
        seen = np.flatnonzero(field.normals @ main_view.toward > 0.25)
        normal = field.normals[seen[np.argmin(np.linalg.norm(field.centroids[seen] - place, axis=1))]]
    return View(place, half_way(normal, main_view), main_view.up, radius)


def view_of_sharpest_corner(field, surface, main_view, aspect):
    """Of the wedges that both views see freely, the one with the smallest angle that is not tiny, and that angle."""
    locator = configured(vtk.vtkStaticCellLocator(), DataSet=surface)
    locator.BuildLocator()

    def is_visible(sector, toward):
        start = sector.tip + 0.02 * field.diagonal * sector.bisector + 0.002 * field.diagonal * sector.normal
        hit = locator.IntersectWithLine(start, start + 2 * field.diagonal * toward, 1e-9, vtk.mutable(0.0),
                                        [0] * 3, [0] * 3, vtk.mutable(0))
        return not hit

    sectors = [s for s in sharp_sectors(field) if s.normal @ main_view.toward > 0.25
               and is_visible(s, main_view.toward) and is_visible(s, half_way(s.normal, main_view))]
    for lowest, highest in np.radians([(10, 45), (3, 60), (0, 180)]):
        for reach in field.diagonal * np.array([0.045, 0.03, 0.015]):
            wedges = [s for s in sectors if lowest <= s.angle <= highest and s.fills(field, reach)]
            if wedges:
                best = min(wedges, key=lambda s: (round(s.angle, 3), -s.normal @ main_view.toward))
                toward = half_way(best.normal, main_view)
                up = np.cross(toward, best.bisector)
                centre = best.tip + 0.7 * min(aspect, 1) * reach * best.bisector
                return View(centre, toward, up if up @ main_view.up >= 0 else -up, reach), best.angle
    return None, 0


# ---------------------------------------------------------------- what to draw

def poly_data(points, lines=None, polygons=None):
    """Lines and polygons are lists of point numbers each, of any lengths."""
    data = vtk.vtkPolyData()
    data.SetPoints(configured(vtk.vtkPoints(), Data=numpy_to_vtk(np.ascontiguousarray(points), deep=True)))
    for cells, set_cells in ((lines, data.SetLines), (polygons, data.SetPolys)):
        if cells is not None:
            ends = np.cumsum([0] + [len(cell) for cell in cells])
            array = vtk.vtkCellArray()
            array.SetData(*(numpy_to_vtkIdTypeArray(numbers.astype(np.int64), deep=True)
                            for numbers in (ends, np.concatenate(cells))))
            set_cells(array)
    return data


def actor(source, colour, **shading):
    mapper = configured(vtk.vtkPolyDataMapper(), InputConnection=source.GetOutputPort(), ScalarVisibility=False)
    result = configured(vtk.vtkActor(), Mapper=mapper)
    configured(result.GetProperty(), Color=colour, **(dict(Ambient=0.42, Diffuse=0.7, SpecularPower=30) | shading))
    return result


def shaded_surface(surface):
    return actor(configured(vtk.vtkPolyDataNormals(), InputData=surface, FeatureAngle=25, Consistency=False), SURFACE)


def tubes(points, segments, radius, colour, **shading):
    source = configured(vtk.vtkTubeFilter(), InputData=poly_data(points, lines=segments), Radius=radius,
                        NumberOfSides=8, Capping=True)
    return actor(source, colour, **shading)


def glyphs(points, shape, colour, **shading):
    source = configured(vtk.vtkGlyph3D(), InputData=poly_data(points), SourceConnection=shape.GetOutputPort(),
                        Scaling=False)
    return actor(source, colour, **shading)


def spheres(points, radius, colour):
    ball = configured(vtk.vtkSphereSource(), Radius=radius, ThetaResolution=24, PhiResolution=24)
    return glyphs(points, ball, colour, Specular=0.4)


def rings(points, view, inner, outer, colour):
    """Flat rings that face the viewer and float above the surface by their own radius."""
    disk = configured(vtk.vtkDiskSource(), InnerRadius=inner, OuterRadius=outer, CircumferentialResolution=48)
    frame = np.eye(4)
    frame[:3, :3] = np.stack([view.right, view.up, view.toward], axis=1)
    turned = configured(vtk.vtkTransformPolyDataFilter(), InputConnection=disk.GetOutputPort(),
                        Transform=configured(vtk.vtkTransform(), Matrix=frame.ravel()))
    return glyphs(points + outer * view.toward, turned, colour, Lighting=False)


def candidate_places(field, view, spacing):
    """(faces, points): the centroids of the faces turned to the viewer, then further points of the large ones."""
    random = np.random.default_rng(1)
    faces = random.permutation(np.flatnonzero(field.normals @ view.toward > 0.3))
    extra = np.repeat(faces, (4 * np.linalg.norm(field.area_vectors[faces], axis=1) / spacing ** 2).astype(int))
    weights = 0.1 + 0.7 * random.dirichlet([1, 1, 1], len(extra))
    inside = np.einsum("ij,ijk->ik", weights, field.points[field.triangles[extra]])
    return np.concatenate([faces, extra]), np.concatenate([field.centroids[faces], inside])


def well_spread_places(field, view, spacing):
    """Of the candidate places those that are no closer to one another than `spacing`."""
    faces, points = candidate_places(field, view, spacing)
    chosen, taken = [], defaultdict(list)
    for place, (i, j, k) in enumerate(np.floor(points / spacing).astype(int).tolist()):
        near = [other for x in (i - 1, i, i + 1) for y in (j - 1, j, j + 1) for z in (k - 1, k, k + 1)
                for other in taken.get((x, y, z), ())]
        if not near or np.linalg.norm(points[near] - points[place], axis=1).min() >= spacing:
            taken[i, j, k].append(place)
            chosen.append(place)
    return faces[chosen], points[chosen]


def crosses(field, view, spacing):
    faces, points = well_spread_places(field, view, spacing)
    arm, thickness = 0.44 * spacing, 0.06 * spacing
    points = points + 1.2 * thickness * field.normals[faces]
    segments = np.arange(2 * len(faces)).reshape(2, -1).T
    return [tubes(np.concatenate([points - arm * branch[faces], points + arm * branch[faces]]), segments, thickness,
                  colour, Ambient=0.8, Diffuse=0.3) for branch, colour in ((field.u, BRANCH_U), (field.v, BRANCH_V))]


def streamlines(field, radius):
    """Of both branch pairs, a little darker where the surface turns away."""
    return [tubes(field.points, lines, radius, colour, Ambient=0.8, Diffuse=0.3)
            for lines, colour in zip(field.streamlines, (BRANCH_U, BRANCH_V)) if lines]


def vert_groups(field):
    """(label, colour, relative size of its sphere or None for a ring, positions) of every kind of marked sector."""
    positions = field.points[field.verts]
    unmeshable = ~field.interior & (field.index >= 2)
    return [("sharp corner", CORNER, None, positions[field.sharp]),
            ("singularity, index > 0", POSITIVE, 1.0, positions[~field.sharp & ~unmeshable & (field.index > 0)]),
            ("singularity, index < 0", NEGATIVE, 1.0, positions[field.interior & (field.index < 0)]),
            ("unmeshable corner (index \u2265 1/2)", UNMESHABLE, 1.3, positions[unmeshable])]


def scene(field, surface, view, spacing, line_width=0.22, ball_size=1.5):
    """The radii of streamlines and singularities are given in percent of half the height of the view."""
    unit_size = view.reach / 100
    renderer = configured(vtk.vtkRenderer(), Background=(1, 1, 1))
    for position, intensity in (((-0.35, 0.6, 1.0), 0.7), ((0.9, -0.1, 0.5), 0.25)):
        light = configured(vtk.vtkLight(), Position=position, FocalPoint=(0, 0, 0), Intensity=intensity)
        light.SetLightTypeToCameraLight()
        renderer.AddLight(light)
    renderer.AddActor(shaded_surface(surface))
    if len(field.features):
        renderer.AddActor(tubes(field.points, field.features, 0.35 * unit_size, FEATURE))
    has_streamlines = any(field.streamlines)
    for branch in streamlines(field, line_width * unit_size) if has_streamlines else crosses(field, view, spacing):
        renderer.AddActor(branch)
    for _, colour, size, positions in vert_groups(field):
        if len(positions):
            radius = ball_size * unit_size
            renderer.AddActor(spheres(positions, size * radius, colour) if size else
                              rings(positions, view, 0.75 * radius, 1.05 * radius, colour))
    view.apply_to(renderer, 3 * field.diagonal)
    return renderer


# ---------------------------------------------------------------- the sheet around it

def text(content, x, y, size, bold=False):
    result = configured(vtk.vtkTextActor(), Input=content, Position=(x, y))
    configured(result.GetTextProperty(), FontSize=size, Color=(0.1, 0.1, 0.1), Bold=bold, BackgroundColor=(1, 1, 1),
               BackgroundOpacity=0.8)
    return result


def swatch(x, y, size, colour):
    corners = np.array([[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0]], dtype=float)
    square = poly_data(corners, polygons=np.array([[0, 1, 2, 3]]))
    result = configured(vtk.vtkActor2D(), Mapper=configured(vtk.vtkPolyDataMapper2D(), InputData=square),
                        Position=(x, y))
    result.GetProperty().SetColor(colour)
    return result


def add_legend(renderer, field, size):
    kind = "streamlines" if any(field.streamlines) else "crosses"
    entries = [("feature edge", FEATURE),
               (f"{kind}, branches \u00b1u", BRANCH_U), (f"{kind}, branches \u00b1v", BRANCH_V)]
    entries += [(f"{label}: {len(positions)}", colour) for label, colour, _, positions in vert_groups(field)]
    for line, (label, colour) in enumerate(reversed(entries)):
        y = size * (1 + 1.6 * line)
        renderer.AddActor2D(swatch(size, y, size, colour))
        renderer.AddActor2D(text(label, 2.5 * size, y, size))


def write_picture(renderers, size, path):
    window = configured(vtk.vtkRenderWindow(), OffScreenRendering=True, MultiSamples=8, Size=size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    grab = configured(vtk.vtkWindowToImageFilter(), Input=window, ReadFrontBuffer=False)
    configured(vtk.vtkPNGWriter(), FileName=path, InputConnection=grab.GetOutputPort()).Write()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("field", help="VTK XML PolyData file (.vtp)")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--title", default="")
    parser.add_argument("--size", nargs=2, type=int, default=[1800, 1000], metavar=("W", "H"))
    parser.add_argument("--view", nargs=2, type=float, default=[30, 40], metavar=("AZIMUTH", "ELEVATION"),
                        help="degrees")
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--cross-spacing", type=float, help="default: diagonal of the bounding box / 70")
    close_up = parser.add_mutually_exclusive_group()
    close_up.add_argument("--focus", nargs=4, type=float, metavar=("X", "Y", "Z", "RADIUS"))
    close_up.add_argument("--focus-sharpest", action="store_true")
    return parser.parse_args()


def close_up_view(options, field, surface, main_view, aspect):
    """The view of the close-up and its caption; no view if none is asked for or no corner suits."""
    if options.focus:
        return view_of_place(field, np.array(options.focus[:3]), options.focus[3], main_view), "close-up"
    if options.focus_sharpest:
        view, angle = view_of_sharpest_corner(field, surface, main_view, aspect)
        if view is None:
            print("no sharp corner suits a close-up: none is large enough and seen freely", file=sys.stderr)
        return view, f"sharp corner of {np.degrees(angle):.1f}\u00b0"
    return None, ""


def main():
    options = arguments()
    field = Field(options.field)
    surface = poly_data(field.points, polygons=field.triangles)
    width, height = options.size
    split = 0.6 if options.focus or options.focus_sharpest else 1.0
    font = max(12, height // 50)
    spacing = options.cross_spacing or field.diagonal / 70

    main_view = view_of_everything(field, *options.view, split * width / height, options.zoom)
    close_view, caption = close_up_view(options, field, surface, main_view, (1 - split) * width / height)
    if close_view is None and split < 1:
        split = 1.0
        main_view = view_of_everything(field, *options.view, width / height, options.zoom)

    main_scene = scene(field, surface, main_view, spacing)
    main_scene.SetViewport(0, 0, split, 1)
    main_scene.AddActor2D(text(options.title, font, height - 2.2 * font, int(1.3 * font), bold=True))
    add_legend(main_scene, field, font)
    scenes = [main_scene]
    if close_view is not None:
        main_scene.AddActor(rings(close_view.centre[None], main_view, close_view.reach, 1.04 * close_view.reach, FOCUS))
        close_scene = scene(field, surface, close_view, min(spacing, close_view.reach / 16))
        close_scene.SetViewport(split, 0, 1, 1)
        close_scene.SetBackground(0.97, 0.97, 0.97)
        close_scene.AddActor2D(text(caption, font, height - 2.2 * font, font))
        scenes.append(close_scene)
    write_picture(scenes, options.size, options.picture)


if __name__ == "__main__":
    main()
