#!/usr/bin/env python3
"""Areal rainfall of Colorado's counties in Python: from files, from frames, with errors, and a plot.

    pip install ./src/python        # once, from the clone, in a venv: see README.md
    samples/python/walkthrough.py [PLOT.png]
"""

import pathlib
import sys

import matplotlib
import pandas

import thiessen

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

colorado = pathlib.Path(__file__).resolve().parents[1] / "colorado"

# 1. Files, as the program reads them. Its long options are keywords.
study = thiessen.Study(colorado / "stations.csv", colorado / "counties.geojson", colorado / "rainfall.csv",
                       basin_id="name")
print(f"{len(study.stations)} gauges in {len(study.basins)} counties; {len(study.never_reporting)} never report")

# 2. Weights: which gauge counts for how much of which county.
weights = study.weights()
print(weights.sort_values("weight", ascending=False).head(3).to_string(index=False))

# 3. The series, and how far each value may be off.
rain = study.rain(error=True)
county = weights.groupby("basin")["station"].count().idxmax()
print(f"{county} County has the most gauges")

# 4. The same from memory: a frame with a column for each station, whose index is the time.
stations = pandas.read_csv(colorado / "stations.csv", dtype={"id": str})
readings = pandas.read_csv(colorado / "rainfall.csv", index_col=0)
in_memory = thiessen.Study(stations, colorado / "counties.geojson", readings, basin_id="name")
assert (in_memory.weights()["weight"] == weights["weight"]).all()

# 5. What a gauge is worth: by how much a county's rainfall changes without it.
influence = study.influence().sort_values("rms_change", ascending=False)
print(influence.head(3).to_string(index=False))

# 6. A plot: the county's monthly rainfall, with the bar that holds the true mean 95 times in 100.
months = pandas.to_datetime(rain["time"])
figure, axes = pyplot.subplots(figsize=(9, 3.5), layout="constrained")
axes.fill_between(months, (rain[county] - 1.96 * rain[f"{county}_se"]).clip(lower=0),
                  rain[county] + 1.96 * rain[f"{county}_se"], color="#9ecae1", linewidth=0, label="95 %")
axes.plot(months, rain[county], color="#08519c", linewidth=1, label="areal rainfall")
axes.set(ylabel="mm per month", title=f"{county} County", ylim=(0, None), xlim=(months.iloc[0], months.iloc[-1]))
axes.legend(frameon=False)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "county.png", dpi=120)
