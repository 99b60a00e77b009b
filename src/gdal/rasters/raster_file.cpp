#include "gdal/rasters/raster_file.h"

#include <gdal_rat.h>

#include <algorithm>
#include <stdexcept>

#include "gdal/rasters/geotiff_writer.h"
#include "gdal/rasters/raster_tables.h"

namespace thiessen {
namespace {

/// Writes the first band, a row of tiles at a time.
template <typename Rows>
void write_band(GeoTiffWriter& writer, const PixelGrid& grid, const Rows& rows) {
  const int step = writer.rows_of_tiles();
  for (int row = 0; row < grid.rows; row += step) {
    const int count = std::min(step, grid.rows - row);
    const auto pixels = rows(row, count);
    if (pixels.size() != static_cast<std::size_t>(count) * static_cast<std::size_t>(grid.columns)) {
      throw std::logic_error("the pixels do not fill their rows");
    }
    writer.write(1, row, count, pixels.data());
  }
}

/// Tells which numbers occur: entry 0 is of the pixels outside.
void note_owners(std::span<const std::int32_t> owners, std::vector<bool>& is_owner) {
  std::int32_t last = 0;
  for (const std::int32_t owner : owners) {
    if (owner == last) continue;
    is_owner[static_cast<std::size_t>(owner)] = true;
    last = owner;
  }
}

/// `colours` is empty or has the colour of each station.
GDALDefaultRasterAttributeTable table_of(const std::vector<std::string>& ids,
                                         const std::vector<bool>& is_owner,
                                         const std::vector<Colour>& colours) {
  GDALDefaultRasterAttributeTable table;
  table.CreateColumn("value", GFT_Integer, GFU_MinMax);
  table.CreateColumn("station", GFT_String, GFU_Name);
  if (!colours.empty()) add_colour_columns(table);
  int row = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!is_owner[i + 1]) continue;
    table.SetRowCount(row + 1);
    table.SetValue(row, 0, static_cast<int>(i) + 1);
    table.SetValue(row, 1, ids[i].c_str());
    if (!colours.empty()) set_colour(table, row, colours[i]);
    ++row;
  }
  return table;
}

}  // namespace

std::vector<EncodedFile> owners_geotiff(const RasterOutput& output, const OwnerRows& owners,
                                        const std::vector<std::string>& station_ids,
                                        const StationColours& colours) {
  GeoTiffWriter writer(output, GeoTiffWriter::Pixels::numbers, 1);
  writer.describe(1, {"station", "", ""});
  std::vector<bool> is_owner(station_ids.size() + 1, false);
  write_band(writer, output.grid, [&](int row, int count) {
    const auto some = owners(row, count);
    note_owners(some, is_owner);
    return some;
  });
  writer.set_table(table_of(station_ids, is_owner, colours ? colours() : std::vector<Colour>()));
  return writer.finish();
}

std::vector<EncodedFile> rainfall_geotiff(const RasterOutput& output, const ValueRows& values,
                                          const BandText& text, const RasterClasses& classes) {
  GeoTiffWriter writer(output, GeoTiffWriter::Pixels::rainfall, 1);
  writer.describe(1, text);
  write_band(writer, output.grid, values);
  const std::vector<RasterClass> found = classes ? classes() : std::vector<RasterClass>();
  if (!found.empty()) writer.set_table(table_of(found));
  return writer.finish();
}

}  // namespace thiessen
