#!/usr/bin/env python3
"""The shrinker comes down to the minimum that is known for a check.

usage: test_shrink_failing_model.py CHECK_MODEL
"""
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

SHRINKER = pathlib.Path(__file__).with_name("shrink_failing_model.py")
SIZE = 6  # of a grid of squares

# Fails with 3 on two faces at (2, 3, 0), one face at (5, 0, 0) and a feature edge that ends at (2, 3, 0).
ARTIFICIAL_CHECKER = f"""
    import importlib.util, pathlib, sys
    specification = importlib.util.spec_from_file_location("shrinker", {str(SHRINKER)!r})
    shrinker = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(shrinker)
    model = shrinker.read_model(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
    def count(elements, *point):
        return sum(any(tuple(map(float, model.points[p])) == point for p in element) for element in elements)
    fails = (count(model.faces, 2, 3, 0) >= 2 and count(model.faces, 5, 0, 0) >= 1
             and count(model.features, 2, 3, 0) >= 1)
    sys.exit(3 if fails else 1 if len(model.faces) % 2 else 0)
"""


def grid():
    """The points and triangles of a grid, and all its edges along the x axis."""
    def number(i, j):
        return (SIZE + 1) * j + i
    points = [[i, j, 0] for j in range(SIZE + 1) for i in range(SIZE + 1)]
    faces = []
    for j in range(SIZE):
        for i in range(SIZE):
            faces += [[number(i, j), number(i + 1, j), number(i + 1, j + 1)],
                      [number(i, j), number(i + 1, j + 1), number(i, j + 1)]]
    return points, faces, [[number(i, j), number(i + 1, j)] for j in range(SIZE) for i in range(SIZE)]


class ShrinkerTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def shrink(self, points, faces, features, checker):
        lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(str, p)) for p in points]
        lines += [" ".join(map(str, [3] + face)) for face in faces]
        (self.folder / "model.off").write_text("\n".join(lines))
        (self.folder / "model.feat").write_text("\n".join(f"{p} {q}" for p, q in features))
        return subprocess.run([sys.executable, str(SHRINKER), "model.off", "model.feat", *checker], cwd=self.folder,
                              capture_output=True, text=True, check=False)

    def assert_shrunk_to(self, number_of_points, number_of_faces, number_of_features, output):
        self.assertEqual(0, output.returncode, output.stderr)
        self.assertEqual(["OFF", f"{number_of_points} {number_of_faces} 0"], output.stdout.splitlines()[:2])
        self.assertEqual(number_of_features, output.stdout.count("# feature edge"))
        mesh = "".join(line + "\n" for line in output.stdout.splitlines() if not line.startswith("#"))
        self.assertEqual(mesh, (self.folder / "shrunk.off").read_text())
        self.assertEqual(number_of_features, len((self.folder / "shrunk.feat").read_text().splitlines()))

    def test_comes_down_to_the_known_minimum(self):
        checker = self.folder / "checker.py"
        checker.write_text(textwrap.dedent(ARTIFICIAL_CHECKER))
        output = self.shrink(*grid(), [sys.executable, str(checker)])
        self.assertEqual(0, output.returncode, output.stderr)
        number_of_points = int(output.stdout.split()[1])
        self.assertIn(number_of_points, (7, 8))  # the two faces share an edge or the point only
        self.assert_shrunk_to(number_of_points, 3, 1, output)

    def test_leaves_one_face_of_a_mesh_that_is_refused(self):
        points, faces, features = grid()
        points[17] = points[16]
        output = self.shrink(points, faces, features, [CHECK_MODEL])
        self.assert_shrunk_to(3, 1, 0, output)

    def test_refuses_a_model_that_does_not_fail(self):
        output = self.shrink(*grid(), [CHECK_MODEL])
        self.assertNotEqual(0, output.returncode)
        self.assertIn("model.off does not fail", output.stderr)


if __name__ == "__main__":
    CHECK_MODEL = sys.argv.pop(1)
    unittest.main()
