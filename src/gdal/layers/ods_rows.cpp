#include "gdal/layers/ods_rows.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t most_columns = 16'384;  // as LibreOffice has it
constexpr std::size_t most_rows = 1'048'576;
constexpr double seconds_a_day = 86'400;
constexpr double days_to_1970 = 25'569;

/// How often an element stands, which is written once.
std::size_t repeated(std::string_view times) {
  const auto number = parse_size(times);
  return number ? std::min(number.value, most_rows) : 1;
}

/// A time such as 2020-01-01T06:00:00.000000000, or a day.
std::optional<SheetCell> time_cell(std::string_view text) {
  const ParsedTime read = parse_iso_time(text);
  if (!read || read.time.precision < TimePrecision::day) return std::nullopt;
  const double seconds =
      static_cast<double>(clock_seconds(read.time)) + read.time.nanosecond * 1e-9;
  SheetCell cell;
  cell.is_time = true;
  cell.serial = seconds / seconds_a_day + days_to_1970;
  cell.form = {true, read.time.precision == TimePrecision::instant};
  return cell;
}

/// A clock or a length of time such as PT06H30M00.5S.
std::optional<SheetCell> clock_cell(std::string_view text) {
  if (!text.starts_with("PT")) return std::nullopt;
  text.remove_prefix(2);
  double seconds = 0;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("HMS");
    if (end == std::string_view::npos) return std::nullopt;
    const auto number = parse_number(text.substr(0, end));
    if (!number) return std::nullopt;
    seconds += number.value * (text[end] == 'H' ? 3600 : text[end] == 'M' ? 60 : 1);
    text.remove_prefix(end + 1);
  }
  SheetCell cell;
  cell.is_time = true;
  cell.serial = seconds / seconds_a_day;
  cell.form = {false, true};
  return cell;
}

class SheetNames : public XmlListener {
 public:
  std::vector<std::string> names;

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element != "table") return;
    if (depth_++ == 0) names.emplace_back(attributes["name"]);
  }
  void end(std::string_view element) override {
    if (element == "table") --depth_;
  }
  void text(std::string_view /*part*/) override {}

 private:
  std::size_t depth_ = 0;
};

/// Hears the rows of one sheet; tables within its cells are none of it.
class OdsListener : public SheetListener {
 public:
  OdsListener(std::string file, std::size_t sheet) : file_(std::move(file)), sheet_(sheet) {}

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element == "table" && depth_++ == 0) is_in_sheet_ = sheets_++ == sheet_;
    if (!is_in_sheet_ || depth_ != 1) return;
    if (element == "annotation") ++remarks_;
    if (remarks_ > 0) return;
    if (element == "table-row") {
      row_ = {last_ + 1, {}, repeated(attributes["number-rows-repeated"])};
      last_ += row_.times;
      column_ = 0;
    } else if (element == "table-cell" || element == "covered-table-cell") {
      begin_cell(attributes);
    } else if (element == "p" && is_in_cell_) {
      if (paragraphs_++ > 0) words_ += '\n';
      ++in_paragraph_;
    } else if (element == "s" && in_paragraph_ > 0) {
      words_.append(std::min<std::size_t>(repeated(attributes["c"]), most_blanks), ' ');
    } else if ((element == "tab" || element == "line-break") && in_paragraph_ > 0) {
      words_ += element == "tab" ? '\t' : '\n';
    }
  }

  void end(std::string_view element) override {
    const bool is_of_sheet = is_in_sheet_ && depth_ == 1;
    if (element == "table" && --depth_ == 0) is_in_sheet_ = false;
    if (!is_of_sheet) return;
    if (element == "annotation") {
      --remarks_;
    } else if (remarks_ > 0) {
      return;
    } else if (element == "p" && in_paragraph_ > 0) {
      --in_paragraph_;
    } else if (element == "table-cell" || element == "covered-table-cell") {
      end_cell();
    } else if (element == "table-row") {
      end_row();
    }
  }

  void text(std::string_view part) override {
    if (in_paragraph_ > 0 && remarks_ == 0 && depth_ == 1) words_ += part;
  }

 private:
  static constexpr std::size_t most_blanks = 1'000;

  void begin_cell(const XmlAttributes& attributes) {
    cells_ = repeated(attributes["number-columns-repeated"]);
    type_ = attributes["value-type"];
    value_ = attributes[type_ == "date"      ? "date-value"
                        : type_ == "time"    ? "time-value"
                        : type_ == "boolean" ? "boolean-value"
                        : type_ == "string"  ? "string-value"
                                             : "value"];
    has_formula_ = !attributes["formula"].empty();
    words_.clear();
    paragraphs_ = 0;
    is_in_cell_ = true;
  }

  void end_cell() {
    is_in_cell_ = false;
    const SheetCell cell = cell_of_value();
    if (!cell.is_empty()) {
      if (column_ + cells_ > most_columns)
        throw Error(Message{file_, row_.number, "a cell stands in no column", {}});
      row_.cells.resize(column_);
      row_.cells.insert(row_.cells.end(), cells_, cell);
    }
    column_ += cells_;
  }

  SheetCell cell_of_value() const {
    std::optional<SheetCell> cell;
    if (type_ == "date") cell = time_cell(value_);
    if (type_ == "time") cell = clock_cell(value_);
    if (cell) return *cell;
    cell.emplace();
    if (type_ == "boolean") {
      cell->text = value_ == "true" ? "1" : "0";
    } else if (type_ == "float" || type_ == "percentage" || type_ == "currency") {
      const auto number = parse_number(value_);
      cell->text = number ? shortest_text(number.value) : value_;
    } else {
      cell->text = value_.empty() ? words_ : value_;
      if (cell->text == "#N/A") cell->text.clear();
      if (type_.empty() && cell->text.empty() && has_formula_) cell->text = "=";
    }
    return *cell;
  }

  void end_row() {
    if (row_.cells.empty()) return;
    if (last_ > most_rows)
      throw Error(Message{file_, row_.number, "a row stands beyond the sheet's end", {}});
    rows.push_back(std::move(row_));
  }

  std::string file_;
  std::size_t sheet_;
  std::size_t sheets_ = 0;  ///< that began so far
  std::size_t depth_ = 0;   ///< tables that are open
  bool is_in_sheet_ = false;
  SheetRow row_;
  std::size_t last_ = 0;  ///< the number of the row that was last read
  std::size_t column_ = 0;
  std::size_t cells_ = 1;  ///< how often the cell comes
  std::string type_;
  std::string value_;
  std::string words_;  ///< what the cell shows
  std::size_t paragraphs_ = 0;
  std::size_t in_paragraph_ = 0;
  std::size_t remarks_ = 0;
  bool is_in_cell_ = false;
  bool has_formula_ = false;
};

}  // namespace

std::vector<std::string> ods_sheets(const std::string& file, const std::string& document) {
  SheetNames listener;
  XmlReader(file, document, listener).read_all();
  return std::move(listener.names);
}

std::unique_ptr<SheetRows> ods_rows(const std::string& file, const std::string& document,
                                    std::size_t sheet) {
  return std::make_unique<SheetRows>(file, document, std::make_unique<OdsListener>(file, sheet));
}

}  // namespace thiessen
