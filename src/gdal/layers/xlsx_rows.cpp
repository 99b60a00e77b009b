#include "gdal/layers/xlsx_rows.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/error.h"
#include "base/number.h"

namespace thiessen {
namespace {

constexpr std::size_t most_columns = 16'384;  // as Excel has it

/// The column of a place such as B12, from 0; most_columns where there is none.
std::size_t column_of(std::string_view place) {
  std::size_t column = 0;
  for (const char c : place) {
    if (c < 'A' || c > 'Z') break;
    column = column * 26 + static_cast<std::size_t>(c - 'A' + 1);
    if (column > most_columns) return most_columns;
  }
  return column == 0 ? most_columns : column - 1;
}

class XlsxListener : public SheetListener {
 public:
  XlsxListener(std::string file, const XlsxBook& book) : file_(std::move(file)), book_(book) {}

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element == "row") {
      const auto number = parse_size(attributes["r"]);
      last_ = number ? number.value : last_ + 1;
      row_ = {last_, {}};
    } else if (element == "c") {
      begin_cell(attributes);
    } else if (element == "f") {
      has_formula_ = true;
    } else if (element == "rPh") {
      in_sound_ = true;
    }
    in_value_ = element == "v" || (element == "t" && !in_sound_);
  }

  void end(std::string_view element) override {
    in_value_ = false;
    if (element == "rPh") in_sound_ = false;
    if (element == "c") end_cell();
    if (element != "row") return;
    while (!row_.cells.empty() && row_.cells.back().is_empty()) row_.cells.pop_back();
    if (!row_.cells.empty()) rows.push_back(std::move(row_));
    row_ = {};
  }

  void text(std::string_view part) override {
    if (in_value_) value_ += part;
  }

 private:
  void begin_cell(const XmlAttributes& attributes) {
    const std::size_t column =
        attributes["r"].empty() ? row_.cells.size() : column_of(attributes["r"]);
    if (column >= most_columns) {
      throw Error(Message{file_, row_.number, "a cell stands in no column", {}});
    }
    column_ = column;
    type_ = attributes["t"];
    value_.clear();
    has_formula_ = false;
    form_ = {};
    const auto form = parse_size(attributes["s"]);
    if (form && form.value < book_.forms.size()) form_ = book_.forms[form.value];
  }

  void end_cell() {
    if (row_.cells.size() <= column_) row_.cells.resize(column_ + 1);
    SheetCell& cell = row_.cells[column_];
    if (type_.empty() || type_ == "n") {
      read_number(cell);
    } else if (type_ == "s") {
      const auto number = parse_size(value_);
      if (!number || number.value >= book_.texts.size()) {
        throw Error(Message{file_, row_.number, "a cell names a text that the file lacks", {}});
      }
      cell.text = book_.texts[number.value];
    } else if (type_ != "e" || value_ != "#N/A") {
      cell.text = value_;
    }
  }

  void read_number(SheetCell& cell) const {
    if (value_.empty() && has_formula_) cell.text = "=";
    if (value_.empty()) return;
    const auto number = parse_number(value_);
    if (!number) {
      cell.text = value_;
    } else if (form_.is_number()) {
      cell.text = shortest_text(number.value);
    } else {
      cell.is_time = true;
      cell.serial = number.value;
      cell.form = form_;
    }
  }

  std::string file_;
  const XlsxBook& book_;
  SheetRow row_;
  std::size_t last_ = 0;
  std::size_t column_ = 0;
  std::string type_;
  std::string value_;
  CellForm form_;
  bool has_formula_ = false;
  bool in_value_ = false;
  bool in_sound_ = false;
};

}  // namespace

std::unique_ptr<SheetRows> xlsx_rows(const std::string& file, const XlsxBook& book,
                                     const XlsxBook::Sheet& sheet) {
  return std::make_unique<SheetRows>(file, sheet.document,
                                     std::make_unique<XlsxListener>(file, book));
}

}  // namespace thiessen
