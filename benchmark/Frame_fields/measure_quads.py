#!/usr/bin/python3
# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Measures a quad mesh made from a triangle mesh with feature edges, whatever program made it; prints JSON.

    /usr/bin/python3 measure_quads.py MODEL.off [FEATURES] QUADS.obj

MODEL and QUADS are OFF or OBJ files. FEATURES has two vertex numbers of MODEL a line; borders are features as well.
Lengths are fractions of the diagonal of MODEL's bounding box, except the tolerance of features: 5 % of the mean edge of
QUADS. Needs Debian's python3-scipy.

irregular_interior          vertices on no feature that do not have 4 faces
irregular_feature_sectors   sectors between features that do not have one face for each 90 degrees, but at least one
scaled_jacobian_*           the least of the four corners of a quad; nonpositive: inverted quads
flipped_faces               their normals point away from those of the nearest triangles
feature_lost                part of the features' length that is farther from all edges of like direction (30 degrees)
corners                     vertices at which features end, meet, or turn by more than 45 degrees
sharp_corners               sectors of less than 45 degrees between features; lost: no vertex is there; collapsed: the
                            faces there are none, or not all of them are valid quads
flaws                       which of the measures keep the mesh from being flawless
"""

import argparse
import json
import math

import numpy as np

from nearest_primitives import Primitives
from polygon_meshes import normals_of, read_features, read_mesh, triangulated, unit
from polygon_surface import Surface, angle_between

SHARP_DEGREES, TURN_DEGREES = 45, 45
NUMBER_OF_SAMPLES = 30000
MUST_BE_ZERO = ("triangles", "other_polygons", "degenerate_faces", "duplicate_faces", "non_manifold_edges",
                "misoriented_edges", "non_manifold_vertices", "scaled_jacobian_nonpositive", "flipped_faces",
                "corners_lost", "sharp_lost", "sharp_collapsed")
MUST_BE_KEPT = ("components", "euler_characteristic", "border_loops")


def scaled_jacobians(points, quads):
    """Of the corners of each quad, as Verdict defines it: seen along the normal of the quad's principal axes."""
    corners = points[quads]
    out, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    a, b, c, d = (corners[:, k] for k in range(4))
    normal = np.cross(b - a + c - d, c - b + d - a)
    normal /= np.where(np.linalg.norm(normal, axis=1) > 0, np.linalg.norm(normal, axis=1), 1)[:, None]
    lengths = np.linalg.norm(out, axis=2) * np.linalg.norm(back, axis=2)
    areas = (np.cross(out, back) * normal[:, None]).sum(axis=2)
    return np.where(lengths > 0, areas / np.where(lengths > 0, lengths, 1), 0)


def samples_of(points, triangles, seed):
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    random = np.random.default_rng(seed)
    weights = random.dirichlet([1, 1, 1], NUMBER_OF_SAMPLES)
    return np.einsum("ij,ijk->ik", weights, corners[random.choice(len(corners), NUMBER_OF_SAMPLES,
                                                                  p=areas / areas.sum())])


class Measurement:
    """Of one mesh against one model; `result` has the measures."""

    def __init__(self, model, features, quads):
        triangles, _ = triangulated(model[1])
        self.model, self.mesh = Surface(model[0], triangles.tolist()), Surface(*quads)
        self.triangles = triangles
        self.diagonal = float(np.linalg.norm(np.ptp(self.model.points[np.unique(triangles)], axis=0)))
        pairs = {(min(a, b), max(a, b)) for a, b in features} & set(self.model.faces_of_edge)
        self.features = np.array(sorted(pairs | self.model.border), dtype=int).reshape(-1, 2)
        self.result = {}
        if not self.mesh.faces:
            self.result["flaws"] = ["empty"]
            return
        self.tolerance = 0.05 * float(self.mesh.lengths.mean())
        self.count_faces()
        self.compare_topology()
        self.measure_shapes()
        self.measure_distances()
        self.measure_features()
        self.count_irregular()
        self.count_corners()
        self.count_sharp_corners()
        self.result["flaws"] = [key for key in MUST_BE_ZERO if self.result[key]] + \
            [key for key in MUST_BE_KEPT if self.result[key] != self.result[key + "_of_model"]]

    def count_faces(self):
        points, faces = self.mesh.points, self.mesh.faces
        sizes = np.array([len(face) for face in faces])
        areas, self.normals, self.centres = np.zeros(len(faces)), np.zeros((len(faces), 3)), np.zeros((len(faces), 3))
        for size in np.unique(sizes):
            which = np.flatnonzero(sizes == size)
            corners = points[[faces[face] for face in which]]
            self.centres[which] = corners.mean(axis=1)
            corners = corners - corners[:, :1]
            vectors = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1) / 2
            areas[which], self.normals[which] = np.linalg.norm(vectors, axis=1), unit(vectors)
        self.is_quad = sizes == 4
        self.is_degenerate = (areas < 1e-12 * self.diagonal ** 2) | [len(set(face)) < len(face) for face in faces]
        self.result |= {"faces": len(faces), "quads": int(self.is_quad.sum()), "triangles": int((sizes == 3).sum()),
                        "other_polygons": int((~np.isin(sizes, (3, 4))).sum()),
                        "degenerate_faces": int(self.is_degenerate.sum()),
                        "duplicate_faces": len(faces) - len({tuple(sorted(face)) for face in faces})}

    def compare_topology(self):
        for key in ("non_manifold_edges", "misoriented_edges", "non_manifold_vertices"):
            self.result[key] = getattr(self.mesh, key)()
        for key in MUST_BE_KEPT:
            self.result |= {key: getattr(self.mesh, key)(), key + "_of_model": getattr(self.model, key)()}

    def measure_shapes(self):
        quads = np.array([face for face in self.mesh.faces if len(face) == 4], dtype=int).reshape(-1, 4)
        least = scaled_jacobians(self.mesh.points, quads).min(axis=1)
        self.is_bad = self.is_degenerate.copy()
        self.is_bad[np.flatnonzero(self.is_quad)[least <= 0]] = True
        if len(least):
            self.result |= {"scaled_jacobian_min": float(least.min()), "scaled_jacobian_mean": float(least.mean())}
        self.result |= {"scaled_jacobian_nonpositive": int((least <= 0).sum()),
                        "scaled_jacobian_below_02": int((least < 0.2).sum())}

    def measure_distances(self):
        model, mesh = self.model, self.mesh
        to_model = Primitives(model.points, self.triangles)
        self.model_normals = normals_of(model.points, self.triangles)
        nearest = to_model.nearest(self.centres)[1]
        self.is_flipped = (self.normals * self.model_normals[nearest]).sum(axis=1) < 0
        if 2 * self.is_flipped.sum() > len(mesh.faces):  # the other side is up in all of them
            self.is_flipped = ~self.is_flipped
        pieces, _ = triangulated(mesh.faces)
        out = to_model.nearest(np.concatenate([mesh.points[mesh.vertices], self.centres,
                                               samples_of(mesh.points, pieces, 1)]))[0]
        back = Primitives(mesh.points, pieces).nearest(np.concatenate([
            model.points[model.vertices], samples_of(model.points, self.triangles, 2)]))[0]
        self.result |= {"flipped_faces": int(self.is_flipped.sum()),
                        "hausdorff": float(max(out.max(), back.max()) / self.diagonal)}

    def measure_features(self):
        """What part of the features has an edge, and which edges run along them (`marked`)."""
        model, mesh, ends = self.model, self.mesh, self.features
        self.marked = set(mesh.border)
        self.result["feature_lost"] = 0.0
        if not len(ends):
            return
        start, along = model.points[ends[:, 0]], model.points[ends[:, 1]] - model.points[ends[:, 0]]
        lengths = np.linalg.norm(along, axis=1)
        step = min(mesh.lengths.mean() / 8, self.diagonal / 500)
        counts = np.clip(np.ceil(lengths / step).astype(int) + 1, 2, 2000)
        owners = np.repeat(np.arange(len(ends)), counts)
        numbers = np.arange(len(owners)) - np.repeat(np.cumsum(counts) - counts, counts)
        samples = start[owners] + along[owners] * (numbers / (counts[owners] - 1))[:, None]
        is_end = (numbers == 0) | (numbers == counts[owners] - 1)
        weights = np.where(is_end, 0.5, 1) * lengths[owners] / (counts[owners] - 1)
        directions = unit(along)
        mesh_directions = unit(mesh.points[mesh.edges[:, 1]] - mesh.points[mesh.edges[:, 0]])

        def are_aligned(feature, edge, degrees):
            cosines = np.abs((directions[feature] * mesh_directions[edge]).sum(axis=1))
            return cosines >= math.cos(math.radians(degrees))

        is_kept = Primitives(mesh.points, mesh.edges).has_near(
            samples, np.full(len(samples), self.tolerance), lambda i, edge: are_aligned(owners[i], edge, 30))
        self.result["feature_lost"] = float(weights[~is_kept].sum() / weights.sum())

        curves = Primitives(model.points, ends)
        limits = np.maximum(self.tolerance, 0.1 * mesh.lengths)
        runs_along = curves.has_near(mesh.points[mesh.edges].mean(axis=1), limits,
                                     lambda edge, feature: are_aligned(feature, edge, 35))
        for end in range(2):
            runs_along &= curves.nearest(mesh.points[mesh.edges[:, end]])[0] <= limits
        self.marked |= set(map(tuple, mesh.edges[runs_along].tolist()))

    def count_irregular(self):
        inside = on_features = 0
        for vertex in self.mesh.vertices:
            sectors = self.mesh.sectors(vertex, self.marked)
            on_features += sectors is None
            for sector in sectors or []:
                if sector.first is None:
                    inside += len(sector.faces) != 4
                else:
                    on_features += len(sector.faces) != max(1, round(sector.degrees / 90))
        self.result |= {"irregular_interior": inside, "irregular_feature_sectors": on_features}

    def count_corners(self):
        points, neighbours = self.model.points, {}
        for a, b in self.features.tolist():
            neighbours.setdefault(a, []).append(b)
            neighbours.setdefault(b, []).append(a)
        self.feature_vertices = list(neighbours)
        corners = [vertex for vertex, ends in neighbours.items() if len(ends) != 2 or angle_between(
            points[ends[0]] - points[vertex], points[vertex] - points[ends[1]]) > TURN_DEGREES]
        distances, nearest = Primitives(self.mesh.points, [[v, v] for v in self.mesh.vertices]).nearest(
            points[self.feature_vertices]) if neighbours else (np.array([]), np.array([], dtype=int))
        self.distance_of = dict(zip(self.feature_vertices, distances.tolist()))
        self.nearest_vertex = dict(zip(self.feature_vertices, np.array(self.mesh.vertices)[nearest].tolist()))
        self.result |= {"corners": len(corners),
                        "corners_lost": sum(self.distance_of[v] > self.tolerance for v in corners)}

    def count_sharp_corners(self):
        marked = set(map(tuple, self.features.tolist()))
        count = lost = collapsed = 0
        for vertex in self.feature_vertices:
            for sector in self.model.sectors(vertex, marked) or []:
                if sector.first is not None and sector.first != sector.last and sector.degrees < SHARP_DEGREES:
                    is_lost = self.distance_of[vertex] > self.tolerance
                    count, lost = count + 1, lost + int(is_lost)
                    collapsed += not is_lost and not self.holds_valid_quads(vertex, sector)
        self.result |= {"sharp_corners": count, "sharp_lost": lost, "sharp_collapsed": collapsed}

    def holds_valid_quads(self, vertex, sector):
        """Whether the faces that point into a sector of the model are valid quads, and at least one does."""
        points, mesh, centre = self.model.points, self.mesh, int(self.nearest_vertex[vertex])
        middle = unit(unit(points[sector.first] - points[vertex]) + unit(points[sector.last] - points[vertex]))
        normal = unit(self.model_normals[sector.faces].sum(axis=0))
        inside = []
        for face in mesh.faces_around[centre]:
            corners = mesh.faces[face]
            place = corners.index(centre)
            ends = mesh.points[[corners[(place + 1) % len(corners)], corners[place - 1]]] - mesh.points[centre]
            direction = unit(unit(ends).sum(axis=0))
            is_in_plane = self.is_degenerate[face] or abs(self.normals[face] @ normal) > 0.7
            if direction.any() and is_in_plane and \
                    angle_between(direction, middle) <= max(sector.degrees / 2, 5) + 5:
                inside.append(face)
        return bool(inside) and all(self.is_quad[face] and not self.is_bad[face] and not self.is_flipped[face]
                                    for face in inside)


def measure(model, features, quads):
    """The measures of a quad mesh; meshes are pairs of points and faces."""
    return Measurement(model, features, quads).result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="MODEL [FEATURES] QUADS")
    files = parser.parse_args().files
    if len(files) not in (2, 3):
        parser.error("two or three files are needed")
    features = read_features(files[1]) if len(files) == 3 else []
    print(json.dumps(measure(read_mesh(files[0]), features, read_mesh(files[-1])), indent=1))


if __name__ == "__main__":
    main()
