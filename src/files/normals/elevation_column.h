#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/error.h"
#include "files/tables/features.h"

namespace thiessen {

/// The field of a file in which the elevations of its features stand.
class ElevationColumn {
 public:
  /// Finds the field of a name, or where that is empty the first of known::elevations, if there is
  /// one; where nothing is wanted there is none. Throws Error where the file has no field of the
  /// name, with a hint that says what else there is.
  ElevationColumn(const Features& features, const std::optional<std::string>& wanted,
                  const Wording& else_hint = {});

  bool any() const { return column_.has_value(); }
  /// The field's name as the file has it; empty where there is none.
  const std::string& name() const { return name_; }
  /// The elevation of the feature that was read last; NaN where it is empty or a code of agencies
  /// for a missing one (-999 and the like). A text that is no number goes to the complaints; `what`
  /// is the feature in their words.
  double read(const Features& features, const std::string& what, Complaints& complaints) const;

 private:
  std::optional<std::size_t> column_;
  std::string name_;
};

/// Whether an elevation is not known: no number, or a code of agencies for a missing one.
bool is_missing_elevation(double elevation);

}  // namespace thiessen
