#!/usr/bin/env python3
"""What normals of a raster add to `rain`, in processor time; asserts nothing.

    tests/benchmarks/rain_with_normals.py [PROGRAM]

The 376 gauges and 64 counties of the Colorado sample, 5 % of the gauges silent: each in spells of 200 steps (20,000
steps; goal 1.2 times as long as without normals), and at random (2,000 steps; goal 1.5 times). The rasters have hills:
in degrees with pixels of some 800 m, in UTM of 500 m. Then the sample's own readings with normals of the months that are
fitted by elevation, over a raster of 10,000 x 10,000 pixels (goal 1.5 s), and with that raster as normals. Runs that are
compared take turns; told are the minima.
"""

import csv
import math
import pathlib
import random
import struct
import sys
import tempfile

from whole_process import CLONE, SEED, measure

SAMPLE = CLONE / "samples" / "colorado"
REPEATS = 5
# Of an ESRI .prj, as GDAL reads it beside a .bil.
DEGREES = ('GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],'
           'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]]')
UTM = (f'PROJCS["WGS_1984_UTM_Zone_13N",{DEGREES},PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],'
       'PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",-105.0],PARAMETER["Scale_Factor",0.9996],'
       'PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]]')


def write_raster(path, corner, pixel, columns, rows, crs, mean=500):
    """A .bil of 4-byte floats round a mean: its upper left corner, the width of its square pixels, its size."""
    path.with_suffix(".hdr").write_text(
        f"BYTEORDER I\nLAYOUT BIL\nNROWS {rows}\nNCOLS {columns}\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\n"
        f"ULXMAP {corner[0] + pixel / 2}\nULYMAP {corner[1] - pixel / 2}\nXDIM {pixel}\nYDIM {pixel}\n")
    path.with_suffix(".prj").write_text(crs)
    hills = [math.sin(column / 15) for column in range(columns)]
    with path.open("wb") as file:
        for row in range(rows):
            height = 300 * math.cos(row / 11)
            file.write(struct.pack(f"<{columns}f", *(mean + height * hill for hill in hills)))


def write_readings(path, gauges, steps, spell):
    """Wide; for so many steps the same gauges are silent, some 5 % of them drawn anew."""
    rng = random.Random(SEED)
    with path.open("w", encoding="utf-8") as file:
        file.write("time," + ",".join(gauges) + "\n")
        silent = set()
        until = [0] * len(gauges)
        for step in range(steps):
            for g in range(len(gauges)):
                if until[g] > step:
                    continue
                until[g] = step + (rng.randrange(1, 2 * spell) if spell > 1 else 1)
                (silent.add if rng.random() < 0.05 else silent.discard)(g)
            file.write(f"{step:06d}" + "".join("," if g in silent else f",{rng.randrange(300) / 10}"
                                               for g in range(len(gauges))) + "\n")


def main():
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else CLONE / "build/cli/thiessen").resolve()
    with open(SAMPLE / "stations.csv", newline="", encoding="utf-8") as file:
        gauges = [row["id"] for row in csv.DictReader(file)]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        write_raster(folder / "degrees.bil", (-110, 42), 0.0075, 1200, 800, DEGREES)
        write_raster(folder / "utm.bil", (50_000, 4_650_000), 500, 1700, 1300, UTM)
        for spell, steps in ((200, 20_000), (1, 2_000)):
            write_readings(folder / "rain.csv", gauges, steps, spell)
            base = [program, "rain", SAMPLE / "stations.csv", SAMPLE / "counties.geojson", folder / "rain.csv",
                    "--basin-id", "name", "-q", "--threads", "1", "--overwrite", "-o", folder / "areal.csv"]
            kinds = {"without": [], **{kind: ["--normals", folder / f"{kind}.bil"] for kind in ("degrees", "utm")}}
            compare("in spells" if spell > 1 else "at random", base, kinds)
        write_raster(folder / "large.bil", (-110, 42), 0.0009, 10_000, 10_000, DEGREES, mean=2000)
        base[4] = SAMPLE / "rainfall.csv"
        compare("10,000^2", base, {kind: [f"--{kind}", folder / "large.bil"] for kind in ("normals", "elevation")})


def compare(what, base, kinds):
    seconds = {kind: [] for kind in kinds}
    for _ in range(REPEATS):
        for kind, options in kinds.items():
            seconds[kind].append(measure([str(a) for a in [*base, *options]])[2])
    first = min(next(iter(seconds.values())))
    for kind, taken in seconds.items():
        print(f"{what:<10} {kind:<9} {min(taken):7.3f} s {min(taken) / first:5.2f} times", flush=True)


if __name__ == "__main__":
    main()
