#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/colour.h"
#include "gdal/output/encoded_file.h"
#include "gdal/output/raster_colours.h"
#include "map/sheet/palette.h"
#include "map/sheet/qgis_style.h"
#include "map/sheet/rainfall_classes.h"

namespace thiessen::cli {

/// Colours for the stations whose numbers a raster holds, so that neighbours differ. The pixels are
/// noted as they are written, row by row from the north. Where more stations than `most_chosen` own
/// a pixel, colours follow their numbers instead, for a colour of each would take megabytes.
class StationStyle {
 public:
  static constexpr std::size_t most_chosen = 10'000;

  /// `columns` is the number of pixels in a row.
  StationStyle(std::vector<std::string> ids, int columns);

  const std::vector<std::string>& ids() const { return ids_; }
  /// Notes which numbers lie beside each other in these rows, and in the last row before them.
  void note(std::span<const std::int32_t> rows);
  /// How many stations own a pixel of the rows noted so far.
  std::size_t owners() const;
  /// Chooses the colours of all stations; none where colours follow numbers. To be called when all
  /// rows are noted.
  const std::vector<Colour>& colours();
  /// The style for QGIS of the raster at `path`: the stations that own a pixel.
  EncodedFile file(const std::string& path) const;

 private:
  void touch(std::int32_t a, std::int32_t b);

  std::vector<std::string> ids_;
  std::size_t columns_;
  std::vector<std::int32_t> last_row_;
  std::vector<bool> owns_;  ///< by a station's number; entry 0 is of pixels outside
  TouchingPairs pairs_;
  std::vector<Colour> colours_;
};

/// The colours of rainfall in a raster: those that a picture of the same readings has.
class RainfallStyle {
 public:
  /// The style of cells, whose `readings` are by station, NaN where there is none.
  RainfallStyle(const RainfallClasses& classes, std::span<const double> readings, std::string unit);
  /// The style of a surface, whose values lie anywhere between the readings; no value is of one
  /// class alone.
  RainfallStyle(const RainfallClasses& classes, std::string unit);

  /// The readings of one colour lie between a class's ends, as a raster of floats holds them.
  const std::vector<RasterClass>& classes() const { return classes_; }
  /// The style for QGIS of the raster at `path`.
  EncodedFile file(const std::string& path) const;

 private:
  /// Entries by the classes' bounds, so that the style fits the rasters of a series alike.
  void lay_entries(const RainfallClasses& classes);
  StyleEntry entry(const RasterClass& c) const;

  std::vector<RasterClass> classes_;
  std::vector<StyleEntry> entries_;
  std::string unit_;
};

}  // namespace thiessen::cli
