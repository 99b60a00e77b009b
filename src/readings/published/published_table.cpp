#include "readings/published/published_table.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "readings/units/rain_unit.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

bool unit_is_said(const ReadingsOptions& options) {
  return options.from_unit || options.scale;
}

std::string in_words(std::string_view unit) {
  if (unit == "0.1mm") return "tenths of a millimetre";
  if (unit == "in") return "inches";
  if (unit == "0.01in") return "hundredths of an inch";
  return "millimetres";
}

/// What a publisher's key says of a mark; empty where it says nothing.
std::string_view meaning_of(std::string_view mark, std::string_view key) {
  for (const std::string_view entry : parted(key, '|')) {
    const auto sides = parted(entry, '=');
    if (sides.size() == 2 && sides[0] == mark) return sides[1];
  }
  return {};
}

std::string one_or_counted(std::size_t count, const char* one, const char* several) {
  return count == 1 ? one : std::to_string(count) + several;
}

}  // namespace

PublishedTable::PublishedTable(std::unique_ptr<Table> table, const PublishedFormat& format,
                               const ReadingsOptions& options, Warnings& warnings)
    : TableOver(std::move(table)),
      format_(format),
      warnings_(warnings),
      value_(published_column(header(), format.value).value()),
      requires_whole_(format.whole_numbers && !unit_is_said(options)) {
  if (!format.kept.empty()) {
    const auto kept = parted(format.kept, '=');
    kept_ = published_column(header(), kept[0]);
    kept_text_ = kept[1];
  }
  if (!format.flags.empty() && !options.keep_flagged)
    flags_ = published_column(header(), format.flags);
  if (!format.marks.empty() && value_ > 0 && has_published_name(header()[value_ - 1], format.marks))
    marks_ = value_ - 1;
  if (!format.period.empty()) period_ = published_column(header(), format.period);
  if (!format.source.empty()) source_ = published_column(header(), format.source);
}

PublishedTable::PublishedTable(const PublishedTable& other, std::unique_ptr<Table> table)
    : TableOver(std::move(table)),
      format_(other.format_),
      warnings_(other.warnings_),
      value_(other.value_),
      kept_(other.kept_),
      flags_(other.flags_),
      marks_(other.marks_),
      period_(other.period_),
      source_(other.source_),
      kept_text_(other.kept_text_),
      requires_whole_(other.requires_whole_),
      told_(other.told_) {}

std::unique_ptr<Table> PublishedTable::over(std::unique_ptr<Table> table) const {
  return std::unique_ptr<Table>(new PublishedTable(*this, std::move(table)));
}

bool PublishedTable::next(Row& row) {
  if (std::exchange(has_ahead_, false)) {
    std::swap(row, ahead_);
    return true;
  }
  while (table_->next(row)) {
    if (takes(row)) return true;
  }
  tell();
  return false;
}

bool PublishedTable::is_waiting(std::chrono::milliseconds patience) {
  while (!has_ahead_) {
    if (table_->is_waiting(patience)) return true;
    if (!table_->next(ahead_)) return false;  // the end, which comes again
    has_ahead_ = takes(ahead_);
  }
  return false;
}

/// Whether a row is one of rain. Empties a value that does not count.
bool PublishedTable::takes(Row& row) {
  if (kept_ && trimmed(row.fields[*kept_]) != kept_text_) return false;
  const bool has_value = !trimmed(row.fields[value_]).empty();
  const bool flagged = has_value && flags_ && has_flag(row);
  const bool of_days = has_value && period_ && is_of_days(row);
  if (has_value && source_ && is_of_model(row)) ++of_models_;
  if (has_value && marks_) note_mark(row);
  if (flagged || of_days) {
    ++(flagged ? flagged_ : of_days_);
    row.fields[value_] = {};
    row.padded = false;
  } else if (requires_whole_) {
    require_whole(row);
  }
  return true;
}

bool PublishedTable::has_flag(const Row& row) const {
  const auto flags = parted(row.fields[*flags_], ',');
  return format_.flag_place < flags.size() && !flags[format_.flag_place].empty();
}

bool PublishedTable::is_of_days(const Row& row) const {
  const std::string_view days = trimmed(row.fields[*period_]);
  return !days.empty() && days != "1";
}

bool PublishedTable::is_of_model(const Row& row) const {
  const auto models = parted(format_.models, ' ');
  return std::ranges::any_of(models, [&](std::string_view model) {
    return row.fields[*source_].find(model) != std::string_view::npos;
  });
}

/// Counts a mark that is not the usual one. A value that is a trace's becomes 0.
void PublishedTable::note_mark(Row& row) {
  constexpr std::size_t most = 20;
  const std::string_view mark = trimmed(row.fields[*marks_]);
  if (mark.empty() || mark == "0") return;
  const auto traces = parted(format_.trace_marks, ' ');
  if (std::ranges::find(traces, mark) != traces.end()) {
    row.fields[value_] = "0";
    row.padded = false;
  }
  if (const auto known = marked_.find(mark); known != marked_.end()) {
    ++known->second;
  } else if (marked_.size() < most) {
    marked_.emplace(mark, 1);
  } else {
    ++otherwise_marked_;
  }
}

/// An order of the same columns may be in millimetres or inches, and these have fractions.
void PublishedTable::require_whole(const Row& row) const {
  const std::string_view value = trimmed(row.fields[value_]);
  if (value.find('.') == std::string_view::npos) return;
  throw Error({file(), row.line,
               quoted(value) + " is no whole number, so that the values are not in " +
                   in_words(format_.unit) + ", as " + std::string(format_.name) + " has them",
               setting("from_unit", "mm") + " or " + setting("from_unit", "in") +
                   " says what they are in"});
}

void PublishedTable::tell() {
  if (std::exchange(told_->at_end, true)) return;
  if (flagged_ > 0) {
    warnings_.add_notice({file(), 0,
                          one_or_counted(flagged_, "a value that failed a check of quality is",
                                         " values that failed a check of quality are") +
                              " missing; " + setting("keep_flagged") + " reads them",
                          ""});
  }
  if (of_days_ > 0) {
    warnings_.add(
        {file(), 0,
         one_or_counted(of_days_, "an amount of several days is", " amounts of several days are") +
             " taken as missing, for nothing tells how much fell on which day",
         ""});
  }
  if (!marked_.empty()) tell_marks();
  if (of_models_ > 0) {
    warnings_.add({file(), 0,
                   one_or_counted(of_models_, "a value is", " values are") +
                       " a weather model's, and no gauge's, as " + std::string(format_.source) +
                       " tells",
                   ""});
  }
}

/// Tells how many values have which mark, and what became of them. A mark that the publisher's key
/// lacks may mean anything, which is a warning.
void PublishedTable::tell_marks() {
  std::string all;
  std::size_t unknown = otherwise_marked_;
  const auto traces = parted(format_.trace_marks, ' ');
  for (const auto& [mark, count] : marked_) {
    const std::string_view meaning = meaning_of(mark, format_.key);
    const bool is_trace = std::ranges::find(traces, mark) != traces.end();
    if (meaning.empty()) unknown += count;
    all += (all.empty() ? "" : ", ") + std::to_string(count) + " of " + quoted(mark, 20) +
           (meaning.empty() ? std::string(", which the publisher's key lacks")
                            : " (" + std::string(meaning) + (is_trace ? ", read as 0)" : ")"));
  }
  if (otherwise_marked_ > 0) all += ", " + std::to_string(otherwise_marked_) + " of others";
  const Message message{
      file(), 0,
      "values with another indicator (" + std::string(format_.marks) + ") than 0 count: " + all,
      ""};
  if (unknown > 0) {
    warnings_.add(message);
  } else {
    warnings_.add_notice(message);
  }
}

namespace {

/// The error that only who ordered a file knows its unit.
Error asks_for_unit(const PublishedFormat& format, const Table& table) {
  std::string words;
  Wording hint;
  const auto units = parted(format.ordered_units, ' ');
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::string between = i == 0 ? "" : i + 1 == units.size() ? " or " : ", ";
    words += between + "in " + in_words(units[i]);
    hint += between + setting("from_unit", units[i]);
  }
  return Error({table.file(), table.header_line(),
                "it is " + std::string(format.name) + ", which may be " + words +
                    ", and it does not say which",
                hint + " says it"});
}

}  // namespace

ReadingsOptions options_of(const PublishedFormat& format, const Table& table,
                           ReadingsOptions options) {
  const auto& header = table.header();
  const auto name_of = [&](std::string_view column) {
    return header[published_column(header, column).value()];
  };
  if (options.station_field.empty() && !format.station.empty())
    options.station_field = name_of(format.station);
  if (options.time_fields.empty()) {
    for (const std::string_view column : parted(format.time, ','))
      options.time_fields.push_back(name_of(column));
  }
  if (options.value_field.empty()) options.value_field = name_of(format.value);
  for (const std::string_view text : parted(format.missing, ' '))
    if (!text.empty()) options.missing.emplace_back(text);
  if (!format.trace.empty()) options.trace.emplace_back(format.trace);
  options.ids_as_numbers = options.ids_as_numbers || format.ids_as_numbers;
  options.day_first = options.day_first || format.day_first;
  if (format.times_end_steps) options.stamp = Stamp::end;
  if (unit_is_said(options)) return options;
  const std::size_t value = published_column(header, format.value).value();
  if (format.unit_is_ordered && !rain_unit(table.unit(value))) throw asks_for_unit(format, table);
  if (!format.unit.empty()) options.from_unit = rain_unit(format.unit);
  return options;
}

void tell_format(const PublishedFormat& format, const Table& table, const ReadingsOptions& said,
                 bool tells_encoding, Warnings& warnings) {
  const auto column = published_column(table.header(), format.value);
  std::string text = "read as " + std::string(format.name) + ": rain is ";
  text += format.kept.empty() ? table.header()[column.value()]
                              : std::string(parted(format.kept, '=')[1]);
  if (!format.unit.empty() && !unit_is_said(said)) text += ", in " + in_words(format.unit);
  if (format.ids_as_numbers && !said.ids_as_numbers) text += "; ids of stations compare as numbers";
  if (tells_encoding) text += "; it is written in " + std::string(format.encoding);
  warnings.add_notice({table.file(), 0, std::move(text), ""});
  if (format.is_of_basins) {
    warnings.add(
        {table.file(), 0,
         "its rain is the mean over the basin of a river gauge, and stands for a rain gauge "
         "there",
         ""});
  }
  const auto unit = rain_unit(format.unit);
  if (!unit || !said.from_unit || said.from_unit->depth == unit->depth) return;
  warnings.add({table.file(), 0,
                "its values are taken to be in " + said.from_unit->name() + ", as " +
                    setting("from_unit") + " says, against its format",
                ""});
}

}  // namespace thiessen
