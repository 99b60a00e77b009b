#pragma once

#include <cstdint>
#include <span>

namespace thiessen {

/// How a total was spread over the steps of its period.
enum class SpreadBy : std::uint8_t {
  gauges,             ///< as the gauges around it had their rain
  evenly_dry,         ///< evenly, for all of these were dry
  evenly_unreported,  ///< evenly, for no gauge reported at any step
  nothing,            ///< not at all, for the period has no steps
};

/// Spreads a total over the steps of its period in proportion to what fell around its gauge.
///
/// `around` has for each step the rain there, NaN where no gauge reported: these steps get nothing,
/// and their amounts are NaN, unless all are so. Where no rain fell around in any step, the total
/// is spread evenly over the steps that gauges reported. The amounts add up to the total to a few
/// units of its last digit, for what rounding leaves is mended in the largest. A total of 0 makes
/// zeros. Requires a total that is not negative, and as many amounts as steps.
SpreadBy spread_total(double total, std::span<const double> around, std::span<double> amounts);

}  // namespace thiessen
