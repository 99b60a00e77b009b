#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/colour.h"
#include "gdal/output/encoded_file.h"
#include "gdal/rasters/raster_colours.h"
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
  /// `values` are readings, or a sample of a surface's or a series' values with the least and the
  /// largest; NaN is none.
  RainfallStyle(const RainfallClasses& classes, std::span<const double> values, std::string unit);

  /// The classes from the lowest to the highest, each up to where the next begins, as a raster of
  /// floats holds values. The outer ones reach over all values. None where there is no value.
  const std::vector<RasterClass>& classes() const { return classes_; }
  /// The style for QGIS of the raster at `path`.
  EncodedFile file(const std::string& path) const;

 private:
  /// Classes between the bounds; the outer ones reach at least from `least` to `largest`.
  void lay_classes(const RainfallClasses& classes, double least, double largest);
  /// Entries by the classes' bounds, so that the style fits the rasters of a series alike.
  void lay_entries(const RainfallClasses& classes);
  /// What the legend says of class `index`.
  std::string label_of(const RainfallClasses& classes, std::size_t index) const;

  std::vector<RasterClass> classes_;
  std::vector<StyleEntry> entries_;
  std::string unit_;
};

}  // namespace thiessen::cli
