#!/usr/bin/env python3
"""Writes the corpus that the fuzzer starts from: small meshes with features, in the format that Fuzz_case.cpp reads.

usage: make_corpus.py FOLDER
"""
import itertools
import math
import pathlib
import sys

SMALL_INTEGER, FRACTION, SPECIAL, ANY_DOUBLE = range(4)
GEOMETRIC, NO_RELAXATION, NO_REPAIR, SPLITS_CHORDS, GUIDED, TARGETS, NO_SPLIT, QUADS = (1 << bit for bit in range(8))


def parameters(strategy=0, flags=0, bound=0, skewness=0, weight=0, length=0):
    return bytes([strategy, flags, bound, skewness, weight, length])


def fraction(x):
    whole = math.floor(x)
    return [whole % 256, round(256 * (x - whole)) % 256]


def points(kind, coordinates):
    encode = {SMALL_INTEGER: lambda x: [round(x) % 256], FRACTION: fraction, SPECIAL: lambda x: [x]}[kind]
    return bytes([kind, len(coordinates)]) + bytes(itertools.chain.from_iterable(
        encode(x) for point in coordinates for x in point))


def tuples(elements):
    return bytes([len(elements)]) + bytes(itertools.chain.from_iterable(elements))


def grid(columns, rows, closed_in_u=False, closed_in_v=False, reverses=False, position=None):
    """A grid of squares, each cut into two triangles; `reverses` glues the last column upside down."""
    width = columns if closed_in_u else columns + 1
    height = rows if closed_in_v else rows + 1

    def number(i, j):
        if reverses and i == columns:
            j = rows - j
        return (j % height) * width + i % width

    triangles = []
    for i in range(columns):
        for j in range(rows):
            p, q, r, s = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
            triangles += [(p, q, r), (p, r, s)]
    place = position or (lambda i, j: (3 * i, 3 * j, 0))
    return [place(i, j) for j in range(height) for i in range(width)], triangles


def torus(columns, rows):
    def position(i, j):
        u, v = 2 * math.pi * i / columns, 2 * math.pi * j / rows
        radius = 20 + 8 * math.cos(v)
        return radius * math.cos(u), radius * math.sin(u), 8 * math.sin(v)
    return grid(columns, rows, True, True, position=position)


def cylinder(columns, rows, **options):
    def position(i, j):
        u = 2 * math.pi * i / columns
        return 10 * math.cos(u), 10 * math.sin(u), 4 * j
    return grid(columns, rows, True, position=position, **options)


CUBE = ([(10 * (k & 1), 10 * (k >> 1 & 1), 10 * (k >> 2)) for k in range(8)],
        [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5)])
CUBE_EDGES = [(p, p | bit) for p in range(8) for bit in (1, 2, 4) if not p & bit]
TETRAHEDRON = [(0, 0, 0), (9, 0, 0), (0, 7, 0), (1, 2, 8)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
FAN = ([(0, 0, 0)] + [(30 * math.cos(0.1 * k), 30 * math.sin(0.1 * k), 0) for k in range(5)],
       [(0, k, k + 1) for k in range(1, 5)])
PEAK = ([(-10, -10, 0), (10, -10, 0), (10, 10, 0), (-10, 10, 0), (0, 0, 15)],
        [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])


def files():
    """Yields names and bytes."""
    def case(name, mesh, features=(), kind=FRACTION, rest=b"", **options):
        return name, (parameters(**options) + points(kind, mesh[0]) + tuples(mesh[1]) + tuples(list(features)) + rest)

    yield case("triangle", (FAN[0], [(0, 1, 2)]))
    yield case("wedge", FAN)
    yield case("wedge_chords", FAN, flags=SPLITS_CHORDS | GEOMETRIC, strategy=4)
    yield case("tetrahedron", TETRAHEDRON)
    yield case("tetrahedron_with_edges", TETRAHEDRON, itertools.combinations(range(4), 2), strategy=3)
    yield case("overconstrained", TETRAHEDRON, itertools.combinations(range(4), 2), flags=NO_SPLIT)
    yield case("cube_with_edges", CUBE, CUBE_EDGES)
    yield case("cube_with_some_edges", CUBE, CUBE_EDGES[:5], flags=GEOMETRIC, strategy=5)
    yield case("cube", CUBE, strategy=1)
    yield case("peak", PEAK, [(0, 4), (4, 2)], bound=4, strategy=6)
    yield case("peak_all", PEAK, [(k, 4) for k in range(4)], bound=6, strategy=7)
    yield case("square", grid(4, 4), [(6, 7), (7, 12)])
    yield case("square_guided", grid(4, 4), flags=GUIDED, rest=bytes(range(7, 39)))
    yield case("square_guided_weighted", grid(4, 4), flags=GUIDED | GEOMETRIC, rest=bytes([9, 44, 5, 105] * 8))
    yield case("square_targets", grid(4, 4), flags=TARGETS, rest=bytes([2, 12, 0, 1, 20, 1, 2]))
    yield case("square_orthogonal", grid(3, 4), flags=NO_RELAXATION, strategy=2)
    yield case("square_unrepaired", grid(3, 3), flags=NO_REPAIR, strategy=1)
    yield case("annulus", cylinder(7, 2), [(0, 8), (8, 15)], flags=NO_REPAIR)
    yield case("cylinder", cylinder(6, 3), weight=1, skewness=2)
    yield case("moebius", cylinder(6, 1, reverses=True))
    yield case("torus", torus(6, 5), strategy=1)
    yield case("torus_with_feature", torus(6, 5), [(0, 1), (1, 7), (12, 13)], flags=GEOMETRIC, length=1)
    yield case("torus_targets", torus(5, 4), flags=TARGETS, rest=bytes([2, 3, 0, 1, 20, 1, 2]))
    yield case("wrong_bound", grid(2, 2), bound=7)
    yield case("wrong_skewness", grid(2, 2), skewness=4)
    yield case("isolated_points", (grid(3, 3)[0] + [(1, 1, 1)] * 3, grid(2, 3)[1]), kind=SMALL_INTEGER)
    yield case("bow_tie", ([(0, 0, 0), (5, 1, 0), (4, 4, 0), (-5, 1, 0), (-4, -4, 0)], [(0, 1, 2), (0, 3, 4)]))
    yield case("edge_of_three_faces", ([(0, 0, 0), (9, 0, 0), (0, 5, 0), (0, 0, 5), (0, -5, -5)],
                                       [(0, 1, 2), (0, 1, 3), (1, 0, 4)]))
    yield case("twice_the_same_face", (FAN[0], FAN[1] + [(0, 1, 2), (2, 1, 0)]))
    yield case("face_with_point_twice", (FAN[0], FAN[1] + [(1, 1, 3)]))
    yield case("collinear", ([(k, k, 0) for k in range(5)] + [(2, 0, 0)], [(0, 2, 4), (0, 4, 5)]), kind=SMALL_INTEGER)
    for kind_of_coordinates in range(0, 24, 3):
        special = [tuple((kind_of_coordinates * (k == i) + k + i) % 24 for k in range(3)) for i in range(9)]
        yield case(f"special_{kind_of_coordinates}", (special, grid(2, 2)[1]), kind=SPECIAL)
    roof = [(2 * i, 16 * j, -abs(i - 1) * (0.1 if j in (3, 4) else 0.28)) for j in range(8) for i in range(3)]
    yield case("gap", (roof, grid(2, 7)[1]), rest=bytes([2, 2, 0, 1]))
    yield case("short_chains", (roof, grid(2, 7)[1]), rest=bytes([2, 2, 4]))
    yield case("streamlines", grid(4, 4), rest=bytes([0] * 4 + [0, 1, 4]))
    yield case("spoilt_angle", grid(4, 4), rest=bytes([0] * 7 + [1, 5, 0, 5]))
    yield case("spoilt_skewness", grid(4, 4), rest=bytes([0] * 7 + [1, 5, 1, 7]))
    yield case("spoilt_matching", grid(4, 4), rest=bytes([0] * 7 + [2, 5, 2, 4, 9, 3, 4]))
    quads = QUADS | NO_SPLIT
    yield case("quads_of_wedge", FAN, flags=quads, rest=bytes([0]))
    yield case("quads_of_tetrahedron", TETRAHEDRON, itertools.combinations(range(4), 2), flags=quads, rest=bytes([2]))
    yield case("quads_of_cube", CUBE, CUBE_EDGES, flags=quads, rest=bytes([2]))
    yield case("quads_of_cube_with_slits", CUBE, CUBE_EDGES[:5], flags=QUADS, rest=bytes([3]))
    yield case("quads_of_square", grid(4, 4), [(6, 7), (7, 12)], flags=quads | NO_REPAIR, rest=bytes([1]))
    yield case("quads_of_moebius", cylinder(6, 1, reverses=True), flags=quads, rest=bytes([6]))
    yield case("quads_of_torus", torus(6, 5), flags=quads, rest=bytes([4]))
    yield case("quads_of_torus_with_feature", torus(6, 5), [(0, 1), (1, 7), (12, 13)], flags=quads, rest=bytes([3]))
    yield case("quads_of_cylinder", cylinder(7, 2), [(0, 8), (8, 15)], flags=quads | GUIDED, rest=bytes(range(29)))
    yield case("quads_of_targets", grid(4, 4), flags=quads | TARGETS, rest=bytes([2, 12, 0, 1, 20, 1, 2, 6]))
    yield case("quads_of_collinear", ([(k, k, 0) for k in range(5)] + [(2, 0, 0)], [(0, 2, 4), (0, 4, 5)]),
               kind=SMALL_INTEGER, flags=quads)
    yield case("quads_of_wrong_size", FAN, flags=quads, rest=bytes([6]))
    yield "empty", b""


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
