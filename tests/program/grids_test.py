#!/usr/bin/env python3
"""Grids of time steps: every band is the raster of its step alone, and GDAL, xarray and R's terra read the right times."""

import json
import re
import shutil
import subprocess
import sys
import unittest

import thiessen

COLORADO = thiessen.SAMPLES / "colorado"
INPUTS = (COLORADO / "stations.csv", COLORADO / "counties.geojson", COLORADO / "rainfall.csv")
PIXELS = ("--resolution", "0.1", "-q")

STATIONS = "id,x,y\na,0.5,0.5\nb,2.5,0.5\nc,1.5,3.5\n"
BASIN = 'basin,wkt\nB,"POLYGON((0 0,3 0,3 4,0 4,0 0))"\n'


def lines_of(*command):
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout.splitlines()


def python_with(module):
    """A Python that has the module: this one, or the system's."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", f"import {module}"], capture_output=True).returncode == 0:
            return python
    return None


class GridsTest(thiessen.ProgramTest):
    def pixels_of(self, file, band):
        """The pixels of a band, as GDAL writes them in an ASCII grid."""
        subprocess.run(["gdal_translate", "-q", "-b", str(band), "-of", "XYZ", self.folder / file, self.folder / "x"],
                       check=True)
        return (self.folder / "x").read_text()

    def test_a_band_is_the_raster_of_its_step(self):
        span = ("--from", "1990-01", "--to", "1990-04")
        self.output("map", *INPUTS, "-o", "g.tif", "--steps", *span, *PIXELS)
        self.output("map", *INPUTS, "-o", "g.nc", "--steps", *span, *PIXELS)
        for band, time in enumerate(("1990-01", "1990-02", "1990-03", "1990-04"), 1):
            self.output("map", *INPUTS, "-o", f"{time}.tif", "--time", time, *PIXELS)
            alone = self.pixels_of(f"{time}.tif", 1)
            self.assertTrue(alone == self.pixels_of("g.tif", band), time)
            # GDAL's grid of the NetCDF has its coordinates from the pixels' centres: compare the values.
            values = [line.split()[2] for line in alone.splitlines()]
            self.assertTrue(values == [line.split()[2] for line in self.pixels_of("g.nc", band).splitlines()], time)

    def textbook_grid(self, output, *options, times=("2020-02-28", "2020-02-29", "2020-03-01")):
        self.write("s.csv", STATIONS)
        self.write("b.csv", BASIN)
        readings = ("1,2,3", "1,,3", "4,5,6")
        self.write("r.csv", "time,a,b,c\n" + "".join(f"{t},{r}\n" for t, r in zip(times, readings)))
        return self.run_program("map", "s.csv", "b.csv", "r.csv", "-o", output, "--steps", "--metric", "planar",
                                "--resolution", "1", "--units", "mm/d", *options)

    def test_gdalinfo_shows_the_bands_with_their_times_and_unit(self):
        ran = self.textbook_grid("g.tif")
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        info = json.loads("\n".join(lines_of("gdalinfo", "-json", self.folder / "g.tif")))
        self.assertEqual([band["description"] for band in info["bands"]], ["2020-02-28", "2020-02-29", "2020-03-01"])
        for band in info["bands"]:
            self.assertEqual(band["unit"], "mm/d")
            self.assertEqual(band["metadata"][""], {"time": band["description"], "units": "mm/d"})
        self.assertTrue(info["metadata"][""]["TIFFTAG_SOFTWARE"].startswith("thiessen"))
        # By hand: the pixels' centres from the north; b is silent on the second day, and (2.5, 1.5) is then as near to a
        # as to c, so that the lower number has it.
        first = "3 3 3  3 3 3  1 1 2  1 1 2".split()
        self.assertEqual([line.split()[2] for line in self.pixels_of("g.tif", 1).splitlines()], first)
        second = "3 3 3  3 3 3  1 1 1  1 1 1".split()
        self.assertEqual([line.split()[2] for line in self.pixels_of("g.tif", 2).splitlines()], second)

    def test_gdalinfo_shows_the_times_of_a_netcdf(self):
        self.assertEqual(self.textbook_grid("g.nc").returncode, 0)
        info = "\n".join(lines_of("gdalinfo", self.folder / "g.nc"))
        self.assertIn("time#units=seconds since 1970-01-01 00:00:00", info)
        self.assertIn("NETCDF_DIM_time_VALUES={1582848000,1582934400,1583020800}", info)
        self.assertIn("Unit Type: mm/d", info)
        self.assertIn("Origin = (0.000000000000000,4.000000000000000)", info)

    def test_a_netcdf_has_its_crs(self):
        self.output("map", *INPUTS, "-o", "g.nc", "--steps", "--from", "1990-01", "--to", "1990-01", *PIXELS)
        info = "\n".join(lines_of("gdalinfo", self.folder / "g.nc"))
        self.assertIn('ID["EPSG",4326]', info)
        self.assertIn("rainfall#grid_mapping=crs", info)
        self.assertIn("crs#grid_mapping_name=latitude_longitude", info)

    def test_xarray_opens_it_with_times_and_their_bounds(self):
        python = python_with("xarray")
        if python is None:
            self.skipTest("python3-xarray is not installed")
        self.assertEqual(self.textbook_grid("g.nc").returncode, 0)
        script = """import sys, xarray
grid = xarray.open_dataset(sys.argv[1])
print(grid.rainfall.dims, grid.rainfall.dtype, grid.rainfall.attrs["units"], grid.attrs["Conventions"])
print(*grid.time.values.astype("datetime64[m]"))
print(*grid.time_bnds.values.astype("datetime64[m]").ravel())
print(*grid.x.values, *grid.y.values)
print(*grid.rainfall.sel(time="2020-02-29").values.ravel())
"""
        self.assertEqual(lines_of(python, "-c", script, self.folder / "g.nc"), [
            "('time', 'y', 'x') float32 mm/d CF-1.8",
            "2020-02-28T00:00 2020-02-29T00:00 2020-03-01T00:00",
            "2020-02-28T00:00 2020-02-29T00:00 2020-02-29T00:00 2020-03-01T00:00 2020-03-01T00:00 2020-03-02T00:00",
            "0.5 1.5 2.5 3.5 2.5 1.5 0.5",
            "3.0 3.0 3.0 3.0 3.0 3.0 1.0 1.0 1.0 1.0 1.0 1.0",
        ])

    def test_terra_opens_it_with_times(self):
        has_terra = shutil.which("Rscript") and subprocess.run(
            ["Rscript", "-e", "library(terra)"], capture_output=True).returncode == 0
        if not has_terra:
            self.skipTest("R's terra (r-cran-terra) is not installed")
        self.assertEqual(self.textbook_grid("g.nc").returncode, 0)
        script = 'suppressMessages(library(terra)); g <- rast(commandArgs(TRUE)[1], "rainfall"); ' \
                 'cat(format(time(g), "%Y-%m-%d", tz="UTC"), nlyr(g), values(g)[, 2], units(g)[1])'
        self.assertEqual(lines_of("Rscript", "-e", script, self.folder / "g.nc"),
                         ["2020-02-28 2020-02-29 2020-03-01 3 3 3 3 3 3 3 1 1 1 1 1 1 mm/d"])

    def test_a_band_of_a_surface_is_the_raster_of_its_step(self):
        span = ("--from", "1990-01", "--to", "1990-02", "--method", "natural", "--resolution", "0.25", "-q")
        self.output("map", *INPUTS, "-o", "g.tif", "--steps", *span)
        self.output("map", *INPUTS, "-o", "g.nc", "--steps", *span)
        for band, time in enumerate(("1990-01", "1990-02"), 1):
            self.output("map", *INPUTS, "-o", f"{time}.tif", "--time", time, "--method", "natural", "--resolution",
                        "0.25", "-q")
            alone = self.pixels_of(f"{time}.tif", 1)
            self.assertTrue(alone == self.pixels_of("g.tif", band), time)
            values = [line.split()[2] for line in alone.splitlines()]
            self.assertTrue(values == [line.split()[2] for line in self.pixels_of("g.nc", band).splitlines()], time)
        info = json.loads("\n".join(lines_of("gdalinfo", "-json", self.folder / "g.tif")))
        self.assertEqual(info["metadata"][""]["method"], "natural")

    def test_a_step_without_readings_has_no_surface(self):
        self.write("s.csv", STATIONS)
        self.write("b.csv", BASIN)
        self.write("r.csv", "time,a,b,c\n2020-01-01,1,2,3\n2020-01-02,,,\n")
        self.output("map", "s.csv", "b.csv", "r.csv", "-o", "g.tif", "--steps", "--metric", "planar", "--resolution",
                    "1", "--method", "linear", "-q")
        self.assertEqual({line.split()[2] for line in self.pixels_of("g.tif", 2).splitlines()}, {"nan"})

    def test_a_series_has_one_style_whose_classes_are_those_of_all_steps_or_as_asked_for(self):
        # Of the readings 1 to 6, of which three equal 1 and three 3: steps of 0.5 or 1 from 1 to 6.
        self.assertEqual(self.textbook_grid("g.tif").returncode, 0)
        style = (self.folder / "g.qml").read_text()
        self.assertIn('type="singlebandpseudocolor" band="1"', style)
        self.assertRegex(style, 'label="from 5[.0-9]* mm/d"')
        ran = self.textbook_grid("g.tif", "--overwrite", "--breaks", "2,5", "--palette", "greys")
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        labels = [line.split('"')[3] for line in (self.folder / "g.qml").read_text().splitlines() if "<item" in line]
        self.assertEqual(labels, ["below 2 mm/d", "2 to 5 mm/d", "from 5 mm/d"])
        rows = re.findall("<Row .*?<F>(.*?)</F>.*?<F>(.*?)</F>", (self.folder / "g.tif.aux.xml").read_text(), re.DOTALL)
        lows = [float(low) for low, _ in rows]
        highs = [float(high) for _, high in rows]
        self.assertEqual(lows, [0, 2, 5])
        self.assertEqual([round(high, 6) for high in highs], [2, 5, 6], "up to the next class, and to the largest reading")
        ran = self.textbook_grid("g.tif", "--overwrite", "--range", "2,8")
        self.assertIn("some of the rainfall lies outside the range of the colours", ran.stderr)

    def netcdf_text(self, file):
        """What the file says of itself and its times, as far as GDAL tells it."""
        return "\n".join(lines_of("gdalinfo", "-mdd", "all", self.folder / file))

    def test_one_step_is_as_long_as_the_series_step(self):
        times = ("2020-02-01T00:00", "2020-02-01T06:00", "2020-02-01T12:00")
        ran = self.textbook_grid("g.nc", "--from", times[1], "--to", times[1], times=times)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        python = python_with("netCDF4") or python_with("xarray")
        self.assertIn("rainfall#cell_methods=time: mean", self.netcdf_text("g.nc"))  # of mm/d
        if python is None:
            self.skipTest("python3-xarray is not installed")
        script = "import sys, xarray\nprint(*xarray.open_dataset(sys.argv[1]).time_bnds.values.ravel())"
        self.assertEqual(lines_of(python, "-c", script, self.folder / "g.nc"),
                         ["2020-02-01T06:00:00.000000000 2020-02-01T12:00:00.000000000"])

    def test_one_step_of_unknown_length_has_no_bounds(self):
        self.write("s.csv", STATIONS)
        self.write("b.csv", BASIN)
        self.write("r.csv", "time,a,b,c\n2020-02-01T06:00,1,2,3\n")
        ran = self.run_program("map", "s.csv", "b.csv", "r.csv", "-o", "g.nc", "--steps", "--metric", "planar",
                               "--resolution", "1")
        self.assertEqual(ran.returncode, 0)
        self.assertIn("nothing tells how long its only step is: in the .nc it has no bounds", ran.stderr)
        text = self.netcdf_text("g.nc")
        self.assertNotIn("cell_methods", text)
        self.assertNotIn("time_bnds", text)

    def test_times_of_no_calendar_are_an_error_that_says_to_use_a_tif(self):
        labels = ("first", "second", "third")
        ran = self.textbook_grid("g.nc", times=labels)
        self.assertEqual(ran.returncode, 1)
        self.assertIn("'first' is no time of the calendar", ran.stderr)
        self.assertIn("hint: a .tif takes any times", ran.stderr)
        self.assertFalse((self.folder / "g.nc").exists())
        self.assertEqual(self.textbook_grid("g.tif", times=labels).returncode, 0)

    def test_a_grid_is_the_same_whatever_the_threads_and_leaves_nothing_else(self):
        for output in ("g.tif", "g.nc"):
            bytes_ = set()
            for threads in ("1", "2"):
                self.assertEqual(self.textbook_grid(output, "--threads", threads, "--overwrite").returncode, 0)
                bytes_.add((self.folder / output).read_bytes())
            self.assertEqual(len(bytes_), 1, output)
        names = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(names, ["b.csv", "g.nc", "g.qml", "g.tif", "g.tif.aux.xml", "r.csv", "s.csv"])


if __name__ == "__main__":
    unittest.main()
