#include "text/csv_writer.h"

#include "base/utf8.h"

namespace thiessen {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool needs_quotes(std::string_view field) {
  if (field.empty()) return false;
  return field.starts_with(byte_order_mark) || is_blank(field.front()) || is_blank(field.back()) ||
         field.find_first_of(",\"\r\n") != std::string_view::npos;
}

}  // namespace

void append_csv_field(std::string& row, std::string_view field) {
  if (!needs_quotes(field)) {
    row += field;
    return;
  }
  row += '"';
  for (const char c : field) {
    if (c == '"') row += '"';
    row += c;
  }
  row += '"';
}

}  // namespace thiessen
