# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Plane models for the figures, meshed in rows of points of nearly even distance."""
import math


class Model:
    """Rows of points; two rows that follow one another are joined by triangles."""

    def __init__(self):
        self.points, self.faces, self.features, self.last = [], [], [], []

    def add_row(self, points, is_closed=False):
        row = list(range(len(self.points), len(self.points) + len(points)))
        self.points += points
        if is_closed:
            row.append(row[0])
        if self.last:
            self.join(self.last, row)
        self.last = row

    def join(self, lower, upper):
        i = j = 0
        while i + 1 < len(lower) or j + 1 < len(upper):
            steps_up = i + 1 == len(lower) or (j + 1 < len(upper) and
                                               (j + 0.5) * (len(lower) - 1) <= (i + 0.5) * (len(upper) - 1))
            self.faces.append((lower[i], upper[j], upper[j + 1]) if steps_up else (lower[i], upper[j], lower[i + 1]))
            i, j = (i, j + 1) if steps_up else (i + 1, j)

    def write(self, path):
        with open(path, "w", encoding="ascii") as file:
            file.write("OFF\n%d %d 0\n" % (len(self.points), len(self.faces)))
            file.writelines("%.17g %.17g %.17g\n" % (*p, 0)[:3] for p in self.points)
            file.writelines("3 %d %d %d\n" % f for f in self.faces)


def sector(degrees, rings):
    """A sector of the unit circle. One of 360 degrees is a disk with a slit: the feature edges from its centre."""
    angle, result = math.radians(degrees), Model()
    result.add_row([(0.0, 0.0)])
    for i in range(1, rings + 1):
        count = max(1, round(angle * i)) + (1 if i == 1 else 0)
        turns = [angle * k / count for k in range(count + 1)]
        row = [(i / rings * math.cos(turn), i / rings * math.sin(turn)) for turn in turns]
        if degrees == 360:
            result.features.append((result.last[0], len(result.points)))
            row.pop()
        result.add_row(row, degrees == 360)
    return result


def polygon(corners, rings):
    """A regular polygon around the origin, which is vertex 0; with two corners, a lens of two arcs."""
    def radius(angle):
        turn = 2 * math.pi / corners
        if corners == 2:
            return math.sqrt(1 + math.sin(angle) ** 2 / 3) - abs(math.sin(angle)) / math.sqrt(3)
        return math.cos(turn / 2) / math.cos(angle % turn - turn / 2)
    result = Model()
    result.add_row([(0.0, 0.0)])
    for i in range(1, rings + 1):
        count = corners * max(1, round(6 * i / corners))
        angles = [2 * math.pi * k / count for k in range(count)]
        lengths = [i / rings * radius(a) for a in angles]
        result.add_row([(r * math.cos(a), r * math.sin(a)) for r, a in zip(lengths, angles)], True)
    return result


def strip(places, low, high, size):
    """The points between the curves y = low(x) and y = high(x) that meet at the first and the last place."""
    result = Model()
    result.add_row([(places[0], low(places[0]))])
    for x in places[1:-1]:
        count = max(1, round((high(x) - low(x)) / size))
        result.add_row([(x, low(x) + (high(x) - low(x)) * k / count) for k in range(count, -1, -1)])
    result.add_row([(places[-1], low(places[-1]))])
    return result


def crescent(degrees, rows):
    """A moon between two circles that meet at this angle at (-1, 0) and (1, 0); it tapers to two tips."""
    def arc(slope):  # the circle through both points with this angle to the x axis at them
        radius = 1 / math.sin(slope)
        return lambda x: math.sqrt(radius ** 2 - x ** 2) - radius * math.cos(slope)
    outer = math.radians(62)
    places = [-math.cos(math.pi * k / rows) for k in range(rows + 1)]
    return strip(places, arc(outer - math.radians(degrees)), arc(outer), 1.6 / rows)


def astroid(rows):
    """Four cusps: |x|^(2/3) + |y|^(2/3) = 1."""
    def height(x):
        return max(0.0, 1 - abs(x) ** (2 / 3)) ** 1.5
    def place(t):  # dense at the cusps
        return math.copysign(math.sin(math.pi / 2 * abs(t)) ** 3, t)
    return strip([place(2 * k / rows - 1) for k in range(rows + 1)], lambda x: -height(x), height, 2.2 / rows)
