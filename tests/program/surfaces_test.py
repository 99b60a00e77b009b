#!/usr/bin/env python3
"""Surfaces, isohyets and the isohyetal mean of a plane of rainfall, against what it is by hand."""

import json
import re
import subprocess
import unittest

import thiessen

PLANAR = ("--metric", "planar")


def plane(x, y):
    return 10 + x / 2 + y / 4


class SurfacesTest(thiessen.ProgramTest):
    def setUp(self):
        super().setUp()
        gauges = {f"g{x}_{y}": (x, y) for x in (-5, 0, 12, 31, 45) for y in (-5, 7, 18, 25)}
        self.write("s.csv", "id,x,y\n" + "".join(f"{id_},{x},{y}\n" for id_, (x, y) in gauges.items()))
        self.write("b.csv", 'basin,wkt\nR,"POLYGON((0 0,40 0,40 20,0 20,0 0))"\nT,"POLYGON((0 0,19 0,0 19,0 0))"\n')
        plane_row = ",".join(repr(plane(x, y)) for x, y in gauges.values())
        x_row = ",".join(str(10 + x) for x, _ in gauges.values())
        self.write("r.csv", f"time,{','.join(gauges)}\nplane,{plane_row}\nx,{x_row}\ndry{',0' * len(gauges)}\n")

    def pixels(self, *options):
        self.output("map", "s.csv", "b.csv", "r.csv", "-o", "m.tif", "--resolution", "1", "--overwrite", *PLANAR, *options)
        text = subprocess.run(["gdal_translate", "-q", "-of", "XYZ", self.folder / "m.tif", "/vsistdout/"],
                              check=True, text=True, capture_output=True).stdout
        return [tuple(map(float, line.split())) for line in text.splitlines()]

    def test_a_raster_of_a_surface_has_a_style_of_its_own_values(self):
        # The plane x from 0 to 10 over a basin from x = 4 to 6: classes lie between 4 and 6, and nothing is dry.
        self.write("g.csv", "id,x,y\na,0,0\nb,10,0\nc,0,10\nd,10,10\n")
        self.write("q.csv", 'basin,WKT\nQ,"POLYGON((4 2,6 2,6 8,4 8,4 2))"\n')
        self.write("p.csv", "time,a,b,c,d\n2020-01-01,0,10,0,10\n")
        self.output("map", "g.csv", "q.csv", "p.csv", "--metric", "planar", "--method", "linear", "--resolution", "0.1",
                    "-o", "s.tif", "-q")
        style = (self.folder / "s.qml").read_text()
        bounds = [float(value) for value in re.findall(r'<item value="([0-9.]+)"', style)]
        self.assertGreaterEqual(len(bounds), 3)
        self.assertTrue(all(4 < bound < 6 for bound in bounds), bounds)
        self.assertNotIn("dry", style)
        table = (self.folder / "s.tif.aux.xml").read_text()
        rows = [(float(low), float(high))
                for low, high in re.findall("<Row .*?<F>(.*?)</F>.*?<F>(.*?)</F>", table, re.DOTALL)]
        self.assertEqual(len(rows), len(bounds) + 1)
        for (_, high), (low, _) in zip(rows, rows[1:]):
            self.assertAlmostEqual(low, high, delta=1e-6, msg="no gap between classes")
        self.assertTrue(rows[0][0] <= 4.05 and rows[-1][1] >= 5.95, "the outer pixels")
        self.output("map", "g.csv", "q.csv", "p.csv", "--metric", "planar", "--method", "linear", "-o", "s.svg", "-q")
        picture = (self.folder / "s.svg").read_text()
        self.assertNotIn(">dry</text>", picture)
        legend = picture.split('class="legend"')[1].split("</g>")[0]
        self.assertEqual(re.findall(r">(10|0)</text>", legend), [])

    def test_natural_and_linear_rasters_reproduce_a_plane(self):
        for method in ("natural", "linear"):
            for x, y, value in self.pixels("--time", "plane", "--method", method):
                self.assertAlmostEqual(value, plane(x, y), delta=4e-6, msg=method)

    def test_a_raster_says_its_method_and_does_not_depend_on_the_threads(self):
        for method in ("idw", "natural", "linear"):
            rasters = set()
            for threads in ("1", "2", "3"):
                self.pixels("--method", method, "--threads", threads)
                rasters.add((self.folder / "m.tif").read_bytes())
            self.assertEqual(len(rasters), 1, method)
        info = subprocess.run(["gdalinfo", self.folder / "m.tif"], text=True, capture_output=True, check=True).stdout
        self.assertIn("method=linear", info)

    def isohyets(self, *options):
        return json.loads(self.output("isohyets", "s.csv", "b.csv", "r.csv", *PLANAR, *options))

    def test_isohyets_of_a_plane_are_its_lines_cut_to_the_basins(self):
        for method in ("natural", "linear"):
            found = self.isohyets("--time", "x", "--interval", "15", "--method", method)
            levels = [(f["properties"]["basin"], f["properties"]["rainfall"]) for f in found["features"]]
            self.assertEqual(levels, [("R", 15), ("R", 30), ("R", 45), ("T", 15)], method)
            self.assertEqual(found["made_by"]["method"], method)
            for feature, length in zip(found["features"], (20, 20, 20, 14)):
                self.assertEqual(feature["geometry"]["type"], "MultiLineString")
                points = [p for line in feature["geometry"]["coordinates"] for p in line]
                for x, _ in points:
                    self.assertAlmostEqual(10 + x, feature["properties"]["rainfall"], delta=1e-4)
                ys = [y for _, y in points]
                self.assertAlmostEqual(max(ys) - min(ys), length, delta=1e-4)

    def test_breaks_are_the_levels(self):
        found = self.isohyets("--time", "x", "--breaks", "3,12.5,99")
        self.assertEqual([f["properties"]["rainfall"] for f in found["features"]], [12.5, 12.5])

    def test_a_dry_day_has_no_isohyets_in_any_format(self):
        self.assertEqual(self.isohyets("--time", "dry")["features"], [])
        for name in ("l.geojson", "l.gpkg", "l.shp", "l.tab", "l.csv"):
            for time in ("dry", "plane"):
                ran = self.run_program("isohyets", "s.csv", "b.csv", "r.csv", "-o", name, "--time", time, "--overwrite",
                                       *PLANAR)
                self.assertEqual(ran.returncode, 0, f"{name}: {ran.stderr}")
                self.assertEqual("no isohyet" in ran.stderr, time == "dry", f"{name}: {ran.stderr}")

    def test_without_an_interval_levels_are_where_the_classes_of_a_picture_meet(self):
        # The surface is 10 to 50 in the basins: equal steps of 5 between.
        levels = sorted({f["properties"]["rainfall"] for f in self.isohyets("--time", "x")["features"]})
        self.output("map", "s.csv", "b.csv", "r.csv", "-o", "m.svg", "--time", "x", "--method", "natural", "--isohyets", *PLANAR)
        picture = (self.folder / "m.svg").read_text()
        drawn = sorted({float(level) for level in re.findall(r'<g class="isohyet" data-level="([^"]+)"', picture)})
        self.assertEqual(levels, drawn)
        self.assertEqual(levels, [15, 20, 25, 30, 35, 40, 45])
        legend = picture[picture.index('<g class="legend">'):]
        ticks = [float(text) for text in re.findall(r">(-?[0-9.]+)</text>", legend)]
        self.assertTrue(set(levels) <= set(ticks), f"{levels} {ticks}")

    def test_a_format_of_degrees_is_refused_where_the_crs_is_not_known(self):
        ran = self.run_program("isohyets", "s.csv", "b.csv", "r.csv", "-o", "l.kml", "--time", "x", *PLANAR)
        self.assertEqual(ran.returncode, 1)
        self.assertIn("the coordinates' CRS is not known", ran.stderr)

    def test_a_geopackage_keeps_its_other_layers(self):
        self.output("cells", "s.csv", "b.csv", "-o", "s.gpkg", *PLANAR)
        for _ in range(2):
            self.output("isohyets", "s.csv", "b.csv", "r.csv", "-o", "s.gpkg", "--time", "x", "--overwrite", *PLANAR)
        info = subprocess.run(["ogrinfo", "-ro", self.folder / "s.gpkg"], text=True, capture_output=True, check=True)
        self.assertIn("cells (Multi Polygon)", info.stdout)
        self.assertIn("isohyets (Multi Line String)", info.stdout)

    def test_cells_have_none(self):
        ran = self.run_program("isohyets", "s.csv", "b.csv", "r.csv", "--method", "thiessen", *PLANAR)
        self.assertEqual(ran.returncode, 2)
        self.assertIn("cells have no isohyets", ran.stderr)

    def test_isohyetal_mean_of_a_plane(self):
        """Of 10 + x at every 15. R: 5, 15, 15 and 5 of 40, whose mid-levels are 12.5, 22.5, 37.5 and 47.5; their mean is the
        plane's own, 30. T: 82.5 of 180.5 at 12.5 and 98 at 22, midway from 15 to 29."""
        rows = thiessen.table(self.output("rain", "s.csv", "b.csv", "r.csv", "--method", "isohyetal", "--interval", "15",
                                          "--grid", "20000", *PLANAR))
        self.assertAlmostEqual(float(rows[1]["R"]), 30, delta=0.05)
        self.assertAlmostEqual(float(rows[1]["T"]), (82.5 * 12.5 + 98 * 22) / 180.5, delta=0.05)
        self.assertEqual((float(rows[2]["R"]), float(rows[2]["T"])), (0, 0))

    def test_methods_stand_side_by_side(self):
        header = self.output("rain", "s.csv", "b.csv", "r.csv", "--method", "thiessen,isohyetal", *PLANAR).split("\n")[0]
        self.assertEqual(header, "time,R_thiessen,R_isohyetal,T_thiessen,T_isohyetal")
        header = self.output("rain", "s.csv", "b.csv", "r.csv", "--method", "all", *PLANAR).split("\n")[0]
        self.assertEqual(header.count("isohyetal"), 0)
        for wrong in (("--method", "idw,idw"), ("--method", "isohyetal", "--gaps", "renormalise"), ("--interval", "3"),
                      ("--method", "isohyetal", "--weights-log", "w.csv")):
            self.assertEqual(self.run_program("rain", "s.csv", "b.csv", "r.csv", *PLANAR, *wrong).returncode, 2, wrong)


if __name__ == "__main__":
    unittest.main()
