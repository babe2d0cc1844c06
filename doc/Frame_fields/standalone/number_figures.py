# Copyright (c) 2026 The Frame_fields authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Filter for Doxygen: numbers the figures of a page, as CGAL's own tools do. The argument is the page."""
import pathlib
import re
import sys

text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
names = re.findall(r"^\\cgalFigureBegin{(\w+),", text, re.MULTILINE)
for number, name in enumerate(names, 1):
    text = text.replace(f"\\cgalFigureRef{{{name}}}", f'\\ref fig__{name} "Figure {number}"')
    text = re.sub(rf"^\\cgalFigureBegin{{{name},.*}}$", rf"\g<0> <b>Figure {number}.</b>", text, flags=re.MULTILINE)
print(text, end="")
