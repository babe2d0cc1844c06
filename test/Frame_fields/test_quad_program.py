#!/usr/bin/python3
"""Tests of the program cad_quad_mesh; see --help for the arguments."""

import collections
import itertools
import json
import math
import re
import struct
import unittest

import test_program
from test_program import (BAD_FILE, BAD_USAGE, CUBE_EDGES, CUBE_FACES, CUBE_POINTS, DONE, ProgramTest, cross,
                          difference, dot, flange, flange_features, norm, off_text, paths, python_with, read_features,
                          read_off, read_vtp, run)

LENGTH = 0.25  # of the edges on the cube, whose edges have length 1
FORMATS = ("obj", "off", "ply", "vtp", "msh")


# ---------------------------------------------------------------- files

def read_obj(text):
    """Points, faces and lines."""
    rows = [line.split() for line in text.splitlines()]
    numbers = {kind: [tuple(int(word) - 1 for word in row[1:]) for row in rows if row[0] == kind] for kind in "fl"}
    return [tuple(map(float, row[1:])) for row in rows if row[0] == "v"], numbers["f"], numbers["l"]


def read_quad_ply(content):
    """Points, features of vertices, faces and their patches."""
    header, body = content.split(b"end_header\n", 1)
    numbers = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    if b"format ascii" in header:
        rows = [line.split() for line in body.decode().splitlines()]
        vertices = [tuple(map(float, row[:3])) + (int(row[3]),) for row in rows[:numbers[0]]]
        faces = [tuple(map(int, row)) for row in rows[numbers[0]:]]
    else:
        vertex, face = struct.Struct("<3di"), struct.Struct("<B5i")
        end = numbers[0] * vertex.size
        vertices, faces = list(vertex.iter_unpack(body[:end])), list(face.iter_unpack(body[end:]))
    if len(faces) != numbers[1] or {face[0] for face in faces} != {4}:
        raise ValueError("the file holds other faces than quadrangles, or not as many as it says")
    return ([vertex[:3] for vertex in vertices], [vertex[3] for vertex in vertices], [face[1:5] for face in faces],
            [face[5] for face in faces])


class Msh:
    """A file of Gmsh 4.1, with vertices counted from 0; lines and quads are lists of (vertices, physical name)."""

    def __init__(self, text):
        sections = dict(re.findall(r"\$(\w+)\n(.*?)\$End\1\n", text, re.DOTALL))
        if sections["MeshFormat"] != "4.1 0 8\n":
            raise ValueError("this is no text file of Gmsh 4.1")
        self.names = {(int(dimension), int(tag)): name for dimension, tag, name in
                      re.findall(r'(\d) (\d+) "(.*)"', sections["PhysicalNames"])}
        self.read_nodes(self.rows(sections["Nodes"]))
        self.lines, self.quads = [], []
        self.read_elements(self.rows(sections["Elements"]))
        self.numbers_of_entities = next(self.rows(sections["Entities"]))

    @staticmethod
    def rows(section):
        return iter([[float(word) for word in line.split()] for line in section.splitlines()])

    def read_nodes(self, rows):
        number_of_blocks, number, first, last = next(rows)
        self.points = [None] * int(last)
        for _ in range(int(number_of_blocks)):
            tags = [next(rows) for _ in range(int(self.block_size(next(rows))))]
            for tag, in tags:
                self.points[int(tag) - 1] = tuple(next(rows))
        if first != 1 or number != last or None in self.points or next(rows, None):
            raise ValueError("there are not as many nodes as the section says")

    def read_elements(self, rows):
        number_of_blocks, number, _, _ = next(rows)
        for _ in range(int(number_of_blocks)):
            dimension, entity, kind, size = map(int, next(rows))
            name = self.names[dimension, entity]
            for _ in range(size):
                vertices = tuple(int(tag) - 1 for tag in next(rows)[1:])
                if (len(vertices), dimension) != {1: (2, 1), 3: (4, 2)}[kind]:
                    raise ValueError("an element has not the vertices of its type")
                (self.lines if kind == 1 else self.quads).append((vertices, name))
        if number != len(self.lines) + len(self.quads) or next(rows, None):
            raise ValueError("there are not as many elements as the section says")

    @staticmethod
    def block_size(header):
        return header[3]


def edges_of(faces):
    """By edge: its faces."""
    result = collections.defaultdict(list)
    for number, face in enumerate(faces):
        for k in range(len(face)):
            result[tuple(sorted((face[k - 1], face[k])))].append(number)
    return result


def sorted_edges(pairs):
    return sorted(tuple(sorted(pair)) for pair in pairs)


def from_first(face):
    """The same face, starting at its least vertex."""
    start = face.index(min(face))
    return face[start:] + face[:start]


def distance_to_segment(point, a, b):
    direction, offset = difference(b, a), difference(point, a)
    t = min(max(dot(offset, direction) / dot(direction, direction), 0), 1)
    return norm(difference(offset, tuple(t * x for x in direction)))


class QuadProgramTest(ProgramTest):
    def mesh(self, *arguments):
        """The quadrangles of a run on a model: points, faces, feature edges, and the report."""
        report = self.report(*arguments, "-o", "out.obj", "--feature-lines")
        return (*read_obj((self.folder / "out.obj").read_text()), report)

    def write_all(self, *options):
        outputs = [word for end in FORMATS for word in ("-o", f"out.{end}")]
        return self.report(self.write_cube(), *options, *outputs, "--write-features", "out.feat")


# ---------------------------------------------------------------- the tests

class QuadUsage(QuadProgramTest):
    def test_help_names_every_option(self):
        text = self.succeed("--help").stdout
        for option in ("MODEL", "--features", "--feature-angle", "--weak-angle", "--close-gaps", "--min-chain-length",
                       "--edge-length", "--quads", "--chord-height", "--edges-across-gap", "--gradation",
                       "--min-edge-length", "--field-follows-sizes", "--no-refinement", "-o", "--ascii",
                       "--feature-lines", "--blocks",
                       "--write-features", "--support", "--edge-weights", "--curvature-weight", "--index-targets",
                       "--sharp-corner-bound", "--blunt-corner-bound", "--no-repair", "--no-relaxation", "--threads",
                       "--report", "--no-merge", "--close-cracks", "--quiet", "--verbose", "--help", "--version",
                       ".obj", ".off", ".ply", ".vtp", ".msh", "Exit codes"):
            self.assertIn(option, text)

    def test_manual_names_every_option_of_the_help(self):
        manual = (paths.sources / "doc/Frame_fields/Programs.txt").read_text()
        for option in re.findall(r"^  .*?(--[a-z-]+)", self.succeed("--help").stdout, re.MULTILINE):
            self.assertIn(option, manual)

    def test_version_names_the_program(self):
        self.assertRegex(self.succeed("--version").stdout, r"\Acad_quad_mesh \d+\.\d+\.\d+\n\Z")

    def test_wrong_command_lines(self):
        self.write_cube()
        self.write_features(CUBE_EDGES)
        for message, arguments in (
                ("MODEL", ""), ("positional", "cube.off cube.off"), ("--suport", "cube.off --suport none"),
                ("--edge-length", "cube.off --edge-length 0"), ("--edge-length", "cube.off --edge-length -1"),
                ("--edge-length", "cube.off --edge-length nan"), ("--edge-length", "cube.off --edge-length inf"),
                ("--edge-length", "cube.off --edge-length long"), ("--quads", "cube.off --quads 0"),
                ("--quads", "cube.off --quads 1.5"), ("exclude", "cube.off --quads 10 --edge-length 1"),
                ("--chord-height", "cube.off --chord-height 0"), ("--chord-height", "cube.off --chord-height inf"),
                ("--edges-across-gap", "cube.off --edges-across-gap 0"),
                ("--gradation", "cube.off --chord-height 1 --gradation 1"),
                ("--min-edge-length", "cube.off --chord-height 1 --min-edge-length 0"),
                ("--gradation needs --chord-height", "cube.off --gradation 2"),
                ("--min-edge-length needs", "cube.off --min-edge-length 1"),
                ("--field-follows-sizes needs", "cube.off --field-follows-sizes"),
                (".msh", "cube.off -o out.stl"), (".msh", "cube.off -o out"), ("--output", "cube.off -o"),
                ("another name", "cube.off -o out.obj -o ./out.obj"), ("another name", "cube.off -o cube.off"),
                ("another name", "cube.off -o out.obj --report out.obj"),
                ("--features", "cube.off --features model.feat --feature-angle 30"),
                ("'ring'", "cube.off --support ring"), ("'two'", "cube.off --blocks two")):
            with self.subTest(arguments):
                self.assert_fails(BAD_USAGE, message, *arguments.split())

    def test_table_shows_the_numbers_of_the_report(self):
        table = self.succeed(self.write_cube(), "--edge-length", LENGTH, "--report", "out.json").stdout
        report = json.loads((self.folder / "out.json").read_text())
        rows = dict(re.split(r" {2,}", line.strip(), maxsplit=1) for line in table.splitlines())
        for row, key in (("faces", "faces"), ("patches", "patches"), ("feature edges", "feature_edges"),
                         ("nodes", "nodes"), ("arcs", "arcs"), ("quadrangles", "quads"),
                         ("from certified maps", "certified_patches"), ("filled", "filled_patches")):
            self.assertEqual(int(rows[row]), report[key], row)
        self.assertAlmostEqual(float(rows["least scaled Jacobian"]), report["quality"]["minimum_scaled_jacobian"],
                               delta=1e-5)

    def run_program(self, *arguments, **settings):
        return super().run_program(*map(str, arguments), **settings)


class QuadInvalidInput(QuadProgramTest):
    """Nothing is written: assert_fails() compares the folder."""

    def test_models_and_features_that_cannot_be_read(self):
        self.write_cube()
        self.write("cut.off", off_text(CUBE_POINTS, CUBE_FACES)[:100])
        self.write("empty.off", "")
        self.write("wrong.feat", "0 1\n0 8\n")
        for message, arguments in (
                ("missing.off: there is no such file", "missing.off -o out.obj"),
                ("empty.off: byte 0: the file is empty", "empty.off -o out.obj"),
                ("cut.off: ", "cut.off -o out.obj"),
                ("wrong.feat:2: the model has no vertex 8", "cube.off --features wrong.feat -o out.obj"),
                ("lost/out.obj: there is no folder", "cube.off -o lost/out.obj --report out.json")):
            with self.subTest(arguments):
                self.assert_fails(BAD_FILE, message, *arguments.split())

    def test_coordinate_that_is_not_finite(self):
        self.write("nan.off", off_text([(math.nan, 0, 0), *CUBE_POINTS[1:]], CUBE_FACES))
        self.assert_fails(BAD_FILE, "nan.off: ", "nan.off", "-o", "out.obj", "-o", "out.msh", "--report", "out.json")


class QuadFormats(QuadProgramTest):
    def test_all_formats_hold_the_same_mesh(self):
        report = self.write_all("--edge-length", str(LENGTH))
        points, faces, lines = read_obj((self.folder / "out.obj").read_text())
        self.assertEqual(lines, [], "without --feature-lines")
        self.assertEqual(len(faces), report["quads"])
        self.assertEqual(len(points), report["quad_vertices"])
        features = sorted_edges(read_features(self.folder / "out.feat"))
        self.assertEqual(len(features), report["quad_feature_edges"])
        with self.subTest("off"):
            self.assertEqual(read_off(self.folder / "out.off"), (points, faces))
        with self.subTest("ply"):
            ply_points, is_on_feature, ply_faces, patches = read_quad_ply((self.folder / "out.ply").read_bytes())
            self.assertEqual((ply_points, ply_faces), (points, faces))
            self.assertEqual({v for v, flag in enumerate(is_on_feature) if flag}, set(itertools.chain(*features)))
            self.assertEqual([number for _, number in sorted(collections.Counter(patches).items())],
                             [patch["quads"] for patch in report["patch_list"]])
        with self.subTest("vtp"):
            self.check_vtp(points, faces, features, patches)
        with self.subTest("msh"):
            msh = Msh((self.folder / "out.msh").read_text())
            self.assertEqual(msh.points, points)
            self.assertEqual(sorted(from_first(quad) for quad, _ in msh.quads), sorted(map(from_first, faces)))
            self.assertEqual(sorted_edges(line for line, _ in msh.lines), features)
            patch_of = {from_first(face): f"patch_{patch}" for face, patch in zip(faces, patches)}
            self.assertTrue(all(patch_of[from_first(quad)] == name for quad, name in msh.quads))

    def check_vtp(self, points, faces, features, patches):
        piece, arrays = read_vtp((self.folder / "out.vtp").read_bytes())
        number_of_verts, number_of_lines = piece["NumberOfVerts"], piece["NumberOfLines"]
        self.assertEqual(list(map(tuple, arrays["Points", "points"])), points)
        connectivity = arrays["Polys", "connectivity"]
        self.assertEqual(list(map(tuple, (connectivity[k:k + 4] for k in range(0, len(connectivity), 4)))), faces)
        connectivity = arrays["Lines", "connectivity"]
        self.assertEqual(sorted_edges(connectivity[k:k + 2] for k in range(0, len(connectivity), 2)), features)
        self.assertEqual(list(arrays["CellData", "patch"][number_of_verts + number_of_lines:]), patches)
        self.assertTrue(all(0 < value <= 1 + 1e-12 for value in
                            arrays["CellData", "scaled_jacobian"][number_of_verts + number_of_lines:]))

    def test_feature_lines_of_obj(self):
        _, _, lines, report = self.mesh(self.write_cube(), "--edge-length", str(LENGTH))
        self.assertEqual(len(lines), report["quad_feature_edges"])

    def test_text_and_binary_ply_hold_the_same(self):
        self.write_cube()
        contents = []
        for options in ((), ("--ascii",)):
            self.succeed("cube.off", "-o", "out.ply", "--quiet", *options)
            contents.append(read_quad_ply((self.folder / "out.ply").read_bytes()))
        self.assertEqual(*contents)

    def test_blocks_without_features(self):
        """They cannot be told from patches with all features of the cube, and are those of its irregular vertices."""
        self.write_cube()
        for kind in ("whole-sides", "by-patch", "t-junctions"):
            report = self.report("cube.off", "--feature-angle", "100", "--blocks", kind, "--ascii", "-o", "out.ply",
                                 "-o", "out.vtp")
            _, arrays = read_vtp((self.folder / "out.vtp").read_bytes())
            blocks = list(arrays["CellData", "block"])[-report["quads"]:]
            rows = (self.folder / "out.ply").read_text().splitlines()[-report["quads"]:]
            self.assertEqual([int(row.split()[6]) for row in rows], blocks)
            self.assertEqual(set(blocks), set(range(report["blocks"])))
            self.assertEqual(report["patches"], 1)
            self.assertGreaterEqual(report["blocks"], 6)
            self.assertEqual(report["options"]["blocks"], kind)
        self.assertIsNone(self.report("cube.off")["blocks"])

    def test_curves_of_the_cube(self):
        self.write_all("--edge-length", str(LENGTH))
        msh = Msh((self.folder / "out.msh").read_text())
        curves, numbers = collections.defaultdict(list), collections.Counter(name for _, name in msh.quads)
        for line, name in msh.lines:
            curves[name].append(line)
        self.assertEqual(len(numbers), 6)
        self.assertEqual(msh.numbers_of_entities, [8, 12, 6, 0])
        for lines in curves.values():
            self.assertTrue(all(a[1] == b[0] for a, b in zip(lines, lines[1:])), "lines run one after the other")
            ends = [msh.points[lines[0][0]], msh.points[lines[-1][1]]]
            self.assertAlmostEqual(norm(difference(*ends)), 1)


class QuadContract(QuadProgramTest):
    """What must hold of every result, on small models."""

    def check(self, model, features, *options):
        points, faces = read_off(model)
        quad_points, quads, lines, report = self.mesh(model, *options)
        self.assertEqual({len(quad) for quad in quads}, {4})
        edges, quad_edges = edges_of(faces), edges_of(quads)
        self.assertLessEqual(max(map(len, quad_edges.values())), 2)
        self.assertEqual(len(quad_points) - len(quad_edges) + len(quads), len(points) - len(edges) + len(faces))
        halfedges = [(quad[k - 1], quad[k]) for quad in quads for k in range(4)]
        self.assertEqual(len(halfedges), len(set(halfedges)), "quadrangles are oriented alike")
        self.assertEqual({vertex for quad in quads for vertex in quad}, set(range(len(quad_points))))
        number_of_features = collections.Counter(itertools.chain(*features))
        present = set(quad_points)
        for vertex, number in number_of_features.items():
            if number != 2:
                self.assertIn(points[vertex], present, "a node is a vertex")
        self.check_features(points, features, quad_points, lines)
        return report

    def check_features(self, points, features, quad_points, lines):
        def length(all_points, pairs):
            return sum(norm(difference(all_points[a], all_points[b])) for a, b in pairs)

        size = max(map(max, points)) - min(map(min, points))
        # The features by the cubes that they may pass.
        side = 1.01 * max(norm(difference(points[a], points[b])) for a, b in features)
        near = collections.defaultdict(list)
        for a, b in features:
            for cube in itertools.product(*({math.floor(c / side + shift) for c in (p, q) for shift in (-1e-3, 1e-3)}
                                            for p, q in zip(points[a], points[b]))):
                near[cube].append((points[a], points[b]))
        for vertex in set(itertools.chain(*lines)):
            point = quad_points[vertex]
            distances = (distance_to_segment(point, *ends) for ends in near[tuple(math.floor(c / side) for c in point)])
            self.assertLess(min(distances, default=size), 1e-9 * size)
        self.assertLessEqual(length(quad_points, lines), (1 + 1e-9) * length(points, features))
        self.assertGreater(length(quad_points, lines), 0.8 * length(points, features))

    def test_cube_at_several_sizes(self):
        self.write_cube()
        for arguments in (("--edge-length", "0.25"), ("--edge-length", "10"), ("--quads", "100"), ()):
            with self.subTest(arguments):
                report = self.check(self.folder / "cube.off", CUBE_EDGES, *arguments)
                self.assertEqual((report["patches"], report["faces"], report["feature_edges"]), (6, 12, 12))

    def test_cube_is_divided_evenly(self):
        report = self.check(self.folder / self.write_cube(), CUBE_EDGES, "--edge-length", str(LENGTH))
        self.assertEqual(report["quads"], 6 * 4 * 4)
        self.assertEqual((report["nodes"], report["arcs"], report["filled_patches"]), (8, 12, 0))
        self.assertAlmostEqual(report["quality"]["minimum_scaled_jacobian"], 1, delta=1e-6)
        for key in ("irregular_vertices", "irregular_feature_sectors", "non_positive_quads"):
            self.assertEqual(report["quality"][key], 0, key)

    def test_flange(self):
        report = self.check(flange(), read_features(flange_features()), "--features", flange_features())
        self.assertEqual(report["quality"]["non_positive_quads"], 0)
        self.assertEqual(report["filled_patches"] + report["certified_patches"], report["patches"])


class QuadSizes(QuadProgramTest):
    """A raw tube of length 2 and radius 3 with a feature at a tenth of its length."""

    SEGMENTS = 40

    def write_tube(self):
        n = self.SEGMENTS
        points = [(3 * math.cos(2 * math.pi * k / n), 3 * math.sin(2 * math.pi * k / n), z)
                  for z in (0, 0.2, 2) for k in range(n)]
        triangles = [t for row in (0, n) for k in range(n) for a, b in [(row + k, row + (k + 1) % n)]
                     for t in ((a, b, b + n), (a, b + n, a + n))]
        (self.folder / "tube.off").write_text(f"OFF\n{len(points)} {len(triangles)} 0\n"
                                              + "".join("%.17g %.17g %.17g\n" % p for p in points)
                                              + "".join("3 %d %d %d\n" % t for t in triangles))
        self.write_features([(n + k, n + (k + 1) % n) for k in range(n)])
        return "tube.off", "--features", "model.feat", "--edge-length", "0.5"

    def numbers(self, *options):
        """The report, the quadrangles around the tube, and those across its two parts."""
        points, quads, lines, report = self.mesh(*self.write_tube(), *options)
        around = sum(all(abs(points[v][2] - 0.2) < 1e-9 for v in line) for line in lines)
        parts = [sum(max(points[v][2] for v in quad) < 0.2 + 1e-9 for quad in quads)]
        return report, around, [number / around for number in parts + [len(quads) - parts[0]]]

    def test_chords(self):
        height = 0.001
        chord = math.sqrt(8 * 3 * height - 4 * height ** 2)
        report, around, _ = self.numbers("--chord-height", str(height))
        self.assertAlmostEqual(around, 6 * math.pi / chord, delta=1)
        self.assertAlmostEqual(report["target_edge_length"], chord, delta=1e-9)
        self.assertEqual(report["options"]["chord_height"], height)
        report, around, _ = self.numbers("--chord-height", str(height), "--min-edge-length", "0.4")
        self.assertLess(around, 50)
        self.assertAlmostEqual(report["minimum_target_edge_length"], 0.4, delta=1e-9)
        self.assertEqual(report["options"]["min_edge_length"], 0.4)

    def test_gaps(self):
        _, _, parts = self.numbers()
        self.assertEqual(parts, [1, 4])
        report, _, (narrow, wide) = self.numbers("--edges-across-gap", "4", "--gradation", "1.3")
        self.assertEqual(narrow, 4)
        # As many as the integral of 1 / length over 1.8, for a length that grows from 0.05 by log(1.3) up to 0.45.
        slope = math.log(1.3)
        expected = math.log(0.45 / 0.05) / slope + (1.8 - 0.4 / slope) / 0.45
        self.assertAlmostEqual(wide, expected, delta=1.5)
        self.assertAlmostEqual(report["minimum_target_edge_length"], 0.05, delta=1e-3)
        self.assertAlmostEqual(report["maximum_target_edge_length"], 0.45, delta=1e-3)
        self.assertEqual((report["options"]["edges_across_gap"], report["options"]["gradation"]), (4, 1.3))


class QuadGuidance(QuadProgramTest):
    def test_index_targets_become_irregular_vertices(self):
        path = self.folder / "grid.off"
        points = [(i, j, 0) for j in range(9) for i in range(9)]
        triangles = [t for j in range(8) for i in range(8) for p in [9 * j + i]
                     for t in ((p, p + 1, p + 10), (p, p + 10, p + 9))]
        path.write_text("OFF\n81 128 0\n" + "".join("%d %d %d\n" % p for p in points)
                        + "".join("3 %d %d %d\n" % t for t in triangles))
        targets = self.folder / "targets.txt"
        targets.write_text("40 1\n30 -1\n")
        points, faces, _, _ = self.mesh(path, "--index-targets", targets)
        borders = {p for p, point in enumerate(points) if {0, 8} & set(point[:2])}
        corners = [p for face in faces for p in face]
        self.assertEqual(sorted(corners.count(p) for p in range(len(points))
                                if p not in borders and corners.count(p) != 4), [3, 5])
        targets.write_text("40 1\n")
        self.assert_fails(BAD_FILE, "sum", path, "--index-targets", targets, "-o", "out.obj")

    def test_curvature_guides(self):
        columns, rows = 16, 8  # of an ellipsoid with three different axes, open at its poles
        points = [(3 * math.sin(u) * math.cos(v), 2 * math.sin(u) * math.sin(v), math.cos(u))
                  for j in range(rows) for u in [math.pi * (j + 1) / (rows + 1)]
                  for i in range(columns) for v in [2 * math.pi * i / columns]]
        triangles = [t for j in range(rows - 1) for i in range(columns)
                     for a, b in [(columns * j + i, columns * j + (i + 1) % columns)]
                     for t in ((a, a + columns, b + columns), (a, b + columns, b))]
        path = self.folder / "ellipsoid.off"
        path.write_text(f"OFF\n{len(points)} {len(triangles)} 0\n" + "".join("%.17g %.17g %.17g\n" % p for p in points)
                        + "".join("3 %d %d %d\n" % t for t in triangles))
        plain, unguided, guided = (self.mesh(path, "--feature-angle", "180", *options)
                                   for options in ((), ("--curvature-weight", "0"), ("--curvature-weight", "1")))
        self.assertEqual(plain[0], unguided[0])
        self.assertNotEqual(plain[0], guided[0])


class QuadReport(QuadProgramTest):
    def test_keys_and_types(self):
        report = self.report(self.write_cube(), "--edge-length", str(LENGTH))
        for keys, kind in (
                ("faces vertices feature_edges nodes arcs patches certified_patches filled_patches repaired_patches "
                 "quads quad_vertices quad_feature_edges", int),
                ("target_edge_length seconds_reading seconds_writing peak_memory_mib", float),
                ("dangling_ends patch_list warnings", list), ("options quality field seconds", dict)):
            for key in keys.split():
                self.assertIs(type(report[key]), kind, key)
        self.assertEqual(list(report["seconds"]), ["preparation", "field", "seamless_map", "t_mesh", "quantization",
                                                   "assembly", "smoothing", "total"])
        for seconds in report["seconds"].values():
            self.assertTrue(0 <= seconds <= report["seconds"]["total"])
        self.assertEqual(report["options"]["edge_length"], LENGTH)
        self.assertEqual(report["target_edge_length"], LENGTH)

    def test_patches(self):
        report = self.report(self.write_cube(), "--edge-length", str(LENGTH))
        patches = report["patch_list"]
        self.assertEqual(len(patches), report["patches"])
        self.assertEqual(sum(patch["quads"] for patch in patches), report["quads"])
        ways = collections.Counter(patch["way"] for patch in patches)
        self.assertEqual((ways["certified_map"], ways["filling"]),
                         (report["certified_patches"], report["filled_patches"]))
        for patch in patches:
            self.assertEqual(patch["reason"] is None, patch["way"] == "certified_map")


class QuadThreads(QuadProgramTest):
    def test_outputs_do_not_depend_on_their_number(self):
        outputs = []
        for number in ("1", "2", "8"):
            completed = self.run_program(flange(), "--features", flange_features(), "--quads", "3000", "--quiet",
                                         "--threads", number, "-o", "out.msh", "-o", "out.vtp")
            if completed.returncode == BAD_USAGE and number != "1":
                self.assertIn("without TBB", completed.stderr)
                self.skipTest("the program was built without TBB")
            self.assertEqual(completed.returncode, DONE, completed.stderr)
            outputs.append([(self.folder / name).read_bytes() for name in ("out.msh", "out.vtp")])
        self.assertEqual(outputs[1:], outputs[:1] * 2)


class QuadsInGnuParallel(test_program.ParallelTest):
    def test_killed_run_goes_on_where_it_was(self):
        self.check_that_a_killed_run_goes_on()


class OtherReaderTest(QuadProgramTest):
    def read_with(self, module, script):
        """What a Python script prints as JSON about the outputs for the cube."""
        python = python_with(module)
        if python is None:
            self.skipTest(f"there is no {module} for Python")
        report = self.write_all("--edge-length", str(LENGTH), "--ascii")
        completed = run(python, "-W", "ignore", "-c", f"import json, {module}\n{script}", cwd=self.folder)
        self.assertEqual(completed.returncode, 0, completed.stderr)
        return report, json.loads(completed.stdout.splitlines()[-1])


class QuadsInGmsh(OtherReaderTest):
    def test_entities_elements_and_groups(self):
        report, read = self.read_with("gmsh", """
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.logger.start()
gmsh.open("out.msh")
model, mesh = gmsh.model, gmsh.model.mesh
quads, _ = mesh.getElementsByType(3)
print(json.dumps({
    "entities": [len(model.getEntities(dimension)) for dimension in range(4)],
    "types": sorted(map(int, mesh.getElementTypes())), "quads": len(quads),
    "lines": len(mesh.getElementsByType(1)[0]), "nodes": len(mesh.getNodes()[0]),
    "groups": sorted(model.getPhysicalName(*group) for group in model.getPhysicalGroups()),
    "boundaries": [len(model.getBoundary([surface])) for surface in model.getEntities(2)],
    "quality": min(mesh.getElementQualities(quads, "minSJ")) if hasattr(mesh, "getElementQualities") else 1,
    "faults": [line for line in gmsh.logger.get() if not line.startswith("Info")]}))
""")
        self.assertEqual(read["entities"], [8, 12, 6, 0])
        self.assertEqual(read["types"], [1, 3])
        self.assertEqual((read["quads"], read["lines"], read["nodes"]),
                         (report["quads"], report["quad_feature_edges"], report["quad_vertices"]))
        self.assertEqual(read["groups"], sorted([f"curve_{k}" for k in range(12)] + [f"patch_{k}" for k in range(6)]))
        self.assertEqual(read["boundaries"], [4] * 6)
        self.assertEqual(read["faults"], [])
        self.assertGreater(read["quality"], 0)


class QuadsInMeshio(OtherReaderTest):
    def test_cells_and_data(self):
        report, read = self.read_with("meshio", """
def summary(name):
    mesh = meshio.read(name)
    number = lambda kind: sum(len(block.data) for block in mesh.cells if block.type == kind)
    return {"points": len(mesh.points), "quads": number("quad"), "lines": number("line"),
            "data": sorted([*mesh.point_data, *mesh.cell_data])}
print(json.dumps({end: summary("out." + end) for end in ("obj", "ply", "msh")}))
""")
        for end, number_of_lines in (("obj", 0), ("ply", 0), ("msh", report["quad_feature_edges"])):
            self.assertEqual((read[end]["points"], read[end]["quads"], read[end]["lines"]),
                             (report["quad_vertices"], report["quads"], number_of_lines), end)
        self.assertEqual(read["ply"]["data"], ["feature", "patch"])
        self.assertIn("gmsh:physical", read["msh"]["data"])


class QuadsInVtk(OtherReaderTest):
    def test_cells_and_data(self):
        report, read = self.read_with("vtk", """
def output_of(reader, name):
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()
def counts(data):
    return [data.GetNumberOfPoints(), data.GetNumberOfPolys(), data.GetNumberOfLines()]
vtp = output_of(vtk.vtkXMLPolyDataReader(), "out.vtp")
print(json.dumps({
    "vtp": counts(vtp), "ply": counts(output_of(vtk.vtkPLYReader(), "out.ply")),
    "obj": counts(output_of(vtk.vtkOBJReader(), "out.obj")), "largest": vtp.GetMaxCellSize(),
    "arrays": {vtp.GetCellData().GetArrayName(k): vtp.GetCellData().GetArray(k).GetNumberOfTuples()
               for k in range(vtp.GetCellData().GetNumberOfArrays())},
    "cells": vtp.GetNumberOfCells()}))
""")
        numbers = [report["quad_vertices"], report["quads"]]
        self.assertEqual(read["vtp"], [*numbers, report["quad_feature_edges"]])
        self.assertEqual(read["ply"], [*numbers, 0])
        self.assertEqual(read["obj"], [*numbers, 0])
        self.assertEqual(read["largest"], 4)
        self.assertEqual(read["arrays"], dict.fromkeys(
            ("valence", "on_feature", "curve", "patch", "scaled_jacobian"), read["cells"]))


if __name__ == "__main__":
    test_program.main()
