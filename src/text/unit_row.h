#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// What a row below a header says of its columns: what each is in.
struct UnitRow {
  std::string units;                   ///< each once, as they are written: "mm, [degC]"
  std::vector<std::string> of_column;  ///< without brackets; empty where none stands
};

/// The units in a row that holds such and, beside them, words without a digit alone, as a row of
/// units below a header does; nothing where it is another row.
std::optional<UnitRow> unit_row(std::span<const std::string_view> fields);

}  // namespace thiessen
