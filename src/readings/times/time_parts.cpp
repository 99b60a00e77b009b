#include "readings/times/time_parts.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/times/time_format.h"
#include "readings/times/time_shape.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Part = TimeColumns::Part;
using Column = TimeColumns::Column;

/// Whether a text is a whole number of so many digits, within these bounds.
bool is_number(std::string_view text, std::size_t digits, std::size_t low, std::size_t high) {
  const Parsed<std::size_t> number = parse_size(text);
  return number && text.size() <= digits && number.value >= low && number.value <= high;
}

/// Whether a text can be such a part of a time.
bool can_be(std::string_view text, Part part) {
  text = trimmed(text);
  if (part != Part::text && text.ends_with(".0")) text.remove_suffix(2);
  switch (part) {
    case Part::text:
      return true;
    case Part::year:
      return text.size() == 4 && is_number(text, 4, 1000, 9999);
    case Part::month:
      return is_number(text, 2, 1, 12) || month_called(text);
    case Part::day:
      return is_number(text, 2, 1, 31);
    case Part::day_of_year:
      return is_number(text, 3, 1, 366);
    case Part::hour:
      return text.size() > 2 ? is_number(text, 4, 0, 2400) : is_number(text, 2, 0, 24);
    case Part::hour_minute:
      return is_number(text, 4, 0, 2400);
    case Part::minute:
      return is_number(text, 2, 0, 59);
    case Part::second:
      return is_number(text.substr(0, text.find('.')), 2, 0, 59);
  }
  return false;
}

/// Looks for the parts of a time.
class PartFinder {
 public:
  explicit PartFinder(const TimeCandidates& candidates) : candidates_(candidates) {
    const auto& header = candidates.header;
    for (std::size_t i = 0; i < header.size(); ++i) {
      const Part part = TimeColumns::part_called(header[i]);
      if ((part != Part::text || is_of_time(header[i])) && candidates.may_be_of_time(i))
        columns_.push_back({i, part});
    }
    if (columns_.size() > 1) first_row_ = candidates.first_row();
  }

  std::optional<std::size_t> column(Part part) const {
    const auto found = std::ranges::find(columns_, part, &Column::part);
    return found == columns_.end() ? std::nullopt : std::optional(found->field);
  }
  /// The column of this name that holds no part of a date or clock by itself.
  std::optional<std::size_t> column(std::span<const std::string_view> names) const {
    const auto found = std::ranges::find_if(columns_, [&](const Column& one) {
      return one.part == Part::text && find_field({name(one.field)}, names);
    });
    return found == columns_.end() ? std::nullopt : std::optional(found->field);
  }

  /// The text of the first row; empty where it is not known.
  std::string_view first(std::size_t field) const {
    return field < first_row_.size() ? std::string_view(first_row_[field]) : std::string_view();
  }

  bool hold_such_parts(const std::vector<Column>& columns) const {
    return !sees_row() || std::ranges::all_of(columns, [&](const Column& one) {
      return can_be(first(one.field), one.part);
    });
  }

  std::string joined(TimeColumns columns) const {
    Row row;
    row.fields.assign(first_row_.begin(), first_row_.end());
    return std::string(columns.text(row));
  }

  const std::string& name(std::size_t field) const { return candidates_.header[field]; }
  bool sees_row() const { return !first_row_.empty(); }

 private:
  /// Whether a name is one of a date, a clock, or of what is no part of either by itself.
  static bool is_of_time(const std::string& name) {
    return find_field({name}, known::dates) || find_field({name}, known::clocks) ||
           find_field({name}, known::parts_of_months) || find_field({name}, known::parts_of_years);
  }

  std::vector<std::string> first_row_;
  const TimeCandidates& candidates_;
  std::vector<Column> columns_;  ///< those that are called as a part of a time
};

/// The columns of a date, with the day or without; none where they make up no date alone.
std::vector<Column> date_columns(const PartFinder& finder) {
  const auto year = finder.column(Part::year);
  const auto month = finder.column(Part::month);
  const auto day = finder.column(Part::day);
  const auto day_of_year = finder.column(Part::day_of_year);
  if (!year) return {};
  std::vector<Column> columns = {{*year, Part::year}};
  if (month && day) {
    columns.insert(columns.end(), {{*month, Part::month}, {*day, Part::day}});
  } else if (month && !day && !day_of_year && !finder.column(known::parts_of_months) &&
             !finder.column(Part::hour)) {
    columns.push_back({*month, Part::month});
    return columns;
  } else if (month || day || !day_of_year) {
    return {};
  }
  if (day_of_year) columns.push_back({*day_of_year, Part::day_of_year});
  return columns;
}

bool has_day(const std::vector<Column>& columns) {
  return std::ranges::any_of(columns, [](const Column& one) {
    return one.part == Part::day || one.part == Part::day_of_year;
  });
}

/// Adds hour, minute and second, each where the one before is there.
void add_parts_of_clock(const PartFinder& finder, std::vector<Column>& columns) {
  if (const auto both = finder.column(Part::hour_minute))
    return columns.push_back({*both, Part::hour_minute});
  for (const Part part : {Part::hour, Part::minute, Part::second}) {
    const auto found = finder.column(part);
    if (!found) break;
    columns.push_back({*found, part});
  }
}

void add_clock(const PartFinder& finder, std::vector<Column>& columns) {
  const std::size_t before = columns.size();
  add_parts_of_clock(finder, columns);
  if (columns.size() > before) return;
  const auto clock = finder.column(known::clocks);
  if (clock && is_clock(finder.first(*clock))) columns.push_back({*clock, Part::text});
}

/// Whether a column is called as no part of a time, so that it holds a whole one or a date.
bool is_text(const PartFinder& finder, std::size_t column) {
  return TimeColumns::part_called(finder.name(column)) == Part::text;
}

/// Whether a text is a date, be it one whose century or order is open.
bool holds_date(std::string_view text) {
  return is_date(text) || !open_formats(text).empty();
}

/// The columns of a time of which one is taken for all of it, be it of dates or of clocks.
std::vector<Column> columns_beside(const PartFinder& finder, std::size_t taken) {
  std::vector<Column> columns;
  if (!finder.sees_row() || is_date_with_clock(finder.first(taken))) return columns;
  if (!holds_date(finder.first(taken))) {
    const auto date = finder.column(known::dates);
    if (date && holds_date(finder.first(*date))) return {{*date, Part::text}, {taken, Part::text}};
    // A number of the row, or an id, beside a date in its parts.
    columns = date_columns(finder);
    return finder.hold_such_parts(columns) ? columns : std::vector<Column>();
  }
  columns = {{taken, Part::text}};
  add_parts_of_clock(finder, columns);
  const auto clock = finder.column(known::clocks);
  if (columns.size() == 1 && clock && *clock != taken) columns.push_back({*clock, Part::text});
  return columns;
}

/// All columns that are called as a part of a time, the larger parts first; what is no part of a
/// date, such as a week, only where there is no day.
std::vector<Column> columns_meant(const PartFinder& finder) {
  std::vector<Column> columns;
  const auto add = [&](std::optional<std::size_t> field, Part part) {
    if (field) columns.push_back({*field, part});
  };
  for (const Part part : {Part::year, Part::month, Part::day}) add(finder.column(part), part);
  const bool has_date = finder.column(Part::month) && finder.column(Part::day);
  if (!has_date) add(finder.column(Part::day_of_year), Part::day_of_year);
  if (!has_day(columns)) {
    add(finder.column(known::parts_of_years), Part::text);
    add(finder.column(known::parts_of_months), Part::text);
  }
  add_parts_of_clock(finder, columns);
  if (!finder.column(Part::hour) && !finder.column(Part::hour_minute))
    add(finder.column(known::clocks), Part::text);
  return columns;
}

/// How a format has such a part, by its text in the first row; nothing of any other text.
std::string conversion(Part part, std::string_view text, bool has_month) {
  const bool is_short = text.size() <= 2;
  switch (part) {
    case Part::text:
      break;
    case Part::year:
      return is_short ? "%y" : "%Y";
    case Part::month:
      return month_called(text) ? "%b" : "%m";
    case Part::day:
      return has_month ? "%d" : "%j";
    case Part::day_of_year:
      return "%j";
    case Part::hour:
      return is_short ? "%H" : "%H%M";
    case Part::hour_minute:
      return "%H%M";
    case Part::minute:
      return "%M";
    case Part::second:
      return "%S";
  }
  return {};
}

/// The format that the texts of the first row want, parted by blanks; empty where they want none,
/// or where none is known.
std::string format_wanted(const PartFinder& finder, std::vector<Column> columns) {
  const std::string text = finder.joined(TimeColumns(columns));
  const std::string shape = time_shape(text).format;
  if (parse_iso_time(text) || (!shape.empty() && TimeFormat(shape).read(text))) return {};
  const bool has_month =
      std::ranges::any_of(columns, [](const Column& one) { return one.part == Part::month; });
  std::string format;
  for (Column& column : columns) {
    const std::string part =
        conversion(column.part, trimmed(finder.first(column.field)), has_month);
    if (part.empty()) return {};
    format += (format.empty() ? "" : " ") + part;
    column.part = Part::text;
  }
  const bool reads = TimeFormat::is_sound(format) &&
                     TimeFormat(format).read(finder.joined(TimeColumns(std::move(columns))));
  return reads ? format : std::string();
}

/// Whether a column that is called as a part of a time holds whole ones.
bool is_whole(const PartFinder& finder, std::size_t column) {
  const std::string_view text = finder.first(column);
  const ParsedTime time = parse_iso_time(trimmed(text));
  return is_date(text) || is_date_with_clock(text) ||
         (time && time.time.precision >= TimePrecision::day);
}

}  // namespace

std::optional<TimeColumns> time_in_parts(const TimeCandidates& candidates) {
  const PartFinder finder(candidates);
  std::vector<Column> columns = date_columns(finder);
  if (columns.empty()) return std::nullopt;
  if (has_day(columns)) add_clock(finder, columns);
  if (!finder.hold_such_parts(columns)) return std::nullopt;
  return TimeColumns(std::move(columns));
}

Wording time_fields_meant(const TimeCandidates& candidates, std::optional<std::size_t> taken) {
  const PartFinder finder(candidates);
  const bool is_one = taken && !is_text(finder, *taken);
  if (is_one && is_whole(finder, *taken)) return {};
  const std::vector<Column> columns =
      taken && !is_one ? columns_beside(finder, *taken) : columns_meant(finder);
  if (columns.size() < 2) return {};
  Wording hint;
  for (const Column& column : columns)
    hint += (hint.empty() ? "" : " ") + setting("time_field", finder.name(column.field));
  const std::string format = finder.sees_row() ? format_wanted(finder, columns) : std::string();
  if (!format.empty()) hint += " " + setting("time_format", format);
  return hint + " reads the time in these columns";
}

}  // namespace thiessen
