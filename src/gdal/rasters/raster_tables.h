#pragma once

#include <gdal_rat.h>

#include <span>

#include "base/colour.h"
#include "gdal/rasters/raster_colours.h"

namespace thiessen {

/// Adds columns of colours to a table that has two others.
void add_colour_columns(GDALDefaultRasterAttributeTable& table);

/// Sets the colour of a row.
void set_colour(GDALDefaultRasterAttributeTable& table, int row, const Colour& colour);

/// The attribute table of classes: their ends and their colours.
GDALDefaultRasterAttributeTable table_of(std::span<const RasterClass> classes);

}  // namespace thiessen
