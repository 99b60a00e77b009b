#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/polygon.h"
#include "map/opencv/encoding.h"

namespace thiessen {

/// A cell, clipped to its basin, as the picture shows it.
struct PictureCell {
  MultiPolygon shape;
  std::size_t gauge =
      0;  ///< position in Picture::gauges of the cell's station: its colour by station
  double rainfall = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no reading
};

struct PictureBasin {
  std::string name;  ///< shown where it fits; may be empty
  MultiPolygon shape;
};

struct PictureGauge {
  Point position;
  std::string label;    ///< UTF-8, any script; may be empty
  bool reports = true;  ///< false: drawn hollow
};

/// What a picture shows, in the study's coordinates. Nothing in it depends on the order of its
/// lists but the choice of colours by station, ties among labels, and what covers what where
/// basins overlap.
struct Picture {
  std::vector<PictureCell> cells;
  std::vector<PictureBasin> basins;
  std::vector<PictureGauge> gauges;
  /// Coordinates are WGS 84 longitude and latitude in degrees; edges are straight in them and take
  /// the short way round, over the antimeridian too.
  bool geographic = false;
  /// Of a plane's coordinates; NaN: unknown, the scale bar then counts plain units.
  double metres_per_unit = std::numeric_limits<double>::quiet_NaN();
  /// Of a plane: whether north is up, so that an arrow may say so.
  bool north_is_up = true;
  /// Cells filled by rainfall, with a colour bar; else by station.
  bool by_rainfall = false;
  std::string title;
  std::string subtitle;  ///< such as "mean over 120 months"; may be empty
  std::string units;     ///< of the rainfall, such as "mm"; may be empty
  int width = 1600;      ///< of the picture, in pixels
  int height = 0;        ///< in pixels; 0: from the shape of the study area
};

/// A side of a picture has at least and at most this many pixels, and all of it this many.
inline constexpr int min_picture_side = 64;
inline constexpr int max_picture_side = 20'000;
inline constexpr long long max_picture_pixels = 100'000'000;

/// Throws Error, naming the limit, where a picture cannot have this size. Allocates nothing.
/// `height` 0 means: from the study area's shape, which then respects the limits.
void check_picture_size(int width, int height);

/// The bytes of a PNG or JPEG file that shows `picture`: cells filled by rainfall or station, cell
/// and basin outlines, gauges with their labels, title, colour bar, scale bar, north arrow.
///
/// A pixel of a cell belongs to the cell that its centre lies in. Areas of longitude and latitude
/// smaller than about a hemisphere are drawn in the ellipsoid's oblique stereographic projection
/// about their centre (conformal, north up at the centre), larger ones in plate carrée. Labels that
/// would overlap anything are left out, those of the smallest cells first, and the picture says how
/// many it shows. Fonts are found by fontconfig; what no font can show goes to `warnings`.
///
/// The same picture gives the same bytes on one machine, whatever the locale and the number of
/// threads. Throws Error where the size is outside the limits, a coordinate is not finite, no font
/// is installed, memory runs out or encoding fails.
/// Cost: proportional to the pixels, the vertices and the pixels along edges.
std::string encode_picture(const Picture& picture, PictureFormat format, Warnings& warnings);

}  // namespace thiessen
