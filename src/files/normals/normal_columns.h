#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/tables/features.h"

namespace thiessen {

/// The field of a file in which the normals of its features stand, or the twelve of the calendar
/// months: `normal`, or `normal_01` to `normal_12`.
class NormalColumns {
 public:
  /// Finds the field; where `name` is empty there is none. Throws Error where the file has neither
  /// the field nor all twelve.
  NormalColumns(const Features& features, const std::string& name);

  bool any() const { return !columns_.empty(); }
  /// The normals of the feature that was read last, one or twelve; NaN where one is empty. A text
  /// that is no number goes to the complaints; `what` is the feature in their words.
  std::vector<double> read(const Features& features, const std::string& what,
                           Complaints& complaints) const;

 private:
  std::vector<std::size_t> columns_;
};

}  // namespace thiessen
