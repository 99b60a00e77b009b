#include "files/normals/elevation_study.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/number.h"
#include "files/normals/fitted_ground.h"
#include "files/normals/gauge_elevations.h"
#include "files/normals/raster_ground.h"
#include "rainfall/normals/elevation_fit.h"
#include "rainfall/normals/elevation_normals.h"

namespace thiessen {
namespace {

std::string percent(double share) {
  return fixed_text(100 * share, 1) + " %";
}

std::size_t places_with_rain(const std::vector<double>& normals) {
  return static_cast<std::size_t>(
      std::count_if(normals.begin(), normals.end(), [](double normal) { return normal > 0; }));
}

/// What to do where no normals can be fitted.
Wording other_ways() {
  return setting("normals") + " and " + setting("normal_field") +
         " take normals that are known; without any each reading counts as it is";
}

/// Fits normals to the gauges.
class Fitting {
 public:
  Fitting(const ElevationRequest& request, const Study& study, const CalendarNormals& gauges,
          const std::vector<double>& elevations)
      : request_(request),
        gauges_(gauges),
        places_(study.network().places()),
        metric_(study.weighing().yardstick().metric) {
    for (std::uint32_t p = 0; p < places_.size(); ++p)
      elevations_.push_back(elevations[index(study.network().stations_at(PlaceIndex{p}).front())]);
  }

  std::shared_ptr<const ElevationFit> fit(Warnings& warnings) const {
    const std::vector<std::vector<double>> year{gauges_.of_year()};
    require_places(year.front());
    auto of_year = fitted(year);
    if (!of_year->is_better_than_nearest()) refuse(*of_year);
    if (auto months = normals_of_months()) {
      auto of_months = fitted(*months);
      if (of_months->is_better_than_nearest()) {
        tell(*of_months, warnings);
        return of_months;
      }
      warnings.add_notice({request_.rainfall, 0,
                           "normals are those of the year, for by calendar months elevation does "
                           "not tell them a tenth better than the nearest gauge",
                           ""});
    }
    tell(*of_year, warnings);
    return of_year;
  }

 private:
  std::shared_ptr<const ElevationFit> fitted(
      const std::vector<std::vector<double>>& normals) const {
    return std::make_shared<const ElevationFit>(places_, elevations_, normals, metric_,
                                                request_.threads);
  }

  void require_places(const std::vector<double>& normals) const {
    const std::size_t known = places_with_rain(normals);
    if (known < FittedNormals::least_places) {
      const std::string who = known == 0   ? "no gauge has"
                              : known == 1 ? "one gauge has"
                                           : std::to_string(known) + " gauges have";
      throw Error({request_.rainfall, 0,
                   who + " rain, and normals are fitted by elevation to ten at least",
                   other_ways()});
    }
    std::optional<double> height;
    for (std::size_t p = 0; p < normals.size(); ++p) {
      if (!(normals[p] > 0)) continue;
      if (height && *height != elevations_[p]) return;
      height = elevations_[p];
    }
    throw Error({request_.rainfall, 0,
                 "all gauges lie at one height, " + shortest_text(*height) +
                     ", and nothing tells how rain changes with elevation",
                 other_ways()});
  }

  /// What the fit is worth, and whether it owes that to elevation: gauges around can tell a normal
  /// better than the nearest does by averaging alone.
  void tell(const ElevationFit& fit, Warnings& warnings) const {
    warnings.add_notice(
        {request_.rainfall, 0,
         std::string("leaving each gauge out: its normal ") +
             (fit.months() > 1 ? "of a calendar month" : "of the year") + " is told to " +
             percent(fit.left_out_error()) + " by elevation and the gauges around, to " +
             percent(fit.level_error()) + " by the gauges around alone, to " +
             percent(fit.nearest_error()) + " by the nearest gauge's (root mean square of ln N)",
         ""});
    if (fit.left_out_error() < fit.level_error()) return;
    warnings.add({request_.rainfall, 0,
                  "elevation adds nothing here: the gauges around tell a normal as well without it",
                  other_ways()});
  }

  [[noreturn]] void refuse(const ElevationFit& fit) const {
    throw Error(
        {request_.rainfall, 0,
         "elevation does not tell rain here: leaving each gauge out, its normal is told to " +
             percent(fit.left_out_error()) + " by elevation and the gauges around, to " +
             percent(fit.nearest_error()) +
             " by the nearest gauge's (root mean square of ln N), and a tenth less is "
             "needed",
         other_ways()});
  }

  /// The normals of calendar months; none where too few gauges have years enough for them.
  std::optional<std::vector<std::vector<double>>> normals_of_months() const {
    if (!request_.may_have_months) return std::nullopt;
    if (gauges_.places_with_enough_years() < FittedNormals::least_places) return std::nullopt;
    std::vector<std::vector<double>> months;
    for (std::size_t m = 0; m < CalendarNormals::months; ++m) {
      months.push_back(gauges_.of_month(m));
      if (places_with_rain(months.back()) < FittedNormals::least_places) return std::nullopt;
    }
    return months;
  }

  const ElevationRequest& request_;
  const CalendarNormals& gauges_;
  const std::vector<Point>& places_;
  Metric metric_;
  std::vector<double> elevations_;  // by place
};

/// `27.5 mm (34.8), bias -1.4 (-3.3)`.
std::string errors_text(const LeftOutReadings::Errors& errors, const std::string& unit) {
  const auto figure = [](double value) {
    return fixed_text(std::abs(value) < 0.05 ? 0 : value, 1);  // no -0.0
  };
  const auto pair = [&](double with_normals, double plain) {
    return figure(with_normals) + unit + " (" + figure(plain) + ")";
  };
  return pair(errors.with_normals.root_mean_square(), errors.plain.root_mean_square()) + ", bias " +
         pair(errors.with_normals.bias(), errors.plain.bias());
}

}  // namespace

ElevationStudy normals_by_elevation(const ElevationRequest& request, const Study& study,
                                    const StudyFiles& files, const CalendarNormals& gauges,
                                    Warnings& warnings) {
  std::optional<RasterGround> ground;
  if (!request.raster.empty()) ground.emplace(request.raster, study, files, warnings);
  GaugeElevations elevations = elevations_of_gauges(study, files, ground ? &*ground : nullptr,
                                                    request.is_field_named, warnings);
  const auto fit = Fitting(request, study, gauges, elevations.of_stations).fit(warnings);
  const FittedGround fitted =
      ground ? normals_of_elevations(*fit, *ground, elevations.raster_scale, study, request.threads,
                                     warnings)
             : normals_of_mean_elevations(*fit, study, files, request.threads, warnings);
  return {std::make_shared<const ElevationNormals>(fit, study.network(), fitted.normals,
                                                   fitted.log_variances),
          std::move(elevations.of_stations)};
}

std::string left_out_text(const LeftOutReadings& readings, const std::string& unit) {
  const std::string of_unit = unit.empty() ? "" : " " + unit;
  std::string text =
      "leaving each gauge out: with these normals (and without) the nearest gauge tells its "
      "readings to " +
      errors_text(readings.all(), of_unit);
  if (readings.bands().size() < 2) return text;
  for (std::size_t band = 0; band < readings.bands().size(); ++band)
    text +=
        "; " + readings.bands().name(band) + ": " + errors_text(readings.in_band(band), of_unit);
  return text;
}

}  // namespace thiessen
