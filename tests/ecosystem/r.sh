#!/bin/bash
# Runs the page for R, and compares what R reads with the program's files
# Packages: r-base-core r-cran-sf r-cran-terra
set -euo pipefail

work=$CLONE/build-ecosystem/r
rm -rf "$work"
mkdir -p "$work"
cd "$CLONE"
export THIESSEN=$BUILD/cli/thiessen
Rscript samples/r/areal_rainfall.R "$work/out" | tee "$work/said"
grep -q '^120 months, 64 counties' "$work/said"
test -s "$work/out/cells.png"
cat >"$work/compare.R" <<'END'
out <- commandArgs(trailingOnly = TRUE)
suppressPackageStartupMessages(library(sf))
suppressPackageStartupMessages(library(terra))
cells <- st_drop_geometry(st_read(file.path(out, "cells.geojson"), quiet = TRUE))
weights <- read.csv(file.path(out, "weights.csv"), colClasses = c(station = "character"))
both <- merge(cells, weights, by = c("basin", "station"))
stopifnot(nrow(both) == nrow(weights), all(both$weight.x == both$weight.y))
# A pixel's reading is the one of the gauge that owns it.
readings <- read.csv("samples/colorado/rainfall.csv", check.names = FALSE)
january <- unlist(readings[readings[[1]] == "1988-01", -1])
pixels <- values(rast(file.path(out, "1988.nc"), subds = "rainfall")[[1]])
pixels <- pixels[!is.na(pixels)]
stopifnot(length(pixels) > 500, all(pixels %in% january))
END
Rscript "$work/compare.R" "$work/out"
echo '= sf, terra and a data frame of the samples'
