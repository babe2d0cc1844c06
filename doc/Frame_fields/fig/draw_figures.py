#!/usr/bin/env python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the figures of the manual as SVG files beside this script.

    draw_figures.py [PROGRAM]

PROGRAM is the example program cad_frame_field. Without it, the two figures that show computed fields are left as they
are. Only the standard library of Python is needed.
"""
import math
import os
import subprocess
import sys
import tempfile

import planar_models

FOLDER = os.path.dirname(os.path.abspath(__file__))
INK, GRID, FEATURE, BRANCHES = "#222222", "#8a9bb0", "#111111", ("#1f6fb2", "#c0392b")
TINTS = ("#dbe8f4", "#fbe3d6", "#dff0d8")


class Picture:
    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def lines(self, pairs, color=INK, width=1.0):
        text = "".join("M%.1f %.1fL%.1f %.1f" % (p[0], p[1], q[0], q[1]) for p, q in pairs)
        self.parts.append('<path d="%s" fill="none" stroke="%s" stroke-width="%.2g" stroke-linecap="round"/>'
                          % (text, color, width))

    def line(self, p, q, color=INK, width=1.0):
        self.lines([(p, q)], color, width)

    def path(self, points, color=INK, width=1.0, fill="none", is_closed=False):
        text = "M" + " L".join("%.1f %.1f" % (x, y) for x, y in points) + (" Z" if is_closed else "")
        self.parts.append('<path d="%s" fill="%s" stroke="%s" stroke-width="%.2g" stroke-linejoin="round"/>'
                          % (text, fill, color, width))

    def dot(self, p, radius, color):
        self.parts.append('<circle cx="%.1f" cy="%.1f" r="%.1f" fill="%s"/>' % (p[0], p[1], radius, color))

    def text(self, p, words, size=13):
        self.parts.append('<text x="%.1f" y="%.1f" font-family="sans-serif" font-size="%d" text-anchor="middle" '
                          'fill="%s">%s</text>' % (p[0], p[1], size, INK, words))

    def write(self, name):
        with open(os.path.join(FOLDER, name), "w", encoding="utf-8") as file:
            file.write('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d">\n'
                       '<rect width="100%%" height="100%%" fill="white"/>\n%s\n</svg>\n'
                       % (self.width, self.height, self.width, self.height, "\n".join(self.parts)))


def polar(center, radius, degrees):
    angle = math.radians(degrees)
    return center[0] + radius * math.cos(angle), center[1] - radius * math.sin(angle)


def draw_quadrangle_fan(picture, center, side, directions):
    """Draws one subdivided quadrangle between each two directions that follow one another."""
    def corner(a, b, s, t):
        p, q = polar((0, 0), s, a), polar((0, 0), t, b)
        return center[0] + p[0] + q[0], center[1] + p[1] + q[1]

    cells = 4
    for a, b in zip(directions, directions[1:]):
        steps = [side * k / cells for k in range(cells + 1)]
        picture.lines([(corner(a, b, s, 0), corner(a, b, s, side)) for s in steps]
                      + [(corner(a, b, 0, s), corner(a, b, side, s)) for s in steps], GRID)


def draw_indices():
    picture = Picture(760, 325)
    for column, (label, directions) in enumerate([("1/2", [0, 30]), ("1/4", [0, 90]), ("0", [0, 90, 180]),
                                                  ("-1/4", [-90, 0, 90, 180])]):
        center = (95 + 190 * column, 95)
        if label == "1/2":
            center = (center[0] - 45, center[1] + 20)
            for angle in (0, 10, 20, 30):
                picture.line(center, polar(center, 100, angle), GRID)
            for radius in (25, 50, 75, 100):
                picture.path([polar(center, radius, angle) for angle in range(0, 31, 3)], GRID)
            end = 100
        else:
            end = 60
            draw_quadrangle_fan(picture, center, end, directions)
        for angle in (directions[0], directions[-1]):
            picture.line(center, polar(center, end, angle), FEATURE, 3.5)
        picture.dot(center, 5, BRANCHES[1])
        picture.text((95 + 190 * column, 178), "I = %s%s" % (label.replace("-", "\u2212"),
                                                             ", cannot be meshed" if label == "1/2" else ""))
    for column, (label, count) in enumerate([("1/4", 3), ("0", 4), ("-1/4", 5)]):
        center = (160 + 220 * column, 250)
        draw_quadrangle_fan(picture, center, 42, [90 + 360 * k / count for k in range(count + 1)])
        picture.dot(center, 5, BRANCHES[1])
        picture.text((center[0] + 88, 255), "I = " + label.replace("-", "\u2212"))
    picture.write("indices.svg")


def draw_sectors():
    picture = Picture(660, 230)
    rays = list(range(0, 360, 36))
    for column, (words, constrained) in enumerate([("no constrained edge: closed sector", []),
                                                   ("one constrained edge: one sector", [0]),
                                                   ("three constrained edges: three", [0, 108, 216])]):
        center, radius = (110 + 220 * column, 105), 80
        starts = constrained or [0]
        for k, start in enumerate(starts):
            end = (starts + [starts[0] + 360])[k + 1]
            fan = [polar(center, radius, angle) for angle in range(start, end + 1, 36)]
            picture.path([center] + fan, GRID, 1, TINTS[k], True)
            arc = [polar(center, 26, angle) for angle in range(start + (8 if constrained else 0),
                                                              end - (7 if constrained else -1), 4)]
            picture.path(arc, BRANCHES[0], 1.6)
        for angle in rays:
            picture.line(center, polar(center, radius, angle), GRID)
        for angle in constrained:
            picture.line(center, polar(center, radius, angle), FEATURE, 3.5)
        picture.dot(center, 4, INK)
        picture.text((center[0], 215), words, 12)
    picture.write("sectors.svg")


def draw_frame(picture, center, radius, alpha, rho):
    """Draws the four branches of a frame as arrows with their numbers."""
    for k in range(4):
        angle = alpha + 90 * k + (rho if k % 2 else 0)
        tip, color = polar(center, radius, angle), BRANCHES[k % 2]
        picture.lines([(center, tip)] + [(tip, polar(tip, 9, angle + 180 + side)) for side in (-25, 25)], color, 2.2)
        label = polar(center, radius + 13, angle)
        picture.text((label[0], label[1] + 4), str(k))


def draw_angle(picture, center, radius, first, last, words):
    picture.path([polar(center, radius, first + (last - first) * k / 24) for k in range(25)], INK, 1)
    label = polar(center, radius + 13, (first + last) / 2)
    picture.text((label[0], label[1] + 4), words)


def draw_halfedge(picture, source, target):
    picture.line(source, target, FEATURE, 2.6)
    angle = math.degrees(math.atan2(source[1] - target[1], target[0] - source[0]))
    picture.lines([(target, polar(target, 11, angle + 180 + side)) for side in (-25, 25)], FEATURE, 2.6)


def draw_branches():
    picture = Picture(760, 300)
    triangle, center = [(30, 250), (330, 250), (160, 20)], (165, 165)
    picture.path(triangle, GRID, 1, TINTS[0], True)
    draw_halfedge(picture, triangle[0], triangle[1])
    picture.lines([(polar(center, 8 * k, 0), polar(center, 8 * k + 4, 0)) for k in range(11)], GRID, 1.2)
    picture.lines([(polar(center, 8 * k, 115), polar(center, 8 * k + 4, 115)) for k in range(8)], GRID, 1.2)
    draw_frame(picture, center, 62, 25, 18)
    draw_angle(picture, center, 40, 0, 25, "\u03b1")
    draw_angle(picture, center, 50, 115, 133, "")
    picture.text(polar(center, 70, 121), "\u03c1")
    picture.text((180, 270), "halfedge(f)", 12)
    picture.text((180, 292), "the four branches of a face", 12)

    ends, faces = [(570, 245), (560, 25)], [(400, 150), (735, 120)]
    for apex, tint, words in zip(faces, TINTS, "ij"):
        picture.path(ends + [apex], GRID, 1, tint, True)
        picture.text((apex[0] + (24 if words == "i" else -24), apex[1] + 4), words)
    picture.line(ends[0], ends[1], GRID, 1.6)
    draw_frame(picture, (495, 140), 30, 12, 0)
    draw_frame(picture, (640, 130), 30, -84, 0)
    picture.text((570, 270), "matching 1: branch 0 of face i goes on as branch 1 of face j,", 12)
    picture.text((570, 287), "branch 1 as branch 2, and so on", 12)
    picture.write("branches.svg")


def read_ply(file_name):
    """Returns the elements of a PLY file in text form: for each name a list of dictionaries."""
    with open(file_name, encoding="ascii") as file:
        lines = iter(file.read().splitlines())
    header = []
    for line in lines:
        words = line.split()
        if words[0] == "element":
            header.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            header[-1][2].append((words[-1], words[1] == "list"))
        elif words[0] == "end_header":
            break
    elements = {}
    for name, count, properties in header:
        elements[name] = []
        for _ in range(count):
            words, record = iter(next(lines).split()), {}
            for key, is_list in properties:
                record[key] = [int(next(words)) for _ in range(int(next(words)))] if is_list else float(next(words))
            elements[name].append(record)
    return elements


def compute(program, model, options):
    ply = model + ".ply"
    subprocess.run([program, model, "--no-baseline", "--quiet", "--ascii", "-o", ply] + options, check=True)
    return read_ply(ply)


def draw_field(picture, field, origin, scale, cross):
    def place(vertex):
        return origin[0] + scale * vertex["x"], origin[1] - scale * vertex["y"]

    vertices = field["vertex"]
    faces = [next(value for value in face.values() if isinstance(value, list)) for face in field["face"]]
    number_of_faces, index = {}, {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            edge = (min(a, b), max(a, b))
            number_of_faces[edge] = number_of_faces.get(edge, 0) + 1
    for halfedge in field["halfedge"]:
        if halfedge["index"]:
            index[int(halfedge["target"])] = int(halfedge["index"])

    ends = {count: [(place(vertices[a]), place(vertices[b])) for (a, b), n in number_of_faces.items() if n == count]
            for count in (1, 2)}
    picture.lines(ends[2], "#d5dbe4", 0.6)
    picture.lines(ends[1], FEATURE, 2.2)
    for branch, color in zip("uv", BRANCHES):
        pairs = []
        for record, face in zip(field["face"], faces):
            center = place({axis: sum(vertices[v][axis] for v in face) / 3 for axis in "xy"})
            x, y = cross * record[branch + "x"], -cross * record[branch + "y"]
            pairs.append(((center[0] - x, center[1] - y), (center[0] + x, center[1] + y)))
        picture.lines(pairs, color, 1.1)
    for v, four_times_index in index.items():
        radius, color = (6.5, INK) if four_times_index >= 2 else (4.5, "#e08a00")
        picture.dot(place(vertices[v]), radius, color)


def draw_computed_fields(program):
    with tempfile.TemporaryDirectory() as folder:
        model = os.path.join(folder, "wedge.off")
        planar_models.sector(30, 18).write(model)
        fields = [compute(program, model, options)
                  for options in (["--support", "none", "--no-repair", "--no-relaxation"], [])]
    picture = Picture(760, 225)
    for column, (field, words) in enumerate(zip(fields, ("classical field: index 1/2 at the tip",
                                                         "this package: 1/4 at the tip and 1/4 inside"))):
        draw_field(picture, field, (15 + 385 * column, 190), 345, 5.2)
        picture.text((190 + 385 * column, 216), words, 13)
    picture.write("corner.svg")
    picture = Picture(120, 120)
    draw_field(picture, fields[1], (6, 92), 190, 3.2)
    picture.write("frame_fields_small.svg")


if __name__ == "__main__":
    draw_branches()
    draw_indices()
    draw_sectors()
    if len(sys.argv) > 1:
        draw_computed_fields(sys.argv[1])
