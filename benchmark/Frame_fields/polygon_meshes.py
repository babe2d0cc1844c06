# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads polygon meshes (OFF and OBJ) and feature edges, and finds feature edges by angle."""

import pathlib

import numpy as np


def read_mesh(path):
    """The points, and the faces as lists of point numbers."""
    path = pathlib.Path(path)
    readers = {".off": read_off, ".obj": read_obj}
    if path.suffix.lower() not in readers:
        raise ValueError(f"{path}: neither .off nor .obj")
    return readers[path.suffix.lower()](path)


def read_off(path):
    """Vertices and faces may have colours behind their numbers if each has a line of its own."""
    lines = [line.split("#")[0].split() for line in path.read_text(encoding="ascii").splitlines()]
    lines = [words for words in lines if words]
    if not lines[0][0].endswith("OFF"):
        raise ValueError(f"{path}: does not start with OFF")
    lines[0] = lines[0][1:]
    if not lines[0]:
        del lines[0]
    number_of_points, number_of_faces = int(lines[0][0]), int(lines[0][1])
    point_lines = lines[1:1 + number_of_points]
    face_lines = lines[1 + number_of_points:1 + number_of_points + number_of_faces]
    points = np.array([words[:3] for words in point_lines], dtype=float).reshape(-1, 3)
    faces = [[int(word) for word in words[1:1 + int(words[0])]] for words in face_lines]
    if len(points) != number_of_points or len(faces) != number_of_faces:
        raise ValueError(f"{path}: fewer lines than vertices and faces")
    return points, faces


def read_obj(path):
    points, faces = [], []
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            points.append([float(word) for word in words[:3]])
        elif kind == "f":
            numbers = [int(word.split("/")[0]) for word in words]
            faces.append([number - 1 if number > 0 else len(points) + number for number in numbers])
    return np.array(points, dtype=float).reshape(-1, 3), faces


def read_features(path):
    """Pairs of vertex numbers, one a line; # starts a comment."""
    lines = [line.split("#")[0].split() for line in pathlib.Path(path).read_text(encoding="ascii").splitlines()]
    return [(int(words[0]), int(words[1])) for words in lines if len(words) > 1]


def triangulated(faces):
    """The triangles of the fans of all faces, and the face of each."""
    fans = [(face[0], face[k], face[k + 1], number) for number, face in enumerate(faces)
            for k in range(1, len(face) - 1)]
    fans = np.array(fans, dtype=int).reshape(-1, 4)
    return fans[:, :3], fans[:, 3]


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def normals_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return unit(np.cross(b - a, c - a))


def sharp_edges(points, faces, degrees):
    """Edges at which the normals of two triangles differ by this angle or more, or that do not have two triangles."""
    triangles, _ = triangulated(faces)
    normals = normals_of(points, triangles)
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    owners = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort(edges.T)
    edges, owners = edges[order], owners[order]
    starts = np.flatnonzero(np.concatenate([[True], (edges[1:] != edges[:-1]).any(axis=1)]))
    counts = np.diff(np.append(starts, len(edges)))
    others = np.minimum(starts + 1, len(edges) - 1)
    cosines = (normals[owners[starts]] * normals[owners[others]]).sum(axis=1)
    return edges[starts[(counts != 2) | (cosines <= np.cos(np.radians(degrees)))]].tolist()


def mean_edge_length(points, faces):
    edges = {(min(a, b), max(a, b)) for face in faces for a, b in zip(face, face[1:] + face[:1])}
    ends = np.array(sorted(edges))
    return float(np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1).mean())
