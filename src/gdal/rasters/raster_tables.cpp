#include "gdal/rasters/raster_tables.h"

namespace thiessen {

void add_colour_columns(GDALDefaultRasterAttributeTable& table) {
  table.CreateColumn("red", GFT_Integer, GFU_Red);
  table.CreateColumn("green", GFT_Integer, GFU_Green);
  table.CreateColumn("blue", GFT_Integer, GFU_Blue);
}

void set_colour(GDALDefaultRasterAttributeTable& table, int row, const Colour& colour) {
  constexpr int red = 2;
  table.SetValue(row, red, int{colour.red});
  table.SetValue(row, red + 1, int{colour.green});
  table.SetValue(row, red + 2, int{colour.blue});
}

GDALDefaultRasterAttributeTable table_of(std::span<const RasterClass> classes) {
  GDALDefaultRasterAttributeTable table;
  table.SetTableType(GRTT_ATHEMATIC);
  table.CreateColumn("low", GFT_Real, GFU_Min);
  table.CreateColumn("high", GFT_Real, GFU_Max);
  add_colour_columns(table);
  int row = 0;
  for (const RasterClass& c : classes) {
    table.SetRowCount(row + 1);
    table.SetValue(row, 0, c.low);
    table.SetValue(row, 1, c.high);
    set_colour(table, row, c.colour);
    ++row;
  }
  return table;
}

}  // namespace thiessen
