#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "basin/basin.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"
#include "rainfall/network/step_rainfall.h"
#include "rainfall/network/weights.h"

/// \file
/// The library's face: Thiessen weights, cells and areal rainfall of data in memory. It owns what
/// it is given, checks it, and refuses what it cannot use in the same words as the program. The
/// rooms below it state requirements; the checks that keep them stand here.
///
///     thiessen::ThiessenInput input;
///     input.stations = {{"a", {0, 0}}, {"b", {4, 0}}};
///     input.basins = {{"B", {{{{-1, -1}, {5, -1}, {5, 1}, {-1, 1}}, {}}}, {}}};
///     const thiessen::Thiessen study(input);
///     for (const auto& gauge : study.weights()[0].stations)
///       std::cout << study.stations()[thiessen::index(gauge.station)].id << gauge.weight;
///
/// samples/library/textbook.cpp is a whole program. What is by basin has the order of basins();
/// thiessen::index() makes a number of a StationIndex, the position in stations().

namespace thiessen {

/// The gauges and study areas of a study in memory, and how they are to be measured.
struct ThiessenInput {
  /// The gauges; no two have the same id. Their positions are coordinates of a plane, or WGS 84
  /// longitude and latitude in degrees, as `metric` says.
  std::vector<Station> stations;
  /// The study areas. Where there are none, the extent of the gauges is the study area. Rings run
  /// in any direction, and may repeat their first point as their last. Basin::bulges are computed,
  /// not given.
  std::vector<Basin> basins;
  /// **Planar unless said otherwise**: longitude and latitude need Metric::geodesic.
  Metric metric = Metric::planar;
  double metres_per_unit = 1;  ///< length of the plane's unit, in metres, from 1e-9 to 1e9
  /// Percent, to 1,000, by which the extent of the gauges is grown where there are no basins.
  double margin = 0;
  /// Metres, from 0.001 to 1e6, that an edge of a cell may lie from the true one.
  double tolerance = 0.1;
  /// Normals, or none: a long-term mean at each station and over each basin (over the study area,
  /// where there are no basins), all above 0 and in one unit, whichever it is. A reading counts
  /// times the basin's normal over the gauge's, which is StationWeight::factor. Where calendar
  /// months have normals of their own, each wants a Thiessen.
  std::vector<double> station_normals;
  std::vector<double> basin_normals;
  /// Whether basins that cross themselves are mended by union, with a warning that names the ground
  /// in dispute, instead of refused.
  bool mend = false;
  /// Whether gauges and basins may be nowhere near each other, farther apart than five times the
  /// longer diagonal of the two extents and than 300 km.
  bool allow_far = false;
};

/// A network of gauges, and the weight of each in every basin. Safe for several threads at once.
/// Numbers are rounded to the nearest, whatever mode the caller has set (std::fesetround), which is
/// set again afterwards.
class Thiessen {
 public:
  /// Checks the input, mends what can be mended (repeated points, spikes, parts that share an edge,
  /// rings that barely cross themselves), each with a warning, and computes the weights. Throws
  /// Error with every fault: no station, a station without an id, an id given twice, a coordinate
  /// that is not a number, is no degree where it has to be one, or lies outside the exact range of
  /// predicates.h; a basin that has no area, crosses itself, or has an edge of more than 180 to 270
  /// degrees of longitude; stations without extent and no basin; gauges and basins nowhere near
  /// each other; normals that are not one for each, or not above 0. Warns of basins far from every
  /// gauge. Cost: n log n in the stations and in the vertices of the basins.
  explicit Thiessen(ThiessenInput input, unsigned threads = 1);
  ~Thiessen();
  Thiessen(Thiessen&&) noexcept;
  Thiessen& operator=(Thiessen&&) noexcept;

  /// Warnings of what was assumed, turned or mended in the input.
  const std::vector<Message>& warnings() const;
  /// The gauges in the order in which they were given, with longitudes brought into [-180, 180].
  const std::vector<Station>& stations() const;
  /// The basins after mending: outer rings counter-clockwise, holes clockwise, no point repeated.
  const std::vector<Basin>& basins() const;

  /// The weights of all gauges, for each basin. Areas are in square metres, of a plane by
  /// `metres_per_unit`.
  const std::vector<BasinWeights>& weights() const;
  /// The weights of the gauges that report, for each basin. `reports` has one entry a station.
  /// Throws Error where it has more or fewer. Where none reports, no basin has weights.
  std::vector<BasinWeights> weights(const std::vector<bool>& reports) const;
  /// The cells of all gauges clipped to each basin, in the coordinates of the study.
  std::vector<std::vector<StationCell>> cells() const;
  /// The areal rainfall of each basin for one reading a station. A gauge is silent where its
  /// reading is NaN: its cell is then shared out among its neighbours. Throws Error where there are
  /// more or fewer readings than stations. The rainfall is NaN where all gauges are silent; no
  /// standard error is computed. Cost: the gauges and the weights; for silent gauges not
  /// met before, the cells of their neighbours too.
  std::vector<BasinRainfall> rainfall(std::span<const double> readings) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace thiessen
