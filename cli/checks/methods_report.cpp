#include "cli/checks/methods_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/counted.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "cli/checks/methods_verdict.h"
#include "cli/checks/text_table.h"
#include "files/normals/elevation_column.h"
#include "rainfall/leaving_out/half_networks.h"
#include "rainfall/leaving_out/method_errors.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t most_stretches = 30;
constexpr std::size_t least_steps_of_stretches = 10;
constexpr std::size_t most_halved_steps = 12;
constexpr std::size_t halved_readings = 40'000;  // as many as are looked at in half a second
constexpr std::size_t points_of_all_basins = 10'000;

using Row = std::vector<std::string>;

void add_cells(Row& row, const ErrorSums& sums, int decimals) {
  row.push_back(error_text(sums.root_mean_square(), decimals));
  row.push_back(error_text(sums.bias(), decimals));
}

/// The bands of the report: none where there is but one.
std::size_t bands_shown(const ElevationBands& bands) {
  return bands.size() > 1 ? bands.size() : 0;
}

/// A table of the errors of all methods, in all and by bands. `of` picks the steps' or the years'.
template <typename Of>
std::string table(const std::string& heading, const MethodErrors& errors,
                  const ElevationBands& bands, const Of& of) {
  std::vector<double> off;
  for (std::size_t m = 0; m < errors.methods().size(); ++m)
    off.push_back(of(errors.errors(m)).root_mean_square());
  const int decimals = decimals_for(off);
  std::vector<Row> rows{{heading, "all", "bias"}};
  for (std::size_t band = 0; band < bands_shown(bands); ++band) {
    rows.front().push_back(bands.name(band));
    rows.front().emplace_back("bias");
  }
  for (std::size_t m = 0; m < errors.methods().size(); ++m) {
    Row row{tried_name(errors.methods()[m].method, errors.methods()[m].with_normals)};
    add_cells(row, of(errors.errors(m)), decimals);
    for (std::size_t band = 0; band < bands_shown(bands); ++band)
      add_cells(row, of(errors.errors(m, bands, band)), decimals);
    rows.push_back(std::move(row));
  }
  return aligned(rows);
}

std::string cost_line(const MethodErrors& errors) {
  std::string text = "cost, in microseconds of processor time for a reading: ";
  for (std::size_t m = 0; m < point_methods.size(); ++m) {
    text += (m == 0 ? "" : ", ") + std::string(thiessen::name_of(point_methods[m])) + " " +
            significant_text(1e6 * errors.seconds_of(point_methods[m]), 2);
  }
  return text + "\n";
}

std::string halves_table(const Weighing& weighing, const DatedSample& sample, bool has_basins,
                         const std::string& in_unit, unsigned threads) {
  std::vector<HalvedStep> steps;
  const std::size_t count =
      std::min(sample.steps(),
               std::clamp<std::size_t>(halved_readings / weighing.network().stations().size(), 2,
                                       most_halved_steps));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t step = i * sample.steps() / count;
    steps.push_back({sample.readings(step), sample.month(step)});
  }
  const std::size_t points =
      std::clamp<std::size_t>(points_of_all_basins / weighing.basins().size(), 30, 500);
  const auto methods = errors_with_half_the_gauges(weighing, steps, points, threads);
  std::vector<double> off;
  off.reserve(methods.size());
  for (const HalvedMethod& method : methods) off.push_back(method.errors.root_mean_square());
  std::vector<Row> rows{{"at the steps", "error", "bias", "means"}};
  for (const HalvedMethod& method : methods) {
    Row row{tried_name(method.method, method.with_normals)};
    add_cells(row, method.errors, decimals_for(off));
    row.push_back(std::to_string(method.errors.count));
    rows.push_back(std::move(row));
  }
  return (has_basins ? "means of basins" : "means of the stations' extent") +
         std::string(" by half of the gauges, against those by all of the same method, at ") +
         counted(count, "step") + in_unit + ":\n" + aligned(rows);
}

}  // namespace

std::vector<double> elevations_in_attributes(const StudyFiles& study) {
  std::vector<std::string> header;
  for (const FieldName& field : study.attributes.fields) header.push_back(field.name);
  const auto column = find_field(header, known::elevations);
  std::vector<double> elevations;
  if (!column) return elevations;
  for (const auto& row : study.attributes.rows) {
    const auto elevation = parse_number(row[*column]);
    elevations.push_back(elevation && !is_missing_elevation(elevation.value)
                             ? elevation.value
                             : std::numeric_limits<double>::quiet_NaN());
  }
  return elevations;
}

MethodsReport::MethodsReport(const Inputs& inputs, std::vector<double> elevations,
                             std::string rainfall, Stamp stamp)
    : inputs_(inputs),
      elevations_(std::move(elevations)),
      months_(std::move(rainfall), stamp),
      stamp_(stamp),
      sample_(inputs.network().stations().size(),
              most_readings / std::max<std::size_t>(1, inputs.network().stations().size())) {}

void MethodsReport::add(const TimeStep& step) {
  const NormalField* const normals = inputs_.weighing().normals();
  NormalMonth month;
  if (normals != nullptr && normals->months() > 1)
    month = months_.of(step.time, step.written, step.line);
  sample_.add(step.readings, month, year_of(step.time, step.written, stamp_));
}

std::string MethodsReport::text(const std::string& unit, unsigned threads) const {
  const Network& network = inputs_.network();
  const std::string head = "leaving each gauge out: ";
  if (network.places().size() < 3) return head + "not done, for it takes gauges at three places\n";
  const Weighing& weighing = inputs_.weighing();
  const bool has_stretches = sample_.steps() >= least_steps_of_stretches;
  const std::size_t stretches = has_stretches ? std::min(sample_.steps(), most_stretches) : 1;
  MethodErrors errors(network, inputs_.study().metric,
                      inputs_.has_basins() ? inputs_.basins() : std::vector<Basin>(),
                      weighing.normals(), stretches);
  const bool has_years = sample_.has_sums_of_years();
  const std::vector<std::size_t> order = sample_.by_years();
  for (std::size_t i = 0; i < order.size(); ++i) {
    throw_if_interrupted();
    errors.add({sample_.readings(order[i]), sample_.month(order[i]),
                has_years ? sample_.year(order[i]) : std::nullopt, i * stretches / order.size()});
  }
  errors.finish();
  if (errors.readings() == 0) return head + "not done, for at no step do two gauges report\n";
  const std::string in_unit = unit.empty() ? "" : ", in " + unit;
  const ElevationBands bands(elevations_);
  std::string text = head + counted(errors.readings(), "reading", "readings") + " of " +
                     counted(errors.gauges(), "gauge", "gauges") +
                     " are told by the others; root mean square error and bias" + in_unit + ":\n" +
                     table("at the steps", errors, bands, [](const auto& e) { return e.steps; });
  if (has_years) {
    text += table("sums of a year", errors, bands, [](const auto& e) { return e.years; }) +
            "sums of a year are of a gauge and the steps at which it reports: " +
            std::to_string(errors.errors(0).years.count) + " in all\n";
  }
  if (sample_.spacing() > 1) {
    text += "of " + std::to_string(sample_.seen()) + " steps one of every " +
            std::to_string(sample_.spacing()) + " was looked at, and sums of a year are of these\n";
  }
  if (bands_shown(bands) > 0) {
    std::size_t unknown = 0;
    for (const double elevation : elevations_) unknown += std::isnan(elevation) ? 1U : 0U;
    if (unknown > 0)
      text += counted(unknown, "gauge", "gauges") + " without elevation: in no band\n";
  }
  if (inputs_.has_basins())
    text += "arithmetic is the mean of the others in a gauge's basin; without any, of all others\n";
  text += verdict_on(errors, unit);
  text += halves_table(weighing, sample_, inputs_.has_basins(), in_unit, threads);
  return text + cost_line(errors);
}

}  // namespace thiessen::cli
