#!/usr/bin/env python3
"""Writes the corpus that the fuzzer of the readers starts from: a small model in each form of each format, after a byte
that selects the format.

usage: make_reader_corpus.py FOLDER
"""
import base64
import pathlib
import struct
import sys
import zlib

FORMATS = {name: bytes([number]) for number, name in enumerate(("off", "obj", "ply", "stl", "ts", "vtp"))}
POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0.5), (0, 1, -2e-3), (0.25, 0.5, 7)]
POLYGONS = [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
TRIANGLES = [(0, 2, 1), (0, 3, 2)] + POLYGONS[1:]
COUNTS = f"{len(POINTS)} {len(POLYGONS)} 0\n"


def lines(rows, start="", end="\n"):
    return "".join(start + " ".join(map(str, row)) + end for row in rows)


def counted(polygons, end="\n"):
    return lines(((len(polygon), *polygon) for polygon in polygons), end=end)


def off_files():
    yield "plain", "OFF\n" + COUNTS + lines(POINTS) + counted(POLYGONS)
    yield "colors", "COFF\n" + COUNTS + lines(POINTS, end=" 255 0 0\n") + counted(POLYGONS, " 0.5 0.5 1\n")
    yield "all", ("STCN4OFF # a comment\n" + COUNTS + lines(POINTS, end=" 2 0 0 1 1 0 0 1 0.5 0.5\n")
                  + counted(POLYGONS))
    yield "flow", "nOFF 3 " + COUNTS + lines(POINTS, end=" ") + "\n" + counted(POLYGONS).replace(" ", "\n")
    yield "headless", COUNTS + lines(POINTS, end=" 1 2\n") + counted(POLYGONS)
    for name, after_points, after_polygon in (("binary", b"", struct.pack(">i", 0)),
                                              ("binary_colors", struct.pack(">4f", 1, 0, 0, 1),
                                               struct.pack(">i3f", 3, 1, 1, 0))):
        yield name, ((b"COFF" if after_points else b"OFF") + b" BINARY\n"
                     + struct.pack(">3i", len(POINTS), len(POLYGONS), 0)
                     + b"".join(struct.pack(">3f", *point) + after_points for point in POINTS)
                     + b"".join(struct.pack(f">{1 + len(polygon)}i", len(polygon), *polygon) + after_polygon
                                for polygon in POLYGONS))


def obj_files():
    from_1 = [tuple(vertex + 1 for vertex in polygon) for polygon in POLYGONS]
    yield "plain", lines(POINTS, "v ") + lines(from_1, "f ")
    yield "rich", ("\ufeff# made by hand\nmtllib a.mtl\no thing\n" + lines(POINTS, "v ", " 1 0 0\r\n")
                   + "vn 0 0 1\nvt 0 0\ng a b\nusemtl m\ns off\n"
                   + lines([[f"{vertex}/1/1" for vertex in polygon] for polygon in from_1], "f ")
                   + "f -5//1 -4/1 \\\n -1\nl 1 2 \\\n 3\np 1\ncurv 0 1 1 2\nsm 3 4\n")


def ply_files():
    def header(form, vertex="property double x\nproperty double y\nproperty double z\n", types="uchar int", more=""):
        return (f"ply\nformat {form} 1.0\ncomment nothing\nelement vertex {len(POINTS)}\n{vertex}"
                f"element face {len(POLYGONS)}\nproperty list {types} vertex_indices\n{more}end_header\n")

    edges = "property uchar kind\nelement edge 1\nproperty int vertex1\nproperty list char float weights\n"
    yield "plain", header("ascii") + lines(POINTS) + counted(POLYGONS)
    yield "flow", header("ascii") + lines(POINTS, end=" ") + "\n" + counted(POLYGONS, " ")
    yield "edges", header("ascii", more=edges) + lines(POINTS) + counted(POLYGONS, " 7\n") + "3 2 0.5 1\n"
    yield "binary", header("binary_little_endian").encode() + b"".join(
        struct.pack("<3d", *point) for point in POINTS) + b"".join(
        struct.pack(f"<B{len(polygon)}i", len(polygon), *polygon) for polygon in POLYGONS)
    yield "big_endian", header("binary_big_endian", "property uchar red\nproperty float z\nproperty short y\n"
                               "property int64 x\n", "int ushort", edges).encode() + b"".join(
        struct.pack(">Bfhq", 9, *map(int, point)) for point in POINTS) + b"".join(
        struct.pack(f">i{len(polygon)}HB", len(polygon), *polygon, 7) for polygon in POLYGONS) + struct.pack(
        ">ib2f", 3, 2, 0.5, 1)


def stl_files():
    facets = "".join("facet normal 0 0 1\nouter loop\n" + lines((POINTS[vertex] for vertex in triangle), "vertex ")
                     + "endloop\nendfacet\n" for triangle in TRIANGLES)
    yield "plain", "solid facet\n" + facets + "endsolid facet\n"
    yield "two", ("\ufeff# a comment\r\nSOLID\n" + facets + "endsolid\nsolid 2\ncolor 1 0 0\n" + facets
                  + "endsolid 2\n")
    yield "binary", (b"solid" + bytes(75) + struct.pack("<I", len(TRIANGLES)) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *(x for vertex in triangle for x in POINTS[vertex]), 0)
        for triangle in TRIANGLES))


def ts_files():
    body = ("TFACE\n" + lines(((number + 1, *point) for number, point in enumerate(POINTS)), "VRTX ")
            + "ATOM 9 2\n" + lines(([vertex + 1 for vertex in triangle] for triangle in TRIANGLES), "TRGL ")
            + "TRGL 9 1 3\nBSTONE 1\nEND\n")
    yield "plain", "GOCAD TSurf 1\nHEADER {\nname:surface\n}\n" + body
    yield "two", ("GOCAD TSurf 1\n" + body) * 2


def vtp_files():
    points = struct.pack("<15f", *(x for point in POINTS for x in point))
    vertices = struct.pack("<16B", *(vertex for polygon in POLYGONS for vertex in polygon))
    strip, ends, end = struct.pack("<4q", 0, 1, 2, 3), struct.pack("<5i", 4, 7, 10, 13, 16), struct.pack("<q", 4)
    for name, form, encoding, compressor in (("raw", "appended", "raw", ""), ("base64", "appended", "base64", ""),
                                             ("inline", "binary", "", ""),
                                             ("zlib", "appended", "raw", "vtkZLibDataCompressor")):
        appended = b""

        def array(attributes, content):
            nonlocal appended
            if compressor:
                packed = zlib.compress(content)
                content = struct.pack("<4I", 1, len(content), 0, len(packed)) + packed
            else:
                content = struct.pack("<I", len(content)) + content
            if encoding != "raw":
                content = base64.b64encode(content)
            start = f'<DataArray {attributes} format="{form}"'.encode()
            if form == "binary":
                return start + b">" + content + b"</DataArray>"
            appended += content
            return start + f' offset="{len(appended) - len(content)}"/>'.encode()

        text = (f'<VTKFile type="PolyData" byte_order="LittleEndian" compressor="{compressor}"><PolyData>'
                f'<Piece NumberOfPoints="5" NumberOfPolys="5" NumberOfStrips="1">').encode()
        text += b"<Points>" + array('type="Float32" NumberOfComponents="3"', points) + b"</Points><Polys>"
        text += array('type="UInt8" Name="connectivity"', vertices) + array('type="Int32" Name="offsets"', ends)
        text += b"</Polys><Strips>" + array('type="Int64" Name="connectivity"', strip)
        text += array('type="Int64" Name="offsets"', end) + b"</Strips></Piece></PolyData>"
        yield name, text.replace(b' compressor=""', b"") + (
            f'<AppendedData encoding="{encoding}">_'.encode() + appended + b"</AppendedData>" if appended else b""
        ) + b"</VTKFile>"
    yield "ascii", ("<?xml version='1.0'?><VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='5' "
                    "NumberOfPolys='5'><Points><DataArray type='Float64' NumberOfComponents='3'>\n" + lines(POINTS)
                    + "</DataArray></Points><Polys><DataArray type='Int32' Name='connectivity'>\n" + lines(POLYGONS)
                    + "</DataArray><DataArray type='Int32' Name='offsets'>4 7 10 13 16</DataArray></Polys></Piece>"
                    "</PolyData></VTKFile>\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for kind, files in (("off", off_files), ("obj", obj_files), ("ply", ply_files), ("stl", stl_files),
                        ("ts", ts_files), ("vtp", vtp_files)):
        for name, content in files():
            content = content if isinstance(content, bytes) else content.encode()
            (folder / f"{kind}_{name}").write_bytes(FORMATS[kind] + content)


if __name__ == "__main__":
    main()
