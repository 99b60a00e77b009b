#include "gdal/layers/sheet_table.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/unit_row.h"

namespace thiessen {
namespace {

constexpr std::size_t rows_above_header = 100;

std::vector<std::string> names_in(const SheetRow& row) {
  std::vector<std::string> names;
  for (const SheetCell& cell : row.cells) {
    names.emplace_back(cell.is_time ? shortest_text(cell.serial) : std::string(trimmed(cell.text)));
  }
  return names;
}

std::size_t cells_in(const SheetRow& row) {
  return static_cast<std::size_t>(std::count_if(
      row.cells.begin(), row.cells.end(), [](const SheetCell& cell) { return !cell.is_empty(); }));
}

bool has_known_name(const SheetRow& row) {
  const std::vector<std::string> names = names_in(row);
  return find_field(names, known::times) || find_field(names, known::station_ids) ||
         find_field(names, known::years);
}

/// The units in a row of the sheet; nothing where it is another row.
std::optional<UnitRow> units_in(const SheetRow& row) {
  const std::vector<std::string> texts = names_in(row);
  return unit_row(std::vector<std::string_view>(texts.begin(), texts.end()));
}

/// How many of the rows stand above the header.
std::size_t above_header(const std::deque<SheetRow>& rows) {
  if (rows.empty() || (cells_in(rows[0]) > 1 && has_known_name(rows[0]))) return 0;
  const std::size_t looked_at = std::min(rows.size(), rows_above_header);
  for (std::size_t i = 1; i + 1 < looked_at; ++i) {
    const std::size_t cells = cells_in(rows[i]);
    const bool has_units = i + 2 < rows.size() && units_in(rows[i + 1]);
    const SheetRow& below = rows[has_units ? i + 2 : i + 1];
    if (cells > 1 && has_known_name(rows[i]) && below.cells.size() <= rows[i].cells.size() &&
        cells_in(below) > 1) {
      return i;
    }
  }
  return 0;
}

std::string names_of(const std::vector<SheetBook::Sheet>& sheets,
                     const std::vector<std::size_t>& chosen) {
  std::vector<std::string> names;
  names.reserve(chosen.size());
  for (const std::size_t sheet : chosen) names.push_back(sheets[sheet].name);
  return listed(names);
}

}  // namespace

SheetTable::SheetTable(Request request, Warnings* warnings)
    : request_(std::move(request)),
      book_(open_sheet_book(request_.kind, request_.file, request_.name)),
      sheet_(chosen_sheet()),
      rows_(book_->rows(sheet_)) {
  pass_to_header(warnings);
  pass_units(warnings);
  see_clocks();
}

SheetTable::SheetTable(Request request, std::shared_ptr<const SheetBook> book, std::size_t sheet,
                       Warnings* warnings)
    : request_(std::move(request)),
      book_(std::move(book)),
      sheet_(sheet),
      rows_(book_->rows(sheet_)) {
  pass_to_header(warnings);
  pass_units(warnings);
  see_clocks();
}

std::unique_ptr<Table> SheetTable::again() const {
  return std::unique_ptr<Table>(new SheetTable(request_, book_, sheet_, nullptr));
}

/// The sheet that is named, or else the only one that has a cell and is not hidden.
std::size_t SheetTable::chosen_sheet() const {
  const std::vector<SheetBook::Sheet>& sheets = book_->sheets();
  std::vector<std::size_t> all, filled;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    all.push_back(i);
    if (sheets[i].name == request_.layer) return i;
    if (!request_.layer.empty() || sheets[i].is_hidden) continue;
    if (!book_->rows(i)->ahead().empty()) filled.push_back(i);
  }
  if (!request_.layer.empty()) {
    throw Error(Message{request_.file, 0, "has no layer " + quoted(request_.layer, 80),
                        "its layers are " + names_of(sheets, all)});
  }
  if (filled.empty()) throw Error(Message{request_.file, 0, "has no sheet with a cell", {}});
  if (filled.size() > 1) {
    throw Error(Message{request_.file, 0, "has several layers: " + names_of(sheets, filled),
                        "name one with " + setting(request_.layer_setting)});
  }
  return filled.front();
}

void SheetTable::pass_to_header(Warnings* warnings) {
  std::size_t passed = 0;
  if (request_.skip) {
    while (!rows_->ahead().empty() && rows_->ahead().front().number <= *request_.skip)
      keep_line_above(*rows_->next());
  } else {
    passed = above_header(rows_->ahead());
    for (std::size_t i = 0; i < passed; ++i) keep_line_above(*rows_->next());
  }
  const SheetRow* const row = rows_->next();
  if (row == nullptr) throw Error(Message{request_.file, 0, "has no row for a header", {}});
  header_ = names_in(*row);
  header_row_ = row->number;
  if (passed == 0 || warnings == nullptr) return;
  warnings->add_notice(
      {request_.file, 0,
       "its header stands in row " + std::to_string(header_row_) + ", below " +
           (passed == 1 ? "a row that is" : std::to_string(passed) + " rows that are") +
           " passed over",
       ""});
}

/// Keeps what stands in a row above the header, as a CSV would have it.
void SheetTable::keep_line_above(const SheetRow& row) {
  if (lines_above_.size() == rows_above_header) lines_above_.erase(lines_above_.begin());
  std::string line;
  for (const std::string& text : names_in(row)) line += (line.empty() ? "" : ",") + text;
  lines_above_.push_back(std::move(line));
}

/// Passes a row of units below the header over.
void SheetTable::pass_units(Warnings* warnings) {
  if (rows_->ahead().empty()) return;
  auto row = units_in(rows_->ahead().front());
  if (!row || row->of_column.size() > header_.size()) return;
  row->of_column.resize(header_.size());
  rows_->next();
  units_ = std::move(row->of_column);
  if (warnings == nullptr) return;
  warnings->add_notice({request_.file, 0,
                        "below its header a row of units (" + row->units + ") is passed over", ""});
}

/// Notes which columns have times with a clock, for their midnights are to have one too.
void SheetTable::see_clocks() {
  has_clock_.assign(header_.size(), false);
  for (const SheetRow& row : rows_->ahead()) {
    for (std::size_t i = 0; i < std::min(row.cells.size(), header_.size()); ++i) {
      const SheetCell& cell = row.cells[i];
      if (cell.is_time && (cell.form.has_clock || has_clock(cell.serial))) has_clock_[i] = true;
    }
  }
}

bool SheetTable::next(Row& row) {
  const SheetRow* read = nullptr;
  while ((read = rows_->next()) != nullptr && read->cells.size() > header_.size()) {
    complaints_.add({request_.file, read->number,
                     "has " + std::to_string(read->cells.size()) + " cells, and the header " +
                         std::to_string(header_.size()),
                     ""});
  }
  if (read == nullptr) {
    complaints_.throw_if_any();
    return false;
  }
  texts_.assign(header_.size(), "");
  for (std::size_t i = 0; i < read->cells.size(); ++i) texts_[i] = text_of(read->cells[i], i);
  row.line = read->number;
  row.padded = false;
  row.fields.assign(texts_.begin(), texts_.end());
  return true;
}

std::string SheetTable::text_of(const SheetCell& cell, std::size_t column) const {
  if (!cell.is_time) return cell.text;
  return time_of_serial(cell.serial, cell.form, has_clock_[column], book_->counts_from_1904())
      .value_or(shortest_text(cell.serial));
}

}  // namespace thiessen
