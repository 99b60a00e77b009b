#include "readings/times/time_reader.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/times/time_shape.h"

namespace thiessen {
namespace {

constexpr std::size_t most_formats = 16;

}  // namespace

TimeReader::TimeReader(const std::string& format, bool day_first) {
  if (day_first) order_ = Order::day_first;
  if (format.empty()) return;
  if (!TimeFormat::is_sound(format)) {
    throw Error({"", 0, setting("time_format", format) + " does not say what time it is",
                 "such as '%d/%m/%Y %H:%M', or excel for serial numbers"});
  }
  given_.emplace(format);
}

void TimeReader::see(std::string_view text, std::size_t line) {
  if (given_) {
    const Parsed<double> number = parse_number(trimmed(text));
    if (given_->is_excel() && number && number.value != std::floor(number.value))
      serials_have_clocks_ = true;
    return;
  }
  text = trimmed(text);
  if (text.empty()) return;
  const ParsedTime iso = parse_iso_time(text);
  // A date that does not exist says that times are not of this calendar.
  if (iso || iso.fault == IsoTimeFault::value) return note(bool(iso), before_);
  const bool was_told = order_ != Order::unknown;
  note(read_written(text, line).has_value(), before_);
  if (!was_told && order_ != Order::unknown) told_late_ = is_left_open_;
  // A time that may be read in two ways tells nothing here, and others may follow.
  is_left_open_ = is_left_open_ || is_begun_;
  is_begun_ = false;
}

std::optional<WrittenTime> TimeReader::read(std::string_view text, std::size_t line) {
  text = trimmed(text);
  if (given_) return read_given(text);
  const ParsedTime iso = parse_iso_time(text);
  if (iso) note(true, since_);
  if (iso || iso.fault == IsoTimeFault::value || text.empty()) return std::nullopt;
  std::optional<WrittenTime> time = read_written(text, line);
  if (!time && !may_be_labels()) return no_time(text);
  note(time.has_value(), since_);
  return time || told_open_ ? time : left_open(text);
}

bool TimeReader::is_no_time(std::string_view text, std::size_t line) {
  const std::optional<WrittenTime> time = read(text, line);
  return time && time->is_no_time();
}

/// A time that is not written as ISO 8601 wants it; nothing where it is a label.
std::optional<WrittenTime> TimeReader::read_written(std::string_view text, std::size_t line) {
  const Formats* formats = formats_of(text);
  if (formats == nullptr) return std::nullopt;
  const ParsedTime first = formats->one.read(text);
  if (!formats->month_first) {
    return WrittenTime{first, {}, {}};
  }
  const ParsedTime second = formats->month_first->read(text);
  if (first && second && order_of_moments(first.time, second.time) != 0 &&
      order_ == Order::unknown) {
    is_begun_ = true;
    return ambiguous(first, second, *formats);
  }
  return read_ordered(text, line, first, second);
}

void TimeReader::note(bool is_time, Seen& seen) {
  if (!is_time && seen.times + seen.labels < 2) seen.begins_with_times = false;
  ++(is_time ? seen.times : seen.labels);
}

bool TimeReader::may_be_labels() const {
  if (are_of_parts_) return false;
  if (before_.times + before_.labels > 1)
    return !before_.begins_with_times || before_.times < 2 || before_.times <= before_.labels;
  return since_.labels > 0 || since_.times < 3;
}

WrittenTime TimeReader::no_time(std::string_view text) const {
  WrittenTime time;
  time.breaks_format = true;
  if (are_of_parts_) {
    time.fault = " is no time";
    time.hint = setting("time_format") +
                " says how the texts of its columns are written, with blanks between them";
    return time;
  }
  time.fault = " is no time, as those of the other rows are";
  if (!column_.empty() && text.find_first_of("'\"") == std::string_view::npos) {
    time.hint = setting("rainfall_where", "\"" + column_ + "\"<>'" + std::string(text) + "'") +
                " leaves such rows out";
  } else {
    time.hint = "take the row out of the file";
  }
  return time;
}

/// A text that some format reads, if it is one; it is not known by the calendar.
std::optional<WrittenTime> TimeReader::left_open(std::string_view text) {
  const std::vector<std::string> formats = open_formats(text);
  if (formats.empty()) return std::nullopt;
  told_open_ = true;
  WrittenTime time;
  time.fault = " is not written as ISO 8601 wants it";
  for (const std::string& format : formats) {
    const std::string iso = iso_text(TimeFormat(format).read(text).time);
    time.hint += (time.hint.empty() ? "" : ", ") + setting("time_format", format) +
                 (time.hint.empty() ? " reads it as " : " as ") + iso;
  }
  return time;
}

TimeReader::OrderTold TimeReader::order_told() const {
  if (!told_late_) return {};
  return {told_by_, told_in_, order_ == Order::day_first};
}

WrittenTime TimeReader::read_given(std::string_view text) const {
  WrittenTime time{given_->read(text), {}, {}};
  if (time.parsed && given_->is_excel() && serials_have_clocks_)
    time.parsed.time.precision = TimePrecision::instant;
  if (time.parsed) return time;
  time.breaks_format = true;
  time.fault = time.parsed.fault == IsoTimeFault::value
                   ? Wording(" does not exist")
                   : " is not written as " + setting("time_format", given_->text()) + " says";
  return time;
}

/// A time whose order is known, or that leaves no choice, and so tells it.
WrittenTime TimeReader::read_ordered(std::string_view text, std::size_t line,
                                     const ParsedTime& day_first, const ParsedTime& month_first) {
  if (bool(day_first) != bool(month_first)) {
    const Order order = day_first ? Order::day_first : Order::month_first;
    if (order_ == Order::unknown && !is_begun_) {
      order_ = order;
      told_by_ = text;
      told_in_ = line;
    }
    if (order_ != Order::unknown && order_ != order) return contradiction();
    return {day_first ? day_first : month_first, {}, {}};
  }
  return {order_ == Order::month_first ? month_first : day_first, {}, {}};
}

WrittenTime TimeReader::contradiction() const {
  const bool day = order_ == Order::day_first;
  WrittenTime time;
  time.parsed.fault = IsoTimeFault::value;
  time.breaks_format = true;
  const std::string other = told_by_.empty()
                                ? std::string("its format")
                                : quoted(told_by_, 80) + " in line " + std::to_string(told_in_);
  time.fault = std::string(" has the ") + (day ? "month" : "day") + " first, and " + other +
               " the " + (day ? "day" : "month");
  return time;
}

WrittenTime TimeReader::ambiguous(const ParsedTime& day_first, const ParsedTime& month_first,
                                  const Formats& formats) {
  const auto date = [](const ParsedTime& time) { return date_text(time.time, TimePrecision::day); };
  WrittenTime time;
  time.parsed.fault = IsoTimeFault::form;
  time.fault = " could be " + date(day_first) + " or " + date(month_first);
  time.hint = setting("time_format", formats.one.text()) + " reads it as " + date(day_first) +
              ", " + setting("time_format", formats.month_first->text()) + " as " +
              date(month_first);
  return time;
}

/// The formats in which a text is written: of the last ones, those that read it.
const TimeReader::Formats* TimeReader::formats_of(std::string_view text) {
  for (const Formats& formats : formats_) {
    if (formats.one.read(text) || (formats.month_first && formats.month_first->read(text)))
      return &formats;
  }
  TimeShape shape = time_shape(text);
  if (shape.format.empty()) return nullptr;
  if (formats_.size() == most_formats) formats_.clear();
  Formats formats{TimeFormat(std::move(shape.format)), std::nullopt};
  if (!shape.month_first.empty()) formats.month_first.emplace(std::move(shape.month_first));
  formats_.push_back(std::move(formats));
  return &formats_.back();
}

}  // namespace thiessen
