#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "geometry/point.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_length.h"
#include "results/provenance.h"

namespace thiessen {

/// What a series of areal rainfall is, whatever the format in which a model reads it.
struct ModelSubject {
  std::vector<std::string> basins;  ///< their ids, in the order of their values in a step
  /// The centroids of the basins, longitude and latitude in degrees; empty where they are not known
  /// on the Earth.
  std::vector<Point> centroids;
  std::string unit = "mm";  ///< of the values
  int decimals = 3;         ///< of the values, where they are written as text
  Provenance made_by;
  /// The length of the steps where it is known beforehand, as of periods that are summed over.
  std::optional<StepLength> step = {};
  /// When days begin that are summed over, in seconds after midnight: each has the date of that.
  std::int64_t day_start = 0;
  Stamp stamp = Stamp::begin;  ///< what the times of steps with a clock are
  std::string rainfall;        ///< the file of the readings, for messages
  std::string output;          ///< the file that is written, for messages
};

/// Areal rainfall as the input of a model. Each format is a class; what it cannot hold it refuses
/// with an Error, so that nothing is lost in silence.
class ModelSeries {
 public:
  virtual ~ModelSeries() = default;
  /// Adds the next step: the rainfall of each basin, NaN where there is none. `errors` are the
  /// standard errors, empty where none were asked for.
  virtual void add(const IsoTime& time, std::span<const double> rainfall,
                   std::span<const double> errors) = 0;
  /// Writes what is still held, and says what had to be assumed. No step may be added afterwards.
  virtual void finish(Warnings& warnings) = 0;
};

}  // namespace thiessen
