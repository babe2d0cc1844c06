#!/usr/bin/python3
"""Tests of the scripts that measure and compare quad meshes.

usage: test_quad_comparison.py CAD_QUAD_MESH
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

BENCHMARK = pathlib.Path(__file__).resolve().parents[2] / "benchmark/Frame_fields"
sys.path.insert(0, str(BENCHMARK))

import measure_quads  # noqa: E402
from measure_quads import measure  # noqa: E402
from nearest_primitives import Primitives  # noqa: E402
from polygon_meshes import read_mesh, sharp_edges  # noqa: E402

PROGRAM = ""
measure_quads.NUMBER_OF_SAMPLES = 1000  # small meshes need no more


def grid_cube(size):
    """The unit cube, with size x size squares a side."""
    numbers, points, faces = {}, [], []

    def number_of(place):
        if place not in numbers:
            numbers[place] = len(points)
            points.append([coordinate / size for coordinate in place])
        return numbers[place]

    for axis in range(3):
        for side in (0, size):
            for i in range(size):
                for j in range(size):
                    square = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        place = [0, 0, 0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = side, i + di, j + dj
                        square.append(number_of(tuple(place)))
                    faces.append(square if side else square[::-1])
    return np.array(points), faces


def wedge(degrees):
    """A prism whose bottom and top are kites, with one quad for each; its features are all edges."""
    angle = np.radians(degrees)
    kite = [(0, 0), (1, 0), (1.1 * np.cos(angle / 2), 1.1 * np.sin(angle / 2)), (np.cos(angle), np.sin(angle))]
    points = np.array([(*corner, z) for z in (0, 1) for corner in kite], dtype=float)
    faces = [[3, 2, 1, 0], [4, 5, 6, 7]] + [[i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4] for i in range(4)]
    return points, faces, sorted({(min(e), max(e)) for f in faces for e in zip(f, f[1:] + f[:1])})


class MeasureTest(unittest.TestCase):

    def setUp(self):
        self.model = grid_cube(4)
        self.features = sharp_edges(*self.model, 40)

    def measures(self, points, faces):
        return measure(self.model, self.features, (points, faces))

    def assert_measures(self, measures, flaws, **expected):
        self.assertEqual(sorted(measures["flaws"]), sorted(flaws))
        self.assertEqual({key: measures[key] for key in expected}, expected)

    def test_a_finer_cube_is_flawless(self):
        self.assertEqual(len(self.features), 48)
        measures = self.measures(*grid_cube(8))
        self.assert_measures(measures, [], quads=384, corners=8, irregular_interior=0, irregular_feature_sectors=0,
                             euler_characteristic=2, components=1, feature_lost=0.0)
        self.assertAlmostEqual(measures["scaled_jacobian_min"], 1)
        self.assertAlmostEqual(measures["hausdorff"], 0)

    def test_the_side_that_is_up_does_not_matter(self):
        points, faces = grid_cube(8)
        self.assert_measures(self.measures(points, [face[::-1] for face in faces]), [])

    def test_faults_of_faces(self):
        points, faces = grid_cube(8)
        self.assert_measures(self.measures(points, faces[:20] + [faces[20][::-1]] + faces[21:]),
                             ["flipped_faces", "misoriented_edges", "non_manifold_vertices"], flipped_faces=1,
                             misoriented_edges=4)
        self.assert_measures(self.measures(points, faces[1:]), ["border_loops", "euler_characteristic"])
        a, b, c, d = faces[9]
        self.assert_measures(self.measures(points, faces[:9] + [[a, b, c], [a, c, d]] + faces[10:]), ["triangles"],
                             triangles=2, quads=383)
        self.assert_measures(self.measures(points, faces + [faces[3]]),
                             ["duplicate_faces", "non_manifold_edges", "non_manifold_vertices",
                              "euler_characteristic"], duplicate_faces=1, non_manifold_edges=4)

    def test_a_moved_mesh(self):
        points, faces = grid_cube(8)
        measures = self.measures(points + [0.03, 0, 0], faces)
        self.assertAlmostEqual(measures["hausdorff"], 0.03 / 3 ** 0.5)
        self.assert_measures(measures, ["corners_lost"], corners_lost=8)
        self.assertGreater(measures["feature_lost"], 0.5)
        self.assertLess(measures["feature_lost"], 1)

    def test_an_inverted_quad(self):
        points, faces = grid_cube(8)
        inner = next(v for v, p in enumerate(points) if p[0] == 1 and 0.4 < p[1] < 0.6 and 0.4 < p[2] < 0.6)
        points[inner] += [0, 0.2, 0.2]
        self.assertIn("scaled_jacobian_nonpositive", self.measures(points, faces)["flaws"])

    def test_irregular_vertices(self):
        """A hexagon of three quads: one vertex of valence 3 inside, and three corners of 120 degrees with two."""
        turns = np.pi / 3 * np.arange(6)
        points = np.array([[0, 0, 0]] + [[np.cos(turn), np.sin(turn), 0] for turn in turns])
        faces = [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]
        self.assert_measures(measure((points, faces), [], (points, faces)), [], irregular_interior=1,
                             irregular_feature_sectors=3)

    def test_sharp_corners(self):
        points, faces, features = wedge(15)
        model = points, faces
        self.assert_measures(measure(model, features, model), [], sharp_corners=2, sharp_lost=0, sharp_collapsed=0)
        cut = [[3, 1, 0], [3, 2, 1]] + faces[1:]
        self.assert_measures(measure(model, features, (points, cut)), ["sharp_collapsed", "triangles"],
                             sharp_collapsed=1)
        moved = points.copy()
        moved[0] += [0.2, 0.02, 0]
        self.assert_measures(measure(model, features, (moved, faces)), ["sharp_lost", "corners_lost"], sharp_lost=1,
                             corners_lost=1)

    def test_distances(self):
        """Against the nearest of many samples of each triangle."""
        random = np.random.default_rng(3)
        points = random.random((40, 3))
        points[:5] *= 20
        triangles = np.array([random.permutation(40)[:3] for _ in range(50)])
        places = 3 * random.random((40, 3))
        distances, owners = Primitives(points, triangles).nearest(places)
        weights = np.array([(i, j, 60 - i - j) for i in range(61) for j in range(61 - i)]) / 60
        for triangle_number, triangle in enumerate(triangles):
            samples = weights @ points[triangle]
            for place, distance, owner in zip(places, distances, owners):
                nearest = np.sqrt(((samples - place) ** 2).sum(axis=1).min())
                self.assertLessEqual(distance, nearest + 1e-9)
                if owner == triangle_number:
                    self.assertAlmostEqual(distance, nearest, delta=0.4)


class ComparisonTest(unittest.TestCase):

    def test_programs_that_work_and_that_fail(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "models").mkdir()
            points, faces = grid_cube(2)
            triangles = [corners for a, b, c, d in faces for corners in ([a, b, c], [a, c, d])]
            (folder / "models/cube.off").write_text(
                f"OFF\n{len(points)} {len(triangles)} 0\n" + "".join("%g %g %g\n" % tuple(p) for p in points)
                + "".join("3 %d %d %d\n" % tuple(t) for t in triangles))
            commands = {"ours": f"{PROGRAM} {{model}} --features {{features}} --edge-length {{edge_length}} --quiet "
                                "-o {output}",
                        "copy": "cp {model} {output}", "hang": "sleep 60", "nothing": "true",
                        "error": "sh -c 'exit 3'"}
            (folder / "list.json").write_text(json.dumps(
                [{"name": key, "command": command, "format": "off"} for key, command in commands.items()]))
            subprocess.run([sys.executable, BENCHMARK / "compare_quad_meshers.py", "list.json", "models", "out",
                            "--timeout", "2"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
            rows = {row["mesher"]: row for row in json.loads((folder / "out/comparison.json").read_text())}
            self.assertEqual({key: row["failure"] for key, row in rows.items()},
                             {"ours": "", "copy": "", "hang": "more than 2 s", "nothing": "no output",
                              "error": "exit code 3"})
            self.assertEqual(rows["ours"]["measures"]["flaws"], [])
            self.assertEqual(rows["ours"]["measures"]["corners"], 8)
            self.assertEqual(rows["copy"]["measures"]["triangles"], 48)
            self.assertGreater(rows["ours"]["seconds"], 0)
            table = (folder / "out/comparison.md").read_text()
            self.assertIn("| hang | 1 | 1 | 0 |", table)
            self.assertIn("| ours | 1 | 0 | 1 |", table)
            self.assertEqual(len(read_mesh(folder / "out/cube.ours.off")[1]), rows["ours"]["measures"]["quads"])


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
