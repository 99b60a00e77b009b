#!/usr/bin/env Rscript
# Areal rainfall of Colorado's counties in R: the program computes, sf and terra open what it writes.
#   Rscript samples/r/areal_rainfall.R [FOLDER]     from the clone; writes into FOLDER, or a temporary one
suppressPackageStartupMessages(library(sf))
suppressPackageStartupMessages(library(terra))

program <- Sys.getenv("THIESSEN", "thiessen")
out <- commandArgs(trailingOnly = TRUE)
out <- if (length(out) > 0) out[1] else tempfile("thiessen")
inputs <- file.path("samples", "colorado", c("stations.csv", "counties.geojson", "rainfall.csv"))

thiessen <- function(...) {
  status <- system2(program, shQuote(c(...)))
  if (status != 0) stop("thiessen ended with ", status)
}

# 1. Everything, in one folder.
thiessen("run", inputs, "-o", out, "--basin-id", "name", "-q")

# 2. The cells are polygons with their weights.
cells <- st_read(file.path(out, "cells.geojson"), quiet = TRUE)
print(head(st_drop_geometry(cells[order(-cells$weight), c("basin", "station", "weight")]), 3), row.names = FALSE)

# Areas on the ellipsoid by s2 and lwgeom differ a little from each other; the program's are exact.
stopifnot(all(abs(tapply(cells$weight, cells$basin, sum) - 1) < 1e-12))

# 3. The series is a data frame: a row for each month, a column for each county.
rain <- read.csv(file.path(out, "rain.csv"), check.names = FALSE)
rain$time <- as.Date(paste0(rain$time, "-01"))
cat(nrow(rain), "months,", ncol(rain) - 1, "counties; the wettest month of Grand:",
    format(rain$time[which.max(rain$Grand)], "%Y-%m"), "\n")

# 4. A raster of each month, with its time, for whatever wants a grid.
grids <- file.path(out, "1988.nc")
thiessen("map", inputs, "-o", grids, "--steps", "--from", "1988-01", "--to", "1988-12", "--resolution", "0.1", "-q")
monthly <- rast(grids, subds = "rainfall")
print(time(monthly)[1:2])
stopifnot(nlyr(monthly) == 12)

# 5. A picture by sf.
png(file.path(out, "cells.png"), width = 900, height = 600)
plot(cells["weight"], main = "Weight of each gauge in its county", border = "white", lwd = 0.3)
invisible(dev.off())
