#include "files/tables/filtered_table.h"

#include <utility>

#include "base/utf8.h"
#include "text/csv_form.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

/// The types of the fields, by the rows at the beginning of a table of texts.
std::vector<FieldType> types_of(const Table& table, const FilteredTable::Filter& filter) {
  const std::unique_ptr<Table> first = table.first_rows();
  if (!first) {
    throw Error(
        Message{table.file(), 0,
                setting(filter.its_setting, filter.where) +
                    " looks at the first rows for what is a number, and it can be read only once",
                "give a file"});
  }
  std::vector<FieldTypeGuess> guesses(table.header().size());
  try {
    Row row;
    for (std::size_t bytes = 0; bytes < csv_beginning_bytes && first->next(row);) {
      for (std::size_t i = 0; i < row.fields.size(); ++i) {
        bytes += row.fields[i].size() + 1;
        guesses[i].see(trimmed(row.fields[i]));
      }
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
  std::vector<FieldType> types;
  types.reserve(guesses.size());
  for (const FieldTypeGuess& guess : guesses) types.push_back(guess.type());
  return types;
}

}  // namespace

FilteredTable::FilteredTable(std::unique_ptr<Table> table, Filter filter,
                             std::vector<FieldName> fields, Warnings* warnings)
    : TableOver(std::move(table)),
      filter_(std::move(filter)),
      fields_(std::move(fields)),
      keeps_(filter_.where, filter_.its_setting, table_->file(), fields_),
      warnings_(warnings) {
  for (const std::size_t field : keeps_.fields_asked()) {
    if (fields_[field].type != FieldType::text) numbers_.push_back(field);
  }
}

bool FilteredTable::next(Row& row) {
  while (next_row(row)) {
    ++read_;
    if (!has_types(row) || !keeps_.keeps(row)) continue;
    ++kept_;
    return true;
  }
  conclude();
  return false;
}

/// Reads the next row of all. At the end the faults of the table join those found here.
bool FilteredTable::next_row(Row& row) {
  try {
    return table_->next(row);
  } catch (const Error& error) {
    if (complaints_.empty()) throw;
    complaints_.add(error);
    return false;
  }
}

std::unique_ptr<Table> FilteredTable::over(std::unique_ptr<Table> table) const {
  return std::make_unique<FilteredTable>(std::move(table), filter_, fields_, nullptr);
}

/// Whether the fields of numbers that the filter asks hold numbers, and complains where they do
/// not.
bool FilteredTable::has_types(const Row& row) {
  for (const std::size_t field : numbers_) {
    const std::string_view text = trimmed(row.fields[field]);
    FieldTypeGuess guess;
    guess.see(text);
    if (text.empty() || guess.type() != FieldType::text) continue;
    complaints_.add({table_->file(), table_->header_line() > 0 ? row.line : 0,
                     quoted(text, 80) + " is no number, and " + setting(filter_.its_setting) +
                         " compares " + quoted(fields_[field].name, 80) +
                         " as numbers, for its first rows hold nothing else",
                     "leave that field out of the filter"});
    return false;
  }
  return true;
}

void FilteredTable::conclude() {
  complaints_.throw_if_any();
  if (warnings_ == nullptr || read_ == 0 || kept_ > 0) return;
  std::exchange(warnings_, nullptr)
      ->add({table_->file(), 0,
             "none of its " + std::to_string(read_) + " rows meets " +
                 setting(filter_.its_setting, filter_.where),
             ""});
}

std::unique_ptr<Table> keep_rows(std::unique_ptr<Table> table, FilteredTable::Filter filter,
                                 std::vector<FieldType> types, Warnings& warnings) {
  if (types.empty()) types = types_of(*table, filter);
  std::vector<FieldName> fields;
  for (std::size_t i = 0; i < types.size(); ++i) fields.push_back({table->header()[i], types[i]});
  return std::make_unique<FilteredTable>(std::move(table), std::move(filter), std::move(fields),
                                         &warnings);
}

}  // namespace thiessen
