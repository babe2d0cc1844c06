# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Filter for Doxygen: numbers the figures through all pages of the manual, in the order in which
the main page lists the pages. The argument is the page."""
import pathlib
import re
import sys

PAGES = ["Frame_fields.txt", "Quad_meshes.txt", "Method.txt", "Programs.txt", "Performance.txt"]

page = pathlib.Path(sys.argv[1])
names = [name for other in PAGES for name in re.findall(
    r"^\\cgalFigureBegin{(\w+),", (page.parent / other).read_text(encoding="utf-8"), re.MULTILINE)]
text = page.read_text(encoding="utf-8")
for number, name in enumerate(names, 1):
    text = text.replace(f"\\cgalFigureRef{{{name}}}", f'\\ref fig__{name} "Figure {number}"')
    text = re.sub(rf"^\\cgalFigureBegin{{{name},.*}}$", rf"\g<0> <b>Figure {number}.</b>", text, flags=re.MULTILINE)
print(text, end="")
