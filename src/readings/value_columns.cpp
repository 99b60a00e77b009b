#include "readings/value_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "readings/units/rain_unit.h"
#include "text/csv_form.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

/// The different texts in a column, of those with which the table begins.
std::vector<std::string> texts_in(const Table& table, std::size_t column) {
  constexpr std::size_t most = 20;
  std::vector<std::string> texts;
  try {
    const std::unique_ptr<Table> rows = table.first_rows();
    Row row;
    for (std::size_t bytes = 0; rows && bytes < csv_beginning_bytes && rows->next(row);) {
      for (const std::string_view field : row.fields) bytes += field.size() + 1;
      const std::string_view text = trimmed(row.fields[column]);
      if (text.empty() || texts.size() == most || std::ranges::find(texts, text) != texts.end())
        continue;
      texts.emplace_back(text);
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
  return texts;
}

bool is_rain(const std::string& text) {
  constexpr std::array<std::string_view, 3> further = {"00045", "pr", "rf"};
  return speaks_of_rain(text) || find_field({text}, known::values) || find_field({text}, further);
}

/// Whether a text is known to be of something else. A code of an agency's own is not.
bool is_other(const std::string& text) {
  constexpr std::array<std::string_view, 17> words = {
      "temp", "tmax", "tmin", "tavg",  "tobs",  "snow",  "snwd",  "wind", "press",
      "humi", "evap", "radi", "level", "disch", "stage", "sunsh", "flow"};
  const std::string plain = plain_name(text);
  return std::ranges::any_of(
      words, [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

/// Warns of rows of something else than rain.
void warn_of_others(const Table& table, std::size_t column, Warnings& warnings) {
  const std::vector<std::string> texts = texts_in(table, column);
  const bool all_may_be_rain = texts.size() < 2 ? std::ranges::none_of(texts, is_other)
                                                : std::ranges::all_of(texts, is_rain);
  if (all_may_be_rain) return;
  const std::string& name = table.header()[column];
  const auto rain = std::ranges::find_if(texts, is_rain);
  Wording hint;
  if (rain != texts.end()) {
    hint = setting("rainfall_where", "\"" + name + "\"='" + *rain + "'") + " reads those of " +
           *rain + " alone";
  }
  warnings.add({table.file(), table.header_line(),
                "its column " + quoted(name, 60) + " says that rows are of " + listed(texts) +
                    ", and all are read as rain",
                hint});
}

}  // namespace

void tell_values(const Table& table, const ReadingsLayout& layout, const ReadingsOptions& options,
                 Warnings& warnings) {
  if (!layout.is_long) return;
  const std::string& name = table.header()[layout.value];
  if (options.value_field.empty()) {
    std::vector<std::string> others;
    for (const std::size_t i : further_values(table, layout)) others.push_back(table.header()[i]);
    if (!others.empty()) {
      warnings.add_notice({table.file(), table.header_line(),
                           "the readings are those of column " + quoted(name, 60) +
                               ", and not of " + listed(others),
                           setting("value_field") + " names another"});
    }
  }
  if (!find_field({name}, known::bare_values)) return;
  const auto measured = find_field(table.header(), known::measured);
  if (measured && *measured != layout.station && *measured != layout.value &&
      !layout.time.has(*measured))
    warn_of_others(table, *measured, warnings);
}

}  // namespace thiessen
