# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Exact distances from points to many segments or triangles."""

import numpy as np
from scipy.spatial import cKDTree

MOST_CANDIDATES = 1 << 20  # of points with pieces that are looked at together


def dots(a, b):
    return np.einsum("ij,ij->i", a, b)


def distances_to_segments(points, ends):
    """From each point to the segment of the same number; `ends` has shape (n, 2, 3)."""
    start, along = ends[:, 0], ends[:, 1] - ends[:, 0]
    squares = dots(along, along)
    places = np.clip(dots(points - start, along) / np.where(squares > 0, squares, 1), 0, 1)
    return np.linalg.norm(points - start - along * places[:, None], axis=1)


def distances_to_triangles(points, corners):
    """The same for triangles: to the plane where the foot is inside, otherwise to the nearest side."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    is_inside = length > 0
    for start, end in ((a, b), (b, c), (c, a)):
        is_inside &= dots(np.cross(end - start, points - start), normal) >= 0
    sides = [distances_to_segments(points, np.stack(side, axis=1)) for side in ((a, b), (b, c), (c, a))]
    height = np.abs(dots(points - a, normal)) / np.where(length > 0, length, 1)
    return np.where(is_inside, height, np.min(sides, axis=0))


class Primitives:
    """Segments or triangles, given by their points' numbers. Long ones are represented by several pieces in a tree of
    the pieces' centres: what is nearer than a distance has a centre that is nearer than it plus the largest radius."""

    def __init__(self, points, primitives, piece_length=None):
        self.corners = points[np.asarray(primitives)]
        size = self.corners.shape[1]
        sides = np.linalg.norm(self.corners - np.roll(self.corners, -1, axis=1), axis=2)
        extent = np.ptp(self.corners.reshape(-1, 3), axis=0).max()
        limit = piece_length or max(2 * np.median(sides), extent / 100)
        corners, owners = self.corners, np.arange(len(self.corners))
        centres, self.owners, self.radius = [], [], 0.0
        while len(corners):
            following = np.roll(corners, -1, axis=1)
            sides = np.linalg.norm(corners - following, axis=2)[:, :3 if size == 3 else 1]
            longest = sides.argmax(axis=1)
            is_long = sides.max(axis=1) > limit
            middles = corners[~is_long].mean(axis=1)
            centres.append(middles)
            self.owners.append(owners[~is_long])
            if len(middles):
                radii = np.linalg.norm(corners[~is_long] - middles[:, None], axis=2)
                self.radius = max(self.radius, radii.max())
            corners, owners, longest = corners[is_long], owners[is_long], longest[is_long]
            every = np.arange(len(corners))
            halves = (corners[every, longest] + corners[every, (longest + 1) % size]) / 2
            first, second = corners.copy(), corners.copy()
            first[every, (longest + 1) % size] = halves
            second[every, longest] = halves
            corners, owners = np.concatenate([first, second]), np.concatenate([owners, owners])
        self.owners = np.concatenate(self.owners)
        self.tree = cKDTree(np.concatenate(centres))

    def distances(self, points, owners):
        function = distances_to_segments if self.corners.shape[1] == 2 else distances_to_triangles
        return function(points, self.corners[owners])

    def nearest(self, points):
        """The distance of each point to the nearest primitive, and which one that is."""
        distance = np.full(len(points), np.inf)
        owner = np.zeros(len(points), dtype=int)
        left, number = np.arange(len(points)), 8
        while len(left):
            number = min(number, len(self.owners))
            unfinished = []
            for part in np.array_split(left, len(left) * number // MOST_CANDIDATES + 1):
                reach, pieces = self.tree.query(points[part], number)
                candidates = self.owners[pieces.reshape(len(part), -1)]
                found = self.distances(np.repeat(points[part], number, axis=0), candidates.ravel())
                found = found.reshape(len(part), -1)
                best = found.argmin(axis=1)
                distance[part] = found[np.arange(len(part)), best]
                owner[part] = candidates[np.arange(len(part)), best]
                if number < len(self.owners):
                    unfinished.append(part[reach.reshape(len(part), -1)[:, -1] - self.radius < distance[part]])
            left = np.concatenate(unfinished) if unfinished else np.array([], dtype=int)
            number *= 4
        return distance, owner

    def has_near(self, points, limits, is_allowed):
        """Whether a primitive is no farther from each point than its limit, of those that `is_allowed(numbers of
        points, primitives)` accepts."""
        result = np.zeros(len(points), dtype=bool)
        for part in np.array_split(np.arange(len(points)), len(points) // 4096 + 1):
            lists = self.tree.query_ball_point(points[part], limits[part] + self.radius)
            numbers = np.repeat(part, [len(pieces) for pieces in lists])
            pieces = np.concatenate(lists).astype(int) if len(numbers) else np.array([], dtype=int)
            owners = self.owners[pieces]
            is_near = is_allowed(numbers, owners)
            numbers, owners = numbers[is_near], owners[is_near]
            result[numbers[self.distances(points[numbers], owners) <= limits[numbers]]] = True
        return result
