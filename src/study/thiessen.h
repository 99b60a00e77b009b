#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "basin/basin.h"
#include "earth/yardstick.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/network.h"
#include "rainfall/weights.h"

/// \file
/// The library's face: Thiessen weights, cells and areal rainfall of data in memory. It owns what
/// it is given, checks it, and refuses what it cannot use with the words of the program. Rooms
/// below it only require what it checks.

namespace thiessen {

struct ThiessenInput {
  /// Gauges; ids differ. Coordinates: of the plane, or WGS 84 longitude and latitude in degrees.
  std::vector<Station> stations;
  /// Study areas; none: the extent of the gauges. Rings run in any direction, and may repeat their
  /// first point as their last. Basin::bulges are computed, not given.
  std::vector<Basin> basins;
  Metric metric = Metric::planar;
  double metres_per_unit = 1;  ///< of the plane
  double margin = 0;           ///< percent, by which the extent is grown
  double tolerance = 0.1;      ///< metres that an edge of a cell may lie from the true one
};

/// A network of gauges weighed in basins. Safe for several threads at once.
class Thiessen {
 public:
  /// Mends what can be mended (repeated points, spikes, rings that barely cross themselves), each
  /// with a warning. Throws Error with every fault: no station, an id that is missing or there
  /// twice, a coordinate that is no number, no degree where it has to be one, or outside the exact
  /// range of predicates.h; a basin that has no area or crosses itself; stations without extent and
  /// no basin. Cost: n log n in the stations and in the basins' vertices.
  explicit Thiessen(ThiessenInput input, unsigned threads = 1);
  ~Thiessen();
  Thiessen(Thiessen&&) noexcept;
  Thiessen& operator=(Thiessen&&) noexcept;

  /// What was assumed, turned or mended.
  const std::vector<Message>& warnings() const;
  /// As they were given, longitudes in [-180, 180].
  const std::vector<Station>& stations() const;
  /// Mended: outer rings counter-clockwise, holes clockwise, no point repeated.
  const std::vector<Basin>& basins() const;

  /// By basin: the weights of all gauges. Areas are in square metres.
  const std::vector<BasinWeights>& weights() const;
  /// The same of the gauges that report. `reports`: one entry a station. Throws Error where there
  /// are more or fewer.
  std::vector<BasinWeights> weights(const std::vector<bool>& reports) const;
  /// By basin: the cells within it, in the coordinates of the study.
  std::vector<std::vector<StationCell>> cells() const;
  /// By basin: the areal rainfall of readings, one a station, NaN where a gauge is silent: its cell
  /// is shared out among its neighbours. Throws Error where there are more or fewer readings.
  /// Cost: the gauges and the weights; for silent gauges not met before, their neighbours' cells.
  std::vector<BasinRainfall> rainfall(std::span<const double> readings) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace thiessen
