#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
# Copyright (c) 2026 The Frame_fields authors
"""Compares the fields that cad_frame_field guides by curvature with those of two published methods, on an ellipsoid, a
torus and a bent pipe, whose principal directions and umbilics are known in closed form.

The two methods are written here from their mathematics; no other program is run:
- the globally optimal 4-direction field on vertices (Knoeppel, Crane, Pinkall, Schroeder 2013), as the smallest
  eigenvector of the connection Laplacian, or aligned to the border where there is one, and aligned to curvature by one
  linear system with lambda = 0, whose right side is the square of the Hopf differential of the dihedral angles;
- the power field on faces with principal directions as soft constraints (Diamanti, Vaxman, Panozzo, Sorkine-Hornung
  2014, with one coefficient), of weight 1 everywhere relative to a smoothness of weight 1, each divided by its total
  mass. The directions come from quadrics fitted to the five rings of vertices around each vertex.

NumPy and SciPy are needed."""

import argparse
import pathlib
import subprocess
import tempfile

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg
from scipy.spatial.transform import Rotation

HALF_AXES = np.array([3., 2., 1.])
UMBILIC = np.array([3 * np.sqrt(5 / 8), 0, np.sqrt(3 / 8)])  # the three others are its mirror images
TORUS_RADIUS, PIPE_RADIUS, PIPE_LEG = 3., 1., 4.


# ----------------------------------------------------------------------------------------------------------- surfaces

def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def icosphere(number_of_subdivisions):
    golden = (1 + np.sqrt(5)) / 2
    points = [[s * 1., t * golden, 0.] for s in (-1, 1) for t in (-1, 1)]
    points = np.array([np.roll(p, k) for k in range(3) for p in points])
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    near = np.abs(distances - 2) < 1e-9
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
             if near[i, j] and near[j, k] and near[i, k]]
    points = unit(points)
    faces = np.array([f if np.linalg.det(points[list(f)]) > 0 else f[::-1] for f in faces])
    for _ in range(number_of_subdivisions):
        sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        edges, number = np.unique(sides, axis=0, return_inverse=True)
        middle = (len(points) + number.reshape(3, -1)).T
        points = np.concatenate([points, unit(points[edges].sum(axis=1))])
        corners = [np.stack([faces[:, k], middle[:, k], middle[:, k - 1]], axis=1) for k in range(3)]
        faces = np.concatenate(corners + [middle])
    return points, faces


def jittered_grid(rows, columns, is_closed):
    """Parameters in rows along the first one and around the second one, moved at random so that no direction is that
    of the mesh, and the triangles between them."""
    generator = np.random.default_rng(1)
    number_of_rows = rows if is_closed else rows + 1
    u, v = np.meshgrid(np.arange(number_of_rows), np.arange(columns), indexing="ij")
    shifts = generator.uniform(-0.25, 0.25, (2, *u.shape))
    if not is_closed:
        shifts[0][[0, -1]] = 0
    parameters = np.stack([(u + shifts[0]) / rows, (v + shifts[1]) / columns], axis=2).reshape(-1, 2)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    a, b, c, d = ((i + di) % number_of_rows * columns + (j + dj) % columns
                  for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)))
    is_first = generator.random(len(i)) < 0.5
    faces = np.concatenate([np.stack([a, b, np.where(is_first, c, d)], axis=1),
                            np.stack([np.where(is_first, a, b), c, d], axis=1)])
    return parameters, faces


class Ellipsoid:
    name = "ellipsoid"

    def mesh(self, number_of_subdivisions=4):
        points, faces = icosphere(number_of_subdivisions)
        return points @ Rotation.from_euler("xyz", [20, 50, 110], degrees=True).as_matrix() * HALF_AXES, faces

    def normals(self, points):
        return unit(points / HALF_AXES**2)

    def principal_directions(self, points):
        """The direction of the largest principal curvature."""
        normals = self.normals(points)
        tangent = np.eye(3) - normals[:, :, None] * normals[:, None, :]
        shape = tangent @ np.diag(1 / HALF_AXES**2) @ tangent
        return np.linalg.eigh(shape)[1][:, :, 2]


class Torus:
    name = "torus"

    def mesh(self):
        parameters, faces = jittered_grid(90, 36, True)
        return self.points(parameters), faces

    def points(self, parameters):
        along, around = 2 * np.pi * parameters.T
        distance = TORUS_RADIUS + PIPE_RADIUS * np.cos(around)
        return np.stack([distance * np.cos(along), distance * np.sin(along), PIPE_RADIUS * np.sin(around)], axis=1)

    def principal_directions(self, points):
        return unit(np.stack([-points[:, 1], points[:, 0], 0 * points[:, 0]], axis=1))

    def normals(self, points):
        centers = TORUS_RADIUS * unit(points * [1, 1, 0])
        return unit(points - centers)


class Bent_pipe:
    """Two straight legs and a quarter of a torus between them."""
    name = "bent pipe"
    length = 2 * PIPE_LEG + TORUS_RADIUS * np.pi / 2

    def mesh(self):
        parameters, faces = jittered_grid(72, 36, False)
        along, around = self.length * parameters[:, 0], 2 * np.pi * parameters[:, 1]
        angle = np.clip((along - PIPE_LEG) / TORUS_RADIUS, 0, np.pi / 2)
        outward = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        axis = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], axis=1)
        straight = along - PIPE_LEG - TORUS_RADIUS * angle
        points = (TORUS_RADIUS + PIPE_RADIUS * np.cos(around))[:, None] * outward + straight[:, None] * axis
        points[:, 2] += PIPE_RADIUS * np.sin(around)
        return points, faces

    def angles(self, points):
        return np.clip(np.arctan2(points[:, 1], points[:, 0]), 0, np.pi / 2)

    def principal_directions(self, points):
        angle = self.angles(points)
        return np.stack([-np.sin(angle), np.cos(angle), 0 * angle], axis=1)

    def normals(self, points):
        angle = self.angles(points)
        axis = self.principal_directions(points)
        centers = TORUS_RADIUS * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        offsets = points - centers
        return unit(offsets - (offsets * axis).sum(axis=1, keepdims=True) * axis)


# ------------------------------------------------------------------------------------------------------ triangle mesh

class Mesh:
    """Halfedge 3f + k goes from corner k of face f to corner k + 1."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.source, self.target = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        self.face = np.arange(3 * len(faces)) // 3
        number = {pair: h for h, pair in enumerate(zip(self.source, self.target))}
        self.opposite = np.array([number.get(pair, -1) for pair in zip(self.target, self.source)])
        self.vectors = points[self.target] - points[self.source]
        sides = self.vectors.reshape(-1, 3, 3)
        normals = np.cross(sides[:, 0], sides[:, 1])
        self.area = np.linalg.norm(normals, axis=1) / 2
        self.face_normal = unit(normals)
        # the corner angle at the source of each halfedge
        back = -np.roll(sides, 1, axis=1)
        self.angle = np.arctan2(np.linalg.norm(np.cross(sides, back), axis=2), (sides * back).sum(axis=2)).ravel()
        self.vertex_area = np.bincount(self.faces.ravel(), np.repeat(self.area / 3, 3))
        self.total_angle = np.bincount(self.source, self.angle)
        self.is_border = np.zeros(len(points), bool)
        self.is_border[self.source[self.opposite < 0]] = True
        self.is_border[self.target[self.opposite < 0]] = True

    def centroids(self):
        return self.points[self.faces].mean(axis=1)

    def inner_halfedges(self):
        """One halfedge of each edge with two faces."""
        h = np.arange(len(self.source))
        return h[self.opposite > h]


def next_of(h):
    return h - h % 3 + (h + 1) % 3


def previous_of(h):
    return h - h % 3 + (h + 2) % 3


def field_angles_in_faces(mesh, vectors):
    """The angles of vectors of faces, counted from the first side of the face."""
    x = unit(mesh.vectors[::3])
    y = np.cross(mesh.face_normal, x)
    return np.arctan2((vectors * y).sum(axis=1), (vectors * x).sum(axis=1))


# ------------------------------------------------------------------------------------ the globally optimal vertex field

class Vertex_field:
    """Directions at a vertex are angles between its edges, scaled so that they sum to 2 pi, or pi on the border."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.scale = np.where(mesh.is_border, np.pi, 2 * np.pi) / mesh.total_angle
        self.polar = np.zeros(len(mesh.source))         # per halfedge: its angle at its source
        self.polar_of_opposite = np.zeros(len(mesh.source))  # per halfedge: the angle of the way back at its target
        self.set_polar_angles()

    def set_polar_angles(self):
        mesh = self.mesh
        first = np.full(len(mesh.points), -1)
        first[mesh.source] = np.arange(len(mesh.source))
        on_border = np.flatnonzero(mesh.opposite < 0)
        first[mesh.source[on_border]] = on_border
        for start in first:
            h, angle = start, 0.
            while True:
                self.polar[h] = angle
                angle += mesh.angle[h] * self.scale[mesh.source[h]]
                into = previous_of(h)
                self.polar_of_opposite[into] = angle    # overwritten by zero where the turn is complete
                h = mesh.opposite[into]
                if h < 0 or h == start:
                    break
        inner = mesh.opposite >= 0
        self.polar_of_opposite[inner] = self.polar[mesh.opposite[inner]]

    def transport(self):
        """Per halfedge, what takes z from its target to its source."""
        return np.exp(4j * (self.polar - self.polar_of_opposite))

    def laplacian(self):
        """The connection Laplacian with cotangent weights."""
        mesh, n = self.mesh, len(self.mesh.points)
        weight = 0.5 / np.tan(mesh.angle[previous_of(np.arange(len(mesh.source)))])  # each triangle's half of the edge
        i, j, values = mesh.source, mesh.target, weight * self.transport()
        diagonal = np.bincount(i, weight, n) + np.bincount(j, weight, n)
        off_diagonal = sparse.csr_matrix((values, (i, j)), (n, n))
        return sparse.diags(diagonal) - off_diagonal - off_diagonal.getH()

    def squared_hopf_differential(self):
        mesh, n = self.mesh, len(self.mesh.points)
        h = mesh.inner_halfedges()
        left, right = mesh.face_normal[mesh.face[h]], mesh.face_normal[mesh.face[mesh.opposite[h]]]
        length = np.linalg.norm(mesh.vectors[h], axis=1)
        bend = np.arctan2((np.cross(right, left) * mesh.vectors[h]).sum(axis=1) / length, (left * right).sum(axis=1))
        result = np.zeros(n, complex)
        np.add.at(result, mesh.source[h], bend * length * np.exp(2j * self.polar[h]))
        np.add.at(result, mesh.target[h], bend * length * np.exp(2j * self.polar_of_opposite[h]))
        return (result / (4 * mesh.vertex_area))**2

    def smoothest(self):
        matrix, mass = self.laplacian().tocsc(), self.mesh.vertex_area
        if self.mesh.is_border.any():
            return self.aligned_to_border()
        solve = linalg.splu(matrix + 1e-8 * sparse.diags(mass).tocsc()).solve
        z = np.random.default_rng(1).standard_normal(len(mass)) + 0j
        for _ in range(200):
            z = solve(mass * z)
            z /= np.sqrt((mass * np.abs(z)**2).sum())
        return z

    def aligned_to_curvature(self):
        return linalg.spsolve(self.laplacian().tocsc(), self.mesh.vertex_area * self.squared_hopf_differential())

    def aligned_to_border(self):
        """The first halfedge of each border vertex has the angle 0, so z = 1 there."""
        inside, border = ~self.mesh.is_border, self.mesh.is_border
        matrix = self.laplacian().tocsr()
        right_side = -matrix[inside][:, border] @ np.ones(border.sum())
        z = np.ones(len(inside), complex)
        z[inside] = linalg.spsolve(matrix[inside][:, inside].tocsc(), right_side)
        return z

    def singularities(self, z):
        """Places and indices (times 4) of the faces around which z turns."""
        mesh = self.mesh
        turns = np.angle(z[mesh.target] * self.transport() / z[mesh.source]).reshape(-1, 3).sum(axis=1)
        excess = (mesh.angle * self.scale[mesh.source]).reshape(-1, 3).sum(axis=1) - np.pi
        index = np.rint((turns + 4 * excess) / (2 * np.pi)).astype(int)
        return mesh.centroids()[index != 0], index[index != 0]

    def vectors(self, z):
        """One branch at each vertex, in the plane of the face it points into."""
        mesh = self.mesh
        best = np.full(len(mesh.points), np.inf)
        result = np.zeros_like(mesh.points)
        angle = np.angle(z) / 4
        for k in range(4):
            offset = (angle + k * np.pi / 2)[mesh.source] - self.polar
            offset = np.mod(offset, 2 * np.pi) / self.scale[mesh.source]
            x = unit(mesh.vectors)
            y = np.cross(mesh.face_normal[mesh.face], x)
            inside = np.flatnonzero(offset <= mesh.angle + 1e-12)
            for h in inside:
                if offset[h] < best[mesh.source[h]]:
                    best[mesh.source[h]] = offset[h]
                    result[mesh.source[h]] = np.cos(offset[h]) * x[h] + np.sin(offset[h]) * y[h]
        return result


# --------------------------------------------------------------------------------------------- the power field on faces

def neighbors_in_rings(mesh, number_of_rings):
    n = len(mesh.points)
    adjacency = sparse.csr_matrix((np.ones(len(mesh.source)), (mesh.source, mesh.target)), (n, n))
    adjacency = adjacency + adjacency.T + sparse.identity(n)
    reach = adjacency
    for _ in range(number_of_rings - 1):
        reach = reach @ adjacency
    reach = reach.tocsr()
    return [reach.indices[reach.indptr[v]:reach.indptr[v + 1]] for v in range(n)]


def fitted_shape_operators(mesh, number_of_rings=5):
    """The shape operator at each vertex, as a matrix of space, of a quadric fitted to the vertices around it."""
    normals = unit(sum(np.stack([np.bincount(mesh.faces[:, k], (mesh.area[:, None] * mesh.face_normal)[:, c],
                                             len(mesh.points)) for c in range(3)], axis=1) for k in range(3)))
    result = np.zeros((len(mesh.points), 3, 3))
    for v, neighbors in enumerate(neighbors_in_rings(mesh, number_of_rings)):
        normal = normals[v]
        x = unit(np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))]))
        frame = np.stack([x, np.cross(normal, x), normal])
        p, q, height = ((mesh.points[neighbors] - mesh.points[v]) @ frame.T).T
        a, b, c, d, e = np.linalg.lstsq(np.stack([p * p / 2, p * q, q * q / 2, p, q], axis=1), height, rcond=None)[0]
        metric = np.array([[1 + d * d, d * e], [d * e, 1 + e * e]])
        operator = np.linalg.solve(metric, np.array([[a, b], [b, c]])) / np.sqrt(1 + d * d + e * e)
        tangents = np.array([[1, 0, d], [0, 1, e]]) @ frame
        result[v] = tangents.T @ operator @ np.linalg.pinv(tangents.T)
    return result


def fitted_principal_directions(mesh):
    """On faces: of the mean of the shape operators of their corners, projected."""
    shape = fitted_shape_operators(mesh)[mesh.faces].mean(axis=1)
    x = unit(mesh.vectors[::3])
    basis = np.stack([x, np.cross(mesh.face_normal, x)], axis=1)
    projected = basis @ shape @ basis.transpose(0, 2, 1)
    directions = np.linalg.eigh((projected + projected.transpose(0, 2, 1)) / 2)[1][:, :, 1]
    return np.arctan2(directions[:, 1], directions[:, 0])


class Face_field:
    def __init__(self, mesh):
        self.mesh = mesh
        self.edges = mesh.inner_halfedges()
        self.left, self.right = mesh.face[self.edges], mesh.face[mesh.opposite[self.edges]]
        vectors = mesh.vectors[self.edges]
        x = unit(mesh.vectors[::3])
        y = np.cross(mesh.face_normal, x)

        def angle_in(f):
            return np.arctan2((vectors * y[f]).sum(axis=1), (vectors * x[f]).sum(axis=1))

        self.transport = np.exp(4j * (angle_in(self.right) - angle_in(self.left)))  # takes z from left to right

    def softly_aligned(self, directions, weight=1.):
        mesh, n, m = self.mesh, len(self.mesh.faces), len(self.edges)
        edge_mass = (mesh.vectors[self.edges]**2).sum(axis=1) * 3 / (mesh.area[self.left] + mesh.area[self.right])
        rows = np.arange(m)
        places = np.concatenate([rows, rows]), np.concatenate([self.left, self.right])
        difference = sparse.csr_matrix((np.concatenate([self.transport, -np.ones(m)]), places), (m, n))
        smoothness = difference.getH() @ sparse.diags(edge_mass / edge_mass.sum()) @ difference
        alignment = weight * mesh.area / mesh.area.sum()
        return linalg.spsolve((smoothness + sparse.diags(alignment)).tocsc(), alignment * np.exp(4j * directions))

    def singularities(self, z):
        """Places and indices (times 4) of the inner vertices around which z turns."""
        mesh, n = self.mesh, len(self.mesh.points)
        to_left = np.angle(z[self.left] * self.transport / z[self.right])  # counter-clockwise about the source
        turns = np.bincount(mesh.source[self.edges], to_left, n) - np.bincount(mesh.target[self.edges], to_left, n)
        index = np.rint((turns + 4 * (2 * np.pi - mesh.total_angle)) / (2 * np.pi)).astype(int)
        index[mesh.is_border] = 0
        return mesh.points[index != 0], index[index != 0]

    def vectors(self, z):
        x = unit(self.mesh.vectors[::3])
        angle = np.angle(z)[:, None] / 4
        return np.cos(angle) * x + np.sin(angle) * np.cross(self.mesh.face_normal, x)


# ----------------------------------------------------------------------------------------------------- cad_frame_field

def read_ascii_ply(path):
    """The properties of each element, as arrays; those of lists as one."""
    lines = path.read_text(encoding="ascii").split("\n")
    elements, k = {}, 0
    while lines[k] != "end_header":
        words = lines[k].split()
        if words[0] == "element":
            elements[words[1]] = (int(words[2]), [])
            names = elements[words[1]][1]
        elif words[0] == "property":
            names += ["size", 0, 1, 2] if words[1] == "list" else [words[-1]]
        k += 1
    result, k = {}, k + 1
    for element, (count, names) in elements.items():
        table = np.array([line.split() for line in lines[k:k + count]], float)
        result[element] = dict(zip(names, table.T))
        k += count
    return result


def run_program(program, mesh, weight):
    """Places and indices of the singularities, and the two branches and the centroid of each face."""
    with tempfile.TemporaryDirectory() as folder:
        model, output = pathlib.Path(folder) / "model.off", pathlib.Path(folder) / "field.ply"
        with open(model, "w", encoding="ascii") as file:
            file.write("OFF\n%d %d 0\n" % (len(mesh.points), len(mesh.faces)))
            np.savetxt(file, mesh.points, "%.17g")
            np.savetxt(file, np.insert(mesh.faces, 0, 3, axis=1), "%d")
        subprocess.run([program, model, "--feature-angle", "180", "--curvature-weight", str(weight), "--no-baseline",
                        "--quiet", "--ascii", "-o", output], check=True)
        ply = read_ascii_ply(output)
    points = np.stack([ply["vertex"][c] for c in "xyz"], axis=1)
    corners = np.stack([ply["face"][k] for k in range(3)], axis=1).astype(int)
    branches = [np.stack([ply["face"][branch + c] for c in "xyz"], axis=1) for branch in "uv"]
    index = np.zeros(len(points), int)
    index[ply["halfedge"]["target"].astype(int)] = ply["halfedge"]["index"].astype(int)
    return (points[index != 0], index[index != 0]), branches, points[corners].mean(axis=1)


# ---------------------------------------------------------------------------------------------------------- comparison

def deviations(surface, places, vectors):
    """The angle in degrees between a branch, projected to the tangent plane, and the nearest principal direction."""
    normals = surface.normals(places)
    vectors = unit(vectors - (vectors * normals).sum(axis=1, keepdims=True) * normals)
    directions = surface.principal_directions(places)
    directions = unit(directions - (directions * normals).sum(axis=1, keepdims=True) * normals)
    angle = np.arctan2((np.cross(directions, vectors) * normals).sum(axis=1), (directions * vectors).sum(axis=1))
    return np.degrees(np.abs(angle - np.rint(angle / (np.pi / 2)) * np.pi / 2))


def row(surface, name, singularities, angles):
    places, indices = singularities
    counts = ", ".join("%d of %d/4" % ((indices == i).sum(), i) for i in np.unique(indices)) or "none"
    distance = "-"
    if isinstance(surface, Ellipsoid) and len(places):
        distances = np.linalg.norm(np.abs(places) - UMBILIC, axis=1)
        distance = "%.2f, %.2f" % (distances.mean(), distances.max())
    return [surface.name, name, counts, distance, "%.2f, %.2f" % (angles.mean(), np.percentile(angles, 95))]


def rows_of(surface, program, weights):
    mesh = Mesh(*surface.mesh())
    vertex_field, face_field = Vertex_field(mesh), Face_field(mesh)
    for name, z in (("on vertices, smoothest", vertex_field.smoothest()),
                    ("on vertices, aligned to curvature", vertex_field.aligned_to_curvature())):
        yield row(surface, name, vertex_field.singularities(z),
                  deviations(surface, mesh.points, vertex_field.vectors(z)))
    z = face_field.softly_aligned(fitted_principal_directions(mesh))
    yield row(surface, "on faces, softly aligned", face_field.singularities(z),
              deviations(surface, mesh.centroids(), face_field.vectors(z)))
    for weight in weights:
        singularities, branches, centroids = run_program(program, mesh, weight)
        angles = np.mean([deviations(surface, centroids, b) for b in branches], axis=0)
        yield row(surface, "`--curvature-weight %g`" % weight, singularities, angles)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program cad_frame_field")
    parser.add_argument("--weights", nargs="+", type=float, default=[0, 0.01, 0.1, 1], metavar="WEIGHT")
    arguments = parser.parse_args()
    print("| surface | field | singularities | distance from umbilics: mean, largest | angle to principal directions "
          "in degrees: mean, 95 % |\n|---|---|---|---|---|")
    for surface in (Ellipsoid(), Torus(), Bent_pipe()):
        for line in rows_of(surface, arguments.program, arguments.weights):
            print("| " + " | ".join(line) + " |", flush=True)


if __name__ == "__main__":
    main()
