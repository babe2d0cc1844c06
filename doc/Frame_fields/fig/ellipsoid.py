# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""An ellipsoid for the figures: an octahedron whose faces are divided evenly, blown up."""
import itertools
import math

from planar_models import Model


def ellipsoid(half_axes, divisions):
    """Vertices 0 to 5 are the ends of the axes: positive and negative x, then y, then z."""
    result, numbers = Model(), {}

    def vertex(corner):
        if corner not in numbers:
            numbers[corner] = len(result.points)
            length = math.hypot(*corner)
            result.points.append(tuple(a * x / length for a, x in zip(half_axes, corner)))
        return numbers[corner]

    for axis, sign in itertools.product(range(3), (1, -1)):
        vertex(tuple(sign * divisions if axis == other else 0 for other in range(3)))
    for signs in itertools.product((1, -1), repeat=3):
        def face(*corners):
            face = [vertex(tuple(s * x for s, x in zip(signs, corner))) for corner in corners]
            result.faces.append(tuple(face if math.prod(signs) > 0 else reversed(face)))

        for i in range(divisions):
            for j in range(divisions - i):
                k = divisions - i - j
                face((i + 1, j, k - 1), (i, j + 1, k - 1), (i, j, k))
                if k > 1:
                    face((i + 1, j + 1, k - 2), (i, j + 1, k - 1), (i + 1, j, k - 1))
    return result
