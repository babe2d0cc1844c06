#!/usr/bin/env python3
"""Reduces a model on which a check fails to one from which no face and no feature edge can be left out.

usage: shrink_failing_model.py MODEL.off FEATURES CHECKER [ARGUMENT...]

CHECKER is called with its arguments, a mesh file and a file of feature edges (two vertex numbers a line), such as
check_model. A model fails as MODEL and FEATURES do if the exit code is the same, which must not be 0, and so are the
words that are printed before the first number or colon. The result goes to the standard output, the mesh as OFF and
the feature edges as comments behind it, and to shrunk.off and shrunk.feat in the current folder.
"""
import pathlib
import re
import subprocess
import sys
import tempfile


class Model:
    """Faces and feature edges with the coordinates of all points, used or not."""

    def __init__(self, points, faces, features):
        self.points, self.faces, self.features = points, faces, features

    def with_faces(self, faces):
        return Model(self.points, faces, self.features)

    def with_features(self, features):
        return Model(self.points, self.faces, features)

    def compact(self):
        """The same without features off the mesh and without points off the faces."""
        edges = {frozenset(edge) for face in self.faces for edge in zip(face, face[1:] + face[:1])}
        used = sorted({p for face in self.faces for p in face})
        number = {p: i for i, p in enumerate(used)}
        return Model([self.points[p] for p in used], [[number[p] for p in face] for face in self.faces],
                     [[number[p] for p in edge] for edge in self.features if frozenset(edge) in edges])

    def off(self):
        lines = ["OFF", f"{len(self.points)} {len(self.faces)} 0"]
        lines += [" ".join(point) for point in self.points]
        lines += [" ".join(map(str, [len(face)] + face)) for face in self.faces]
        return "\n".join(lines) + "\n"

    def feature_lines(self):
        return [" ".join(map(str, edge)) for edge in self.features]

    def write(self, mesh_file, feature_file):
        mesh_file.write_text(self.off())
        feature_file.write_text("".join(line + "\n" for line in self.feature_lines()))


def words(file):
    lines = (line.split("#")[0] for line in file.read_text().splitlines())
    return [word for line in lines for word in line.split()]


def read_model(mesh_file, feature_file):
    """Coordinates stay the text they are, so that they are never rounded."""
    header, *rest = words(mesh_file)
    if header != "OFF":
        raise ValueError(f"{mesh_file} is not an OFF file")
    number_of_points, number_of_faces = int(rest[0]), int(rest[1])
    points = [rest[3 + 3 * p:6 + 3 * p] for p in range(number_of_points)]
    place = 3 + 3 * number_of_points
    faces = []
    for _ in range(number_of_faces):
        size = int(rest[place])
        faces.append([int(word) for word in rest[place + 1:place + 1 + size]])
        place += 1 + size
    numbers = [int(word) for word in words(feature_file)]
    return Model(points, faces, [list(edge) for edge in zip(numbers[::2], numbers[1::2])])


def minimal_sublist(elements, fails):
    """Delta debugging: a sublist that fails and of which no single element can be left out."""
    size = max(len(elements) // 2, 1)
    while elements:
        kept = elements
        for begin in reversed(range(0, len(elements), size)):
            candidate = kept[:begin] + kept[begin + size:]
            if fails(candidate):
                kept = candidate
        if size == 1 and len(kept) == len(elements):
            break
        elements, size = kept, max(size // 2, 1)
    return elements


def shrink(model, fails):
    """Leaves out faces and features in turn until none of both can go."""
    while True:
        faces = minimal_sublist(model.faces, lambda faces: faces and fails(model.with_faces(faces)))
        fewer_faces = model.with_faces(faces)
        features = minimal_sublist(model.features, lambda edges: fails(fewer_faces.with_features(edges)))
        if (faces, features) == (model.faces, model.features):
            return model
        model = fewer_faces.with_features(features).compact()


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    mesh_file, feature_file, *checker = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        candidate_files = pathlib.Path(folder, "model.off"), pathlib.Path(folder, "model.feat")

        def outcome(model):
            model.compact().write(*candidate_files)
            run = subprocess.run(checker + [str(file) for file in candidate_files], stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True, check=False)
            return run.returncode, re.split(r"[\d:]", run.stdout)[0]

        model = read_model(pathlib.Path(mesh_file), pathlib.Path(feature_file))
        failure = outcome(model)
        if failure[0] == 0:
            sys.exit(f"{mesh_file} does not fail")
        shrunk = shrink(model.compact(), lambda candidate: outcome(candidate) == failure)
    shrunk.write(pathlib.Path("shrunk.off"), pathlib.Path("shrunk.feat"))
    print(shrunk.off() + "".join(f"# feature edge {line}\n" for line in shrunk.feature_lines()), end="")


if __name__ == "__main__":
    main()
