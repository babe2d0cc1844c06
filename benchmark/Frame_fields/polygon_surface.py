# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The connectivity of a polygon mesh, and the sectors around its vertices."""

import dataclasses
import functools
import math

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components


def number_of_components(pairs, size):
    """Of the graph of `size` vertices with these edges."""
    rows, columns = np.array(pairs, dtype=int).reshape(-1, 2).T
    return int(connected_components(coo_matrix((np.ones(len(rows)), (rows, columns)), (size, size)), False)[0])


def angle_between(a, b):
    """In degrees."""
    (ax, ay, az), (bx, by, bz) = a, b
    cross = math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    return math.degrees(math.atan2(cross, ax * bx + ay * by + az * bz))


@dataclasses.dataclass
class Sector:
    """Faces that follow one another around a vertex, between the edges to the first and to the last neighbour; a
    sector that nothing bounds has no such neighbours."""
    faces: list
    first: int | None
    last: int | None
    degrees: float


@dataclasses.dataclass
class Fan:
    """Faces around a vertex and the other ends of the edges between them; an open one has one more end than faces."""
    faces: list
    ends: list
    is_closed: bool


class Surface:
    """Polygons given by the numbers of their vertices."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.faces_of_edge, self.runs = {}, {}
        self.faces_around = [[] for _ in points]
        for number, face in enumerate(faces):
            for a, b in zip(face, face[1:] + face[:1]):
                self.faces_of_edge.setdefault((min(a, b), max(a, b)), []).append(number)
                self.runs[a, b] = self.runs.get((a, b), 0) + 1
            for vertex in set(face):
                self.faces_around[vertex].append(number)
        self.vertices = [vertex for vertex, around in enumerate(self.faces_around) if around]
        self.edges = np.array([edge for edge in self.faces_of_edge if edge[0] != edge[1]], dtype=int).reshape(-1, 2)
        self.lengths = np.linalg.norm(points[self.edges[:, 0]] - points[self.edges[:, 1]], axis=1)

    @functools.cached_property
    def border(self):
        return {edge for edge, faces in self.faces_of_edge.items() if len(faces) == 1}

    def non_manifold_edges(self):
        return sum(len(faces) > 2 for faces in self.faces_of_edge.values())

    def misoriented_edges(self):
        """Edges through which two faces run in the same direction."""
        return sum(len(faces) == 2 and 2 in (self.runs.get((a, b)), self.runs.get((b, a)))
                   for (a, b), faces in self.faces_of_edge.items())

    def non_manifold_vertices(self):
        fans = (self.fans(vertex) for vertex in self.vertices)
        return sum(fan is None or len(fan) > 1 for fan in fans)

    def euler_characteristic(self):
        return len(self.vertices) - len(self.faces_of_edge) + len(self.faces)

    def components(self):
        pairs = [(faces[0], other) for faces in self.faces_of_edge.values() for other in faces[1:]]
        return number_of_components(pairs, len(self.faces))

    def border_loops(self):
        number_of = {vertex: number for number, vertex in enumerate(sorted({v for edge in self.border for v in edge}))}
        return number_of_components([(number_of[a], number_of[b]) for a, b in self.border], len(number_of)) \
            if self.border else 0

    def fans(self, vertex):
        """The fans of faces around a vertex, or None where the faces do not make fans."""
        following, face_behind, has_previous = {}, {}, set()
        for number in self.faces_around[vertex]:
            face = self.faces[number]
            place = face.index(vertex)
            out_of, into = face[(place + 1) % len(face)], face[place - 1]
            if len(face) < 3 or face.count(vertex) > 1 or out_of in following or into in has_previous:
                return None
            following[out_of], face_behind[out_of] = into, number
            has_previous.add(into)
        fans = []
        while following:
            open_starts = [end for end in following if end not in has_previous]
            end = (open_starts or list(following))[0]
            fan = Fan([], [end], not open_starts)
            while end in following:
                fan.faces.append(face_behind[end])
                end = following.pop(end)
                fan.ends.append(end)
            if fan.is_closed:
                fan.ends.pop()
            fans.append(fan)
        return fans

    def sectors(self, vertex, marked):
        """The sectors of a vertex between marked edges (pairs of a smaller and a larger number) and the border, or
        None where the faces do not make fans."""
        fans = self.fans(vertex)
        return None if fans is None else [sector for fan in fans for sector in self.sectors_of_fan(vertex, fan, marked)]

    def sectors_of_fan(self, vertex, fan, marked):
        count = len(fan.ends)
        cuts = [place for place, end in enumerate(fan.ends) if (min(vertex, end), max(vertex, end)) in marked
                or (not fan.is_closed and place in (0, count - 1))]
        if not cuts:
            return [Sector(fan.faces, None, None, 360.0)]
        directions = [self.points[end] - self.points[vertex] for end in fan.ends]
        degrees = [angle_between(directions[k], directions[(k + 1) % count]) for k in range(len(fan.faces))]
        stops = cuts[1:] + [cuts[0] + count] if fan.is_closed else cuts[1:]
        result = []
        for start, stop in zip(cuts, stops):
            places = [place % count for place in range(start, stop)]
            result.append(Sector([fan.faces[place] for place in places], fan.ends[start], fan.ends[stop % count],
                                 sum(degrees[place] for place in places)))
        return result
