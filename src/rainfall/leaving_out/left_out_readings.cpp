#include "rainfall/leaving_out/left_out_readings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rainfall/network/mean_reading.h"
#include "rainfall/normals/relative_readings.h"

namespace thiessen {
namespace {

constexpr std::size_t kept_at_most = 24;

}  // namespace

LeftOutReadings::LeftOutReadings(const Network& network, Metric metric, const NormalField* normals,
                                 ElevationBands bands)
    : network_(network),
      normals_(normals),
      bands_(std::move(bands)),
      nearest_(network.places(), metric),
      kept_(std::min(kept_at_most, network.places().size() - 1)),
      by_band_(bands_.size()) {
  near_.reserve(kept_ * network.places().size());
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    nearest_.find(network.places()[p], kept_ + 1, {}, found_);
    for (std::size_t i = 1; i <= kept_; ++i) near_.push_back(found_[i].place);
  }
}

std::optional<PlaceIndex> LeftOutReadings::nearest_that_reports(PlaceIndex place,
                                                                std::span<const double> by_place) {
  const auto reports = [&](PlaceIndex p) { return !std::isnan(by_place[index(p)]); };
  for (const PlaceIndex p : std::span(near_).subspan(index(place) * kept_, kept_)) {
    if (reports(p)) return p;
  }
  if (kept_ + 1 == by_place.size()) return std::nullopt;
  ReportingPlaces others(by_place.size(), false);
  for (std::uint32_t p = 0; p < by_place.size(); ++p)
    others.set(PlaceIndex{p}, PlaceIndex{p} != place && reports(PlaceIndex{p}));
  nearest_.find(network_.places()[index(place)], 1, others, found_);
  return found_.empty() ? std::nullopt : std::optional(found_.front().place);
}

void LeftOutReadings::add(std::span<const double> readings, const NormalMonth& month) {
  const std::vector<double> by_place = readings_by_place(network_, readings);
  std::vector<double> relative;
  if (normals_ != nullptr)
    relative = readings_by_place(network_, relative_readings(normals_, readings, month));
  for (std::uint32_t s = 0; s < readings.size(); ++s) {
    if (std::isnan(readings[s])) continue;
    const StationIndex station{s};
    const auto nearest = nearest_that_reports(network_.place_of(station), by_place);
    if (!nearest) continue;
    const auto add_to = [&](Errors& errors) {
      errors.plain.add(by_place[index(*nearest)] - readings[s]);
      if (normals_ == nullptr) return;
      const double normal =
          normal_without(*normals_, station, month) / reference_normal(*normals_, month);
      errors.with_normals.add(relative[index(*nearest)] * normal - readings[s]);
    };
    add_to(all_);
    if (const auto band = bands_.of(s)) add_to(by_band_[*band]);
  }
}

}  // namespace thiessen
