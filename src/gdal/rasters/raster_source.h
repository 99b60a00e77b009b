#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "geometry/point.h"
#include "rainfall/normals/window_values.h"

namespace thiessen {

/// A part of a raster, in pixels from its upper left corner.
struct RasterPart {
  std::size_t column = 0;
  std::size_t row = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/// A raster of numbers that GDAL reads, of this machine.
class RasterSource {
 public:
  /// Throws Error where the file is missing, is no raster, is cut off, or tells nothing of where
  /// its pixels lie.
  explicit RasterSource(const std::string& file);
  ~RasterSource();
  RasterSource(RasterSource&&) noexcept;
  RasterSource& operator=(RasterSource&&) noexcept;

  const std::string& file() const { return file_; }
  std::size_t columns() const;
  std::size_t rows() const;
  /// The number of bands, without one that tells which pixels count.
  std::size_t bands() const;
  const std::optional<Crs>& crs() const { return crs_; }
  /// The raster's coordinates of a position in pixels: x is [0] + column [1] + row [2], y is [3] +
  /// column [4] + row [5].
  const std::array<double, 6>& transform() const { return transform_; }
  /// The files of it that are texts of lines: see texts_of_raster.
  std::vector<std::string> texts() const;
  /// The unit that the first band names for its values; empty where it names none.
  std::string unit() const;
  /// Whether the values of some band need eight bytes.
  bool is_wide() const;
  /// Reads all bands of a part of the raster into `values`, from its column `at` on. Values that
  /// are not there are left as they are. Throws Error where GDAL cannot.
  void read(const RasterPart& part, WindowValues& values, std::size_t at) const;

 private:
  struct Held;
  std::string file_;
  std::optional<Crs> crs_;
  std::array<double, 6> transform_{};
  std::unique_ptr<Held> held_;
};

}  // namespace thiessen
