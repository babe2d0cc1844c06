#!/usr/bin/python3
"""Tests of the program cad_frame_field and of the examples; see --help for the arguments."""

import argparse
import collections
import csv
import functools
import json
import math
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

DONE, BAD_USAGE, BAD_FILE, NOT_SOLVED = range(4)
QUARTER_TURN = math.pi / 2
MAXIMUM_SKEWNESS = 0.45 * math.pi
ANGLE_TOLERANCE = 1e-3  # angles that differ by less count as equal where they decide on a number of quadrangles

paths = argparse.Namespace()  # set from the command line


# ---------------------------------------------------------------- vectors

def difference(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(a):
    return math.sqrt(dot(a, a))


def unit(a):
    length = norm(a)
    return (a[0] / length, a[1] / length, a[2] / length)


def rounded(a):
    return tuple(round(coordinate, 9) for coordinate in a)


def angle_near_zero(angle):
    """The angle that differs by full turns and is from -pi to pi."""
    return math.remainder(angle, 2 * math.pi)


# ---------------------------------------------------------------- files

def read_off(path):
    lines = [line for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]
    number_of_points, number_of_faces, _ = map(int, lines[1].split())
    points = [tuple(map(float, line.split())) for line in lines[2:2 + number_of_points]]
    faces = [tuple(map(int, line.split()))[1:] for line in lines[2 + number_of_points:][:number_of_faces]]
    return points, faces


def read_features(path):
    lines = (line.split("#")[0].split() for line in path.read_text().splitlines())
    return [tuple(map(int, words)) for words in lines if words]


def numbers_as_lines(rows):
    return "".join(" ".join(map(repr, row)) + "\n" for row in rows)


def off_text(points, faces):
    return f"OFF\n{len(points)} {len(faces)} 0\n" + numbers_as_lines(points) + numbers_as_lines(
        (len(face), *face) for face in faces)


def obj_text(points, faces):
    return "".join("v %r %r %r\n" % point for point in points) + "".join(
        "f %d %d %d\n" % tuple(vertex + 1 for vertex in face) for face in faces)


def ply_text(points, faces):
    return (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n"
            "property double x\nproperty double y\nproperty double z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
            + numbers_as_lines(points) + numbers_as_lines((3, *face) for face in faces))


def stl_text(points, faces):
    facets = ("facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % points[vertex] for vertex in face)
              + "endloop\nendfacet\n" for face in faces)
    return "solid model\n" + "".join(facets) + "endsolid model\n"


PlyElement = collections.namedtuple("PlyElement", "properties rows")
PLY_TYPES = {"double": "d", "int": "i", "uchar": "B"}
PLY_TRIANGLE = "list uchar int"


def read_ply(content):
    """The elements of a PLY file of triangles by name; a row of a face starts with 3 and its vertices."""
    header, body = content.split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    is_binary = lines[1] == "format binary_little_endian 1.0"
    words_of_body = iter(() if is_binary else body.split())
    elements, position = {}, 0
    for start, line in enumerate(lines):
        if not line.startswith("element "):
            continue
        _, name, count = line.split()
        properties = []  # (name, type)
        for property_line in lines[start + 1:]:
            if not property_line.startswith("property "):
                break
            property_type, property_name = property_line[len("property "):].rsplit(" ", 1)
            properties.append((property_name, property_type))
        codes = "".join("Biii" if kind == PLY_TRIANGLE else PLY_TYPES[kind] for _, kind in properties)
        if is_binary:
            row = struct.Struct("<" + codes)
            end = position + int(count) * row.size
            rows = list(row.iter_unpack(body[position:end]))
            position = end
        else:
            converters = [float if code == "d" else int for code in codes]
            rows = [tuple(convert(next(words_of_body)) for convert in converters) for _ in range(int(count))]
        elements[name] = PlyElement(properties, rows)
    if position != (len(body) if is_binary else 0) or next(words_of_body, None) is not None:
        raise ValueError("the file goes on after its last element")
    return elements


def read_vtp(content):
    """The attributes of the piece, and the arrays by the element they are in and their name."""
    text, data = content.split(b'<AppendedData encoding="raw">\n_', 1)
    text = text.decode()
    arrays, parent = {}, None
    for tag, attributes in re.findall(r"<([A-Za-z/]+)([^>]*)>", text):
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', attributes))
        if tag != "DataArray":
            parent = tag
            if tag == "Piece":
                piece = {name: int(value) for name, value in attributes.items()}
            continue
        start = int(attributes["offset"])
        size, = struct.unpack_from("<Q", data, start)
        code = {"Float64": "d", "Int32": "i", "Int64": "q"}[attributes["type"]]
        values = struct.unpack_from(f"<{size // struct.calcsize(code)}{code}", data, start + 8)
        width = int(attributes["NumberOfComponents"])
        arrays[parent, attributes["Name"]] = (
            values if width == 1 else [values[i:i + width] for i in range(0, len(values), width)])
    return piece, arrays


# ---------------------------------------------------------------- sectors and patches, computed independently

class DisjointSets:
    def __init__(self, size):
        self.parents = list(range(size))

    def find(self, i):
        parents = self.parents
        while parents[i] != i:
            parents[i] = parents[parents[i]]
            i = parents[i]
        return i

    def join(self, i, j):
        self.parents[self.find(i)] = self.find(j)


class Sector:
    def __init__(self, vertex, patch):
        self.vertex, self.patch, self.angle, self.is_constrained = vertex, patch, 0.0, False


class Cut:
    """A mesh of triangles, cut along features and borders. An edge is a pair of vertices in ascending order."""

    def __init__(self, points, faces, features):
        self.face_of = {}  # by halfedge: source, target
        for f, (a, b, c) in enumerate(faces):
            self.face_of[a, b] = self.face_of[b, c] = self.face_of[c, a] = f
        self.features = {(min(edge), max(edge)) for edge in features}
        self.features.update((min(h), max(h)) for h in self.face_of if h[::-1] not in self.face_of)
        self.inner_halfedges = [h for h in self.face_of if (min(h), max(h)) not in self.features]

        self._faces = faces
        patches, self._corners = DisjointSets(len(faces)), DisjointSets(3 * len(faces))
        for h in self.inner_halfedges:
            f, g = self.face_of[h], self.face_of[h[::-1]]
            patches.join(f, g)
            self._corners.join(self._corner(f, h[0]), self._corner(g, h[0]))

        self.patch_of = [patches.find(f) for f in range(len(faces))]
        self.sectors = {}  # by the number of a corner in it
        vertices_on_features = {vertex for edge in self.features for vertex in edge}
        for f, face in enumerate(faces):
            for k, vertex in enumerate(face):
                sector = self.sectors.setdefault(self._corners.find(3 * f + k), Sector(vertex, self.patch_of[f]))
                sector.is_constrained = vertex in vertices_on_features
                to_next = difference(points[face[k - 2]], points[vertex])
                to_previous = difference(points[face[k - 1]], points[vertex])
                sector.angle += math.atan2(norm(cross(to_next, to_previous)), dot(to_next, to_previous))

    def _corner(self, f, vertex):
        return 3 * f + self._faces[f].index(vertex)

    def sector_at_target(self, h):
        return self.sectors[self._corners.find(self._corner(self.face_of[h], h[1]))]

    def euler_characteristics(self):
        """By patch."""
        euler = collections.Counter(self.patch_of)
        for sector in self.sectors.values():
            euler[sector.patch] += 1
        for h, f in self.face_of.items():
            is_cut = (min(h), max(h)) in self.features
            euler[self.patch_of[f]] -= is_cut or h[0] < h[1]  # each side of a cut is an edge
        return euler

    def constrained_sectors_under(self, degrees):
        return [s for s in self.sectors.values() if s.is_constrained and s.angle < math.radians(degrees)]

    def faces_with_several_features(self):
        number = collections.Counter(self.face_of[h] for e in self.features for h in (e, e[::-1]) if h in self.face_of)
        return [f for f in number if number[f] > 1]


class Field:
    """A field as the program wrote it to a PLY file."""

    def __init__(self, content, report):
        self.report = report
        self.elements = read_ply(content)
        self.points = self.elements["vertex"].rows
        self.faces = [row[1:4] for row in self.elements["face"].rows]
        self.alpha, self.rho = zip(*(row[4:6] for row in self.elements["face"].rows))
        self.u, self.v = zip(*((row[6:9], row[9:12]) for row in self.elements["face"].rows))
        self.features = {(min(a, b), max(a, b)) for a, b, is_feature in self.elements["edge"].rows if is_feature}
        halfedges = self.elements["halfedge"].rows
        self.matching = {(source, target): matching for source, target, matching, _, _ in halfedges}
        self.rotation = {(source, target): rotation for source, target, _, rotation, _ in halfedges}
        self.index = {(source, target): index for source, target, _, _, index in halfedges}

    @functools.cached_property
    def cut(self):
        return Cut(self.points, self.faces, self.features)

    @functools.cached_property
    def normals(self):
        corners = ([self.points[vertex] for vertex in face] for face in self.faces)
        return [unit(cross(difference(b, a), difference(c, a))) for a, b, c in corners]

    def direction(self, h):
        return unit(difference(self.points[h[1]], self.points[h[0]]))

    def branch_angle(self, f, branch, axis):
        """The angle of a branch of the cross of a face, from an axis in its plane, up to full turns."""
        vector = (self.u, self.v)[branch % 2][f]
        angle = math.atan2(dot(vector, cross(self.normals[f], axis)), dot(vector, axis))
        return angle + (math.pi if branch % 4 > 1 else 0)

    def turn(self, h, branch):
        """By what angle a branch turns across a halfedge, with the faces unfolded, up to full turns."""
        axis = self.direction(h)
        f, g = self.cut.face_of[h], self.cut.face_of[h[::-1]]
        return self.branch_angle(g, branch + self.matching[h], axis) - self.branch_angle(f, branch, axis)

    def index_by_sector(self):
        return {self.cut.sector_at_target(h): self.index[h] for h in self.cut.face_of}


# ---------------------------------------------------------------- running the program

CUBE_POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
CUBE_SQUARES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
CUBE_FACES = [triangle for a, b, c, d in CUBE_SQUARES for triangle in ((a, b, c), (a, c, d))]
CUBE_EDGES = sorted({tuple(sorted((square[k - 1], square[k]))) for square in CUBE_SQUARES for k in range(4)})
CUBE_COUNTS = {
    "faces": 12, "vertices": 8, "patches": 6, "feature_edges": 12, "split_faces": 12, "faces_after_split": 36,
    "sharp_corners": 24, "unmeshable_before": 0, "unmeshable_after": 0,
    "index_histogram": {"interior": {"0": 12}, "constrained": {"1": 24}}}


def run(program, *arguments, **settings):
    return subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, **settings)


def counts(report):
    return {name: report[name] for name in CUBE_COUNTS}


def flange():
    return paths.sources / "examples/Frame_fields/data/flange.off"


def flange_features():
    return flange().with_suffix(".feat")


def computed_field(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        ply, report = pathlib.Path(folder, "out.ply"), pathlib.Path(folder, "out.json")
        completed = run(paths.program, *arguments, "-o", ply, "--report", report, "--quiet")
        if completed.returncode != DONE:
            raise AssertionError(completed.stderr)
        return Field(ply.read_bytes(), json.loads(report.read_text()))


@functools.lru_cache(maxsize=None)
def flange_field(*options):
    return computed_field(flange(), "--features", flange_features(), *options)


@functools.lru_cache(maxsize=None)
def flange_cut():
    return Cut(*read_off(flange()), read_features(flange_features()))


@functools.lru_cache(maxsize=None)
def python_with(module):
    """A Python that has a module, or None."""
    return next((python for python in ("/usr/bin/python3", sys.executable) if os.access(python, os.X_OK)
                 and run(python, "-c", f"import {module}").returncode == 0), None)


class ProgramTest(unittest.TestCase):
    """Runs the program in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def write_cube(self):
        return self.write("cube.off", off_text(CUBE_POINTS, CUBE_FACES))

    def write_features(self, pairs, name="model.feat"):
        return self.write(name, numbers_as_lines(pairs))

    def run_program(self, *arguments, **settings):
        return run(paths.program, *arguments, cwd=self.folder, **settings)

    def succeed(self, *arguments):
        completed = self.run_program(*arguments)
        self.assertEqual(completed.returncode, DONE, completed.stderr)
        return completed

    def run_example_on(self, name, *models):
        """The words of each line that an example prints."""
        example = paths.program.with_name(name)
        for path in (example, *models):
            if not path.is_file():
                self.skipTest(f"there is no {path}")
        completed = run(example, *models)
        self.assertEqual(completed.returncode, 0, completed.stderr)
        return [line.split() for line in completed.stdout.splitlines()]

    def report(self, *arguments):
        self.succeed(*arguments, "--quiet", "--report", "out.json")
        return json.loads((self.folder / "out.json").read_text())

    def output(self, *arguments):
        self.succeed(*arguments, "--quiet", "-o", "out.ply")
        return (self.folder / "out.ply").read_bytes()

    def content_of_folder(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def assert_fails(self, exit_code, message, *arguments, **settings):
        """Expects one line on stderr that holds the message, nothing on stdout, and no change in the folder."""
        content = self.content_of_folder()
        completed = self.run_program(*arguments, **settings)
        self.assertEqual(completed.returncode, exit_code, completed.stderr)
        self.assertRegex(completed.stderr, rf"\A{paths.program.name}: error: .*\n\Z")
        self.assertIn(message, completed.stderr)
        self.assertFalse(completed.stdout)
        self.assertEqual(self.content_of_folder(), content)

    def assert_poincare_hopf(self, field):
        """The indices of each patch sum up to its Euler characteristic."""
        sums = collections.Counter()
        for sector, index in field.index_by_sector().items():
            sums[sector.patch] += index
        euler = field.cut.euler_characteristics()
        self.assertEqual(sums, collections.Counter({patch: 4 * number for patch, number in euler.items()}))
        self.assertEqual(len(euler), field.report["patches"])


# ---------------------------------------------------------------- the tests

class Usage(ProgramTest):
    def test_help_names_every_option(self):
        text = self.succeed("--help").stdout
        manual = (paths.sources / "doc/Frame_fields/Programs.txt").read_text()
        for option in ("MODEL", "--features", "--feature-angle", "--weak-angle", "--close-gaps", "--min-chain-length",
                       "--write-features", "--support", "none", "local", "rings:K", "radius:R", "component",
                       "--edge-weights", "--curvature-weight", "--index-targets", "--sharp-corner-bound",
                       "--blunt-corner-bound", "--no-repair", "--no-relaxation", "--no-baseline", "--compare",
                       "--threads", "-o", "--ascii", "--vtp",
                       "--field", "--report", "--no-merge", "--close-cracks", "--quiet", "--verbose", "--help",
                       "--version", "Exit codes"):
            with self.subTest(option):
                self.assertIn(option, text)
                self.assertIn(option.lower(), manual.lower())

    def test_manual_names_every_option_of_the_help(self):
        manual = (paths.sources / "doc/Frame_fields/Programs.txt").read_text()
        for option in re.findall(r"^  .*?(--[a-z-]+)", self.succeed("--help").stdout, re.MULTILINE):
            self.assertIn(option, manual)

    def test_version_is_that_of_the_project(self):
        cmake = (paths.sources / "CMakeLists.txt").read_text()
        version = re.search(r"project\(Frame_fields VERSION ([\d.]+)", cmake).group(1)
        self.assertEqual(self.succeed("--version").stdout, f"cad_frame_field {version}\n")

    def test_wrong_command_lines(self):
        cube = self.write_cube()
        self.write_features(CUBE_EDGES)
        for message, arguments in (
                ("MODEL", ""), ("MODEL", "--quiet"), ("positional", "cube.off cube.off"),
                ("--suport", "cube.off --suport none"), ("'ring'", "cube.off --support ring"),
                ("'rings:'", "cube.off --support rings:"), ("'rings:-1'", "cube.off --support rings:-1"),
                ("'rings:1x'", "cube.off --support rings:1x"),
                ("'rings:99999999999'", "cube.off --support rings:99999999999"),
                ("--sharp-corner-bound", "cube.off --sharp-corner-bound nan"),
                ("--sharp-corner-bound", "cube.off --sharp-corner-bound 361"),
                ("--sharp-corner-bound", "cube.off --sharp-corner-bound -1"),
                ("--blunt-corner-bound", "cube.off --blunt-corner-bound -1"),
                ("--feature-angle", "cube.off --feature-angle sharp"),
                ("--feature-angle", "cube.off --feature-angle 181"),
                ("--weak-angle", "cube.off --weak-angle nan"), ("--weak-angle", "cube.off --weak-angle 41"),
                ("--min-chain-length", "cube.off --min-chain-length -1"),
                ("--min-chain-length", "cube.off --min-chain-length nan"),
                ("--weak-angle", "cube.off --features model.feat --weak-angle 30"),
                ("--close-gaps", "cube.off --features model.feat --close-gaps"),
                ("--min-chain-length", "cube.off --features model.feat --min-chain-length 3"),
                ("--threads", "cube.off --threads 0"), ("--threads", "cube.off --threads many"),
                (".rosy", "cube.off --field out.txt"), (".rosy", "cube.off --compare model.feat"),
                ("--close-cracks", "cube.off --close-cracks -1"), ("--close-cracks", "cube.off --close-cracks nan"),
                ("YAML", "cube.off --write-features out.yml"),
                ("--features", "cube.off --features model.feat --feature-angle 30"),
                ("--output", "cube.off -o"), ("--output", "cube.off -o a.ply -o b.ply"),
                ("--quiet", "cube.off --quiet=1")):
            with self.subTest(arguments):
                self.assert_fails(BAD_USAGE, message, *arguments.split())
        self.assert_fails(BAD_USAGE, "--features", cube, "--features", "")
        self.assert_fails(BAD_USAGE, "MODEL", "")

    def test_files_that_are_the_same_under_any_name(self):
        self.write_cube()
        self.write_features(CUBE_EDGES)
        for arguments in ("-o out --vtp out", "-o out --report ./out", "--field a.rosy --field a.rosy",
                          "--write-features cube.off", "--report cube.off", "--report ./cube.off",
                          "--features model.feat --vtp model.feat"):
            with self.subTest(arguments):
                self.assert_fails(BAD_USAGE, arguments.split("/")[-1].split()[-1], "cube.off", *arguments.split())

    def test_table_shows_the_numbers_of_the_report(self):
        table = self.succeed(flange(), "--features", flange_features(), "--report", "out.json").stdout
        report = json.loads((self.folder / "out.json").read_text())
        rows = dict(re.split(r" {2,}", line.strip(), maxsplit=1) for line in table.splitlines())
        for row, key in (("faces", "faces"), ("patches", "patches"), ("feature edges", "feature_edges"),
                         ("components", "components"), ("border edges", "border_edges"),
                         ("border loops", "border_loops"), ("sharp corners", "sharp_corners"),
                         ("clamped faces", "clamped_faces")):
            self.assertEqual(int(rows[row]), report[key], row)
        self.assertEqual(rows["unmeshable corners"],
                         f"{report['unmeshable_before']} -> {report['unmeshable_after']}")
        for row, key in (("interior sectors", "interior"), ("sectors on features", "constrained")):
            numbers = re.findall(r"(\d+) of index", rows[row])
            self.assertEqual(list(map(int, numbers)), list(report["index_histogram"][key].values()), row)
        for row, key in (("orthogonal energy", "energy_orthogonal"), ("relaxed energy", "energy_relaxed")):
            self.assertAlmostEqual(float(rows[row]) / report[key], 1, delta=1e-5, msg=row)
        self.assertEqual(int(rows["dangling ends"]), len(report["dangling_ends"]))
        self.assertEqual(len([line for line in table.splitlines() if line.startswith("  ")]), 5, "stages")

    def test_quiet_prints_nothing(self):
        completed = self.succeed(self.write_cube(), "--quiet")
        self.assertEqual(completed.stdout + completed.stderr, "")


class Terminal(ProgramTest):
    def test_progress_is_shown_on_a_terminal_only_and_not_when_quiet(self):
        self.write_cube()
        self.assertEqual(self.run_program("cube.off").stderr, "")
        for options, is_shown in (((), True), (("--quiet",), False)):
            try:
                terminal, stderr = pty.openpty()
            except OSError as error:
                self.skipTest(f"no pseudo-terminal: {error}")
            subprocess.run([paths.program, "cube.off", *options], cwd=self.folder, stdout=subprocess.DEVNULL,
                           stderr=stderr, check=True)
            os.write(stderr, b"end")  # otherwise there may be nothing to read
            os.close(stderr)
            shown = os.read(terminal, 10000)
            os.close(terminal)
            self.assertEqual(b"reading cube.off" in shown, is_shown)


class InvalidInput(ProgramTest):
    def test_models_that_are_no_files(self):
        (self.folder / "folder.off").mkdir()
        for name in ("missing.off", "missing/cube.off", "folder.off"):
            with self.subTest(name):
                self.assert_fails(BAD_FILE, name, name)

    def test_damaged_models(self):
        off, obj, ply, stl = (text(CUBE_POINTS, CUBE_FACES) for text in (off_text, obj_text, ply_text, stl_text))
        for reason, name, text in (
                ("empty", "model.off", ""), ("without faces", "model.off", off_text(CUBE_POINTS, [])),
                ("ends in the vertices", "model.off", off[:40]), ("ends in the faces", "model.off", off[:100]),
                ("NaN", "model.off", off.replace("1 0 0\n", "1 nan 0\n", 1)),
                ("infinity", "model.off", off.replace("1 0 0\n", "1 inf 0\n", 1)),
                ("overflow", "model.off", off.replace("1 0 0\n", "1 1e999 0\n", 1)),
                ("index too large", "model.off", off_text(CUBE_POINTS, CUBE_FACES + [(0, 1, 8)])),
                ("negative index", "model.off", off_text(CUBE_POINTS, CUBE_FACES + [(0, 1, -1)])),
                ("more vertices than memory", "model.off", off.replace("8 12", "8000000000000 12")),
                ("more faces than memory", "model.off", off.replace("8 12", "8 12000000000000")),
                ("unknown kind", "model.xyz", off), ("no extension", "model", off),
                ("no OBJ", "model.obj", off), ("no PLY", "model.ply", off), ("no STL", "model.stl", off),
                ("NaN in OBJ", "model.obj", obj.replace("v 1", "v nan", 1)),
                ("index in OBJ", "model.obj", obj + "f 1 2 9\n"), ("index 0 in OBJ", "model.obj", obj + "f 1 2 0\n"),
                ("NaN in PLY", "model.ply", ply.replace("1 0 0\n", "nan 0 0\n", 1)),
                ("PLY ends in the faces", "model.ply", ply[:-20]),
                ("PLY ends in the header", "model.ply", ply[:100]),
                ("NaN in STL", "model.stl", stl.replace("vertex 1", "vertex nan", 1)),
                ("STL ends in a facet", "model.stl", stl[:200])):
            with self.subTest(reason):
                self.assert_fails(BAD_FILE, name, self.write(name, text))

    def test_message_names_the_line_of_an_off_file(self):
        lines = off_text(CUBE_POINTS, CUBE_FACES).splitlines(keepends=True)
        lines[4] = "1 nan 0\n"
        self.assert_fails(BAD_FILE, "line 5, '1 nan 0'", self.write("model.off", "".join(lines)))

    def test_binary_coordinates_that_are_not_finite(self):
        header = ply_text([(0, 0, 0)] * 3, []).replace("ascii", "binary_little_endian").replace("face 0", "face 1")
        header = header[:header.index("end_header\n")] + "end_header\n"
        for value in (math.nan, math.inf):
            content = header.encode() + struct.pack("<9dB3i", 0, 0, 0, 1, 0, 0, 0, value, 0, 3, 0, 1, 2)
            (self.folder / "model.ply").write_bytes(content)
            self.assert_fails(BAD_FILE, f"model.ply: byte {len(header) + 48}: vertex 2 ", "model.ply")

    def test_feature_files(self):
        self.write_cube()
        self.assert_fails(BAD_FILE, "missing.feat", "cube.off", "--features", "missing.feat")
        self.assert_fails(BAD_FILE, ".: ", "cube.off", "--features", ".")
        for line in ("3", "1 2 3", "a b", "1 b", "1.5 2", "-1 2", "0 8", "0 99999999999999999999"):
            with self.subTest(line):
                self.write("wrong.feat", f"# a comment\n0 1\n{line}\n")
                self.assert_fails(BAD_FILE, "wrong.feat:3: ", "cube.off", "--features", "wrong.feat")

    def test_feature_file_without_any_edge_of_the_model(self):
        self.write_cube()
        self.write("other.feat", "0 6\n1 7\n")
        self.assert_fails(BAD_FILE, "other.feat", "cube.off", "--features", "other.feat")

    def test_field_that_does_not_exist(self):
        """With all eight corners of this ring sharp, nothing is left to compensate what they prescribe."""
        points = [(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0), (-2, -2, 0), (2, -2, 0), (0.8, 1, 0), (-1.5, 0.3, 0)]
        faces = [(k, (k + 1) % 4, (k + 1) % 4 + 4) for k in range(4)] + [(k, (k + 1) % 4 + 4, k + 4) for k in range(4)]
        ring = self.write("ring.off", off_text(points, faces))
        self.succeed(ring)
        self.assert_fails(NOT_SOLVED, "ring.off: ", ring, "--sharp-corner-bound", "360", "-o", "out.ply",
                          "--vtp", "out.vtp", "--report", "out.json")


def cube_text(scale=1.0):
    return off_text([tuple(scale * coordinate for coordinate in point) for point in CUBE_POINTS], CUBE_FACES)


class HostileInput(ProgramTest):
    """Whatever the input: a documented exit code, one line for an error, no partial output, inputs as they were."""

    OUTPUTS = ("out.ply", "out.vtp", "out.json", "out.rawfield")

    def run_with_outputs(self, *arguments):
        before = self.content_of_folder()
        completed = self.run_program(*arguments, "-o", "out.ply", "--vtp", "out.vtp", "--streamlines",
                                     "--report", "out.json", "--field", "out.rawfield", "--quiet", timeout=60)
        after = self.content_of_folder()
        self.assertEqual({name: after[name] for name in before}, before, "inputs are changed")
        expected = set(before) | (set(self.OUTPUTS) if completed.returncode == DONE else set())
        self.assertEqual(set(after), expected)
        for name in set(after) - set(before):
            os.remove(self.folder / name)
        if completed.returncode == DONE:
            field = Field(after["out.ply"], json.loads(after["out.json"]))
            self.assertTrue(all(map(math.isfinite, field.alpha + field.rho)))
        else:
            self.assertIn(completed.returncode, (BAD_FILE, NOT_SOLVED))
            self.assertRegex(completed.stderr.splitlines()[-1], r"\Acad_frame_field: error: [^:]+: .")
        return completed

    def test_coordinates_of_any_size(self):
        for scale in (1e300, 1e150, 1e-150, 1e-300):
            with self.subTest(scale):
                completed = self.run_with_outputs(self.write("cube.off", cube_text(scale)))
                self.assertEqual(completed.returncode, DONE, completed.stderr)
                self.assertEqual(counts(self.report("cube.off")), CUBE_COUNTS)
                os.remove(self.folder / "out.json")

    def test_sizes_that_do_not_go_together(self):
        for name, point in (("far", (1e300, 1e300, 1e300)), ("near", (1e-300, 0, 0)),
                            ("largest", (1.7e308, -1.7e308, 0)), ("smallest", (5e-324, 0, 0))):
            with self.subTest(name):
                points = [*CUBE_POINTS[:6], point, CUBE_POINTS[7]]
                self.run_with_outputs(self.write("cube.off", off_text(points, CUBE_FACES)))

    def test_faces_without_area(self):
        middle = [(0.5, 0, 0), (0.5, 0, 1)]
        for name, points, faces in (
                ("collinear", CUBE_POINTS + middle[:1], [*CUBE_FACES, (0, 1, 8)]),
                ("cap", CUBE_POINTS + middle[:1], [f for f in CUBE_FACES if set(f) != {0, 1, 5}]
                 + [(0, 8, 5), (8, 1, 5), (0, 1, 8)]),
                ("zero length", CUBE_POINTS + [CUBE_POINTS[0]], [*CUBE_FACES, (0, 8, 1)]),
                ("all in a line", [(k, 0, 0) for k in range(4)], [(0, 1, 2), (1, 2, 3)]),
                ("one point", [(1, 2, 3)] * 3, [(0, 1, 2)]),
                ("needle", [(0, 0, 0), (1, 0, 0), (1, 1e-200, 0)], [(0, 1, 2)])):
            with self.subTest(name):
                self.run_with_outputs(self.write("model.off", off_text(points, faces)))

    def test_surfaces_that_are_no_manifolds(self):
        strip = [(math.cos(a) * (2 + w * math.cos(a / 2)), math.sin(a) * (2 + w * math.cos(a / 2)), w * math.sin(a / 2))
                 for a in (2 * math.pi * k / 12 for k in range(12)) for w in (-0.5, 0.5)]
        quads = [(2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2) for k in range(11)] + [(22, 23, 0, 1)]
        moebius = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
        wing = [(0, 0, 2), (0, 2, 0)]
        for name, points, faces in (
                ("Moebius strip", strip, moebius), ("Moebius strip of quadrangles", strip, quads),
                ("edge of three faces", CUBE_POINTS + wing, [*CUBE_FACES, (0, 1, 8)]),
                ("edge of four faces", CUBE_POINTS + wing, [*CUBE_FACES, (0, 1, 8), (1, 0, 9)]),
                ("vertex of two fans", CUBE_POINTS + [(-1, 0, 0), (0, -1, -1)], [*CUBE_FACES, (0, 8, 9)]),
                ("isolated vertices", [*CUBE_POINTS, (9, 9, 9), (8, 8, 8)], CUBE_FACES),
                ("isolated vertex that is no number", [*CUBE_POINTS, (math.nan, 0, 0)], CUBE_FACES),
                ("duplicate faces", CUBE_POINTS, CUBE_FACES * 2),
                ("opposite faces", CUBE_POINTS, CUBE_FACES + [face[::-1] for face in CUBE_FACES]),
                ("face that touches itself", CUBE_POINTS, [*CUBE_SQUARES, (0, 1, 0, 3)]),
                ("face of two vertices", CUBE_POINTS, [*CUBE_FACES, (0, 1)]),
                ("concave polygon", [(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 0.1, 0), (0, 2, 0)], [(0, 1, 2, 3, 4)]),
                ("polygon that crosses itself", [(0, 0, 0), (2, 2, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2, 3)]),
                ("twisted quadrangle", [(0, 0, 0), (1, 0, 1), (1, 1, 0), (0, 1, 1)], [(0, 1, 2, 3)])):
            with self.subTest(name):
                self.run_with_outputs(self.write("model.off", off_text(points, faces)))

    def test_files_cut_at_any_byte(self):
        for name, text in (("model.off", off_text), ("model.obj", obj_text), ("model.ply", ply_text),
                           ("model.stl", stl_text)):
            content = text(CUBE_POINTS, CUBE_FACES)
            for end in range(0, len(content), 37):
                with self.subTest(name, end=end):
                    self.run_with_outputs(self.write(name, content[:end]))

    def test_folder_that_takes_no_files(self):
        self.assert_fails(BAD_FILE, "/proc/out.ply", self.write_cube(), "-o", "/proc/out.ply")

    def test_190_of_200_models_succeed_and_each_of_10_broken_ones_tells_what_it_is(self):
        broken = {
            "missing.off": None, "empty.off": "", "nan.off": cube_text().replace("1.0 0.0 0.0", "1 nan 0"),
            "faceless.off": off_text(CUBE_POINTS, []), "index.off": off_text(CUBE_POINTS, [(0, 1, 8)]),
            "cut.off": cube_text()[:100], "kind.xyz": cube_text(), "noply.ply": cube_text(),
            "degenerate.off": off_text(CUBE_POINTS, [(0, 0, 1)]), "noobj.obj": "f 1 2 0\n"}
        for name, text in broken.items():
            if text is not None:
                self.write(name, text)
        names = list(broken)
        for k in range(190):
            names.insert(20 * k // 19, self.write(f"cube_{k}.off", cube_text(1 + k)))
        codes, messages = collections.Counter(), {}
        for name in names:
            completed = self.run_program(name, "--quiet", "--no-baseline", "-o", "out.ply")
            codes[completed.returncode] += 1
            if completed.returncode != DONE:
                messages[name] = completed.stderr.splitlines()[-1]
        self.assertEqual(codes, {DONE: 190, BAD_FILE: 10})
        self.assertEqual(set(messages), set(broken))
        for name, message in messages.items():
            self.assertTrue(message.startswith(f"cad_frame_field: error: {name}: "), message)
        self.assertEqual(len({message.split(": ", 3)[3] for message in messages.values()}), 10, messages)


class Permissions(ProgramTest):
    """Since nothing is forbidden to root, tests of root run the program as a user without rights."""

    USER_WITHOUT_RIGHTS = 65534

    def setUp(self):
        super().setUp()
        self.program, self.user = paths.program, {}
        if os.geteuid() == 0:
            self.program = shutil.copy(paths.program, self.folder)  # which that user may not see where it lies
            self.user = {"user": self.USER_WITHOUT_RIGHTS, "group": self.USER_WITHOUT_RIGHTS, "extra_groups": []}
            try:
                os.chown(self.folder, self.USER_WITHOUT_RIGHTS, self.USER_WITHOUT_RIGHTS)
                self.run_program("--version", check=True)
            except (OSError, subprocess.SubprocessError) as error:
                self.skipTest(f"root cannot run the program as another user: {error}")
        (self.folder / "folder").mkdir()
        self.write("folder/cube.off", cube_text())

    def run_program(self, *arguments, **settings):
        return run(self.program, *arguments, cwd=self.folder, **self.user, **settings)

    def give_away(self, name, mode):
        os.chmod(self.folder / name, mode)
        if self.user:
            os.chown(self.folder / name, self.USER_WITHOUT_RIGHTS, self.USER_WITHOUT_RIGHTS)

    def test_folder_that_must_not_be_written(self):
        (self.folder / "locked").mkdir()
        self.give_away("locked", 0o500)
        self.assert_fails(BAD_FILE, "no permission", "folder/cube.off", "-o", "locked/out.ply")
        self.assertEqual(list((self.folder / "locked").iterdir()), [])

    def test_model_that_must_not_be_read(self):
        self.give_away("folder/cube.off", 0)
        self.assert_fails(BAD_FILE, "folder/cube.off: ", "folder/cube.off", "-o", "out.ply")

    def test_old_file_that_must_not_be_written(self):
        (self.folder / "locked").mkdir()
        self.write("locked/out.ply", "old")
        self.give_away("locked/out.ply", 0o400)
        self.give_away("locked", 0o500)
        self.assert_fails(BAD_FILE, "locked/out.ply", "folder/cube.off", "-o", "locked/out.ply")
        self.assertEqual([path.read_text() for path in (self.folder / "locked").iterdir()], ["old"])


class Signals(ProgramTest):
    def start(self, *arguments, **settings):
        return subprocess.Popen([paths.program, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **settings)

    def grid(self, number):
        """A fine square grid with a height, as OFF."""
        points = [(x, y, math.sin(x / 9) * math.cos(y / 7)) for y in range(number) for x in range(number)]
        faces = [triangle for y in range(number - 1) for v in range(y * number, (y + 1) * number - 1)
                 for triangle in ((v, v + 1, v + number + 1), (v, v + number + 1, v + number))]
        return self.write("grid.off", off_text(points, faces))

    def test_no_unfinished_file_is_left_whenever_the_signal_comes(self):
        model = self.grid(60)
        start = time.monotonic()
        self.succeed(model, "-o", "whole.ply", "--ascii", "--vtp", "whole.vtp", "--quiet")
        duration = time.monotonic() - start
        whole = {path.suffix: path.read_bytes() for path in self.folder.glob("whole.*")}
        endings = collections.Counter()
        number = 24
        for k in range(number):
            for suffix in whole:
                self.write("out" + suffix, "old")
            process = self.start(model, "-o", "out.ply", "--ascii", "--vtp", "out.vtp", "--quiet")
            time.sleep(duration * k / number)
            sent = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)[k % 3]
            process.send_signal(sent)
            status = process.wait()
            self.assertIn(status, (DONE, -sent))
            endings[status == DONE] += 1
            self.assertEqual({path.name for path in self.folder.iterdir()},
                             {model, "whole.ply", "whole.vtp", "out.ply", "out.vtp"})
            for suffix, content in whole.items():
                self.assertIn((self.folder / ("out" + suffix)).read_bytes(), (b"old", content))
        self.assertGreater(endings[False], number // 4)

    def test_signal_while_a_file_is_being_written(self):
        model = self.grid(120)
        interrupted = 0
        for _ in range(4):
            process = self.start(model, "-o", "out.ply", "--ascii", "--no-repair", "--no-relaxation", "--no-baseline",
                                 "--quiet")
            while process.poll() is None and not list(self.folder.glob("*.part")):
                pass
            process.terminate()
            interrupted += process.wait() == -signal.SIGTERM
            self.assertFalse(list(self.folder.glob("*.part")))
        self.assertGreater(interrupted, 0)

    def test_signal_that_is_ignored_stays_so(self):
        process = self.start(self.grid(60), "-o", "out.ply", "--quiet",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        time.sleep(0.05)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(), DONE)


class Threads(ProgramTest):
    def test_output_does_not_depend_on_their_number(self):
        arguments = (flange(), "--features", flange_features(), "--vtp", "out.vtp", "--field", "out.rawfield")
        outputs = []
        for number in ("1", "1", "2", "8"):
            completed = self.run_program(flange(), "--threads", number, "--quiet")
            if completed.returncode == BAD_USAGE and number != "1":
                self.assertIn("without TBB", completed.stderr)
                self.skipTest("the program was built without TBB")
            outputs.append((self.output(*arguments, "--threads", number), (self.folder / "out.vtp").read_bytes(),
                            (self.folder / "out.rawfield").read_bytes()))
        for output in outputs:
            self.assertEqual(output, outputs[0])
        self.assertEqual(self.output(*arguments), outputs[0][0])


class Outputs(ProgramTest):
    def test_outputs_that_cannot_be_written(self):
        cube = self.write_cube()
        (self.folder / "folder").mkdir()
        for option in ("-o", "--vtp", "--report"):
            for path in ("/dev/full", "missing/out", "folder", "cube.off/out"):
                with self.subTest(option=option, path=path):
                    self.assert_fails(BAD_FILE, path, cube, option, path)

    def test_wrong_path_is_found_before_anything_is_written(self):
        self.assert_fails(BAD_FILE, "missing/out", self.write_cube(), "-o", "out.ply", "--report", "missing/out")

    def test_full_disk_leaves_the_old_file(self):
        self.write_cube()
        self.write("out.ply", "old")
        self.assert_fails(BAD_FILE, "out.ply", "cube.off", "-o", "out.ply", restore_signals=False,  # ignores SIGXFSZ
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))

    def test_standard_output_that_cannot_be_written(self):
        for arguments in ((self.write_cube(),), ("--help",), ("--version",)):
            with open("/dev/full", "w") as full:
                completed = subprocess.run([paths.program, *arguments], cwd=self.folder, stdout=full,
                                           stderr=subprocess.PIPE, text=True)
            self.assertEqual(completed.returncode, BAD_FILE)
            self.assertIn("standard output", completed.stderr)

    def test_nothing_else_is_left_in_the_folder(self):
        self.succeed(self.write_cube(), "-o", "out.ply", "--vtp", "out.vtp", "--report", "out.json")
        self.assertEqual(set(self.content_of_folder()), {"cube.off", "out.ply", "out.vtp", "out.json"})

    def test_pipe(self):
        piped = self.succeed(self.write_cube(), "-o", "/dev/stdout", "--ascii", "--quiet").stdout
        self.assertEqual(piped.encode(), self.output("cube.off", "--ascii"))

    def test_symbolic_link_stays_one(self):
        link = self.folder / "link.ply"
        link.symlink_to(self.write("target.ply", "old"))
        self.succeed(self.write_cube(), "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertTrue(link.read_text("latin-1").startswith("ply\n"))

    def test_symbolic_link_to_nothing_makes_its_target(self):
        (self.folder / "folder").mkdir()
        link, second = self.folder / "link.ply", self.folder / "second.ply"
        second.symlink_to("folder/target.ply")
        link.symlink_to("second.ply")
        self.succeed(self.write_cube(), "-o", link)
        self.assertTrue(link.is_symlink() and second.is_symlink())
        self.assertTrue((self.folder / "folder/target.ply").is_file())
        lost = self.folder / "lost.ply"
        lost.symlink_to("missing/target.ply")
        self.assert_fails(BAD_FILE, "lost.ply: there is no folder", "cube.off", "-o", "lost.ply")


class Report(ProgramTest):
    def test_keys_and_types(self):
        report = self.report(self.write_cube())
        for keys, kind in (
                ("components border_edges border_loops", int),
                ("faces vertices patches feature_edges split_faces faces_after_split sharp_corners unmeshable_before "
                 "unmeshable_after clamped_faces", int),
                ("energy_orthogonal energy_relaxed peak_memory_mib", float),
                ("unmeshable_sectors changed_sectors warnings", list), ("index_histogram seconds", dict)):
            for key in keys.split():
                self.assertIs(type(report[key]), kind, key)
        self.assertEqual(list(report["seconds"]), ["cut_surface", "prescribed_rotation", "orthogonal",
                                                   "matching_and_indices", "relaxation", "total"])
        for seconds in report["seconds"].values():
            self.assertIs(type(seconds), float)
            self.assertTrue(0 <= seconds <= report["seconds"]["total"])
        self.assertGreater(report["peak_memory_mib"], 0)

    def test_cube(self):
        report = self.report(self.write_cube())
        self.assertEqual(counts(report), CUBE_COUNTS)
        self.assertAlmostEqual(report["energy_orthogonal"], 0, delta=1e-20)
        self.assertAlmostEqual(report["energy_relaxed"], 0, delta=1e-20)

    def test_counts_of_the_flange(self):
        report, cut = flange_field().report, flange_cut()
        points, faces = read_off(flange())
        sectors = collections.Counter(sector.is_constrained for sector in cut.sectors.values())
        self.assertEqual((report["vertices"], report["faces"]), (len(points), len(faces)))
        self.assertEqual(report["feature_edges"], len(cut.features))
        self.assertEqual(report["patches"], len(set(cut.patch_of)))
        self.assertEqual(report["split_faces"], len(cut.faces_with_several_features()))
        self.assertEqual(report["faces_after_split"], report["faces"] + 2 * report["split_faces"])
        self.assertEqual(report["sharp_corners"], len(cut.constrained_sectors_under(135)))
        interior, constrained = (report["index_histogram"][key] for key in ("interior", "constrained"))
        self.assertEqual(sum(interior.values()), sectors[False] + report["split_faces"])
        self.assertEqual(sum(constrained.values()), sectors[True])

    def test_indices_sum_up_to_the_euler_characteristic(self):
        histogram = flange_field().report["index_histogram"]
        total = sum(int(index) * number for part in histogram.values() for index, number in part.items())
        self.assertEqual(total, 4 * sum(flange_cut().euler_characteristics().values()))

    def test_unmeshable_sectors_are_those_under_45_degrees_without_correction(self):
        report = flange_field("--support", "none", "--no-repair").report
        sectors = report["unmeshable_sectors"]
        self.assertEqual(len(sectors), report["unmeshable_after"])
        self.assertEqual(len(sectors), report["unmeshable_before"])
        sharpest = flange_cut().constrained_sectors_under(45)
        self.assertGreater(len(sharpest), 0)
        for sector, expected in zip(sorted(sectors, key=lambda s: (s["vertex"], s["angle"])),
                                    sorted(sharpest, key=lambda s: (s.vertex, s.angle))):
            self.assertEqual((sector["vertex"], sector["index"]), (expected.vertex, 2))
            self.assertAlmostEqual(sector["angle"], math.degrees(expected.angle), delta=1e-9)
        self.assertEqual(len(sectors), len(sharpest))

    def test_no_unmeshable_sectors_with_correction(self):
        report = flange_field().report
        self.assertEqual((report["unmeshable_after"], report["unmeshable_sectors"]), (0, []))
        self.assertEqual(report["unmeshable_before"], len(flange_cut().constrained_sectors_under(45)))

    def test_changed_sectors_are_those_that_the_repair_changed(self):
        def key(sector):
            return sector["vertex"], round(sector["angle"], 9)

        before = flange_field("--support", "none", "--no-repair").report
        after = flange_field("--support", "none").report
        changed = {key(sector): sector["index"] for sector in after["changed_sectors"]}
        self.assertEqual(before["changed_sectors"], [])
        self.assertEqual(len(changed), len(after["changed_sectors"]))
        vertices_on_features = {vertex for edge in flange_cut().features for vertex in edge}
        repaired = [sector for sector in after["changed_sectors"] if sector["vertex"] in vertices_on_features]
        self.assertEqual(after["repaired_sectors"], len(repaired))
        for sector in repaired:
            quadrangles = max(1, math.floor((math.radians(sector["angle"]) + ANGLE_TOLERANCE) / QUARTER_TURN + 0.5))
            self.assertEqual(sector["index"], 2 - quadrangles)
        self.assertGreater(len(before["unmeshable_sectors"]), 0)
        for sector in before["unmeshable_sectors"]:
            self.assertEqual(changed[key(sector)], 1)

    def test_no_baseline(self):
        with_baseline, without = self.report(self.write_cube()), self.report("cube.off", "--no-baseline")
        self.assertIsNone(without["unmeshable_before"])
        self.assertEqual({**counts(without), "unmeshable_before": 0}, counts(with_baseline))
        self.assertNotIn("->", self.succeed("cube.off", "--no-baseline").stdout)


class Options(ProgramTest):
    def assert_rotation_prescribed_at(self, sharp_corners, field):
        """The index of a sharp corner is 1/4 if its crosses turn by its angle less a right one."""
        sums = collections.Counter()
        for h in field.cut.inner_halfedges:
            sums[field.cut.sector_at_target(h)] += field.rotation[h]
        for sector in sharp_corners:
            self.assertAlmostEqual(sums[sector], sector.angle - QUARTER_TURN, delta=1e-10)

    def test_no_support_prescribes_no_rotation(self):
        self.assertEqual(set(flange_field("--support", "none", "--no-repair").rotation.values()), {0})

    def test_support_strategies(self):
        for support in ("local", "rings:1", "rings:4", "component"):
            with self.subTest(support):
                field = flange_field("--support", support)
                self.assert_rotation_prescribed_at(field.cut.constrained_sectors_under(135), field)
                self.assert_poincare_hopf(field)
                self.assertEqual(field.report["unmeshable_after"], 0)
                self.assertEqual(field.report["options"]["support"], support)

    def test_default_support_is_four_rings(self):
        self.assertEqual(flange_field().elements, flange_field("--support", "rings:4").elements)

    def test_sharp_corner_bound(self):
        for degrees in (0, 45, 100):
            with self.subTest(degrees):
                field = flange_field("--sharp-corner-bound", str(degrees), "--no-repair")
                sharp_corners = field.cut.constrained_sectors_under(degrees)
                self.assertEqual(field.report["sharp_corners"], len(sharp_corners))
                self.assert_rotation_prescribed_at(sharp_corners, field)

    def test_repair_alone_leaves_nothing_unmeshable(self):
        field = flange_field("--support", "none")
        self.assertEqual(field.report["unmeshable_after"], 0)
        self.assert_poincare_hopf(field)

    def test_no_relaxation_keeps_crosses_orthogonal_and_singularities_the_same(self):
        orthogonal, relaxed = flange_field("--no-relaxation"), flange_field()
        self.assertEqual(set(orthogonal.rho), {0})
        self.assertGreater(max(map(abs, relaxed.rho)), 0)
        self.assertEqual(orthogonal.matching, relaxed.matching)
        self.assertEqual(orthogonal.index, relaxed.index)

    def test_feature_angle(self):
        self.write_cube()
        self.assertEqual(self.report("cube.off", "--feature-angle", "80")["feature_edges"], 12)
        self.assertEqual(self.report("cube.off", "--feature-angle", "100")["feature_edges"], 0)

    def test_feature_file_may_hold_comments_and_blank_lines(self):
        self.write_cube()
        self.write("model.feat", "# all edges\r\n\r\n" + "".join(f"\t{b}  {a} # edge\r\n" for a, b in CUBE_EDGES))
        self.assertEqual(counts(self.report("cube.off", "--features", "model.feat")), CUBE_COUNTS)

    def test_feature_lines_that_name_no_edge_are_told(self):
        self.write_cube()
        self.write_features([*CUBE_EDGES * 2, (0, 6), (1, 1)])
        report = self.report("cube.off", "--features", "model.feat")
        self.assertEqual(counts(report), CUBE_COUNTS)
        self.assertRegex("".join(report["warnings"]), "model.feat: .*: 2, the first is line 25, '0 6'")


class FlangeField(ProgramTest):
    def test_elements_and_properties(self):
        elements = flange_field().elements
        vectors = [(name, "double") for name in "alpha rho ux uy uz vx vy vz".split()]
        self.assertEqual({name: element.properties for name, element in elements.items()}, {
            "vertex": [("x", "double"), ("y", "double"), ("z", "double")],
            "face": [("vertex_indices", PLY_TRIANGLE), *vectors],
            "edge": [("vertex1", "int"), ("vertex2", "int"), ("feature", "int")],
            "halfedge": [("source", "int"), ("target", "int"), ("matching", "int"),
                         ("prescribed_rotation", "double"), ("index", "int")]})

    def test_text_holds_the_same_values(self):
        text = self.output(flange(), "--features", flange_features(), "--ascii")
        self.assertTrue(text.startswith(b"ply\nformat ascii 1.0\n"))
        self.assertEqual(read_ply(text), flange_field().elements)

    def test_mesh_is_the_model_with_split_faces(self):
        field, (points, faces), cut = flange_field(), read_off(flange()), flange_cut()
        self.assertEqual(field.points[:len(points)], points)
        self.assertEqual(len(field.points), len(points) + field.report["split_faces"])
        self.assertEqual(len(field.faces), field.report["faces_after_split"])
        self.assertEqual(cut.face_of.keys() - field.cut.face_of.keys(), set())
        split = ([points[vertex] for vertex in faces[f]] for f in cut.faces_with_several_features())
        centroids = (tuple(sum(coordinates) / 3 for coordinates in zip(*corners)) for corners in split)
        self.assertEqual(set(map(rounded, field.points[len(points):])), set(map(rounded, centroids)))

    def test_edges_and_halfedges_are_those_of_the_faces(self):
        field = flange_field()
        self.assertEqual(field.features, flange_cut().features)
        edges = {(min(a, b), max(a, b)) for a, b, _ in field.elements["edge"].rows}
        self.assertEqual(edges, {(min(h), max(h)) for h in field.cut.face_of})
        self.assertEqual(field.index.keys(), {h for edge in edges for h in (edge, edge[::-1])})

    def test_u_and_v_are_unit_vectors_in_the_plane_of_the_face(self):
        field = flange_field()
        for f, normal in enumerate(field.normals):
            for vector in (field.u[f], field.v[f]):
                self.assertAlmostEqual(norm(vector), 1, delta=1e-12)
                self.assertAlmostEqual(dot(vector, normal), 0, delta=1e-9)

    def test_angle_from_u_to_v_is_a_right_one_and_rho(self):
        field = flange_field()
        for u, v, normal, rho in zip(field.u, field.v, field.normals, field.rho):
            angle = math.atan2(dot(cross(u, v), normal), dot(u, v))
            self.assertAlmostEqual(angle_near_zero(angle - QUARTER_TURN - rho), 0, delta=1e-9)

    def test_alpha_is_the_angle_of_u_from_an_edge(self):
        field = flange_field()
        for f, (a, b, c) in enumerate(field.faces):
            self.assertLess(min(abs(angle_near_zero(field.branch_angle(f, 0, field.direction(h)) - field.alpha[f]))
                                for h in ((a, b), (b, c), (c, a))), 1e-9)

    def test_rho_is_clamped(self):
        field = flange_field()
        self.assertLess(max(map(abs, field.rho)), MAXIMUM_SKEWNESS + 1e-12)
        self.assertEqual(sum(abs(rho) > MAXIMUM_SKEWNESS - 1e-12 for rho in field.rho), field.report["clamped_faces"])

    def test_crosses_follow_features(self):
        for options in ((), ("--no-relaxation",), ("--support", "none", "--no-repair"), ("--support", "component")):
            field = flange_field(*options)
            for h, f in field.cut.face_of.items():
                if (min(h), max(h)) not in field.features:
                    continue
                sines = (norm(cross(field.direction(h), vector)) for vector in (field.u[f], field.v[f]))
                self.assertLess(min(sines), 1e-9)

    def test_values_change_sign_with_the_halfedge(self):
        field = flange_field()
        for h in field.matching:
            self.assertEqual(field.matching[h], -field.matching[h[::-1]])
            self.assertEqual(field.rotation[h], -field.rotation[h[::-1]])

    def test_all_corners_of_a_sector_have_its_index(self):
        field = flange_field()
        index = field.index_by_sector()
        for h in field.cut.face_of:
            self.assertEqual(field.index[h], index[field.cut.sector_at_target(h)])
        for key, is_constrained in (("interior", False), ("constrained", True)):
            histogram = collections.Counter(str(i) for sector, i in index.items()
                                            if sector.is_constrained == is_constrained)
            self.assertEqual(histogram, field.report["index_histogram"][key])

    def test_indices_of_each_patch_sum_up_to_its_euler_characteristic(self):
        for options in ((), ("--support", "none", "--no-repair")):
            self.assert_poincare_hopf(flange_field(*options))

    def test_matching_rounds_and_gives_indices_and_energy(self):
        """All follows from the vectors: which branches match, the indices and the energy."""
        field = flange_field("--no-relaxation", "--no-repair")
        turns, energy = collections.Counter(), 0
        for h in field.cut.inner_halfedges:
            rotation = field.rotation[h]
            residual = angle_near_zero(field.turn(h, 0) - rotation)
            self.assertLess(abs(residual), QUARTER_TURN / 2 + 1e-9)
            turns[field.cut.sector_at_target(h)] += residual + rotation
            energy += residual ** 2 / 2
        self.assertAlmostEqual(energy / field.report["energy_orthogonal"], 1, delta=1e-9)
        for sector, index in field.index_by_sector().items():
            expected = (turns[sector] - sector.angle) / QUARTER_TURN + (2 if sector.is_constrained else 4)
            self.assertAlmostEqual(index, expected, delta=1e-6)

    def test_relaxed_energy_is_that_of_the_vectors(self):
        field = flange_field()
        energy = sum(angle_near_zero(field.turn(h, branch)) ** 2 / 2
                     for h in field.cut.inner_halfedges for branch in (0, 1))
        self.assertAlmostEqual(energy / field.report["energy_relaxed"], 1, delta=1e-9)

    def test_paraview_file(self):
        field = flange_field()
        self.succeed(flange(), "--features", flange_features(), "--vtp", "out.vtp")
        piece, arrays = read_vtp((self.folder / "out.vtp").read_bytes())

        self.assertEqual(arrays["Points", "points"], field.points)
        number_of_verts, number_of_lines, number_of_polys = (
            piece[f"NumberOf{kind}"] for kind in ("Verts", "Lines", "Polys"))
        for kind, size in (("Verts", 1), ("Lines", 2), ("Polys", 3)):
            ends = arrays[kind, "offsets"]
            self.assertEqual(ends, tuple(range(size, size * piece[f"NumberOf{kind}"] + 1, size)))
            self.assertEqual(len(arrays[kind, "connectivity"]), size * len(ends))

        lines = arrays["Lines", "connectivity"]
        self.assertEqual({(min(edge), max(edge)) for edge in zip(lines[::2], lines[1::2])}, field.features)
        self.assertEqual(number_of_lines, field.report["feature_edges"])
        triangles = arrays["Polys", "connectivity"]
        self.assertEqual(list(zip(triangles[::3], triangles[1::3], triangles[2::3])), field.faces)
        self.assertEqual(number_of_polys, field.report["faces_after_split"])

        first_face = number_of_verts + number_of_lines
        for name in ("alpha", "rho", "u", "v"):
            values = arrays["CellData", name]
            self.assertEqual(len(values), first_face + number_of_polys)
            self.assertEqual(tuple(values[first_face:]), getattr(field, name))

        def of_verts(name):
            return arrays["CellData", name][:number_of_verts]

        sharp_corners = set(field.cut.constrained_sectors_under(135))
        expected = [(sector.vertex, index, sector in sharp_corners, not sector.is_constrained)
                    for sector, index in field.index_by_sector().items() if index != 0 or sector in sharp_corners]
        self.assertEqual(sorted(zip(arrays["Verts", "connectivity"], of_verts("index"), of_verts("sharp_corner"),
                                    of_verts("interior"))), sorted(expected))

    def test_streamlines_in_the_paraview_file(self):
        self.succeed(self.write_cube(), "--vtp", "plain.vtp")
        self.succeed(self.write_cube(), "--vtp", "out.vtp", "--streamlines=0.25")
        plain, plain_arrays = read_vtp((self.folder / "plain.vtp").read_bytes())
        piece, arrays = read_vtp((self.folder / "out.vtp").read_bytes())
        self.assertEqual(set(plain_arrays["CellData", "streamline"]), {0})

        points, number_of_points = arrays["Points", "points"], plain["NumberOfPoints"]
        self.assertEqual(points[:number_of_points], plain_arrays["Points", "points"])
        ends = arrays["Lines", "offsets"]
        lines = [arrays["Lines", "connectivity"][start:end] for start, end in zip((0,) + ends, ends)]
        first_line = piece["NumberOfVerts"]
        kinds = arrays["CellData", "streamline"]
        self.assertEqual(len(kinds), sum(piece[f"NumberOf{kind}"] for kind in ("Verts", "Lines", "Polys")))
        streamlines = [line for line, kind in zip(lines, kinds[first_line:]) if kind]
        self.assertEqual(len(lines) - len(streamlines), plain["NumberOfLines"])
        self.assertEqual({kind for kind in kinds}, {0, 1, 2})
        self.assertEqual([point for line in streamlines for point in line], list(range(number_of_points, len(points))))
        # Three lines of each pair on each side of the cube, straight from edge to edge, 1/4 apart.
        self.assertEqual(len(streamlines), 6 * 2 * 3)
        for line in streamlines:
            first, last = points[line[0]], points[line[-1]]
            self.assertAlmostEqual(math.dist(first, last), 1, delta=1e-9)
            self.assertEqual(sorted(round(4 * abs(a - b), 6) for a, b in zip(first, last)), [0, 0, 4])
            self.assertTrue(any(abs(4 * x - k) < 1e-6 for x in first for k in (1, 2, 3)))

    def test_streamlines_need_a_file_and_a_positive_spacing(self):
        for arguments in (["--streamlines"], ["--streamlines=-1", "--vtp", "out.vtp"],
                          ["--streamlines=nan", "--vtp", "out.vtp"]):
            self.assert_fails(BAD_USAGE, "--streamlines", self.write_cube(), *arguments)


class FieldInVtk(ProgramTest):
    def test_cells_and_data(self):
        python = python_with("vtk")
        if python is None:
            self.skipTest("there is no vtk for Python")
        report = self.report(flange(), "--features", flange_features(), "-o", "out.ply", "--vtp", "out.vtp")
        self.succeed(flange(), "--features", flange_features(), "-o", "text.ply", "--ascii")
        completed = run(python, "-c", """
import json, vtk
def output_of(reader, name):
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()
def counts(data):
    return [data.GetNumberOfPoints(), data.GetNumberOfPolys(), data.GetNumberOfLines()]
vtp = output_of(vtk.vtkXMLPolyDataReader(), "out.vtp")
print(json.dumps({
    "vtp": counts(vtp), "ply": [counts(output_of(vtk.vtkPLYReader(), name)) for name in ("out.ply", "text.ply")],
    "arrays": {vtp.GetCellData().GetArrayName(k): vtp.GetCellData().GetArray(k).GetNumberOfTuples()
               for k in range(vtp.GetCellData().GetNumberOfArrays())},
    "cells": vtp.GetNumberOfCells()}))
""", cwd=self.folder)
        self.assertEqual(completed.returncode, 0, completed.stderr)
        read = json.loads(completed.stdout.splitlines()[-1])
        numbers = [report["vertices"] + report["split_faces"], report["faces_after_split"]]
        self.assertEqual(read["vtp"], [*numbers, report["feature_edges"]])
        self.assertEqual(read["ply"], [[*numbers, 0]] * 2)
        self.assertEqual(read["arrays"], dict.fromkeys(
            "u v alpha rho index sharp_corner interior streamline".split(), read["cells"]))


class Repair(ProgramTest):
    def assert_warnings(self, report, **numbers):
        """Expects warnings with these words and numbers at their ends, and no other ones."""
        warnings = report["warnings"]
        self.assertEqual(len(warnings), len(numbers), warnings)
        for words, number in numbers.items():
            self.assertTrue(any(words.replace("_", " ") in warning and warning.endswith(f": {number}")
                                for warning in warnings), (words, number, warnings))

    def test_clean_model_needs_none(self):
        self.assertEqual(flange_field().report["warnings"], [])

    def test_soup_gives_the_same_counts_as_the_clean_model(self):
        points, faces = read_off(flange())
        features = read_features(flange_features())
        copy_of = {vertex: len(points) + k for k, vertex in enumerate(range(0, len(points), 7))}
        soup = [tuple(copy_of.get(vertex, vertex) if f % 2 else vertex for vertex in face)
                for f, face in enumerate(faces)]
        turned = range(1, len(soup), 3)  # less than half of them
        for f in turned:
            soup[f] = soup[f][::-1]
        soup += [(0, 0, 134), (0, 134, 0), faces[0], faces[8]]
        self.write("soup.off", off_text(points + [points[vertex] for vertex in copy_of], soup))
        self.write_features([(copy_of.get(a, a), b) for a, b in features])

        report = self.report("soup.off", "--features", "model.feat")
        self.assertEqual(counts(report), counts(flange_field().report))
        number_turned = int(re.search(r"orientation: (\d+)", "".join(report["warnings"])).group(1))
        self.assertIn(number_turned, (len(turned), len(faces) - len(turned)))
        self.assert_warnings(report, duplicate_vertices_merged=len(copy_of),
                             degenerate_or_duplicate_faces_removed=4,
                             faces_turned_around_for_a_consistent_orientation=number_turned)

    def test_cubes_that_share_an_edge_are_taken_apart(self):
        second = {0: 0, 4: 4}  # the shared edge
        points = list(CUBE_POINTS)
        for vertex, (x, y, z) in enumerate(CUBE_POINTS):
            if vertex not in second:
                second[vertex] = len(points)
                points.append((-x, -y, z))
        faces = CUBE_FACES + [tuple(second[vertex] for vertex in face) for face in CUBE_FACES]
        edges = set(CUBE_EDGES) | {(second[a], second[b]) for a, b in CUBE_EDGES}
        self.assertEqual(len(edges), 23)
        self.write("cubes.off", off_text(points, faces))
        self.write_features(edges)
        report = self.report("cubes.off", "--features", "model.feat")
        self.assertEqual(report["feature_edges"], 24)
        self.assertEqual((report["faces"], report["vertices"], report["patches"]), (24, 16, 12))
        self.assertEqual(report["index_histogram"]["constrained"], {"1": 48})
        self.assert_warnings(report, vertices_duplicated_where_the_surface_is_not_a_manifold=2)

    def test_squares_are_triangulated(self):
        report = self.report(self.write("squares.off", off_text(CUBE_POINTS, CUBE_SQUARES)))
        self.assertEqual(counts(report), CUBE_COUNTS)
        self.assert_warnings(report, faces_of_more_than_three_vertices_triangulated=6)

    def test_warnings_are_shown_even_when_quiet(self):
        self.write("squares.off", off_text(CUBE_POINTS, CUBE_SQUARES))
        report = self.report("squares.off")
        stderr = self.succeed("squares.off", "--quiet").stderr
        self.assertEqual(stderr, "".join(f"cad_frame_field: warning: {warning}\n" for warning in report["warnings"]))

    def test_model_of_degenerate_faces_only(self):
        name = self.write("model.off", off_text(CUBE_POINTS, [(0, 0, 1), (2, 3, 2)]))
        completed = self.run_program(name)
        self.assertEqual(completed.returncode, BAD_FILE)
        self.assertIn("error: model.off: ", completed.stderr.splitlines()[-1])


class Formats(ProgramTest):
    def test_all_formats_give_the_same_counts(self):
        points, faces = read_off(flange())
        expected = counts(self.report(flange()))
        for name, make_text in (("model.obj", obj_text), ("model.ply", ply_text), ("model.stl", stl_text),
                                ("model.OFF", off_text)):
            with self.subTest(name):
                self.assertEqual(counts(self.report(self.write(name, make_text(points, faces)))), expected)

    def test_vertices_keep_their_numbers(self):
        points, faces = read_off(flange())
        for name, make_text in (("model.obj", obj_text), ("model.ply", ply_text)):
            with self.subTest(name):
                self.write(name, make_text(points, faces))
                self.assertEqual(counts(self.report(name, "--features", flange_features())),
                                 counts(flange_field().report))

    def test_what_is_left_out_is_told_once(self):
        text = "\ufeff" + obj_text(CUBE_POINTS, CUBE_FACES).replace(" ", "\t") + "l 1 2\nsm 1 2\nl 3 \\\n4\n"
        report = self.report(self.write("cube.obj", text))
        self.assertEqual(counts(report), CUBE_COUNTS)
        self.assertEqual(report["warnings"], ["cube.obj: lines left out: 2 of kind 'l', 1 of kind 'sm'"])

    def test_coordinates_and_indices_of_ply_have_any_type(self):
        text = ply_text(CUBE_POINTS, CUBE_FACES).replace("double", "uchar").replace("uchar int", "ushort char")
        self.assertEqual(counts(self.report(self.write("cube.ply", text))), CUBE_COUNTS)

    def test_faults_are_told_with_their_line_or_byte(self):
        self.assert_fails(BAD_FILE, "model.obj: line 3, 'v 1.01.0 0': '1.01.0' is no number", self.write(
            "model.obj", "v 0 0 0\nv 1 0 0\nv 1.01.0 0\nf 1 2 3\n"))
        content = bytes(80) + struct.pack("<I", 2) + bytes(50)
        (self.folder / "model.stl").write_bytes(content)
        self.assert_fails(BAD_FILE, "model.stl: byte 80: 2 facets", "model.stl")

    def test_own_vtp_can_be_read_again(self):
        self.succeed(flange(), "--features", flange_features(), "--vtp", "again.vtp", "--streamlines")
        first, report = flange_field().report, self.report("again.vtp", "--features", flange_features())
        self.assertEqual((report["faces"], report["feature_edges"], report["patches"]),
                         (first["faces_after_split"], first["feature_edges"], first["patches"]))

    def test_own_output_can_be_read_again(self):
        for options in ((), ("--ascii",)):
            (self.folder / "again.ply").write_bytes(self.output(flange(), "--features", flange_features(), *options))
            report = self.report("again.ply", "--features", flange_features())
            first = flange_field().report
            expected = {**counts(first), "faces": first["faces_after_split"], "split_faces": 0,
                        "vertices": first["vertices"] + first["split_faces"]}
            self.assertEqual(counts(report), expected)


def words_of(path):
    """The words of a text file without its comments."""
    return [word for line in path.read_text().splitlines() for word in line.split("#")[0].split()]


def threes(words):
    return [tuple(map(float, words[i:i + 3])) for i in range(0, len(words), 3)]


class FieldFormats(ProgramTest):
    FORMATS = (".rawfield", ".rosy", ".ffield")

    def write_fields(self, *options):
        fields = [argument for end in self.FORMATS for argument in ("--field", "out" + end)]
        self.succeed(flange(), "--features", flange_features(), *fields, "--write-features", "out.feat", "-o",
                     "out.ply", "--quiet", *options)
        field = Field((self.folder / "out.ply").read_bytes(), {})
        self.write("again.off", off_text(field.points, field.faces))
        return field

    def test_directional_gets_the_four_vectors_counter_clockwise(self):
        field = self.write_fields()
        words = words_of(self.folder / "out.rawfield")
        self.assertEqual(words[:2], ["4", str(len(field.faces))])
        vectors = threes(words[2:])
        self.assertEqual(vectors[::4], list(field.u))
        self.assertEqual(vectors[1::4], list(field.v))
        for f, normal in enumerate(field.normals):
            around = vectors[4 * f:4 * f + 4]
            for vector, successor in zip(around, around[1:] + around[:1]):
                self.assertGreater(dot(cross(vector, successor), normal), 0)

    def test_vcglib_gets_both_directions(self):
        field = self.write_fields()
        lines = (self.folder / "out.ffield").read_text().splitlines()
        self.assertTrue(lines[0].startswith("#"))
        self.assertEqual(int(lines[2]), len(field.faces))
        rows = [tuple(map(float, line.split())) for line in lines[4:]]
        self.assertEqual([row[2:5] for row in rows], list(field.u))
        self.assertEqual([row[5:8] for row in rows], list(field.v))

    def test_quadwild_gets_a_cross_that_follows_the_features(self):
        field = self.write_fields()
        words = words_of(self.folder / "out.rosy")
        self.assertEqual(words[:2], [str(len(field.faces)), "4"])
        directions = threes(words[2:])
        for h, f in field.cut.face_of.items():
            if (min(h), max(h)) in field.features:
                self.assertLess(norm(cross(field.direction(h), directions[f])), 1e-9)
        aligned = {field.cut.face_of[h] for e in field.features for h in (e, e[::-1]) if h in field.cut.face_of}
        for f in set(range(len(field.faces))) - aligned:
            turns = [math.atan2(dot(cross(directions[f], w), field.normals[f]), dot(directions[f], w)) / QUARTER_TURN
                     for w in (field.u[f], field.v[f])]
            differences = [turn - round(turn) for turn in turns]
            self.assertAlmostEqual(differences[0], -differences[1], delta=1e-9)

    def test_who_writes_crosses_is_told_what_they_forget(self):
        for end in self.FORMATS:
            report = self.report(flange(), "--features", flange_features(), "--field", "out" + end)
            self.assertEqual(len(report["warnings"]), end == ".rosy", end)
            for warning in report["warnings"]:
                self.assertRegex(warning, "out.rosy: .*matching")

    def compared(self, end, *options):
        return self.report("again.off", "--features", "out.feat", "--compare", "out" + end, *options)["compared"]

    def test_own_frames_are_read_as_they_are(self):
        self.write_fields()
        expected = self.report("again.off", "--features", "out.feat", "--verbose")
        for end in (".rawfield", ".ffield"):
            compared = self.compared(end)
            self.assertEqual(compared["unmeshable"], 0)
            self.assertLess(compared["maximum_misalignment"], 1e-7)
            self.assertEqual(compared["index_histogram"], expected["index_histogram"])
            for name in ("energy", "curl", "mean_skewness"):
                self.assertAlmostEqual(compared["quality"][name] / expected["quality"][name], 1, delta=1e-6)

    def test_crosses_are_the_same_in_all_formats_and_lose_the_correction_at_corners_under_45_degrees(self):
        self.write_fields("--no-relaxation")
        compared = [self.compared(end) for end in self.FORMATS]
        for figures in compared:
            self.assertEqual(figures["index_histogram"], compared[0]["index_histogram"])
            self.assertAlmostEqual(figures["quality"]["energy"] / compared[0]["quality"]["energy"], 1, delta=1e-9)
            self.assertEqual(figures["unmeshable"], len(flange_cut().constrained_sectors_under(45)))

    def test_fields_without_correction_are_told_from_those_with_it(self):
        self.write_fields("--support", "none", "--no-repair", "--no-relaxation")
        report = self.report("again.off", "--features", "out.feat", "--compare", "out.rosy")
        self.assertEqual(report["compared"]["unmeshable"], report["unmeshable_before"])
        self.assertGreater(report["compared"]["unmeshable"], 0)
        self.assertEqual(report["unmeshable_after"], 0)
        table = self.succeed("again.off", "--features", "out.feat", "--compare", "out.rosy").stdout
        self.assertRegex(table, r"compared field\n(  .*\n)*  unmeshable corners +%d\n"
                         % report["compared"]["unmeshable"])

    def test_parts_of_a_split_face_have_the_directions_of_the_face(self):
        """The field on the faces of the cube that its edges give: each has three parts."""
        cube = self.write_cube()
        directions = {0: (1.0, 0.0, 0.0), 1: (0.0, 1.0, 0.0), 2: (0.0, 0.0, 1.0)}
        normals = [unit(cross(difference(CUBE_POINTS[b], CUBE_POINTS[a]), difference(CUBE_POINTS[c], CUBE_POINTS[a])))
                   for a, b, c in CUBE_FACES]
        rows = [next(d for d in directions.values() if abs(dot(d, normal)) < 0.5) for normal in normals]
        self.write("cube.rosy", f"{len(rows)}\n4\n" + numbers_as_lines(rows))
        compared = self.report(cube, "--compare", "cube.rosy")["compared"]
        self.assertEqual(compared["index_histogram"], CUBE_COUNTS["index_histogram"])
        self.assertAlmostEqual(compared["maximum_misalignment"], 0, delta=1e-9)
        self.assertAlmostEqual(compared["quality"]["energy"], 0, delta=1e-12)

    def test_wrong_fields(self):
        cube = self.write_cube()
        rows = numbers_as_lines([(1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0)] * 12)
        for name, message, text in (
                ("a.rosy", "a.rosy:1: the file ends", "12"),
                ("b.rosy", "b.rosy:2: the field has 6 directions", "12\n6\n"),
                ("c.rosy", "11 faces and the model 12", "11\n4\n"), ("d.rosy", "coordinate of a vector of face 1",
                                                                     "12\n4\n1 0 0\n1 x 0\n"),
                ("e.rawfield", "the file ends where a coordinate of a vector of face 11", "4 12\n" + rows[:-3]),
                ("f.rawfield", "goes on", "4 12\n" + rows + "1\n"), ("g.ffield", "number of faces", "# frame\nx\n"),
                ("h.rawfield", "h.rawfield: ", "4 12\n" + rows), ("i.rosy", "i.rosy: ", "12\n4\n" + "nan 0 0\n" * 12),
                ("j.rosy", "negative", "-1\n4\n")):
            with self.subTest(name):
                self.write(name, text)
                self.assert_fails(BAD_FILE, message, cube, "--compare", name)
        self.assert_fails(BAD_FILE, "missing.rosy", cube, "--compare", "missing.rosy")
        self.write("squares.off", off_text(CUBE_POINTS, CUBE_SQUARES))
        completed = self.run_program("squares.off", "--compare", "c.rosy")
        self.assertEqual(completed.returncode, BAD_FILE)
        self.assertIn("needs no repair", completed.stderr)


class FeatureFiles(ProgramTest):
    def test_written_features_are_read_again(self):
        self.succeed(flange(), "--features", flange_features(), "-o", "out.ply", "--quiet")
        field = Field((self.folder / "out.ply").read_bytes(), {})
        self.write("again.off", off_text(field.points, field.faces))
        for name in ("out.feat", "out.sharp", "out.feature"):
            with self.subTest(name):
                self.succeed(flange(), "--features", flange_features(), "--write-features", name, "--quiet")
                self.succeed("again.off", "--features", name, "-o", "again.ply", "--quiet")
                self.assertEqual(Field((self.folder / "again.ply").read_bytes(), {}).features, field.features)

    def test_format_of_quadwild(self):
        """All edges of a cube are convex; each line names a face and which of its edges."""
        cube = self.write_cube()
        self.succeed(cube, "--write-features", "out.sharp", "-o", "out.ply", "--quiet")
        faces = Field((self.folder / "out.ply").read_bytes(), {}).faces
        number, *lines = (self.folder / "out.sharp").read_text().splitlines()
        self.assertEqual(int(number), 12)
        edges = set()
        for line in lines:
            convex, face, edge = map(int, line.split(","))
            self.assertEqual(convex, 1)
            edges.add(tuple(sorted((faces[face][edge], faces[face][(edge + 1) % 3]))))
        self.assertEqual(sorted(edges), CUBE_EDGES)

        inside_out = self.write("inside_out.off", off_text(CUBE_POINTS, [face[::-1] for face in CUBE_FACES]))
        self.succeed(inside_out, "--write-features", "concave.sharp", "--quiet")
        self.assertEqual({line[0] for line in (self.folder / "concave.sharp").read_text().splitlines()[1:]}, {"0"})

    def test_commas_and_blanks_separate(self):
        cube = self.write_cube()
        places = [(f, k) for edge in CUBE_EDGES for f, face in enumerate(CUBE_FACES) for k in range(3)
                  if (face[k], face[(k + 1) % 3]) == edge]
        self.assertEqual(len(places), 12)
        self.write("commas.sharp", "12\n" + "".join(f"1,{f},{k}\n" for f, k in places))
        self.write("blanks.sharp", "# all edges\n12\n" + "".join(f"0 {f} {k}\n" for f, k in places))
        self.write("pairs.feature", "12\n" + "".join(f"{f},{k}\n" for f, k in places))
        for name in ("commas.sharp", "blanks.sharp", "pairs.feature"):
            self.assertEqual(counts(self.report(cube, "--features", name)), CUBE_COUNTS)

    def test_wrong_files(self):
        cube = self.write_cube()
        for message, text in (
                ("x.sharp:1: ", "twelve\n"), ("x.sharp:2: the model has no face 12", "1\n1,12,0\n"),
                ("x.sharp:2: face 3 has no edge 3", "1\n1,3,3\n"), ("x.sharp:2: ", "1\n1,-1,0\n"),
                ("x.sharp:2: a line must hold", "1\n1,2\n"), ("announces 2 edges and there are 1", "2\n1,0,0\n"),
                ("announces 0", "# nothing\n")):
            with self.subTest(message):
                self.write("x.sharp", text)
                self.assert_fails(BAD_FILE, message, cube, "--features", "x.sharp")


class FeatureDetection(ProgramTest):
    def roof(self, angles):
        """A long roof whose ridge has the mean of the angles of two neighbours, in degrees, at each of its edges."""
        points, faces = [], []
        for k, angle in enumerate(angles):
            slope = math.tan(math.radians(angle / 2))
            points += [(-1.0, 100.0 * k, -slope), (0.0, 100.0 * k, 0.0), (1.0, 100.0 * k, -slope)]
            for v in (3 * k, 3 * k + 1) if k + 1 < len(angles) else ():
                faces += [(v, v + 1, v + 4), (v, v + 4, v + 3)]
        return self.write("roof.off", off_text(points, faces))

    def ridge(self, *options):
        """The lengths, in hundreds, of the features at the ridge by their beginning, and the dangling ends."""
        report = self.report("roof.off", "--write-features", "out.feat", "--feature-angle", "18", *options)
        pairs = read_features(self.folder / "out.feat")
        rows = sorted(min(a, b) // 3 for a, b in pairs if a % 3 == b % 3 == 1)
        return rows, [vertex // 3 for vertex in report["dangling_ends"] if vertex % 3 == 1]

    def test_hysteresis(self):
        self.roof([30, 26, 22, 18, 14, 10, 6])
        self.assertEqual(self.ridge(), ([0, 1, 2], [3]))
        self.assertEqual(self.ridge("--weak-angle", "10"), ([0, 1, 2, 3, 4], [5]))

    def test_gaps_of_one_edge(self):
        self.roof([24, 24, 14, 14, 24, 24])
        self.assertEqual(self.ridge(), ([0, 1, 3, 4], [2, 3]))
        self.assertEqual(self.ridge("--close-gaps"), ([0, 1, 2, 3, 4], []))

    def test_short_chains(self):
        self.roof([24, 24, 24, 14, 14, 24, 14, 14])
        self.assertEqual(self.ridge(), ([0, 1, 2, 4, 5], [3, 4, 6]))
        self.assertEqual(self.ridge("--min-chain-length", "201"), ([0, 1, 2], [3]))
        self.assertEqual(self.ridge("--min-chain-length", "301"), ([], []))

    def test_report_tells_the_options(self):
        options = self.report(self.roof([24, 24]), "--feature-angle", "30", "--weak-angle", "20", "--close-gaps",
                              "--min-chain-length", "7")["options"]
        self.assertEqual([options[key] for key in ("feature_angle", "weak_angle", "close_gaps", "min_chain_length")],
                         [30, 20, True, 7])


class ParallelTest(ProgramTest):
    """GNU parallel runs the program on many models."""

    NUMBER = 24

    def setUp(self):
        super().setUp()
        self.parallel = shutil.which("parallel")
        if not self.parallel or "GNU" not in run(self.parallel, "--version").stdout:
            self.skipTest("there is no GNU parallel")
        (self.folder / "results").mkdir()
        names = [self.write(f"cube {k}.off", cube_text(1 + k)) for k in range(self.NUMBER - 1)]
        self.write("models", "\n".join([*names[:3], self.write("broken.off", cube_text()[:100]), *names[3:]]) + "\n")

    def command(self):
        """As in the manual."""
        return [self.parallel, "--will-cite", "--jobs", "2", "--joblog", "log", "--resume", "--timeout", "600",
                paths.program, "{}", "--quiet", "--threads", "1", "--report", "results/{/.}.json",
                "-o", "results/{/.}.ply", "::::", "models"]

    def logged(self):
        """The exit codes of the models that are done, by their numbers from 1."""
        log = self.folder / "log"
        rows = [line.split("\t") for line in log.read_text().splitlines()[1:]] if log.is_file() else []
        codes = {int(row[0]): int(row[6]) for row in rows if len(row) > 8}
        self.assertEqual(len(codes), len(rows), "no model was done twice")
        return codes

    def check_that_a_killed_run_goes_on(self):
        process = subprocess.Popen(self.command(), cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and len(self.logged()) < 4:
            time.sleep(0.01)
        process.kill()
        process.wait()
        before = self.logged()
        self.assertTrue(4 <= len(before) < self.NUMBER, "it was killed before its end")
        number_of_failures = 4 not in before
        self.assertEqual(run(*self.command(), cwd=self.folder).returncode, number_of_failures)
        codes = self.logged()
        self.assertEqual({number: codes[number] for number in before}, before)
        self.assertEqual(codes, {number: BAD_FILE if number == 4 else DONE for number in range(1, self.NUMBER + 1)})
        self.assertEqual({path.name for path in (self.folder / "results").iterdir()},
                         {f"cube {k}.{end}" for k in range(self.NUMBER - 1) for end in ("json", "ply")})
        for k in range(self.NUMBER - 1):
            report = json.loads((self.folder / f"results/cube {k}.json").read_text())
            self.assertEqual((report["faces"], report["patches"]), (12, 6))


class GnuParallel(ParallelTest):
    def test_killed_run_goes_on_where_it_was(self):
        self.check_that_a_killed_run_goes_on()


class Step(ProgramTest):
    """Runs the example that meshes a STEP file."""

    @classmethod
    def setUpClass(cls):
        cls.python = next((python for python in ("/usr/bin/python3", sys.executable) if os.access(python, os.X_OK)
                           and run(python, "-c", "import gmsh; gmsh.initialize()").returncode == 0), None)

    SOLID = """
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
occ = gmsh.model.occ
box = occ.addBox(0, 0, 0, 4, 3, 2)
hole = occ.addCylinder(2, 1.5, 0, 0, 0, 2, 0.7)
(solid,), _ = occ.cut([(3, box)], [(3, hole)])
occ.synchronize()
edge, = [tag for _, tag in gmsh.model.getEntitiesInBoundingBox(-0.1, -0.1, 1.9, 0.1, 3.1, 2.1, 1)]
occ.fillet([solid[1]], [edge], [0.5])
occ.synchronize()
gmsh.write("solid.step")
"""

    def test_box_with_a_hole_and_a_fillet(self):
        if self.python is None:
            self.skipTest("there is no gmsh for Python")
        made = run(self.python, "-c", self.SOLID, cwd=self.folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        script = paths.sources / "examples/Frame_fields/step_to_frame_field.py"
        completed = run(self.python, script, "solid.step", "--size", "0.3", "--program", paths.program,
                        "--", "-o", "out.ply", "--report", "out.json", "--quiet", cwd=self.folder)
        self.assertEqual(completed.returncode, 0, completed.stderr)
        report = json.loads((self.folder / "out.json").read_text())
        self.assertEqual(report["unmeshable_after"], 0)
        self.assertEqual((report["dangling_ends"], report["warnings"]), ([], []))
        self.assertEqual(report["patches"], 8)  # six sides, the hole and the fillet

        field = Field((self.folder / "out.ply").read_bytes(), report)
        self.assert_poincare_hopf(field)
        length = sum(norm(difference(field.points[a], field.points[b])) for a, b in field.features)
        straight = 4 * (4 + 3 + 2) - 3 - 4 * 0.5 + 3 + 3  # without the edge of the fillet and what it cuts off
        arcs = 2 * 0.5 * QUARTER_TURN + 2 * 2 * math.pi * 0.7
        self.assertLessEqual(length, straight + arcs + 1e-9)
        self.assertAlmostEqual(length, straight + arcs, delta=0.02 * arcs)  # chords are shorter than their arcs
        for a, b in field.features:  # on curves: the ends are where at least two of the surfaces meet
            for x, y, z in (field.points[a], field.points[b]):
                on = [abs(x) < 1e-6, abs(x - 4) < 1e-6, abs(y) < 1e-6, abs(y - 3) < 1e-6, abs(z) < 1e-6,
                      abs(z - 2) < 1e-6, abs(math.hypot(x - 2, y - 1.5) - 0.7) < 1e-6,
                      x < 0.5 + 1e-6 and z > 1.5 - 1e-6 and abs(math.hypot(x - 0.5, z - 1.5) - 0.5) < 1e-6]
                self.assertGreaterEqual(sum(on), 2)

    def test_file_that_is_no_step(self):
        if self.python is None:
            self.skipTest("there is no gmsh for Python")
        script = paths.sources / "examples/Frame_fields/step_to_frame_field.py"
        completed = run(self.python, script, self.write("wrong.step", "nothing"), "--program", paths.program,
                        cwd=self.folder)
        self.assertEqual(completed.returncode, 2)
        self.assertIn("wrong.step", completed.stderr)
        self.assertEqual(set(self.content_of_folder()), {"wrong.step"})


class CgalModels(ProgramTest):
    def test_models_of_cgal(self):
        for name in ("fandisk", "anchor_dense", "mech-holes-shark", "joint", "pinion_small", "rotor_small",
                     "couplingdown", "cube-meshed", "oblong", "part", "u", "cross"):
            model = paths.cgal_data / "meshes" / f"{name}.off"
            if not model.is_file():
                self.skipTest(f"there is no {model}")
            with self.subTest(name):
                field = computed_field(model)
                self.assert_poincare_hopf(field)
                self.assertEqual(field.report["unmeshable_after"], 0)
                self.assertEqual(self.report(model, "--no-repair")["unmeshable_after"], 0)


class CadModels(ProgramTest):
    def test_real_models_against_an_independent_implementation(self):
        reference = paths.cad_data / "reference.csv"
        if not reference.is_file():
            self.skipTest(f"there is no {reference}")
        with open(reference, newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["features"] in ("feat", "all")]
        for row in rows:
            with self.subTest(model=row["model"], features=row["features"]):
                model = paths.cad_data / row["model"]
                arguments = (model, "--features", model.with_suffix("." + row["features"]))
                self.assertEqual(self.report(*arguments, "--no-baseline")["unmeshable_after"], 0)

                # The reference has no tolerance, and no blunt corners: test_every_model compares without them.
                bound = 135 + math.degrees(ANGLE_TOLERANCE)
                report = self.report(*arguments, "--sharp-corner-bound", repr(bound), "--no-repair", "--no-relaxation",
                                     "--no-baseline")
                self.assertEqual(report["unmeshable_after"], len(report["unmeshable_sectors"]))
                for key, column in (("faces", "faces"), ("faces_after_split", "faces_after_split"),
                                    ("patches", "patches"), ("sharp_corners", "sectors_below_135deg")):
                    self.assertEqual(report[key], int(row[column]), key)

    def test_indices_of_each_patch_sum_up_to_its_euler_characteristic(self):
        models = sorted(paths.cad_data.glob("*.off"), key=lambda model: (model.stat().st_size, model))
        if not models:
            self.skipTest(f"there are no models in {paths.cad_data}")
        for model in models[:-3]:  # the three largest ones take longer than all others, and test_every_model has them
            with self.subTest(model.name):
                self.assert_poincare_hopf(computed_field(model, "--features", model.with_suffix(".feat")))


class Examples(ProgramTest):
    def run_example(self, name):
        """The words of each line that an example prints for CGAL's fandisk."""
        return self.run_example_on(name, paths.cgal_data / "meshes/fandisk.off")

    def test_surface_mesh_example_prints_four_unit_vectors(self):
        vectors = [tuple(map(float, words)) for words in self.run_example("frame_field_surface_mesh")]
        self.assertEqual(len(vectors), 4)
        for vector, opposite in zip(vectors, vectors[2:] + vectors[:2]):
            self.assertAlmostEqual(norm(vector), 1, delta=1e-5)
            self.assertAlmostEqual(dot(vector, opposite), -1, delta=1e-5)

    def test_polyhedron_example_counts_as_many_singular_corners_as_the_program(self):
        line, = self.run_example("frame_field_polyhedron")
        field = computed_field(paths.cgal_data / "meshes/fandisk.off")
        self.assertEqual(int(line[0]), sum(index != 0 for index in field.index.values()))

    def test_stages_example_finds_as_many_singular_sectors_as_the_program(self):
        count = {" ".join(words[1:]): words[0] for words in self.run_example("frame_field_stages")}
        report = computed_field(paths.cgal_data / "meshes/fandisk.off").report
        self.assertEqual(int(count["sharp corners"]), report["sharp_corners"])
        histogram = report["index_histogram"]
        self.assertEqual(int(count["singular sectors"]), sum(number for place in histogram.values()
                                                             for index, number in place.items() if int(index) != 0))

    def test_indices_example_sums_to_the_euler_characteristic_of_each_patch(self):
        patches = [words for words in self.run_example("frame_field_indices") if words[0] == "patch"]
        self.assertEqual(len(patches), computed_field(paths.cgal_data / "meshes/fandisk.off").report["patches"])
        for words in patches:
            self.assertEqual(int(words[3].removesuffix("/4,")), 4 * int(words[6]))

    def test_example_with_listed_features_has_all_of_them(self):
        features = flange().with_suffix(".feat")
        words, = self.run_example_on("frame_field_own_feature_map", flange(), features)
        pairs = [line for line in features.read_text().splitlines() if line and not line.startswith("#")]
        self.assertEqual(int(words[0]), len(pairs))

    def test_example_with_its_own_solver_reaches_the_energy_of_the_default_solver(self):
        words, = self.run_example("frame_field_own_solver")
        energy = computed_field(paths.cgal_data / "meshes/fandisk.off").report["energy_relaxed"]
        self.assertAlmostEqual(float(words[-1]) / energy, 1, delta=1e-5)

    def test_parallel_example_solves_all_patches(self):
        words, = self.run_example("frame_field_parallel")
        self.assertEqual(int(words[0]), computed_field(paths.cgal_data / "meshes/fandisk.off").report["patches"])

    def test_seams_around_each_vertex_turn_by_its_index(self):
        lines = self.run_example("frame_field_for_quad_mesher")
        rows = {key: [words[1:] for words in lines if words[0] == key] for key in "vfcsp"}
        constrained = {int(v) for words in rows["c"] for v in words[:2]}
        turn = collections.Counter()
        for a, b, jump in (map(int, words) for words in rows["s"]):
            turn[b] += jump  # turning counter-clockwise about b, the edge is crossed from its left to its right ...
            turn[a] -= jump  # ... and the other way about a
        index = collections.Counter()
        for v, quarters, is_constrained in (map(int, words) for words in rows["p"]):
            if not is_constrained:
                index[v] = quarters
        self.assertGreater(len(index), 0)
        for v in range(len(rows["v"])):
            if v not in constrained:
                self.assertEqual((turn[v] - index[v]) % 4, 0, f"vertex {v}")

    def test_directions_for_a_quad_mesher_run_along_constrained_edges(self):
        lines = self.run_example("frame_field_for_quad_mesher")
        points = [tuple(map(float, words[1:])) for words in lines if words[0] == "v"]
        directions = {}
        for words in (words for words in lines if words[0] == "f"):
            corners, numbers = [int(v) for v in words[1:4]], [float(number) for number in words[4:]]
            u, v = numbers[:3], numbers[3:]
            for k in range(3):
                directions[corners[k - 1], corners[k]] = (u, v, [-x for x in u], [-x for x in v])
        for a, b, left, right in (map(int, words[1:]) for words in lines if words[0] == "c"):
            for side, number in (((a, b), left), ((b, a), right)):
                along = unit(difference(points[side[1]], points[side[0]]))
                self.assertAlmostEqual(dot(directions[side][number], along), 1, delta=1e-9)

    def test_streamlines_example_writes_the_polylines_of_the_program(self):
        lines, branch_pairs, points, polylines = self.run_example("frame_field_streamlines"), 0, [], []
        for key, *values in lines:
            if key == "o":
                branch_pairs += 1
            elif key == "v":
                points.append(tuple(map(float, values)))
            else:
                polylines.append((branch_pairs, [points[int(value) - 1] for value in values]))
        self.succeed(paths.cgal_data / "meshes/fandisk.off", "--vtp", "out.vtp", "--streamlines")
        piece, arrays = read_vtp((self.folder / "out.vtp").read_bytes())
        ends, places = arrays["Lines", "offsets"], arrays["Points", "points"]
        kinds = arrays["CellData", "streamline"][piece["NumberOfVerts"]:]
        expected = [(kind, [places[v] for v in arrays["Lines", "connectivity"][start:end]])
                    for start, end, kind in zip((0,) + ends, ends, kinds) if kind]
        self.assertGreater(len(expected), 0)
        self.assertEqual(sorted(polylines), sorted(expected))

    def test_seamless_map_example_writes_a_seamless_and_aligned_map(self):
        lines = self.run_example("frame_field_seamless_map")
        places = [tuple(map(float, words[1:])) for words in lines if words[0] == "vt"]
        features = {frozenset(int(word) for word in words[1:]) for words in lines if words[0] == "l"}
        sides = collections.defaultdict(list)
        for words in lines:
            if words[0] == "f":
                corners = [tuple(int(number) for number in word.split("/")) for word in words[1:]]
                (a, b, c) = (places[corner[1] - 1] for corner in corners)
                self.assertGreater((b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0]))
                for (v, p), (w, q) in zip(corners, corners[1:] + corners[:1]):
                    lengths = [abs(places[q - 1][k] - places[p - 1][k]) for k in range(2)]
                    sides[frozenset((v, w))].append(sorted(lengths))
        self.assertGreater(len(features), 0)
        for edge, lengths in sides.items():
            if edge in features:
                self.assertTrue(all(least == 0 for least, _ in lengths), edge)
            else:
                self.assertEqual(*lengths)  # a quarter turn swaps them

    def test_examples_that_cannot_read_their_model_fail(self):
        for name in ("surface_mesh", "polyhedron", "stages", "indices", "own_solver", "parallel", "for_quad_mesher",
                     "streamlines", "seamless_map"):
            name = "frame_field_" + name
            self.run_example(name)  # or skip
            completed = run(paths.program.with_name(name), "missing.off")
            self.assertEqual(completed.returncode, 1)
            self.assertIn("missing.off", completed.stderr)

    def test_listings_of_the_readme_stand_in_the_examples(self):
        readme = (paths.sources / "README.md").read_text()
        examples = "".join((paths.sources / f"examples/Frame_fields/{name}_surface_mesh.cpp").read_text()
                           for name in ("quad_mesh", "frame_field"))
        listings = re.findall(r"^```cpp\n(.*?)^```$", readme, re.DOTALL | re.MULTILINE)
        self.assertGreater(len(listings), 0)
        for listing in listings:
            self.assertIn("\n" + listing, examples)


class OpenmeshExample(ProgramTest):
    def test_openmesh_example_prints_two_unit_vectors(self):
        vectors = [tuple(map(float, words)) for words in self.run_example_on(
            "frame_field_openmesh", paths.cgal_data / "meshes/fandisk.off")]
        self.assertEqual(len(vectors), 2)
        for vector in vectors:
            self.assertAlmostEqual(norm(vector), 1, delta=1e-5)


class DrawingExample(ProgramTest):
    def test_drawing_example_starts_without_a_screen(self):
        if not shutil.which("xvfb-run"):
            self.skipTest("there is no xvfb-run")
        example = paths.program.with_name("draw_frame_field")
        if not example.is_file():
            self.skipTest(f"there is no {example}")
        # For builds with sanitizers: what Qt, the graphics driver and CGAL's viewer do is not under test.
        suppressions = pathlib.Path(__file__).with_name("viewer_suppressions.txt")
        environment = {**os.environ, "CGAL_TEST_SUITE": "1", "ASAN_OPTIONS": "detect_leaks=0",
                       "UBSAN_OPTIONS": f"suppressions={suppressions}"}
        completed = subprocess.run(["xvfb-run", "-a", example, flange()], env=environment, capture_output=True,
                                   text=True)
        self.assertEqual(completed.returncode, 0, completed.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog="Further arguments, such as tests, go to unittest.")
    parser.add_argument("program", type=pathlib.Path, help="the executable under test; the examples are beside it")
    parser.add_argument("sources", type=pathlib.Path, help="the folder of the package")
    parser.add_argument("cgal_data", type=pathlib.Path, help="the data folder of CGAL, which holds meshes/")
    parser.add_argument("cad_data", type=pathlib.Path, help="a folder with CAD models, which may be missing")
    _, arguments_of_unittest = parser.parse_known_args(namespace=paths)
    for name, path in vars(paths).items():
        setattr(paths, name, path.resolve())
    unittest.main(argv=[sys.argv[0], *arguments_of_unittest])


if __name__ == "__main__":
    main()
