#!/usr/bin/python3
"""Tests of what cad_frame_field makes of polygons, soups and feature files; see --help for the arguments."""

import itertools
import math
import random
import re

import test_program
from test_program import (BAD_FILE, CUBE_COUNTS, CUBE_EDGES, CUBE_FACES, CUBE_POINTS, DONE, ProgramTest, counts, flange,
                          flange_features, numbers_as_lines, obj_text, off_text, ply_text, read_features, read_off,
                          stl_text)


def polygons_as_obj(points, faces):
    return "".join("v %r %r %r\n" % point for point in points) + "".join(
        "f " + " ".join(str(vertex + 1) for vertex in face) + "\n" for face in faces)


def polygons_as_ply(points, faces):
    header = ply_text(points, []).replace("element face 0", f"element face {len(faces)}")
    return header + numbers_as_lines((len(face), *face) for face in faces)


POLYGON_FORMATS = {"obj": polygons_as_obj, "off": off_text, "ply": polygons_as_ply}
ALL_FORMATS = {"obj": obj_text, "off": off_text, "ply": ply_text, "stl": stl_text}


def moved(point, size):
    """A rotation that leaves no axis, a scaling and a shift."""
    x, y, z = point
    x, y = 0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y
    y, z = 5 / 13 * y - 12 / 13 * z, 12 / 13 * y + 5 / 13 * z
    return (size * (x + 1), size * (y - 2), size * (z + 3))


def prism(ring, points_in_plane):
    """The points and polygons of the solid over a ring in the plane, which may run along edges in both directions."""
    number = len(points_in_plane)
    points = [(x, y, 0.0) for x, y in points_in_plane] + [(x, y, 1.0) for x, y in points_in_plane]
    edges = [(a, b) for a, b in zip(ring, ring[1:] + ring[:1]) if a != b]
    walls = [(a, b, b + number, a + number) for a, b in edges if (b, a) not in edges]
    return points, [tuple(reversed(ring)), tuple(vertex + number for vertex in ring), *walls]


SQUARE = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)]
HOLE = [(2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0)]
SECOND_HOLE = [(5.0, 5.0), (5.0, 7.0), (7.0, 7.0), (7.0, 5.0)]


class SoupTest(ProgramTest):
    def euler_characteristic(self, report):
        """Of a closed surface of triangles."""
        self.assertEqual(report["border_edges"], 0)
        return report["vertices"] - report["faces"] // 2

    def assert_warning(self, report, pattern):
        self.assertRegex("\n".join(report["warnings"]), re.compile(pattern, re.MULTILINE))


class Polygons(SoupTest):
    def check_prism(self, ring, points, walls, holes):
        """With as many walls and holes, in each format, at any place and in any size."""
        ring = list(ring)
        for (end, make_text), (k, size) in itertools.product(POLYGON_FORMATS.items(), enumerate((1, 1e-4, 3e5))):
            solid_points, faces = prism(ring[k:] + ring[:k], points)
            name = self.write(f"solid.{end}", make_text([moved(point, size) for point in solid_points], faces))
            report = self.report(name)
            self.assertEqual((report["patches"], report["components"]), (2 + walls, 1))
            self.assertEqual(self.euler_characteristic(report), 2 - 2 * holes)
            self.assertEqual(report["feature_edges"], 3 * walls)
            self.assertEqual(report["sharp_corners"], 4 * walls + 2 * sum(
                self.is_convex(ring, points, j) for j in range(len(ring))))

    @staticmethod
    def is_convex(ring, points, j):
        (ax, ay), (bx, by), (cx, cy) = (points[ring[(j + i) % len(ring)]] for i in (-1, 0, 1))
        return (bx - ax) * (cy - by) - (by - ay) * (cx - bx) > 0

    def test_concave_ones(self):
        corner = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0), (0.0, 4.0)]
        self.check_prism(range(6), corner, 6, 0)
        fork = [(0.0, 0.0), (5.0, 0.0), (5.0, 6.0), (4.0, 6.0), (4.0, 1.0), (3.0, 1.0), (3.0, 6.0), (2.0, 6.0),
                (2.0, 1.0), (1.0, 1.0), (1.0, 6.0), (0.0, 6.0)]
        self.check_prism(range(12), fork, 12, 0)

    def check_plate(self, ring, points, walls, holes, bottom_ring=None, flat=0):
        """With so many edges between walls that are flat."""
        for (end, make_text), (k, size) in itertools.product(POLYGON_FORMATS.items(), enumerate((1, 1e-4, 3e5))):
            ring = ring[k:] + ring[:k]
            solid_points, faces = prism(ring, points)
            if bottom_ring:
                faces[0] = tuple(reversed(bottom_ring))
            name = self.write(f"plate.{end}", make_text([moved(point, size) for point in solid_points], faces))
            report = self.report(name)
            self.assertEqual((report["patches"], report["components"]), (2 + walls - flat, 1))
            self.assertEqual(self.euler_characteristic(report), 2 - 2 * holes)
            self.assertEqual(report["feature_edges"], 3 * walls - flat)
            self.assert_warning(report, f"more than three vertices triangulated: {2 + walls}$")

    def test_holes_at_bridges(self):
        self.check_plate([0, 1, 2, 3, 0, 4, 5, 6, 7, 4], SQUARE + HOLE, 8, 1)
        two = SQUARE + HOLE + SECOND_HOLE
        self.check_plate([0, 1, 2, 3, 0, 4, 5, 6, 8, 9, 10, 11, 8, 6, 7, 4], two, 12, 2)
        self.check_plate([0, 1, 2, 10, 11, 8, 9, 10, 2, 3, 0, 4, 5, 6, 7, 4], two, 12, 2)
        # The bridges of the bottom are others than those of the top.
        self.check_plate([0, 1, 2, 10, 11, 8, 9, 10, 2, 3, 0, 4, 5, 6, 7, 4], two, 12, 2,
                         [0, 1, 2, 3, 0, 4, 5, 6, 8, 9, 10, 11, 8, 6, 7, 4])

    def test_slits_repeated_and_collinear_vertices(self):
        self.check_plate([0, 4, 1, 2, 3], SQUARE + [(4.0, 0.0)], 5, 0, flat=1)
        self.check_plate([0, 0, 1, 1, 1, 2, 3, 3], SQUARE, 4, 0)
        self.check_plate([0, 4, 5, 4, 1, 2, 3], SQUARE + [(4.0, 0.0), (3.0, 5.0)], 5, 0, flat=1)
        self.check_plate([0, 4, 5, 6, 5, 4, 1, 2, 3], SQUARE + [(4.0, 0.0), (3.0, 5.0), (6.0, 6.0)], 5, 0, flat=1)

    def test_vertices_of_bridges_may_come_twice_in_the_file(self):
        points, faces = prism([0, 1, 2, 3, 0, 4, 5, 6, 7, 4], SQUARE + HOLE)
        points += [points[0], points[4]]
        faces[0] = (16, 3, 2, 1, 0, 4, 7, 6, 5, 17)
        report = self.report(self.write("plate.obj", polygons_as_obj(points, faces)))
        self.assertEqual((self.euler_characteristic(report), report["patches"]), (0, 10))

    def test_polygons_that_are_not_plane(self):
        rng = random.Random(1)
        for _ in range(5):
            points, faces = prism(list(range(6)), [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0),
                                                   (0.0, 4.0)])
            points = [(x, y, z + rng.uniform(-0.1, 0.1)) for x, y, z in points]
            report = self.report(self.write("solid.obj", polygons_as_obj(points, faces)), "--feature-angle", "60")
            self.assertEqual((report["faces"], self.euler_characteristic(report)), (20, 2))

    def test_two_solids_joined_in_a_vertex_of_polygons(self):
        points, faces = prism([0, 1, 2, 3, 4, 2], [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (2.0, 2.0), (0.0, 2.0)])
        report = self.report(self.write("solids.obj", polygons_as_obj(points, faces)))
        self.assertEqual((report["components"], report["border_edges"], report["patches"]), (2, 0, 10))
        self.assertEqual(report["vertices"], 12)

    def test_wrong_ones_are_refused_by_number(self):
        points = [(x, y, 0.0) for x, y in SQUARE + HOLE + [(4.5, 0.0)]]
        for words, polygon in (("crosses itself", (0, 2, 1, 3)), ("touches itself", (0, 1, 2, 8, 3)),
                               ("crosses itself", (0, 1, 2, 3, 0, 4, 7, 6, 5, 4)), ("crosses itself", (0, 1, 2) * 2)):
            for (end, make_text), exponent in itertools.product(POLYGON_FORMATS.items(), (-20, 0, 300)):
                with self.subTest(polygon, end=end, exponent=exponent):
                    placed = [tuple(math.ldexp(x, exponent) for x in (a + 2 * b, b, b - a)) for a, b, _ in points]
                    text = make_text(placed, [(0, 1, 2), polygon, (2, 1, 0)])
                    self.assert_fails(BAD_FILE, f"triangulated: 1, the first is face 1 (counted from 0), which {words}",
                                      self.write(f"model.{end}", text))

    def test_any_ring_gives_a_mesh_or_is_refused(self):
        rng = random.Random(2)
        codes = set()
        for _ in range(60):
            points = [tuple(map(float, (rng.randrange(3), rng.randrange(3), rng.randrange(2)))) for _ in range(8)]
            faces = [tuple(rng.randrange(8) for _ in range(rng.randrange(2, 8))) for _ in range(rng.randrange(1, 6))]
            completed = self.run_program(self.write("model.off", off_text(points, faces)), "--quiet", timeout=20)
            self.assertIn(completed.returncode, (DONE, BAD_FILE), completed.stderr)
            codes.add(completed.returncode)
        self.assertEqual(codes, {DONE, BAD_FILE})


def apart(points, faces):
    """The same with three vertices of its own for each triangle."""
    return ([points[vertex] for face in faces for vertex in face],
            [(3 * f, 3 * f + 1, 3 * f + 2) for f in range(len(faces))])


def two_cubes(shift):
    points = CUBE_POINTS + [tuple(a + b for a, b in zip(point, shift)) for point in CUBE_POINTS]
    return points, CUBE_FACES + [tuple(vertex + 8 for vertex in face) for face in CUBE_FACES]


class Soups(SoupTest):
    def test_coincident_vertices_are_merged_in_all_formats(self):
        points, faces = apart(CUBE_POINTS, CUBE_FACES)
        for (end, make_text), size in itertools.product(ALL_FORMATS.items(), (1, 1e-3, 7e6)):
            with self.subTest(end, size=size):
                name = self.write(f"soup.{end}", make_text([moved(point, size) for point in points], faces))
                report = self.report(name)
                self.assertEqual(counts(report), CUBE_COUNTS)
                if end != "stl":  # which has no other way to say it
                    self.assert_warning(report, r": duplicate vertices merged: 28$")

    def test_soup_of_the_flange(self):
        report = self.report(self.write("soup.off", off_text(*apart(*read_off(flange())))))
        self.assertEqual(counts(report), counts(self.report(flange())))

    def test_vertices_can_be_kept_apart(self):
        for faces, components in ((CUBE_FACES, 12), (CUBE_FACES[:4] + CUBE_FACES[6:], 10)):
            report = self.report(self.write("soup.off", off_text(*apart(CUBE_POINTS, faces))), "--no-merge")
            self.assertEqual((report["components"], report["border_loops"]), (components, components))
            self.assertEqual((report["border_edges"], report["vertices"]), (3 * components, 3 * components))
            self.assertEqual(report["options"]["merge"], False)

    def test_solids_that_touch_stay_two(self):
        for shift in ((1, 0, 0), (0, -1, 0), (0, 0, 1), (1, 1, 0), (0, 1, -1), (1, 1, 1)):
            points, faces = two_cubes(shift)
            for (end, make_text), size in itertools.product(ALL_FORMATS.items(), (1, 4096)):
                with self.subTest(shift, end=end, size=size):
                    name = self.write(f"cubes.{end}", make_text([tuple(size * x for x in p) for p in points], faces))
                    report = self.report(name)
                    self.assertEqual((report["components"], report["patches"], report["faces"], report["vertices"]),
                                     (2, 12, 24, 16))
                    self.assertEqual((report["border_edges"], report["border_loops"]), (0, 0))

    def test_vertices_without_faces_keep_the_numbers_of_others(self):
        points = [(9.0, 9.0, 9.0), *CUBE_POINTS, CUBE_POINTS[3]]
        faces = [tuple(vertex + 1 for vertex in face) for face in CUBE_FACES]
        self.write_features([(a + 1, b + 1) for a, b in CUBE_EDGES])
        for end in ("off", "obj", "ply"):
            name = self.write(f"cube.{end}", ALL_FORMATS[end](points, faces))
            report = self.report(name, "--features", "model.feat")
            self.assertEqual({**counts(report), "vertices": 8}, CUBE_COUNTS)
            self.assertEqual((report["vertices"], report["warnings"]), (10, []))

    def test_borders_are_counted(self):
        for removed, edges, loops in (((), 0, 0), ((0, 1), 4, 1), ((0, 1, 2, 3), 8, 2), ((0, 1, 4, 5), 6, 1),
                                      ((0,), 3, 1)):
            faces = [face for f, face in enumerate(CUBE_FACES) if f not in removed]
            report = self.report(self.write("cube.off", off_text(CUBE_POINTS, faces)))
            self.assertEqual((report["border_edges"], report["border_loops"], report["components"]), (edges, loops, 1))

    def test_fan_takes_linear_time(self):
        """Adding triangles one by one with a walk around the tip takes half a minute, and four times that for both."""
        seconds = []
        for number in (10000, 80000):
            ring = [(math.cos(a), math.sin(a), 0.0) for a in (2 * math.pi * k / number for k in range(number))]
            faces = [(number, k, (k + 1) % number) for k in range(number)]
            name = self.write("cone.off", off_text(ring + [(0.0, 0.0, 1.0)], faces))
            seconds.append(self.report(name, "--no-baseline")["seconds_reading"])
        self.assertLess(seconds[1], 8 * 4 * seconds[0] + 1)


def cracked_cube(gap, number, ratio, end):
    """A cube of squares; its top is shifted by a gap, and has its own vertices, ratio times as many along an edge."""
    points, faces = [], []

    def add(corner, u, v, count, shift=0.0):
        first = len(points)
        points.extend(tuple(corner[i] + (j * u[i] + k * v[i]) / count + (shift if i == 2 else 0) for i in range(3))
                      for k in range(count + 1) for j in range(count + 1))
        for k, j in itertools.product(range(count), repeat=2):
            a = first + k * (count + 1) + j
            faces.extend([(a, a + 1, a + count + 2), (a, a + count + 2, a + count + 1)])

    x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    for corner, u, v in (((0, 0, 0), y, x), ((0, 0, 0), x, z), ((0, 0, 0), z, y), ((1, 0, 0), y, z), ((0, 1, 0), z, x)):
        add(corner, u, v, number)
    add((0, 0, 1), x, y, number * ratio, gap)
    return ALL_FORMATS[end](points, faces), len(faces)


class CracksOfFiles(SoupTest):
    def test_are_told_and_closed(self):
        for end, (number, ratio), gap in itertools.product(ALL_FORMATS, ((2, 1), (4, 1), (2, 3)), (1e-7, 4e-7)):
            with self.subTest(end, number=number, ratio=ratio, gap=gap):
                text, faces = cracked_cube(gap, number, ratio, end)
                report = self.report(self.write(f"cube.{end}", text))
                self.assertEqual(report["border_edges"], 4 * number * (1 + ratio))
                self.assertEqual((report["border_loops"], report["components"]), (2, 2))
                tolerance = re.search(r"border edges that run along others, at most ([\d.e-]+) apart: (\d+); "
                                      r"--close-cracks ([\d.e-]+) ", "\n".join(report["warnings"]))
                self.assertAlmostEqual(float(tolerance[1]) / gap, 1, delta=0.1)
                self.assertEqual(int(tolerance[2]), report["border_edges"])

                report = self.report(f"cube.{end}", "--close-cracks", tolerance[3])
                self.assertEqual((report["components"], report["patches"]), (1, 6))
                self.assertEqual(self.euler_characteristic(report), 2)
                self.assertEqual(report["faces"], faces + 4 * number * (ratio - 1))
                self.assertEqual(report["feature_edges"], 8 * number + 4 * number * ratio)
                self.assert_warning(report, f"border edges joined across cracks: {4 * number * (1 + ratio)}$")

    def test_borders_that_are_wanted_are_not_told(self):
        for faces in (CUBE_FACES[2:], CUBE_FACES[4:]):
            report = self.report(self.write("cube.off", off_text(CUBE_POINTS, faces)))
            self.assertEqual(report["warnings"], [])
        text, _ = cracked_cube(1e-3, 3, 1, "obj")
        report = self.report(self.write("cube.obj", text))
        self.assertNotIn("run along", "\n".join(report["warnings"]))
        self.assertEqual(report["border_edges"], 24)

    def test_tolerance_without_sense(self):
        self.assert_fails(BAD_FILE, "smaller than the tolerance", self.write_cube_in_parts(), "--close-cracks", "9")

    def write_cube_in_parts(self):
        points, faces = apart(CUBE_POINTS, CUBE_FACES)
        points = [tuple(x + 1e-3 * (k // 3) for x in point) for k, point in enumerate(points)]
        return self.write("parts.off", off_text(points, faces))


class FeatureNumbers(SoupTest):
    def test_lines_counted_from_1_are_named(self):
        self.write_cube()
        self.write_features([(a + 1, b + 1) for a, b in CUBE_EDGES])
        self.assert_fails(BAD_FILE, "of 12 lines name edges of the model; counted from 1, all of them do", "cube.off",
                          "--features", "model.feat")
        lower = [edge for edge in CUBE_EDGES if max(edge) < 7]  # no number is too large
        self.write_features([(a + 1, b + 1) for a, b in lower])
        self.assert_fails(BAD_FILE, "counted from 1, all of them do", "cube.off", "--features", "model.feat")
        self.write_features([(a + 1, b + 1) for a, b in read_features(flange_features())])
        self.assert_fails(BAD_FILE, "of 2422 lines name edges of the model; counted from 1, all of them do", flange(),
                          "--features", "model.feat")

    def test_file_of_another_model(self):
        """More than a tenth of the lines name no edge."""
        rng = random.Random(3)
        diagonals = [(0, 6), (1, 7)]
        for wrong, right in ((2, 17), (2, 0), (5, 12)):
            self.write_cube()
            pairs = [rng.choice(diagonals) for _ in range(wrong)] + [rng.choice(CUBE_EDGES) for _ in range(right)]
            self.write_features(pairs)
            self.assert_fails(BAD_FILE, f"{right} of {right + wrong} lines name edges", "cube.off", "--features",
                              "model.feat")
        self.write_features(CUBE_EDGES + diagonals[:1])
        self.assert_warning(self.report("cube.off", "--features", "model.feat"), ": 1, the first is line 13, '0 6'")

    def test_text_as_editors_save_it(self):
        self.write_cube()
        rows = [f"{a} {b}" for a, b in CUBE_EDGES]
        for name, content in (("mark", b"\xef\xbb\xbf" + "\n".join(rows).encode()),
                              ("mark and comment", b"\xef\xbb\xbf# all\r\n" + "\r\n".join(rows).encode()),
                              ("tabs", "\n".join(f"\t{a}\t\t{b} \t# edge" for a, b in CUBE_EDGES).encode()),
                              ("commas", "\n\n".join(f"{a}, {b}" for a, b in CUBE_EDGES).encode())):
            with self.subTest(name):
                (self.folder / "model.feat").write_bytes(content)
                self.assertEqual(counts(self.report("cube.off", "--features", "model.feat")), CUBE_COUNTS)
        for encoding in ("utf-16", "utf-16-le"):
            (self.folder / "model.feat").write_bytes("\n".join(rows).encode(encoding))
            self.assert_fails(BAD_FILE, "model.feat:1: ", "cube.off", "--features", "model.feat")
        self.assert_fails(BAD_FILE, "UTF-16", "cube.off", "--features", "model.feat")

    def test_numbers_are_those_of_the_file_before_any_merging(self):
        """An edge is named by any of the vertices that lie at its ends, also by those of removed faces."""
        rng = random.Random(4)
        for trial in range(4):
            points, faces = apart(CUBE_POINTS, CUBE_FACES)
            order = list(range(len(points)))
            rng.shuffle(order)
            points = [points[k] for k in order] + CUBE_POINTS
            faces = [tuple(order.index(vertex) for vertex in face) for face in faces]
            if trial % 2:
                faces.insert(rng.randrange(12), (36, 36, 37))
            copies = {p: [k for k, q in enumerate(points) if q == p] for p in CUBE_POINTS}
            self.write_features([(rng.choice(copies[CUBE_POINTS[a]]), rng.choice(copies[CUBE_POINTS[b]]))
                                 for a, b in CUBE_EDGES])
            name = self.write("soup.off", off_text(points, faces))
            self.assertEqual(counts(self.report(name, "--features", "model.feat")), CUBE_COUNTS)

    def test_features_of_one_of_two_solids_that_touch(self):
        points, faces = two_cubes((1, 0, 0))
        for first in (0, 8):
            self.write_features([(a + first, b + first) for a, b in CUBE_EDGES])
            report = self.report(self.write("cubes.off", off_text(points, faces)), "--features", "model.feat")
            self.assertEqual((report["feature_edges"], report["patches"]), (12, 7))

    def test_features_of_polygons(self):
        points, faces = prism([0, 1, 2, 3, 0, 4, 5, 6, 7, 4], SQUARE + HOLE)
        edges = {tuple(sorted(edge)) for face in faces[2:] for edge in zip(face, face[1:] + face[:1])}
        self.write_features(sorted(edges))
        report = self.report(self.write("plate.obj", polygons_as_obj(points, faces)), "--features", "model.feat")
        self.assertEqual((report["feature_edges"], report["patches"], len(edges)), (24, 10, 24))


def abc_text(curves, in_brackets, first=0):
    """Features as the data set ABC has them; curves are (vertices, whether sharp)."""
    lines = ["curves:"]
    for vertices, is_sharp in curves:
        numbers = [vertex + first for vertex in vertices]
        lines += ["- direction: [1.0, 0.0, 0.0]", "  location: [0.5, 1.5, -2.0e-05]",
                  f"  sharp: {str(is_sharp).lower()}", "  type: Line"]
        if in_brackets:
            text = "  vert_indices: [" + ", ".join(map(str, numbers)) + "]"
            lines += re.sub(r"(.{30}\S*,) ", r"\1\n    ", text).split("\n")
            lines += ["  vert_parameters: [" + ", ".join("0.5" for _ in numbers) + "]"]
        else:
            lines += ["  vert_indices:", *(f"  - {number}" for number in numbers)]
            lines += ["  vert_parameters:", *("  - 0.5" for _ in numbers)]
    lines += ["surfaces:", "- coefficients: [0.0, 1.0, 0.0, 2.0]", "  face_indices: [0, 1, 2]", "  type: Plane",
              "  vert_indices: [0, 2, 5, 7]", "  vert_parameters:", "  - [0.0, 0.0]", "  - [0.0, 1.0]"]
    return "\n".join(lines) + "\n"


class FeaturesOfAbc(SoupTest):
    # The vertices of curves that go around the cube; the diagonal of a square is not sharp.
    CURVES = [((0, 1, 2, 3, 0), True), ((4, 5, 6, 7, 4), True), ((0, 2), False), ((0, 4), True), ((1, 5), True),
              ((2, 6), True), ((3, 7), True)]

    def test_sharp_curves(self):
        self.write_cube()
        for in_brackets, newline, mark in itertools.product((True, False), ("\n", "\r\n"), ("", "\ufeff")):
            for end in ("yml", "YML", "yaml"):
                text = mark + abc_text(self.CURVES, in_brackets).replace("\n", newline)
                (self.folder / f"cube.{end}").write_bytes(text.encode())
                report = self.report("cube.off", "--features", f"cube.{end}")
                self.assertEqual(counts(report), CUBE_COUNTS)
                self.assertEqual(report["warnings"], [])

    def test_curves_of_the_flange(self):
        """Its features as chains of several vertices."""
        pairs = read_features(flange_features())
        chains = []
        for a, b in pairs:
            if chains and chains[-1][-1] == a:
                chains[-1].append(b)
            else:
                chains.append([a, b])
        expected = counts(self.report(flange(), "--features", flange_features()))
        for first in (0, 1, -1):
            self.write("flange.yml", abc_text([(chain, True) for chain in chains], True, first))
            report = self.report(flange(), "--features", "flange.yml")
            self.assertEqual(counts(report), expected)
            self.assertEqual(report["warnings"], [] if first == 0 else [
                f"flange.yml: it counts vertices from {first} and not from 0"])

    def test_wrong_files(self):
        self.write_cube()
        text = abc_text(self.CURVES, True)
        for message, wrong in (
                ("'x' is no vertex index", text.replace("[0, 4]", "[0, x]")), ("has no end", text.split(", 7, 4")[0]),
                ("there is no list 'curves'", text.replace("curves", "curve")), ("x.yml:1: ", "0 1\n1 2\n"),
                ("of 12 edges of sharp curves are edges of the model", abc_text(
                    [(tuple(3 * v % 8 for v in vertices), sharp) for vertices, sharp in self.CURVES], True))):
            with self.subTest(message):
                self.write("x.yml", wrong)
                self.assert_fails(BAD_FILE, message, "cube.off", "--features", "x.yml")


if __name__ == "__main__":
    test_program.main()
