#pragma once

#include <array>
#include <span>
#include <vector>

#include "rainfall/gaps/cell_account.h"
#include "rainfall/step_rainfall.h"

namespace thiessen {

/// What a time step with silent gauges gets. Each is a class in this folder, which says it in full.
enum class Gaps { retessellate, renormalise, strict };

/// In the order in which they are offered.
inline constexpr std::array all_gaps{Gaps::retessellate, Gaps::renormalise, Gaps::strict};

/// Says which values a step gets when some of its gauges are silent. Where none is all policies
/// agree: the value is the sum of the full network's weights x readings. Safe for several threads
/// at once; what a policy gives depends on the readings alone. `readings`: one a station of the
/// network, NaN where it is silent.
class GapPolicy {
 public:
  GapPolicy() = default;
  GapPolicy(const GapPolicy&) = delete;
  GapPolicy& operator=(const GapPolicy&) = delete;
  virtual ~GapPolicy() = default;

  /// Whether a step's values are those of a network that never had its silent gauges. Only then
  /// what a gauge is worth is what its leaving changes (see Influence).
  virtual bool leaves_silent_out() const = 0;

  /// The weights where every gauge reports, by basin.
  virtual const std::vector<BasinWeights>& full_weights() const = 0;

  /// By basin, without coverage, which is no matter of the policy.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings) const = 0;
  /// The same, and what the values are made of.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings,
                                        CellAccount& account) const = 0;
  /// The weights that the values are made with, by basin; a basin without a value has none.
  virtual std::vector<BasinWeights> weights_at(std::span<const double> readings) const = 0;

  /// The full network's weights of the account's cells, by basin, then by cell.
  virtual std::vector<CellWeight> full_cells() const = 0;
  /// The account's readings.
  virtual std::vector<double> cell_readings(std::span<const double> readings) const = 0;
};

}  // namespace thiessen
