"""What the program reads from PostGIS and writes into it: postgis_tables.py CLONE PROGRAM PSQL

The server is the one that PGHOST and its like name.
"""

import csv
import io
import os
import pathlib
import subprocess
import sys

clone, program, psql = map(pathlib.Path, sys.argv[1:])
colorado = clone / "samples/colorado"
FILES = [str(colorado / name) for name in ("stations.csv", "counties.geojson", "rainfall.csv")]
DATABASE = f"PG:host={os.environ['PGHOST']} port={os.environ['PGPORT']} dbname=postgres user=tester password=open-sesame"


def ask(sql):
    """The rows of an answer, as texts."""
    ran = subprocess.run([psql, "-X", "-q", "--csv", "-v", "ON_ERROR_STOP=1", "-f", "-"], input=sql, check=True,
                         capture_output=True, text=True)
    return list(csv.reader(io.StringIO(ran.stdout)))[1:]


def value(sql):
    return ask(sql)[0][0]


def run(*arguments, status=0):
    ran = subprocess.run([program, *arguments], capture_output=True, text=True)
    assert ran.returncode == status, (arguments, ran.returncode, ran.stderr)
    assert "open-sesame" not in ran.stderr + ran.stdout, ran.stderr
    return ran.stdout if status == 0 else ran.stderr


def rows(text):
    return list(csv.reader(io.StringIO(text)))


def same(found, wanted):
    """Whether two tables are equal, numbers as numbers."""
    def plain(text):
        try:
            return float(text)
        except ValueError:
            return text

    assert len(found) == len(wanted), (len(found), len(wanted))
    for one, other in zip(found, wanted):
        assert [plain(text) for text in one] == [plain(text) for text in other], (one, other)


# Into the database.
run("cells", *FILES[:2], "-o", DATABASE)
weights = rows(run("weights", *FILES[:2]))
assert int(value("SELECT count(*) FROM cells")) == len(weights) - 1
assert value("SELECT bool_and(ST_IsValid(geom)) FROM cells") == "t"
assert ask("SELECT DISTINCT ST_SRID(geom), GeometryType(geom) FROM cells") == [["4326", "MULTIPOLYGON"]]
# An equal-area projection of the same ellipsoid, in which edges that are straight in degrees are drawn finely.
assert float(value("SELECT max(abs(ST_Area(ST_Transform(ST_Segmentize(geom, 0.01), 5070)) / 1e6 - area_km2) / area_km2) "
                   "FROM cells WHERE area_km2 > 100")) < 5e-5  # an edge may lie 0.1 m from the true one
assert value("SELECT obj_description('cells'::regclass)").startswith("thiessen ")
assert value("SELECT count(*) FROM pg_indexes WHERE tablename = 'cells' AND indexdef LIKE '%gist%'") == "1"
same(ask('SELECT basin, station, area_km2, weight FROM cells ORDER BY basin COLLATE "C", station COLLATE "C"'),
     sorted(weights[1:]))

run("weights", *FILES[:2], "-o", DATABASE)
same(ask("SELECT * FROM weights"), weights[1:])

run("rain", *FILES, "-o", DATABASE, "--error")
same(ask("SELECT * FROM rain"), rows(run("rain", *FILES, "--error", "--long"))[1:])
assert value("SELECT pg_typeof(rainfall) FROM rain LIMIT 1") == "double precision"
assert int(value("SELECT count(*) FROM rain WHERE rainfall IS NULL")) == int(
    value("SELECT count(*) FROM rain WHERE gauges = 0"))

run("rain", *FILES, "-o", DATABASE, "--output-layer", "results.by_year", "--every", "year")
assert value("SELECT count(DISTINCT time) FROM results.by_year") == "10"
run("weights", *FILES[:2], "-o", DATABASE + " active_schema=results", "--output-layer", 'it"s')
assert int(value('SELECT count(*) FROM results."it""s"')) == len(weights) - 1

# What is there is replaced only where that is asked for, and only where it is ours.
said = run("weights", *FILES[:2], "-o", DATABASE, status=1)
assert "already exists" in said and "--overwrite" in said, said
run("weights", *FILES[:2], "-o", DATABASE, "--overwrite")
ask("CREATE TABLE theirs (a int)")
said = run("weights", *FILES[:2], "-o", DATABASE, "--output-layer", "theirs", "--overwrite", status=1)
assert "never dropped" in said and "--output-layer" in said, said
assert value("SELECT count(*) FROM theirs") == "0"
ask("CREATE VIEW seen AS SELECT * FROM weights")
said = run("weights", *FILES[:2], "-o", DATABASE, "--overwrite", status=1)
assert "view" in said, said
same(ask("SELECT * FROM seen"), weights[1:])
said = run("weights", *FILES[:2], "-o", DATABASE, "--output-layer", "nowhere.table", status=1)
assert "nowhere" in said, said
assert "cannot be reached" in run("weights", *FILES[:2], "-o", DATABASE.replace("dbname=postgres", "dbname=none"), status=1)
run("weights", *FILES[:2], "-o", "w.csv", "--output-layer", "x", status=2)

# A comment that only begins as ours do is no mark, and a name that the server would cut is none.
ask("CREATE TABLE drawn (a int); COMMENT ON TABLE drawn IS 'thiessen polygons drawn by hand, 1998'")
said = run("weights", *FILES[:2], "-o", DATABASE, "--output-layer", "drawn", "--overwrite", status=1)
assert "never dropped" in said, said
assert value("SELECT count(*) FROM drawn") == "0"
said = run("weights", *FILES[:2], "-o", DATABASE, "--output-layer", 64 * "a", status=1)
assert "64 bytes" in said and "63" in said, said
run("weights", *FILES[:2], "-o", DATABASE, "--output-layer", 63 * "a")

# A table is looked for where it would be made, and not in other schemas of the search_path.
ask("CREATE SCHEMA mine")
ours = value("SELECT 'public.weights'::regclass::oid")
mine = DATABASE + " options='-csearch_path=mine,public'"
run("weights", *FILES[:2], "-o", mine)
run("weights", *FILES[:2], "-o", mine, "--overwrite")
assert value("SELECT 'public.weights'::regclass::oid") == ours
assert int(value("SELECT count(*) FROM mine.weights")) == len(weights) - 1
said = run("weights", *FILES[:2], "-o", DATABASE + " active_schema=absent", status=1)
assert "CREATE SCHEMA" in said and "LINE" not in said, said
assert "no schema" in run("weights", *FILES[:2], "-o", DATABASE + " options='-csearch_path=absent'", status=1)

# What replaces a table gives the same rights to others.
ask("CREATE ROLE reader; CREATE ROLE clerk; GRANT SELECT ON mine.weights TO reader, PUBLIC; "
    "GRANT INSERT ON mine.weights TO clerk WITH GRANT OPTION")
rights = "SELECT relacl FROM pg_class WHERE oid = 'mine.weights'::regclass"
before = value(rights)
run("weights", *FILES[:2], "-o", mine, "--overwrite")
assert sorted(value(rights).strip("{}").split(",")) == sorted(before.strip("{}").split(",")), (value(rights), before)


# The comment says by which method and in which unit.
def comment_of(*options):
    run("rain", *FILES, "-o", DATABASE, "--output-layer", "told", "--overwrite", *options)
    return value("SELECT obj_description('told'::regclass)")


assert comment_of().endswith("; method: thiessen; unit: mm"), comment_of()
assert comment_of("--method", "idw").endswith("; method: idw; unit: mm")
assert comment_of("--method", "thiessen,idw").endswith("; method: thiessen,idw; unit: mm")
assert comment_of("--from-unit", "mm", "--to-unit", "in").endswith("; unit: in")
assert comment_of("--units", "in").endswith("; unit: in")

# Stations' fields that are called as the geometry is, and as a column of numbers of another table.
with open(FILES[0], encoding="utf-8") as file, open("fields.csv", "w", encoding="utf-8") as fields:
    for line in file:
        fields.write(line.rstrip("\n") + (",geom,gauges\n" if line.startswith('"id"') else ",round,old ones\n"))
said = subprocess.run([program, "cells", "fields.csv", FILES[1], "--attributes", "-o", DATABASE, "--output-layer", "fields"],
                      check=True, capture_output=True, text=True).stderr
assert "'geom' is called 'geom_'" in said, said
assert ask("SELECT DISTINCT geom_, gauges FROM fields") == [["round", "old ones"]]

# A run that fails leaves nothing.
with open("bad.csv", "w", encoding="utf-8") as bad:
    bad.write("month,028468\n1988-01,1\n1988-02,oops\n")
run("rain", *FILES[:2], "bad.csv", "-o", DATABASE, "--output-layer", "broken", status=1)
assert value("SELECT to_regclass('broken') IS NULL") == "t"

# Out of the database: stations, basins and readings in tables of their own.
subprocess.run(["ogr2ogr", "-f", "PostgreSQL", DATABASE, FILES[1], "-nln", "counties", "-lco", "LAUNDER=NO"], check=True)
ask("CREATE TABLE gauges (id text, place geometry(Point, 4326)); CREATE TABLE readings (month text, station text, mm float8)")
with open(FILES[0], encoding="utf-8") as file:
    lists = list(csv.DictReader(file))
ask("INSERT INTO gauges VALUES " + ", ".join(
    f"('{row['id']}', ST_SetSRID(ST_MakePoint({row['lon']}, {row['lat']}), 4326))" for row in lists))
with open(FILES[2], encoding="utf-8") as file:
    header, *steps = csv.reader(file)
ask("INSERT INTO readings VALUES " + ", ".join(
    f"('{step[0]}', '{station}', {reading})" for step in steps for station, reading in zip(header[1:], step[1:]) if reading))
inputs = [DATABASE, DATABASE, DATABASE, "--stations-layer", "gauges", "--basins-layer", "counties", "--rainfall-layer",
          "readings", "--id", "id", "--station-field", "station", "--value-field", "mm",
          "--time-field", "month"]
from_files = rows(run("rain", *FILES))
from_tables = rows(run("rain", *inputs))
assert from_tables == from_files
run("rain", *inputs, "-o", DATABASE, "--overwrite")
same(ask("SELECT time, basin, rainfall FROM rain"),
     [[row[0], row[1], row[2]] for row in rows(run("rain", *FILES, "--long"))[1:]])

# A run is repeated by its file to the byte, which holds no password, nor does the page tell of one.
study = [DATABASE, FILES[1], FILES[2], "--stations-layer", "gauges", "--id", "id"]
run("run", *study, "-o", "a")
run("run", "--config", "a/study.toml", "-o", "b")
subprocess.run(["diff", "-r", "a", "b"], check=True)
