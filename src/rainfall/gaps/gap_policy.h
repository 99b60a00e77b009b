#pragma once

#include <array>
#include <span>
#include <vector>

#include "rainfall/gaps/cell_account.h"
#include "rainfall/network/step_rainfall.h"

namespace thiessen {

/// The policies for time steps with silent gauges. Each is a class in this folder, which says what
/// it does.
enum class Gaps { retessellate, renormalise, strict };

/// All policies, in the order in which they are offered.
inline constexpr std::array all_gaps{Gaps::retessellate, Gaps::renormalise, Gaps::strict};

/// Decides which values a step gets when some of its gauges are silent. Where none is silent all
/// policies agree: the value is the sum of the full network's weights x readings.
///
/// Safe for several threads at once; the result depends on the readings alone. `readings` has one
/// entry for each station of the network, NaN where it is silent.
class GapPolicy {
 public:
  GapPolicy() = default;
  GapPolicy(const GapPolicy&) = delete;
  GapPolicy& operator=(const GapPolicy&) = delete;
  virtual ~GapPolicy() = default;

  /// Whether the values of a step equal those of a network without the gauges that are silent then.
  /// Only in that case is a gauge's worth the change that its leaving makes (see Influence).
  virtual bool leaves_silent_out() const = 0;

  /// The weights by basin when every gauge reports.
  virtual const std::vector<BasinWeights>& full_weights() const = 0;

  /// The values of a step by basin. The coverage is left at 0, for it does not depend on the
  /// policy.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings) const = 0;
  /// The values of a step by basin, and the account of what they are made of.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings,
                                        CellAccount& account) const = 0;
  /// The weights that the values are made with, by basin; a basin without a value has none.
  virtual std::vector<BasinWeights> weights_at(std::span<const double> readings) const = 0;

  /// The full network's weights of the cells that an account speaks of, by basin, then by cell.
  virtual std::vector<CellWeight> full_cells() const = 0;
  /// The readings that an account would hold: one for each cell.
  virtual std::vector<double> cell_readings(std::span<const double> readings) const = 0;
};

}  // namespace thiessen
