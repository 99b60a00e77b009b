#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/pixels.h"
#include "geometry/polygon.h"
#include "map/opencv/picture_tags.h"
#include "map/sheet/rainfall_classes.h"
#include "map/svg/svg_canvas.h"

namespace thiessen {

/// A cell, clipped to its basin, as the picture shows it.
struct PictureCell {
  MultiPolygon shape;
  std::size_t gauge = 0;  ///< position of the cell's station in Picture::gauges, which decides its
                          ///< colour by station
  double rainfall = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no reading
  std::size_t basin = 0;  ///< position of the cell's basin in Picture::basins
};

/// A basin, as the picture outlines and names it.
struct PictureBasin {
  std::string name;  ///< shown where it fits; may be empty
  MultiPolygon shape;
};

/// A gauge, as the picture marks and labels it.
struct PictureGauge {
  Point position;
  std::string label;      ///< UTF-8, any script; may be empty
  bool reports = true;    ///< false: drawn hollow
  std::string station{};  ///< the station's id, as a picture that can say so says it
};

/// The ground on which a surface lies between two levels, as the picture colours it.
struct PictureBand {
  MultiPolygon shape;
  double rainfall = 0;  ///< a value of its class
};

/// The lines of one level.
struct PictureIsohyet {
  std::string level;  ///< as the picture writes it
  std::vector<std::vector<Point>> lines;
};

/// All that a picture shows, in the study's coordinates. The order of its lists matters only to the
/// choice of colours by station, to ties among labels, and to what covers what where basins
/// overlap.
struct Picture {
  std::vector<PictureCell> cells;
  /// Where a surface is shown, its bands are filled and not the cells, which still say how many
  /// gauges share the ground and which classes their rainfall has.
  std::vector<PictureBand> bands;
  /// Values of the surface, evenly from all the study area, with the least and the largest: its
  /// classes are of these. Empty: cells are shown.
  std::vector<double> surface;
  std::vector<PictureIsohyet> isohyets;
  std::vector<PictureBasin> basins;
  std::vector<PictureGauge> gauges;
  /// Whether coordinates are WGS 84 longitude and latitude in degrees. Edges are straight in them
  /// and take the short way round, over the antimeridian too.
  bool geographic = false;
  /// The length of a plane's unit in metres; NaN where it is unknown: the scale bar then counts
  /// plain units.
  double metres_per_unit = std::numeric_limits<double>::quiet_NaN();
  /// Whether north is up in a plane, so that an arrow may say so.
  bool north_is_up = true;
  /// Whether the basins were given, and are not the surroundings of the gauges.
  bool has_basins = true;
  /// Whether cells are filled by rainfall, with a colour bar, and not by station.
  bool by_rainfall = false;
  ClassRule classes;
  std::string title;
  std::string subtitle;  ///< such as "mean over 120 months"; may be empty
  std::string units;     ///< of the rainfall, such as "mm"; may be empty
  PictureTags tags;      ///< what the file says of how it was made
  /// The density that the file tells a printer; 0: none. An SVG has its size on paper by it.
  int dots_to_the_inch = 0;
  PaperSize paper;  ///< as it was asked for, which whole pixels may miss by a little; 0: it was not
  int width = 1600;  ///< width of the picture, in pixels
  int height = 0;    ///< in pixels; 0: chosen by the shape of the study area
};

/// The classes of the rainfall that all maps show: of each gauge that has a cell, once a map, or of
/// a surface; none where cells are not filled by rainfall. The rule is that of the last map.
RainfallClasses classes_of(std::span<const Picture> maps);
RainfallClasses classes_of(const Picture& picture);

/// Warns of rainfall outside of a range that was asked for: of gauges, or anywhere on a surface or
/// in a series.
void warn_of_outside(const RainfallClasses& classes, bool is_of_gauges, Warnings& warnings);

/// The limits of a picture's side, and of its area, in pixels.
inline constexpr int min_picture_side = 64;
inline constexpr int max_picture_side = 20'000;
inline constexpr long long max_picture_pixels = 100'000'000;
/// The largest density that a picture can tell a printer.
inline constexpr int max_dots_to_the_inch = 10'000;

/// Throws Error, naming the limit, where a picture cannot have this size. Allocates nothing. A
/// `height` of 0 is chosen later by the study area's shape, and then respects the limits.
void check_picture_size(int width, int height);

enum class PictureFormat { png, jpeg, svg };

/// Throws Error where the system has no room for what drawing such a picture takes, before any of
/// it is taken: a picture that cannot be drawn is then refused at once, and not after hours. Where
/// the height is not known yet, and of an SVG, which has no pixels, there is nothing to say.
void check_picture_memory(int width, int height, PictureFormat format);

/// Draws `picture` and has it encoded as the bytes of a PNG, JPEG or SVG file (which needs no
/// encoder): cells filled by rainfall or station, outlines of cells and basins, gauges with their
/// labels, title, colour bar, scale bar, north arrow.
///
/// Areas of longitude and latitude smaller than
/// about a hemisphere are drawn in the ellipsoid's oblique stereographic projection about their
/// centre (conformal, north up at the centre), larger ones in plate carrée. Labels that would
/// overlap anything are left out, those of the smallest cells first, and the picture says how many
/// it shows. Fonts are found by fontconfig; characters that no font can show are told in
/// `warnings`.
///
/// The same picture gives the same bytes on one machine, whatever the locale and the number of
/// threads. Throws Error where the size is outside the limits, a coordinate is not finite, no font
/// is installed, memory runs out or encoding fails. Cost: proportional to the pixels, the vertices
/// and the pixels along edges.
std::string encode_picture(const Picture& picture, PictureFormat format, ImageEncoder encoder,
                           Warnings& warnings);

}  // namespace thiessen
