#include "readings/units/unit_column.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/utf8.h"
#include "readings/units/rain_unit.h"
#include "text/csv_form.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/table_over.h"

namespace thiessen {
namespace {

class UnitColumn : public TableOver {
 public:
  struct Columns {
    std::size_t unit;
    std::size_t value;
  };

  UnitColumn(std::unique_ptr<Table> table, Columns columns, std::string text, bool is_believed)
      : TableOver(std::move(table)),
        columns_(columns),
        text_(std::move(text)),
        is_believed_(is_believed) {}

  bool is_waiting(std::chrono::milliseconds patience) override {
    return table_->is_waiting(patience);
  }
  std::string unit(std::size_t field) const override {
    return field == columns_.value && !text_.empty() ? text_ : table_->unit(field);
  }

  bool next(Row& row) override {
    if (!table_->next(row)) return false;
    if (is_believed_) require_same(row);
    return true;
  }

 private:
  std::unique_ptr<Table> over(std::unique_ptr<Table> table) const override {
    return std::make_unique<UnitColumn>(std::move(table), columns_, text_, is_believed_);
  }

  void require_same(const Row& row) {
    const std::string_view text = trimmed(row.fields[columns_.unit]);
    if (text.empty() || text == text_ || text == same_) return;
    const auto one = rain_unit(text_);
    const auto other = rain_unit(text);
    if (one && other && one->name() == other->name()) {
      same_ = text;
      return;
    }
    const RowPlace place = table_->place(row.line);
    const std::string& name = header()[columns_.unit];
    throw Error({place.file, place.line,
                 "its reading is in " + quoted(text, 40) + ", as the column " + quoted(name, 60) +
                     " says, and " +
                     (text_.empty() ? "of those above nothing tells what they are in"
                                    : "those above are in " + quoted(text_, 40)),
                 setting("rainfall_where", filter_of(name, text_.empty() ? text : text_)) +
                     " reads the rows of one unit, and " + setting("from_unit") +
                     " says one for all"});
  }

  /// A filter of the rows with a text in a column.
  static std::string filter_of(const std::string& name, std::string_view text) {
    return "\"" + name + "\"='" + std::string(text) + "'";
  }

  Columns columns_;
  std::string text_;  ///< what the first rows say; empty where they are not known
  std::string same_;  ///< another text for the same unit
  bool is_believed_;
};

/// What the first row says that says anything, of those at the beginning.
std::string first_text(const Table& table, std::size_t column) {
  try {
    const std::unique_ptr<Table> rows = table.first_rows();
    Row row;
    for (std::size_t bytes = 0; rows && bytes < csv_beginning_bytes && rows->next(row);) {
      for (const std::string_view field : row.fields) bytes += field.size() + 1;
      if (const std::string_view text = trimmed(row.fields[column]); !text.empty())
        return std::string(text);
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
  return {};
}

}  // namespace

std::unique_ptr<Table> with_unit_column(std::unique_ptr<Table> table, const ReadingsLayout& layout,
                                        const ReadingsOptions& options) {
  if (!layout.is_long) return table;
  const auto column = find_field(table->header(), known::unit_columns);
  if (!column || *column == layout.value || *column == layout.station || layout.time.has(*column))
    return table;
  const bool is_believed = !options.from_unit && !options.scale;
  std::string text = first_text(*table, *column);
  const bool is_known = rain_unit(text).has_value();
  if (is_believed && !text.empty() && !is_known) {
    throw Error({table->file(), table->header_line(),
                 "its column " + quoted(table->header()[*column], 60) +
                     " says that readings are in " + quoted(text, 40) +
                     ", which is no unit of rain that is known",
                 setting("from_unit") + " says what they are in"});
  }
  if (!is_known) text.clear();
  return std::make_unique<UnitColumn>(std::move(table), UnitColumn::Columns{*column, layout.value},
                                      std::move(text), is_believed);
}

}  // namespace thiessen
