#include "gdal/layers/xlsx_table.h"

#include <algorithm>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::size_t rows_above_header = 100;

std::vector<std::string> names_in(const XlsxRow& row) {
  std::vector<std::string> names;
  for (const XlsxCell& cell : row.cells) {
    names.emplace_back(cell.is_time ? shortest_text(cell.serial) : std::string(trimmed(cell.text)));
  }
  return names;
}

std::size_t cells_in(const XlsxRow& row) {
  return static_cast<std::size_t>(
      std::count_if(row.cells.begin(), row.cells.end(),
                    [](const XlsxCell& cell) { return cell.is_time || !cell.text.empty(); }));
}

bool has_known_name(const XlsxRow& row) {
  const std::vector<std::string> names = names_in(row);
  return find_field(names, known::times) || find_field(names, known::station_ids) ||
         find_field(names, known::years);
}

/// How many of the rows stand above the header.
std::size_t above_header(const std::deque<XlsxRow>& rows) {
  if (rows.empty() || (cells_in(rows[0]) > 1 && has_known_name(rows[0]))) return 0;
  const std::size_t looked_at = std::min(rows.size(), rows_above_header);
  for (std::size_t i = 1; i + 1 < looked_at; ++i) {
    const std::size_t cells = cells_in(rows[i]);
    if (cells > 1 && has_known_name(rows[i]) && rows[i + 1].cells.size() <= rows[i].cells.size() &&
        cells_in(rows[i + 1]) > 1) {
      return i;
    }
  }
  return 0;
}

std::string names_of(const std::vector<const XlsxBook::Sheet*>& sheets) {
  std::vector<std::string> names;
  names.reserve(sheets.size());
  for (const XlsxBook::Sheet* sheet : sheets) names.push_back(sheet->name);
  return listed(names);
}

}  // namespace

XlsxTable::XlsxTable(Request request, Warnings* warnings)
    : request_(std::move(request)),
      book_(std::make_shared<const XlsxBook>(read_xlsx_book(request_.file, request_.name))),
      sheet_(chosen_sheet()),
      rows_(request_.file, *book_, sheet_) {
  pass_to_header(warnings);
  see_clocks();
}

XlsxTable::XlsxTable(Request request, std::shared_ptr<const XlsxBook> book,
                     const XlsxBook::Sheet& sheet, Warnings* warnings)
    : request_(std::move(request)),
      book_(std::move(book)),
      sheet_(sheet),
      rows_(request_.file, *book_, sheet_) {
  pass_to_header(warnings);
  see_clocks();
}

std::unique_ptr<Table> XlsxTable::again() const {
  return std::unique_ptr<Table>(new XlsxTable(request_, book_, sheet_, nullptr));
}

/// The sheet that is named, or else the only one that has a cell and is not hidden.
const XlsxBook::Sheet& XlsxTable::chosen_sheet() const {
  std::vector<const XlsxBook::Sheet*> all, filled;
  for (const XlsxBook::Sheet& sheet : book_->sheets) {
    all.push_back(&sheet);
    if (sheet.name == request_.layer) return sheet;
    if (!request_.layer.empty() || sheet.is_hidden) continue;
    if (!XlsxRows(request_.file, *book_, sheet).ahead().empty()) filled.push_back(&sheet);
  }
  if (!request_.layer.empty()) {
    throw Error(Message{request_.file, 0, "has no layer " + quoted(request_.layer, 80),
                        "its layers are " + names_of(all)});
  }
  if (filled.empty()) throw Error(Message{request_.file, 0, "has no sheet with a cell", {}});
  if (filled.size() > 1) {
    throw Error(Message{request_.file, 0, "has several layers: " + names_of(filled),
                        "name one with " + setting(request_.layer_setting)});
  }
  return *filled.front();
}

void XlsxTable::pass_to_header(Warnings* warnings) {
  std::size_t passed = 0;
  if (request_.skip) {
    while (!rows_.ahead().empty() && rows_.ahead().front().number <= *request_.skip) rows_.next();
  } else {
    passed = above_header(rows_.ahead());
    for (std::size_t i = 0; i < passed; ++i) rows_.next();
  }
  const XlsxRow* const row = rows_.next();
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

/// Notes which columns have times with a clock, for their midnights are to have one too.
void XlsxTable::see_clocks() {
  has_clock_.assign(header_.size(), false);
  for (const XlsxRow& row : rows_.ahead()) {
    for (std::size_t i = 0; i < std::min(row.cells.size(), header_.size()); ++i) {
      const XlsxCell& cell = row.cells[i];
      if (cell.is_time && (cell.form.has_clock || has_clock(cell.serial))) has_clock_[i] = true;
    }
  }
}

bool XlsxTable::next(Row& row) {
  const XlsxRow* read = nullptr;
  while ((read = rows_.next()) != nullptr && read->cells.size() > header_.size()) {
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

std::string XlsxTable::text_of(const XlsxCell& cell, std::size_t column) const {
  if (!cell.is_time) return cell.text;
  return time_of_serial(cell.serial, cell.form, has_clock_[column], book_->from_1904)
      .value_or(shortest_text(cell.serial));
}

}  // namespace thiessen
