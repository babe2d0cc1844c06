#!/usr/bin/env python3
"""check_tested_table.py MANUAL REPORT...: makes a table of mesh types and kernels by combinations from the JSON
reports of test_mesh_matrix, prints it, and fails if it is not what the manual has."""

import collections
import json
import re
import sys


def combination_of(report):
    return f"\\cgal {report['cgal']}<br>Eigen {report['eigen']}<br>{report['compiler']}<br>{report['standard']}"


def results_of(report):
    """The number of tests that passed of each type, and what they say of themselves in their names: mesh and kernel."""
    passed = collections.Counter()
    for suite in report["testsuites"]:
        for test in suite["testsuite"]:
            mesh_and_kernel = re.fullmatch(r".*/(\w+)_of_(\w+)", suite["name"])
            if mesh_and_kernel and test["result"] == "COMPLETED" and "failures" not in test:
                passed[mesh_and_kernel.groups()] += 1
    return passed


def mesh_text(mesh):
    class_name, _, rest = mesh.partition("_with_")
    return f"`{class_name.replace('OpenMesh_', 'OpenMesh::')}`" + (f" with {rest}" if rest else "")


def row(cell, texts):
    return "<tr>" + "".join(f"<{cell}>{text}</{cell}>" for text in texts) + "</tr>"


def table(reports):
    results = {combination_of(report): results_of(report) for report in reports}
    types = sorted({mesh_and_kernel for result in results.values() for mesh_and_kernel in result})
    lines = [row("th", ["mesh", "points", *sorted(results)])]
    for mesh, kernel in types:
        names = [mesh_text(mesh), kernel.replace("_", " ")]
        lines.append(row("td", [*names, *(results[c][mesh, kernel] for c in sorted(results))]))
    return "\n".join(["<table>", *lines, "</table>", ""])


def main():
    manual_file, *report_files = sys.argv[1:]
    reports = []
    for report_file in report_files:
        with open(report_file, encoding="utf-8") as file:
            reports.append(json.load(file))
    with open(manual_file, encoding="utf-8") as file:
        manual = file.read()
    tested = table(reports)
    print(tested, end="")
    if tested not in manual:
        sys.exit(f"{manual_file} does not have the table of what was tested:\n{tested}")


main()
