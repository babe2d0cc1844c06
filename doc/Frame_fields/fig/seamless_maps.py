# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the maps that the example frame_field_seamless_map writes, and traces their motorcycle graphs for the figures,
with floating-point numbers and without a guarantee."""

import collections
import math

import numpy as np

AXES = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)], dtype=float)
MOST_STEPS = 3000
Port = collections.namedtuple("Port", "face corner axis")
Step = collections.namedtuple("Step", "trace face start end axis time")  # on a face, in its chart


class SeamlessMap:
    """Triangles whose corners have points (u, v), and the feature edges."""

    def __init__(self, path):
        kinds = {"v": [], "vt": [], "f": [], "l": []}
        with open(path, encoding="ascii") as file:
            for line in file:
                kind, *words = line.split()
                kinds[kind].append(words)
        self.points = np.array(kinds["v"], dtype=float)
        corners = np.array([[word.split("/") for word in words] for words in kinds["f"]], dtype=int) - 1
        self.triangles, self.uv = corners[:, :, 0], np.array(kinds["vt"], dtype=float)[corners[:, :, 1]]
        self.features = np.array(kinds["l"], dtype=int) - 1
        self.across = self.neighbours()
        self.singularities, self.ports = self.find_singularities()  # of singularities those on no feature

    def neighbours(self):
        """For (face, k), the edge from corner k to the next one, the same of the other face if it is no feature."""
        features = {(min(a, b), max(a, b)) for a, b in self.features.tolist()}
        edges = collections.defaultdict(list)
        for face, corners in enumerate(self.triangles.tolist()):
            for k in range(3):
                a, b = corners[k], corners[(k + 1) % 3]
                if (min(a, b), max(a, b)) not in features:
                    edges[min(a, b), max(a, b)].append((face, k))
        return {pair[i]: pair[1 - i] for pair in edges.values() if len(pair) == 2 for i in range(2)}

    def sectors(self):
        """The corners (face, k) around each vertex between features, counter-clockwise, and whether they close."""
        left = {(face, k) for face in range(len(self.triangles)) for k in range(3)}
        while left:
            first = corner = next(iter(left))
            while True:  # back to the start of the sector
                before = self.across.get(corner)
                if before is None:
                    break
                corner = (before[0], (before[1] + 1) % 3)
                if corner == first:
                    break
            is_closed = self.across.get(corner) is not None
            sector, first = [], corner
            while True:
                sector.append(corner)
                left.discard(corner)
                behind = self.across.get((corner[0], (corner[1] + 2) % 3))
                if behind is None or behind == first:
                    break
                corner = behind
            yield sector, is_closed

    def corner_angles(self, face, k):
        """The direction of the edge that leaves the corner, and the angle of the corner, in the chart."""
        here, ahead, behind = (self.uv[face, (k + i) % 3] for i in range(3))
        out, back = ahead - here, behind - here
        start = math.atan2(out[1], out[0])
        return start, math.atan2(out[0] * back[1] - out[1] * back[0], out @ back)

    def find_singularities(self):
        vertices, ports = [], []
        for sector, is_closed in self.sectors():
            angles = [self.corner_angles(*corner) for corner in sector]
            quarters = round(sum(angle for _, angle in angles) / (math.pi / 2))
            if quarters == (4 if is_closed else 2) or not self.uv[sector[0][0]].any():
                continue
            if is_closed:
                vertices.append((self.triangles[sector[0]], quarters))
            for number, (corner, (start, angle)) in enumerate(zip(sector, angles)):
                for axis in range(4):
                    turn = (axis * math.pi / 2 - start + 1e-7) % (2 * math.pi) - 1e-7
                    is_first_side = not is_closed and number == 0 and abs(turn) < 1e-6
                    if turn < angle - 1e-7 and not is_first_side:
                        ports.append(Port(*corner, axis))
        return vertices, ports

    def turned(self, face, k, point, axis):
        """A point on an edge and an axis in the chart of the face across it, and that edge there."""
        other, j = self.across[face, k]
        here, there = self.uv[face, k], self.uv[other, (j + 1) % 3]
        along, along_there = self.uv[face, (k + 1) % 3] - here, self.uv[other, j] - there
        turns = round((math.atan2(along_there[1], along_there[0]) - math.atan2(along[1], along[0])) / (math.pi / 2))
        part = (point - here) @ along / (along @ along)
        return other, j, there + part * along_there, (axis + turns) % 4

    def exit_of(self, face, point, axis, entry):
        """The edge through which a line leaves a face, and where; `entry` are edges that it does not leave through."""
        best = None
        direction, normal = AXES[axis], AXES[(axis + 1) % 4]
        for k in range(3):
            if k in entry:
                continue
            a, b = self.uv[face, k], self.uv[face, (k + 1) % 3]
            left, right = (b - point) @ normal, (a - point) @ normal
            share = min(max(right / (right - left), 0), 1) if right != left else 0.5
            miss = max(0, right, -left)  # a line leaves with the first end on its right
            where = a + share * (b - a)
            if best is None or miss < best[0]:
                best = miss, k, where, (where - point) @ direction
        return best[1:]

    def trace(self, number, port):
        face, point, axis, time = port.face, self.uv[port.face, port.corner], port.axis, 0.0
        entry = (port.corner, (port.corner + 2) % 3)
        for _ in range(MOST_STEPS):
            k, where, length = self.exit_of(face, point, axis, entry)
            yield Step(number, face, point, where, axis, time)
            time += max(length, 0)
            if (face, k) not in self.across:
                return
            face, k, point, axis = self.turned(face, k, where, axis)
            entry = (k,)

    def motorcycle_graph(self):
        """Polylines in space from each port to where it stops."""
        traces = [list(self.trace(number, port)) for number, port in enumerate(self.ports)]
        ends = [math.inf] * len(traces)
        for _, (first, first_time), (second, second_time) in sorted(crossings(traces)):
            if ends[first] >= first_time and ends[second] >= second_time and \
                    (first != second or first_time != second_time):
                later, time = (first, first_time) if first_time > second_time else (second, second_time)
                ends[later] = min(ends[later], time)
        return [self.polyline(steps, end) for steps, end in zip(traces, ends)]

    def polyline(self, steps, end):
        points = [self.in_space(steps[0].face, steps[0].start)]
        for step in steps:
            length = (step.end - step.start) @ AXES[step.axis]
            if step.time + length >= end:
                points.append(self.in_space(step.face, step.start + (end - step.time) * AXES[step.axis]))
                break
            points.append(self.in_space(step.face, step.end))
        return np.array(points)

    def in_space(self, face, point):
        a, b, c = self.uv[face]
        weights = np.linalg.solve(np.array([b - a, c - a]).T, point - a)
        corners = self.points[self.triangles[face]]
        return corners[0] + weights[0] * (corners[1] - corners[0]) + weights[1] * (corners[2] - corners[0])


def crossings(traces):
    """(time of the later one, (trace, its time), (other trace, its time)) wherever perpendicular lines cross."""
    on_face = collections.defaultdict(list)
    for steps in traces:
        for step in steps:
            on_face[step.face].append(step)
    for steps in on_face.values():
        for number, first in enumerate(steps):
            for second in steps[:number]:
                if (first.axis - second.axis) % 2:
                    u, v = (first, second) if first.axis % 2 == 0 else (second, first)
                    place = np.array([v.start[0], u.start[1]])
                    times = [(place - step.start) @ AXES[step.axis] for step in (first, second)]
                    lengths = [(step.end - step.start) @ AXES[step.axis] for step in (first, second)]
                    if all(0 <= time <= length for time, length in zip(times, lengths)):
                        found = [(step.trace, step.time + time) for step, time in zip((first, second), times)]
                        if min(found[0][1], found[1][1]) > 1e-9 or found[0][1] != found[1][1]:
                            yield max(found[0][1], found[1][1]), *found
