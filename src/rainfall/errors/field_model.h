#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/errors/step_variance.h"
#include "rainfall/errors/variogram.h"
#include "rainfall/network/weights.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// The random field of which the readings of each step are taken to be a draw: its correlation,
/// which is fitted once to a sample of the series, and how its variance is estimated at a step.
/// Safe for several threads at once.
class FieldModel {
 public:
  /// `sample` has a column for each site; the weighing must outlive this object.
  FieldModel(const Weighing& weighing, Sites sites, const StepSample& sample, unsigned threads);
  FieldModel(const FieldModel&) = delete;
  FieldModel& operator=(const FieldModel&) = delete;

  const Weighing& weighing() const { return weighing_; }
  const Sites& sites() const { return sites_; }
  /// Says why nothing is fitted; empty where something is.
  const std::string& shortfall() const { return shortfall_; }
  /// Requires that there is no shortfall, as does `variance`.
  const Variogram& variogram() const { return *variogram_; }
  const StepVariance& variance() const { return *variance_; }

 private:
  const Weighing& weighing_;
  Sites sites_;
  std::string shortfall_;
  std::optional<Variogram> variogram_;
  std::optional<StepVariance> variance_;
};

/// Puts values by place in the order of the sites.
std::vector<double> by_site(const Sites& sites, const std::vector<double>& of_place);

}  // namespace thiessen
