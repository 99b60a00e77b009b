#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "rainfall/network/network.h"

namespace thiessen {

/// Why a reading, or all readings of a gauge, cannot be true beside those of the gauges next to it.
enum class FindingKind : std::uint8_t {
  spike,  ///< far above all its neighbours
  zero,   ///< nothing where it rained at all of them, and heavily
  stuck,  ///< the same value, above 0, step after step
  unit,   ///< all of the gauge's rain is many times, or a small part of, that of its neighbours
  shift,  ///< its series goes with theirs one step earlier or later
  jump,   ///< from some year on it catches more, or less, beside them than before: a break
};

inline constexpr std::array all_findings = {FindingKind::unit, FindingKind::shift,
                                            FindingKind::jump, FindingKind::spike,
                                            FindingKind::zero, FindingKind::stuck};

/// The name of a kind in reports and files: `spike` and so on; a jump is a `break`.
const char* name_of(FindingKind kind);

/// Whether a kind means the whole gauge, and no single reading of it.
constexpr bool is_of_gauge(FindingKind kind) {
  return kind == FindingKind::unit || kind == FindingKind::shift || kind == FindingKind::jump;
}

/// A reading, or a gauge, that cannot be true.
struct ReadingFinding {
  StationIndex station = {};
  FindingKind kind = FindingKind::spike;
  std::string time;  ///< of the step, as the file writes it; empty where the gauge is meant
  /// The reading; of a gauge how many times its neighbours' its rain is (unit), by how many steps
  /// its series is late (shift), and how many times more it catches since (break).
  double value = 0;
  /// The median of the neighbours' readings, NaN where it is not known; of a gauge what `value`
  /// would be of a good one.
  double expected = 0;
  int since = 0;      ///< of a break: the first year that differs from those before
  double excess = 0;  ///< of a spike: how far it is above three times the largest neighbour
};

}  // namespace thiessen
