#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// What the texts of a field stand for.
enum class FieldType { text, integer, real };

/// The name of a field and the type that its texts stand for.
struct FieldName {
  std::string name;
  FieldType type = FieldType::text;
};

/// The further fields of the stations, as text: one row for each station, in their order. In a
/// field of numbers, an empty text means that there is no value.
struct Attributes {
  std::vector<FieldName> fields;
  std::vector<std::vector<std::string>> rows;
};

}  // namespace thiessen
