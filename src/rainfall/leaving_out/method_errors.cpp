#include "rainfall/leaving_out/method_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rainfall/leaving_out/gauge_groups.h"
#include "rainfall/network/mean_reading.h"
#include "rainfall/normals/relative_readings.h"

namespace thiessen {
namespace {

std::vector<std::size_t> by_station(const Network& network,
                                    const std::vector<std::size_t>& by_place) {
  std::vector<std::size_t> values;
  for (std::uint32_t s = 0; s < network.stations().size(); ++s)
    values.push_back(by_place[index(network.place_of(StationIndex{s}))]);
  return values;
}

}  // namespace

std::vector<TriedMethod> tried_methods(const NormalField* normals) {
  std::vector<TriedMethod> methods;
  for (const PointMethod method : point_methods) {
    methods.push_back({method, false});
    if (normals != nullptr) methods.push_back({method, true});
  }
  return methods;
}

MethodErrors::MethodErrors(const Network& network, Metric metric, const std::vector<Basin>& basins,
                           const NormalField* normals, std::size_t stretches)
    : network_(network),
      normals_(normals),
      methods_(tried_methods(normals)),
      estimates_(network, metric, basins),
      squares_(methods_.size(), GaugeGroups(network).count, stretches),
      stations_(network.stations().size() * methods_.size()),
      read_in_year_(network.stations().size()),
      told_(methods_.size(), std::vector<double>(network.places().size())),
      of_reading_(methods_.size()) {
  group_of_ = by_station(network, GaugeGroups(network).of_place);
  for (const NormalMonth& month : months_of(normals)) {
    normals_told_.emplace_back();
    for (std::uint32_t s = 0; s < network.stations().size(); ++s) {
      normals_told_.back().push_back(normal_without(*normals, StationIndex{s}, month) /
                                     reference_normal(*normals, month));
    }
  }
}

/// Adds what some work costs to the seconds of methods, so many times as the step stands for.
template <typename Work>
void MethodErrors::timed(std::size_t times, std::initializer_list<PointMethod> methods,
                         const Work& work) {
  if (times == 0) return work();
  const double before = thread_seconds();
  work();
  const double seconds = static_cast<double>(times) * (thread_seconds() - before);
  for (const PointMethod method : methods) seconds_[static_cast<std::size_t>(method)] += seconds;
}

/// Tells all places by all methods. Their time is taken without normals, for it is the same with
/// them; what natural and linear share counts for both.
void MethodErrors::tell_all(const LeftOutStep& step) {
  const std::vector<double> values = readings_by_place(network_, step.readings);
  std::vector<double> relative;
  if (normals_ != nullptr)
    relative = readings_by_place(network_, relative_readings(normals_, step.readings, step.month));
  estimates_.report(reporting_places(network_, step.readings));
  const std::size_t times = timed_steps_.next();
  timed(times, {PointMethod::natural, PointMethod::linear}, [&] { estimates_.tessellate(); });
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    const PointMethod method = methods_[m].method;
    const bool with_normals = methods_[m].with_normals;
    timed(with_normals ? 0 : times, {method},
          [&] { estimates_.tell(method, with_normals ? relative : values, told_[m]); });
  }
}

void MethodErrors::take(std::size_t station, const LeftOutStep& step) {
  const std::size_t place =
      index(network_.place_of(StationIndex{static_cast<std::uint32_t>(station)}));
  const double reading = step.readings[station];
  if (std::isnan(told_.front()[place])) return;
  ++readings_;
  if (step.year) {
    read_in_year_[station].sum += reading;
    read_in_year_[station].has_any = true;
  }
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    double told = told_[m][place];
    if (methods_[m].with_normals) told *= normals_told_[place_of(normals_, step.month)][station];
    AtStation& sums = at(station, m);
    sums.errors.steps.add(told - reading);
    if (step.year) sums.told_in_year += told;
    of_reading_[m] = (told - reading) * (told - reading);
  }
  squares_.add(group_of_[station], step.stretch, of_reading_);
}

void MethodErrors::add(const LeftOutStep& step) {
  if (step.year != year_) finish();
  year_ = step.year;
  tell_all(step);
  for (std::size_t s = 0; s < step.readings.size(); ++s) {
    if (!std::isnan(step.readings[s])) take(s, step);
  }
}

void MethodErrors::finish() {
  for (std::size_t s = 0; s < read_in_year_.size(); ++s) {
    if (!read_in_year_[s].has_any) continue;
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      AtStation& sums = at(s, m);
      sums.errors.years.add(sums.told_in_year - read_in_year_[s].sum);
      sums.told_in_year = 0;
    }
    read_in_year_[s] = {};
  }
}

MethodErrors::Errors MethodErrors::errors(std::size_t method) const {
  Errors all;
  for (std::size_t s = 0; s < read_in_year_.size(); ++s) {
    all.steps.add(at(s, method).errors.steps);
    all.years.add(at(s, method).errors.years);
  }
  return all;
}

MethodErrors::Errors MethodErrors::errors(std::size_t method, const ElevationBands& bands,
                                          std::size_t band) const {
  Errors in_band;
  for (std::size_t s = 0; s < read_in_year_.size(); ++s) {
    if (bands.of(s) != band) continue;
    in_band.steps.add(at(s, method).errors.steps);
    in_band.years.add(at(s, method).errors.years);
  }
  return in_band;
}

std::size_t MethodErrors::gauges() const {
  std::size_t count = 0;
  for (std::size_t s = 0; s < read_in_year_.size(); ++s)
    count += at(s, 0).errors.steps.count > 0 ? 1U : 0U;
  return count;
}

double MethodErrors::seconds_of(PointMethod method) const {
  if (readings_ == 0) return 0;
  return seconds_[static_cast<std::size_t>(method)] / static_cast<double>(readings_);
}

}  // namespace thiessen
