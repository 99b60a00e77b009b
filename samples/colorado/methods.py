#!/usr/bin/env python3
"""Draws methods.png: what other methods say beside Thiessen's mean and its 95 % bar.

    samples/colorado/methods.py [PROGRAM]      needs Debian's python3-matplotlib

Above a county, month by month; below all counties and months: how far the others are off, in standard errors.
"""

import csv
import io
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of what it draws with)

SAMPLE = pathlib.Path(__file__).resolve().parent
COUNTY = "Larimer"
YEARS = ("1995", "1996", "1997")
METHODS = {"natural": ("natural neighbours", "#1b9e77"), "idw": ("inverse distance", "#d95f02"),
           "arithmetic": ("arithmetic mean", "#7570b3")}
BAR = 1.96


def rain(program, *options):
    files = [SAMPLE / name for name in ("stations.csv", "counties.geojson", "rainfall.csv")]
    command = [program, "rain", *files, "--basin-id", "name", "-q", *options]
    text = subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout
    return list(csv.DictReader(io.StringIO(text)))


def number(row, column):
    return float(row[column]) if row[column] else None


def draw_county(axes, bars, others):
    months = [row["time"] for row in bars if row["time"][:4] in YEARS]
    kept = [row for row in bars if row["time"] in months]
    values = [number(row, COUNTY) for row in kept]
    errors = [BAR * (number(row, f"{COUNTY}_se") or 0) for row in kept]
    x = range(len(months))
    low = [max(0, v - e) for v, e in zip(values, errors)]
    high = [v + e for v, e in zip(values, errors)]
    axes.fill_between(x, low, high, step="mid", color="#cccccc", label="Thiessen, 95 % bar")
    axes.step(x, values, where="mid", color="black", label="Thiessen")
    at = {row["time"]: row for row in others}
    for offset, (method, (name, colour)) in zip((-0.22, 0, 0.22), METHODS.items()):
        points = [number(at[month], f"{COUNTY}_{method}") for month in months]
        axes.plot([i + offset for i in x], points, "o", ms=4, color=colour, label=name)
    axes.set_xticks([i for i in x if months[i].endswith(("-01", "-07"))])
    axes.set_xticklabels([m for m in months if m.endswith(("-01", "-07"))])
    axes.set_xlim(-0.6, len(months) - 0.4)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("mm a month")
    axes.set_title(f"{COUNTY} County, Colorado", loc="left")
    axes.legend(frameon=False, fontsize=8, ncol=2)


def draw_all(axes, bars, others):
    counties = [name[:-3] for name in bars[0] if name.endswith("_se")]
    edges = [i / 4 for i in range(-16, 17)]
    for method, (name, colour) in METHODS.items():
        off = []
        for bar, other in zip(bars, others):
            for county in counties:
                error, value, mean = number(bar, f"{county}_se"), number(other, f"{county}_{method}"), number(bar, county)
                if error and value is not None:
                    off.append((value - mean) / error)
        within = sum(abs(o) <= BAR for o in off) / len(off)
        axes.hist([min(max(o, -3.99), 3.99) for o in off], bins=edges, histtype="step", lw=1.6, color=colour,
                  weights=[100 / len(off)] * len(off), label=f"{name}: {100 * within:.1f} % within the bar")
    for side in (-BAR, BAR):
        axes.axvline(side, color="#888888", ls="--", lw=1)
    axes.set_xlabel("off Thiessen's mean, in its standard errors")
    axes.set_ylabel("% of county months")
    axes.set_title("64 counties, 120 months", loc="left")
    axes.legend(framealpha=1, edgecolor="white", fontsize=8, loc="upper left")


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else SAMPLE.parents[1] / "build/cli/thiessen"
    bars = rain(program, "--error", "--decimals", "6")
    others = rain(program, "--method", "all", "--decimals", "6")
    figure, (above, below) = plt.subplots(2, 1, figsize=(9, 7), height_ratios=(1.1, 1))
    draw_county(above, bars, others)
    draw_all(below, bars, others)
    for axes in (above, below):
        axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    figure.savefig(SAMPLE / "methods.png", dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    main()
