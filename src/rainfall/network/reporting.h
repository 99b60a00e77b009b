#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// Which stations of a network report, or which of its places, in one bit each. Stations and places
/// have types of their own here, for a network has fewer places than stations as soon as two gauges
/// share one.
template <typename Index>
class Reporting {
 public:
  Reporting() = default;
  /// Makes `count` entries, all of which report or none.
  Reporting(std::size_t count, bool report) : bits_(count, report) {}
  /// Makes one entry for each bit, in the order of the indices.
  Reporting(std::initializer_list<bool> bits) : bits_(bits) {}
  explicit Reporting(std::vector<bool> bits) : bits_(std::move(bits)) {}

  std::size_t size() const { return bits_.size(); }
  bool empty() const { return bits_.empty(); }
  bool operator[](Index i) const { return bits_[index(i)]; }
  void set(Index i, bool reports) { bits_[index(i)] = reports; }
  /// Whether at least one reports. Cost: linear.
  bool any() const { return std::find(bits_.begin(), bits_.end(), true) != bits_.end(); }

  friend bool operator==(const Reporting& a, const Reporting& b) = default;

  struct Hash {
    std::size_t operator()(const Reporting& r) const {
      return std::hash<std::vector<bool>>{}(r.bits_);
    }
  };

 private:
  std::vector<bool> bits_;
};

using ReportingStations = Reporting<StationIndex>;
using ReportingPlaces = Reporting<PlaceIndex>;

/// The stations that report. `readings` has one entry for each station, NaN where it is silent.
ReportingStations reporting_stations(std::span<const double> readings);

/// The places at which at least one station reports.
ReportingPlaces reporting_places(const Network& network, std::span<const double> readings);

}  // namespace thiessen
