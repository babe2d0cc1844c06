#!/usr/bin/python3
"""Computes a frame field on a STEP solid: its CAD curves are the feature edges of the mesh that gmsh makes of it.

Arguments after -- go to cad_frame_field."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import gmsh


def mesh_surfaces(path, size):
    """Meshes the surfaces of a CAD file with triangles of about a size, or of gmsh's choice."""
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.occ.importShapes(str(path))
    gmsh.model.occ.synchronize()
    if size is not None:
        gmsh.option.setNumber("Mesh.MeshSizeMin", size)
        gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", 24)  # elements for a full turn
    gmsh.model.mesh.generate(2)


def elements(dimension, tag, number_of_nodes):
    _, _, nodes = gmsh.model.mesh.getElements(dimension, tag)
    nodes = [node for nodes_of_type in nodes for node in nodes_of_type]
    return [tuple(nodes[i:i + number_of_nodes]) for i in range(0, len(nodes), number_of_nodes)]


def triangles():
    """The triangles of all surfaces, oriented as the boundaries of their volumes have it."""
    result = []
    orientation = {abs(tag): 1 if tag > 0 else -1
                   for volume in gmsh.model.getEntities(3) for _, tag in gmsh.model.getBoundary([volume])}
    for dimension, tag in gmsh.model.getEntities(2):
        result += [triangle[::orientation.get(tag, 1)] for triangle in elements(dimension, tag, 3)]
    return result


def curve_edges():
    """The edges on CAD curves but seams, which have the same surface on both sides."""
    result = []
    for dimension, tag in gmsh.model.getEntities(1):
        surfaces, _ = gmsh.model.getAdjacencies(dimension, tag)
        is_seam = len(surfaces) == 1 and is_inside(tag, surfaces[0])
        if len(surfaces) > 0 and not is_seam:
            result += elements(dimension, tag, 2)
    return result


def is_inside(curve, surface):
    """Whether triangles of the surface are on both sides of the curve."""
    edges = {frozenset(edge) for edge in elements(1, curve, 2)}
    sides = [frozenset((t[k - 1], t[k])) for t in elements(2, surface, 3) for k in range(3)]
    return sum(side in edges for side in sides) == 2 * len(edges)


def write_model(mesh_path, feature_path):
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    faces = triangles()
    position = {tag: coordinates[3 * i:3 * i + 3] for i, tag in enumerate(tags)}
    number = {tag: i for i, tag in enumerate(sorted({node for face in faces for node in face}))}
    with open(mesh_path, "w") as file:
        file.write(f"OFF\n{len(number)} {len(faces)} 0\n")
        file.writelines("%r %r %r\n" % tuple(map(float, position[tag])) for tag in number)
        file.writelines("3 %d %d %d\n" % tuple(number[node] for node in face) for face in faces)
    with open(feature_path, "w") as file:
        file.writelines("%d %d\n" % (number[a], number[b]) for a, b in curve_edges())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", type=pathlib.Path, help="a STEP, IGES or BREP file")
    parser.add_argument("--program", default="cad_frame_field", help="the program, if it is not in the path")
    parser.add_argument("--size", type=float, help="the length of the edges of the mesh")
    parser.add_argument("--mesh", type=pathlib.Path, help="keep the mesh under this name, as OFF")
    parser.add_argument("--features", type=pathlib.Path, help="keep the feature edges under this name, as vertex pairs")
    own, options = sys.argv[1:], []
    if "--" in own:
        own, options = own[:own.index("--")], own[own.index("--") + 1:]
    arguments = parser.parse_args(own)

    gmsh.initialize()
    with tempfile.TemporaryDirectory() as folder:
        mesh = arguments.mesh or pathlib.Path(folder, arguments.step.stem + ".off")
        features = arguments.features or pathlib.Path(folder, arguments.step.stem + ".feat")
        try:
            mesh_surfaces(arguments.step, arguments.size)
            write_model(mesh, features)
        except Exception as error:  # gmsh raises nothing more special
            print(f"{arguments.step}: gmsh cannot mesh it: {error}", file=sys.stderr)
            return 2
        return subprocess.run([arguments.program, mesh, "--features", features, *options]).returncode


if __name__ == "__main__":
    sys.exit(main())
