#!/usr/bin/env python3
"""Turns the figures of study_mesh_dependence into tables and a plot.

    plot_mesh_dependence.py CSV_FILE [FOLDER]

writes mesh_dependence.md, mesh_dependence.svg and mesh_dependence.png into FOLDER, by default that of CSV_FILE.
Matplotlib is needed.
"""
import csv
import math
import os
import sys
from collections import defaultdict
from statistics import mean

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STRATEGIES = ("rings(4)", "component()", "radius()")
WEIGHTS = ("uniform", "geometric")
WEDGES = {"regular": ("#1f6fb2", "o"), "irregular": ("#c0392b", "s"), "graded": ("#2e8b57", "^"),
          "needles": ("#8e44ad", "D")}
# Where the area that receives the rotation has taken 45 of the 75 degrees of the tip of a thin wedge of 15 degrees.
# With component() the two other corners, of 82.5 degrees, ask for 7.5 degrees each.
LIMITS = {"component()": math.sqrt(45 / 90), "radius()": 0.5 * math.sqrt(45 / 75)}


def read_figures(file_name):
    """Returns the values of each quantity: figures[study][strategy, weights][mesh, resolution][quantity] is a list."""
    figures = defaultdict(lambda: defaultdict(lambda: defaultdict(lambda: defaultdict(list))))
    with open(file_name, encoding="ascii", newline="") as file:
        for row in csv.DictReader(file):
            settings, mesh = (row["strategy"], row["weights"]), (row["mesh"], int(row["resolution"]))
            figures[row["study"]][settings][mesh][row["quantity"]].append(row["value"])
    return figures


def numbers(record, quantity):
    return [float(value) for value in record[quantity]]


def table(header, rows):
    lines = [header, ["---"] * len(header)] + rows
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def all_settings(study):
    return [(strategy, weights) for strategy in STRATEGIES for weights in WEIGHTS if (strategy, weights) in study]


def resolutions(study):
    return sorted({resolution for meshes in study.values() for _, resolution in meshes})


def position_table(study):
    def cell(record):
        positions, on_border = numbers(record, "position"), mean(numbers(record, "on border"))
        return "%.3f%s" % (mean(positions), "*" if on_border > 0.5 else "")

    rows = [[*settings, mesh] + [cell(study[settings][mesh, n]) for n in resolutions(study)]
            for settings in all_settings(study) for mesh in WEDGES]
    return table(["strategy", "weights", "mesh"] + ["%d edges" % n for n in resolutions(study)], rows)


def spread_table(study, quantity):
    """Over all kinds of meshes with at least so many edges per side."""
    rows = []
    for settings in all_settings(study):
        row = list(settings)
        for smallest in resolutions(study)[:3]:
            records = [record for (_, n), record in study[settings].items() if n >= smallest]
            means = [mean(numbers(record, quantity)) for record in records]
            singles = [position for record in records for position in numbers(record, quantity)]
            row.append("%.3f (%.3f)" % (max(means) - min(means), max(singles) - min(singles)))
        rows.append(row)
    return table(["strategy", "weights"] + ["from %d edges" % n for n in resolutions(study)[:3]], rows)


def range_table(study):
    def cell(record):
        positions = numbers(record, "position")
        return "%.3f to %.3f" % (min(positions), max(positions))

    rows = [[*settings, mesh] + [cell(study[settings][mesh, n]) for n in resolutions(study)]
            for settings in all_settings(study) for mesh in WEDGES]
    return table(["strategy", "weights", "mesh"] + ["%d edges" % n for n in resolutions(study)], rows)


def wedge_skewness_table(study):
    def cell(record):
        return "%.1f / %.1f" % (max(numbers(record, "maximum skewness")), mean(numbers(record, "mean skewness")))

    rows = [[*settings, mesh] + [cell(study[settings][mesh, n]) for n in resolutions(study)]
            for settings in all_settings(study) for mesh in WEDGES]
    return table(["strategy", "weights", "mesh"] + ["%d edges" % n for n in resolutions(study)], rows)


def index_map_of(record):
    return record["corner indices times 4"][0], int(numbers(record, "border singularities")[0]), \
        int(numbers(record, "interior singularities")[0])


def plate_table(study):
    rows = []
    for settings in all_settings(study):
        records = list(study[settings].values())
        others = records[1:]  # the first one is the reference

        def mean_and_largest(quantity, factor, form):
            values = [factor * numbers(record, quantity)[0] for record in others]
            return (form + " / " + form) % (mean(values), max(values))

        rows.append([*settings, "%d" % len({record["corner indices times 4"][0] for record in records}),
                     "%d" % len({index_map_of(record) for record in records}),
                     "%d" % sum(numbers(record, "unmatched singularities")[0] for record in others),
                     mean_and_largest("distance of singularities", 100, "%.2f"),
                     mean_and_largest("difference of orthogonal fields", 1, "%.2f"),
                     mean_and_largest("difference of fields", 1, "%.2f")])
    return table(["strategy", "weights", "different corner indices", "different index maps", "unmatched singularities",
                  "distance in %", "orthogonal field", "field"], rows)


def plate_table_by_mesh(study):
    settings = all_settings(study)
    rows = []
    for mesh in study[settings[0]]:
        records = [study[s][mesh] for s in settings]
        rows.append([mesh[0], records[0]["faces"][0]]
                    + ["%.2f" % numbers(record, "difference of fields")[0] for record in records])
    return table(["mesh", "faces"] + ["%s, %s" % s for s in settings], rows)


def orthogonality_table(study):
    rows = []
    for settings in all_settings(study):
        for mesh in sorted({name for name, _ in study[settings]}):
            records = [study[settings][mesh, k] for k in resolutions(study)]
            for quantity in ("mean skewness", "maximum skewness away from corners", "maximum skewness"):
                rows.append([mesh, settings[1], quantity] + ["%.1f" % numbers(r, quantity)[0] for r in records])
    return table(["domain", "weights", "degrees"] + ["refinement %d" % k for k in resolutions(study)], rows)


def convergence_table(study):
    rows = [[mesh, settings[1]] + ["%.2f" % numbers(study[settings][mesh, k], "difference of orthogonal fields")[0]
                                   for k in resolutions(study)]
            for mesh in dict.fromkeys(name for meshes in study.values() for name, _ in meshes)
            for settings in all_settings(study)]
    return table(["mesh", "weights"] + ["refinement %d" % k for k in resolutions(study)], rows)


def write_tables(figures, file_name):
    wedge, plate, orthogonality = figures["wedge"], figures["plate"], figures["orthogonality"]
    sections = [
        ("Wedge of 15 degrees: distance of the compensating singularity from the tip, in sides; mean over the seeds, "
         "* if most are on the border", position_table(wedge)),
        ("Wedge: smallest and largest distance of single meshes", range_table(wedge)),
        ("Wedge: largest less smallest distance, of means over the seeds (of single meshes)",
         spread_table(wedge, "position")),
        ("Wedge: the same for the vertices that carry the index", spread_table(wedge, "position of the vertex")),
        ("Wedge: maximum / mean skewness in degrees", wedge_skewness_table(wedge)),
        ("Plate: ten meshings; mean / largest difference from the first one, distances in % of the diameter, angles in "
         "degrees", plate_table(plate)),
        ("Plate: mean angle between the fields of a meshing and of the first one, in degrees",
         plate_table_by_mesh(plate)),
        ("Skewness under refinement", orthogonality_table(orthogonality)),
        ("Plate: mean angle between the orthogonal fields of radius() on a mesh and on a very fine one, in degrees",
         convergence_table(figures["convergence"]))]
    with open(file_name, "w", encoding="utf-8") as file:
        file.write("\n".join("## %s\n\n%s" % section for section in sections))


def draw_panel(axes, meshes, strategy):
    for name, (color, marker) in WEDGES.items():
        sizes = sorted(n for mesh, n in meshes if mesh == name)
        positions = [numbers(meshes[name, n], "position") for n in sizes]
        means = [mean(p) for p in positions]
        errors = [[m - min(p) for m, p in zip(means, positions)], [max(p) - m for m, p in zip(means, positions)]]
        axes.errorbar(sizes, means, yerr=errors, color=color, linewidth=1.2, capsize=2, elinewidth=0.8)
        for n, m in zip(sizes, means):
            is_on_border = mean(numbers(meshes[name, n], "on border")) > 0.5
            axes.plot([n], [m], marker, color=color, markersize=5, markerfacecolor="white" if is_on_border else color)
    if strategy in LIMITS:
        axes.axhline(LIMITS[strategy], color="#444444", linestyle=":", linewidth=1)


def draw_positions(study, file_names):
    plt.rcParams.update({"font.family": "sans-serif", "font.size": 9, "svg.fonttype": "none",
                         "svg.hashsalt": "mesh_dependence"})
    figure, grid = plt.subplots(len(WEIGHTS), len(STRATEGIES), sharex=True, sharey=True, figsize=(8.2, 4.8))
    for row, weights in zip(grid, WEIGHTS):
        for axes, strategy in zip(row, STRATEGIES):
            draw_panel(axes, study[strategy, weights], strategy)
            axes.set_title("%s, %s weights" % (strategy, weights), fontsize=9)
            axes.set_xscale("log", base=2)
            axes.set_xticks(resolutions(study))
            axes.set_xticklabels(["%d" % n for n in resolutions(study)])
            axes.set_ylim(0, 0.8)
            axes.grid(color="#e4e8ee", linewidth=0.6)
    for axes in grid[-1]:
        axes.set_xlabel("edges per side")
    for row in grid:
        row[0].set_ylabel("distance / side")
    handles = [plt.Line2D([], [], color=color, marker=marker, markersize=5, label=name)
               for name, (color, marker) in WEDGES.items()]
    figure.legend(handles=handles, loc="lower center", ncol=len(WEDGES), frameon=False)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    for file_name in file_names:
        is_svg = file_name.endswith(".svg")
        figure.savefig(file_name, dpi=150, metadata={"Date": None} if is_svg else None)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[2] if len(sys.argv) == 3 else os.path.dirname(os.path.abspath(sys.argv[1]))
    figures = read_figures(sys.argv[1])
    write_tables(figures, os.path.join(folder, "mesh_dependence.md"))
    draw_positions(figures["wedge"], [os.path.join(folder, "mesh_dependence" + ending) for ending in (".svg", ".png")])


if __name__ == "__main__":
    main()
