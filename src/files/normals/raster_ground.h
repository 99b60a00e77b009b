#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/study_files.h"
#include "gdal/crs/transformation.h"
#include "gdal/rasters/raster_source.h"
#include "geometry/box.h"
#include "rainfall/normals/raster_normals.h"
#include "study/study.h"

namespace thiessen {

/// Where a basin lies in a raster: whole columns and rows, as far as the raster has them. Where the
/// raster goes all round the Earth columns run on beyond its sides.
struct RasterFrame {
  struct Range {
    double first = 0;
    double last = 0;
    bool is_whole = true;  ///< whether the raster has all of it
    double count() const { return last - first; }
  };
  Range columns;
  Range rows;
  double shift = 0;  ///< how many columns the study's longitudes were moved to lie in the raster
  /// How many columns and rows of the raster make one of the window: blocks of pixels may stand for
  /// them where they are many. The last block may reach beyond the range.
  std::size_t block_columns = 1;
  std::size_t block_rows = 1;

  bool holds_all() const { return columns.is_whole && rows.is_whole; }
  std::size_t window_columns() const { return blocks(columns, block_columns); }
  std::size_t window_rows() const { return blocks(rows, block_rows); }

 private:
  static std::size_t blocks(const Range& range, std::size_t pixels) {
    return (static_cast<std::size_t>(range.count()) + pixels - 1) / pixels;
  }
};

/// A raster under a study, in its own CRS: which of its pixels hold the gauges, which a basin
/// needs, and how large they are. Positions in it are in pixels from its upper left corner.
///
/// Pixels are measured as the study measures areas: see normals_of_raster. Not safe for two threads
/// at once.
class RasterGround {
 public:
  /// The study must outlive it. A raster without a CRS has that of the basins, with a warning.
  /// Throws Error where the file is no raster of this machine.
  RasterGround(const std::string& file, const Study& study, const StudyFiles& files,
               Warnings& warnings);

  const RasterSource& source() const { return source_; }
  /// The pixel that holds each station; nothing where none does. Throws Error where all stations
  /// lie elsewhere.
  std::vector<std::optional<RasterPart>> pixels_of_stations() const;
  /// The values of a pixel, band by band; NaN where there are none.
  std::vector<double> at_pixel(const std::optional<RasterPart>& pixel) const;
  /// The values at each station, band by band; NaN where there is none. All stations may lie
  /// elsewhere.
  std::vector<std::vector<double>> at_stations() const;
  /// Where a basin lies; nothing where it lies outside, with a complaint. Throws Error where it has
  /// too many pixels.
  std::optional<RasterFrame> frame_of(std::size_t basin, Complaints& complaints) const;
  /// Has blocks of at most so many pixels stand for them in the window of a basin, where it has
  /// more than `enough_blocks` pixels along a side.
  void set_blocks(RasterFrame& frame, double most_columns, double most_rows) const;
  static constexpr double enough_blocks = 128;
  /// All values of a frame, pixel by pixel.
  WindowValues values_of(const RasterFrame& frame) const;
  /// Reads as many rows of a frame as `values` has, from its row `row` on.
  void read(const RasterFrame& frame, std::size_t row, WindowValues& values) const;
  /// The window of a basin with these values of its frame, block by block; `references` has one for
  /// each band.
  NormalWindow window(std::size_t basin, const RasterFrame& frame, WindowValues values,
                      const std::vector<double>& references) const;
  /// The share of a basin's ground on which `marks` has values.
  double share_of(std::size_t basin, const RasterFrame& frame, WindowValues marks) const;
  /// The mapping from the study to the blocks of a frame, counted from its corner.
  std::unique_ptr<const PixelMapping> mapping_of(const Basin& basin,
                                                 const RasterFrame& frame) const;
  /// Brings positions in pixels to the study's coordinates. On the Earth their longitudes may be
  /// any turn of the true one.
  std::vector<Point> to_study(std::vector<Point> positions) const;
  /// Brings points of the study to pixels; longitudes run on as those of the study.
  std::vector<Point> to_pixels(std::vector<Point> points) const;
  /// A basin in the words of messages.
  std::string place_of(std::size_t basin) const;
  /// Warns of basins that are not covered whole, refuses those that are not at all; `what` is what
  /// they lack, in the plural.
  void judge_cover(const NormalField& normals, const std::string& what, Warnings& warnings) const;

 private:
  bool on_earth() const { return files_.metric == Metric::geodesic; }
  bool is_along_axes() const { return source_.transform()[2] == 0 && source_.transform()[4] == 0; }
  /// Whether the raster's coordinates are degrees, one way or another.
  bool in_degrees() const { return crs_ && crs_->geographic(); }
  void settle_crs(Warnings& warnings);
  /// Where the basins and the gauges lie, in degrees.
  Box extent() const;
  Point pixel_of(Point p) const;
  /// A turn of longitude in columns; 0 where the raster is not in degrees.
  double columns_of_turn() const;
  bool goes_round() const;
  /// By how many turns a range of columns is to be moved to lie in the raster as far as it can.
  double turns_to(double first, double last) const;
  /// The stations' positions in pixels.
  std::vector<Point> stations_in_pixels() const;
  /// The pixel that holds a position; nothing where none does.
  std::optional<RasterPart> pixel_that_holds(Point at) const;
  /// The raster's coordinates of a position in pixels.
  Point position_of(Point pixel) const;
  /// Says that all stations, which are at these positions in pixels, lie elsewhere.
  [[noreturn]] void throw_elsewhere(const std::vector<Point>& stations) const;
  /// The mapping to the raster's own pixels; null where the projection does not reach.
  std::unique_ptr<const PixelMapping> mapping_of(const Basin& basin) const;
  /// The mapping to blocks of pixels counted from a corner.
  std::unique_ptr<const PixelMapping> shifted(const Basin& basin, Point corner, Point block) const;
  std::unique_ptr<const PixelAreas> areas_of(const RasterFrame& frame) const;
  /// The areas of a block of pixels round each of these positions.
  std::vector<double> areas_at(const std::vector<Point>& positions, Point block,
                               const Surface& surface) const;

  RasterSource source_;
  const Study& study_;
  const StudyFiles& files_;
  std::optional<Crs> crs_;
  std::array<double, 4> inverse_{};
  bool keeps_turns_ = true;
  bool is_same_ = true;
  std::optional<Transformation> forth_;
  std::optional<Transformation> back_;
};

/// A share of ground for a message: `3.1 %`.
std::string percent_of_ground(double share);

}  // namespace thiessen
