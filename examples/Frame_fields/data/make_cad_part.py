#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds and meshes a bearing flange with a side port, the CAD part of the Frame_fields examples.

Writes flange.off (a closed triangle mesh, millimetres) and flange.feat (its feature edges, two 0-based
vertex indices a line). The part is our own design; every wedge of it is an ordinary machining detail:

  toes of the ribs              18 and 40 degrees
  ledges of the wrench flats    12 and 28 degrees (a plane cutting a cylinder close to its side)
  flats cutting the chamfer     23 degrees
  run-out of the ramped slots    8 degrees
  taper of the guide wedges      3 degrees
  bolt pads and port web         0 degrees (a cylinder tangent to a flat side)

Needs Debian's python3-gmsh (gmsh with its OpenCASCADE kernel). Run it with /usr/bin/python3.
"""

import argparse
import math
import os
from collections import defaultdict

import gmsh

PLATE_LENGTH, PLATE_WIDTH, PLATE_TOP = 130.0, 90.0, 10.0
CORNER_RADIUS = 12.0  # of the plate's corners and of the bolt pads, which are coaxial
PAD_TOP = 13.0
BOLT_RADIUS = 4.5
HUB_RADIUS, HUB_TOP, LEDGE_HEIGHT = 24.0, 50.0, 39.0
BORE_RADIUS, SEAT_RADIUS, SEAT_DEPTH = 14.0, 18.0, 11.0
PORT_RADIUS, PORT_HEIGHT, PORT_END, PORT_BORE_RADIUS = 9.0, 28.0, 52.0, 5.0
WEB_END = 41.0
FOOT_FILLET = 3.0

SHARP_DIHEDRAL = 20.0  # degrees; a CAD curve bent less than this is smooth
SMALL_ANGLE = 45.0  # degrees; corners below this are refined and listed
LARGEST_EDGE = 4.5
TIP_EDGE = 0.8  # at small corners
WEDGE_WIDTH = 8.0  # mean width; narrower faces with a small corner are wedges, and get small edges all along:
WEDGE_EDGE = (0.6, 1.2)  # FINENESS times the width of the wedge, in this range
FINENESS = 0.8
GROWTH = 1.0  # of the edge length per unit of distance from these places
EDGES_PER_TURN = 16  # on curved faces

occ = gmsh.model.occ


# ---------------------------------------------------------------- the solid

def box(x_range, y_range, z_range):
    (x0, x1), (y0, y1), (z0, z1) = x_range, y_range, z_range
    return occ.addBox(x0, y0, z0, x1 - x0, y1 - y0, z1 - z0)


def upright_cylinder(radius, z0, z1, x=0.0, y=0.0):
    return occ.addCylinder(x, y, z0, 0, 0, z1 - z0, radius)


def upright_cone(radius0, radius1, z0, z1, x=0.0, y=0.0):
    return occ.addCone(x, y, z0, 0, 0, z1 - z0, radius0, radius1)


def prism(profile, thickness, turn=0.0):
    """The (x, z) polygon `profile`, `thickness` wide in y about y = 0, turned about the z axis."""
    points = [occ.addPoint(x, -thickness / 2, z) for x, z in profile]
    lines = [occ.addLine(p, q) for p, q in zip(points, points[1:] + points[:1])]
    face = occ.addPlaneSurface([occ.addCurveLoop(lines)])
    volume = next(tag for dim, tag in occ.extrude([(2, face)], 0, thickness, 0) if dim == 3)
    occ.rotate([(3, volume)], 0, 0, 0, 0, 0, 1, math.radians(turn))
    return volume


def moved(volume, x, y):
    occ.translate([(3, volume)], x, y, 0)
    return volume


def fused(body, tools):
    return occ.fuse([(3, body)], [(3, t) for t in tools])[0][0][1]


def drilled(body, tools):
    return occ.cut([(3, body)], [(3, t) for t in tools])[0][0][1]


def curves_where(body, accepts):
    """The curves of `body` whose bounding box satisfies accepts(low, high)."""
    occ.synchronize()
    curves = []
    for dim, tag in gmsh.model.getBoundary(
            gmsh.model.getBoundary([(3, body)], oriented=False), combined=False, oriented=False):
        bounds = gmsh.model.getBoundingBox(dim, tag)
        if tag not in curves and accepts(bounds[:3], bounds[3:]):
            curves.append(tag)
    return curves


def is_vertical(low, high):
    return high[2] - low[2] > 1 and high[0] - low[0] < 1e-3 and high[1] - low[1] < 1e-3


def lies_at_height(z):
    return lambda low, high: abs(low[2] - z) < 1e-3 and abs(high[2] - z) < 1e-3


def is_hub_foot(low, high):
    centre_reach = max(abs(c) for c in low[:2] + high[:2])
    return lies_at_height(PLATE_TOP)(low, high) and centre_reach < HUB_RADIUS + 1e-3 and high[0] - low[0] > 5


def base_plate():
    half_length, half_width = PLATE_LENGTH / 2, PLATE_WIDTH / 2
    plate = box((-half_length, half_length), (-half_width, half_width), (0, PLATE_TOP))
    plate = occ.fillet([plate], curves_where(plate, is_vertical), [CORNER_RADIUS])[0][1]
    bottom = curves_where(plate, lies_at_height(0))
    faces = [gmsh.model.getAdjacencies(1, curve)[0][0] for curve in bottom]
    return occ.chamfer([plate], bottom, faces, [1.5])[0][1]


def bolt_centres():
    x, y = PLATE_LENGTH / 2 - CORNER_RADIUS, PLATE_WIDTH / 2 - CORNER_RADIUS
    return [(sx * x, sy * y) for sx in (-1, 1) for sy in (-1, 1)]


def bolt_pad(x, y):
    """Its seam stands on a line where it is tangent to the plate's side: elsewhere OpenCASCADE's fuse fails."""
    pad = upright_cylinder(CORNER_RADIUS, PLATE_TOP, PAD_TOP, x, y)
    occ.rotate([(3, pad)], x, y, 0, 0, 0, 1, 0 if x > 0 else math.pi)
    return pad


def rib(toe_angle, toe_radius, thickness, turn):
    inside = HUB_RADIUS - 3
    rise = (toe_radius - inside) * math.tan(math.radians(toe_angle))
    return prism([(toe_radius, PLATE_TOP), (inside, PLATE_TOP + rise), (inside, PLATE_TOP)], thickness, turn)


def guide_wedge(angle, heel, tip, thickness, y):
    rise = (tip - heel) * math.tan(math.radians(angle))
    return moved(prism([(heel, PLATE_TOP), (tip, PLATE_TOP), (heel, PLATE_TOP + rise)], thickness), 0, y)


def ramped_slot(angle, run_out, width, y):
    """A slot that opens at the plate's end x < 0 and runs out on its top at x = run_out."""
    end, clearance = -PLATE_LENGTH / 2 - 1, 5
    depth = (run_out - end) * math.tan(math.radians(angle))
    profile = [(end, PLATE_TOP - depth), (run_out, PLATE_TOP), (run_out, PLATE_TOP + clearance),
               (end, PLATE_TOP + clearance)]
    return moved(prism(profile, width), 0, y)


def wrench_flat(ledge_angle, turn):
    """Cuts the upper hub so that the ledge left below has corners of `ledge_angle`."""
    near = HUB_RADIUS * math.cos(math.radians(ledge_angle))
    far = HUB_RADIUS + 5
    return prism([(near, LEDGE_HEIGHT), (far, LEDGE_HEIGHT), (far, HUB_TOP + 1), (near, HUB_TOP + 1)],
                 2 * HUB_RADIUS, turn)


def hub():
    chamfer = 2.0
    shaft = upright_cylinder(HUB_RADIUS, PLATE_TOP / 2, HUB_TOP - chamfer)
    rim = upright_cone(HUB_RADIUS, HUB_RADIUS - chamfer, HUB_TOP - chamfer, HUB_TOP)
    return fused(shaft, [rim])


def port_and_web():
    chamfer = 1.5
    pipe = occ.addCylinder(0, 0, PORT_HEIGHT, PORT_END - chamfer, 0, 0, PORT_RADIUS)
    rim = occ.addCone(PORT_END - chamfer, 0, PORT_HEIGHT, chamfer, 0, 0, PORT_RADIUS, PORT_RADIUS - chamfer)
    web = box((0, WEB_END), (-PORT_RADIUS, PORT_RADIUS), (PLATE_TOP / 2, PORT_HEIGHT))
    return fused(web, [pipe, rim])


def bolt_hole(x, y):
    countersink = 2.5
    return [upright_cylinder(BOLT_RADIUS, -1, PAD_TOP + 1, x, y),
            upright_cone(BOLT_RADIUS, BOLT_RADIUS + countersink, PAD_TOP - countersink, PAD_TOP, x, y)]


def bores():
    chamfer = 1.0
    return [upright_cylinder(BORE_RADIUS, -1, HUB_TOP),
            upright_cylinder(SEAT_RADIUS, HUB_TOP - SEAT_DEPTH, HUB_TOP + 1),
            upright_cone(SEAT_RADIUS, SEAT_RADIUS + chamfer, HUB_TOP - chamfer, HUB_TOP),
            upright_cylinder(BORE_RADIUS + 8, -1, 3),
            occ.addCylinder(0, 0, PORT_HEIGHT, PORT_END + 1, 0, 0, PORT_BORE_RADIUS)]


def flange():
    pads = [bolt_pad(x, y) for x, y in bolt_centres()]
    ribs = [rib(18, 58, 8, 180), rib(40, 42, 8, 90), rib(40, 42, 8, -90)]
    wedges = [guide_wedge(3, 29, 60, 6, y) for y in (-16, 16)]
    body = fused(base_plate(), [hub(), port_and_web()] + pads + ribs + wedges)
    body = occ.fillet([body], curves_where(body, is_hub_foot), [FOOT_FILLET])[0][1]
    slots = [ramped_slot(8, -31, 9, y) for y in (-14, 14)]
    flats = [wrench_flat(angle, turn) for angle, turn in ((12, 0), (28, 90), (12, 180), (28, 270))]
    holes = [tool for x, y in bolt_centres() for tool in bolt_hole(x, y)]
    return drilled(body, slots + flats + holes + bores())



# ---------------------------------------------------------------- the mesh

def mesh_triangles():
    """(CAD face, node tags of a triangle) for all triangles; their normals point out of the solid."""
    triangles = []
    for _, face in gmsh.model.getEntities(2):
        _, _, nodes = gmsh.model.mesh.getElements(2, face)
        flat = [int(n) for n in nodes[0]]
        triangles += [(face, tuple(flat[i:i + 3])) for i in range(0, len(flat), 3)]
    return triangles


def mesh_positions():
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    return {int(tag): tuple(coordinates[3 * i:3 * i + 3]) for i, tag in enumerate(tags)}


def vector(p, q):
    return tuple(y - x for x, y in zip(p, q))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def angle_between(a, b):
    dot = sum(x * y for x, y in zip(a, b))
    return math.degrees(math.atan2(math.hypot(*cross(a, b)), dot))


def corner_angle(apex, p, q):
    return angle_between(vector(apex, p), vector(apex, q))


def small_corners():
    """{CAD face: its CAD points where it has a corner below SMALL_ANGLE}, measured on the current mesh."""
    positions = mesh_positions()
    point_of_node = {int(gmsh.model.mesh.getNodes(0, tag)[0][0]): tag for _, tag in gmsh.model.getEntities(0)}
    angles = defaultdict(float)
    for face, nodes in mesh_triangles():
        for i, node in enumerate(nodes):
            if node in point_of_node:
                others = nodes[(i + 1) % 3], nodes[(i + 2) % 3]
                angles[face, point_of_node[node]] += corner_angle(positions[node], *(positions[n] for n in others))
    corners = defaultdict(list)
    for (face, point), angle in angles.items():
        if angle < SMALL_ANGLE:
            corners[face].append(point)
    return corners


def width_of_face(face):
    curves = gmsh.model.getBoundary([(2, face)], oriented=False)
    return 2 * occ.getMass(2, face) / sum(occ.getMass(1, tag) for _, tag in curves)


def size_growing_from(edge_length, points=(), curves=()):
    """A field of mesh sizes: `edge_length` at the given entities, growing to LARGEST_EDGE away from them."""
    field = gmsh.model.mesh.field
    distance, size = field.add("Distance"), field.add("Threshold")
    field.setNumbers(distance, "NodesList", points)
    field.setNumbers(distance, "EdgesList", curves)
    field.setNumber(distance, "NNodesByEdge", 100)
    for option, value in (("IField", distance), ("LcMin", edge_length), ("LcMax", LARGEST_EDGE), ("DistMin", 0),
                          ("DistMax", (LARGEST_EDGE - edge_length) / GROWTH)):
        field.setNumber(size, option, value)
    return size


def refine_at(corners):
    tips = sorted({point for points in corners.values() for point in points})
    sizes = [size_growing_from(TIP_EDGE, points=tips)]
    for face in sorted(corners):
        width = width_of_face(face)
        if width < WEDGE_WIDTH:
            curves = [tag for _, tag in gmsh.model.getBoundary([(2, face)], oriented=False)]
            sizes.append(size_growing_from(min(max(FINENESS * width, WEDGE_EDGE[0]), WEDGE_EDGE[1]), curves=curves))
    smallest = gmsh.model.mesh.field.add("Min")
    gmsh.model.mesh.field.setNumbers(smallest, "FieldsList", sizes)
    gmsh.model.mesh.field.setAsBackgroundMesh(smallest)


def mesh_solid(body):
    gmsh.model.mesh.setOutwardOrientation(body)
    for option, value in (("Mesh.MeshSizeMax", LARGEST_EDGE), ("Mesh.MeshSizeFromCurvature", EDGES_PER_TURN),
                          ("Mesh.MeshSizeExtendFromBoundary", 0), ("Mesh.Algorithm", 6),
                          ("Mesh.RandomSeed", 1), ("General.NumThreads", 1)):
        gmsh.option.setNumber(option, value)
    gmsh.model.mesh.generate(2)
    refine_at(small_corners())
    gmsh.model.mesh.clear()
    gmsh.model.mesh.generate(2)


def is_seam(curve):
    """Whether the curve only closes a face on itself, as a cylinder's seam does."""
    return len(gmsh.model.getAdjacencies(1, curve)[0]) < 2


def indexed_mesh():
    """Positions, triangles and the edges of every CAD curve that is no seam, all by 0-based vertex index."""
    positions = mesh_positions()
    triangles = [nodes for _, nodes in mesh_triangles()]
    index = {node: i for i, node in enumerate(sorted({n for t in triangles for n in t}))}
    curves = []
    for _, curve in gmsh.model.getEntities(1):
        if not is_seam(curve):
            ends = [index[int(n)] for n in gmsh.model.mesh.getElements(1, curve)[2][0]]
            curves.append([tuple(sorted(ends[i:i + 2])) for i in range(0, len(ends), 2)])
    return ([positions[node] for node in index], [tuple(index[n] for n in t) for t in triangles], curves)


# ---------------------------------------------------------------- its features and sectors

def edges_of(triangle):
    return [tuple(sorted((triangle[i], triangle[(i + 1) % 3]))) for i in range(3)]


def triangles_at_edges(triangles):
    at_edge = defaultdict(list)
    for t, triangle in enumerate(triangles):
        for edge in edges_of(triangle):
            at_edge[edge].append(t)
    return at_edge


def feature_edges(points, triangles, curves):
    """The edges of the CAD curves whose mean dihedral angle exceeds SHARP_DIHEDRAL: whole curves, no broken chains."""
    normals = [cross(vector(points[a], points[b]), vector(points[a], points[c])) for a, b, c in triangles]
    at_edge = triangles_at_edges(triangles)

    def mean_dihedral(curve):
        return sum(angle_between(*(normals[t] for t in at_edge[edge])) for edge in curve) / len(curve)

    return sorted({edge for curve in curves if mean_dihedral(curve) > SHARP_DIHEDRAL for edge in curve})


def sector_angles(points, triangles, features):
    """[(angle, vertex)] of the corners left at the ends of features when the mesh is cut along them."""
    at_edge, features = triangles_at_edges(triangles), set(features)
    unseen = {(t, v) for t, triangle in enumerate(triangles) for v in triangle
              if any(v in edge and edge in features for edge in edges_of(triangle))}
    sectors = []
    while unseen:
        stack, angle = [unseen.pop()], 0.0
        visited = set(stack)
        while stack:
            t, v = stack.pop()
            angle += corner_angle(points[v], *(points[w] for w in triangles[t] if w != v))
            for edge in edges_of(triangles[t]):
                if v in edge and edge not in features:
                    for neighbour in at_edge[edge]:
                        if (neighbour, v) not in visited:
                            visited.add((neighbour, v))
                            stack.append((neighbour, v))
        unseen -= visited
        sectors.append((angle, v))
    return sorted(sectors)


# ---------------------------------------------------------------- the files

def write_off(path, points, triangles):
    with open(path, "w") as out:
        out.write(f"OFF\n# made by make_cad_part.py\n{len(points)} {len(triangles)} 0\n")
        out.writelines("%.9g %.9g %.9g\n" % p for p in points)
        out.writelines("3 %d %d %d\n" % t for t in triangles)


def write_features(path, features):
    with open(path, "w") as out:
        out.write("# Feature edges of flange.off, made by make_cad_part.py: two 0-based vertex indices a line.\n")
        out.write(f"# All edges of the CAD curves whose dihedral angle exceeds {SHARP_DIHEDRAL:g} degrees.\n")
        out.writelines("%d %d\n" % edge for edge in features)


def without_negative_zeros(points):
    return [tuple(round(c, 6) + 0.0 for c in p) for p in points]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output-dir", default=os.path.dirname(os.path.abspath(__file__)))
    directory = parser.parse_args().output_dir

    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    body = flange()
    occ.synchronize()
    mesh_solid(body)
    points, triangles, curves = indexed_mesh()
    gmsh.finalize()

    points = without_negative_zeros(points)
    features = feature_edges(points, triangles, curves)
    write_off(os.path.join(directory, "flange.off"), points, triangles)
    write_features(os.path.join(directory, "flange.feat"), features)

    small = [angle for angle, _ in sector_angles(points, triangles, features) if angle < SMALL_ANGLE]
    print(f"{len(triangles)} faces, {len(points)} vertices, {len(features)} feature edges")
    print(f"{len(small)} corners below {SMALL_ANGLE:g} degrees:", " ".join(f"{angle:.1f}" for angle in small))


if __name__ == "__main__":
    main()
