#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// What a field's texts stand for.
enum class FieldType { text, integer, real };

struct FieldName {
  std::string name;
  FieldType type = FieldType::text;
};

/// The stations' further fields, as text: one row for each station, in their order. An empty text
/// of a number's field is no value.
struct Attributes {
  std::vector<FieldName> fields;
  std::vector<std::vector<std::string>> rows;
};

}  // namespace thiessen
