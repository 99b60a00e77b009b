#include "readings/readings_findings.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "readings/stations/named_stations.h"
#include "text/csv_records.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field_shown = 80;

}  // namespace

ReadingsFindings::ReadingsFindings(std::string file, const ReadingsStations& stations,
                                   bool ignore_unknown, Warnings& warnings)
    : file_(std::move(file)),
      stations_(stations),
      ignore_unknown_(ignore_unknown),
      warnings_(warnings),
      heard_(stations.all().size()),
      steps_(stations.all().size()) {}

Message ReadingsFindings::at(std::size_t row, Wording text, Wording hint) const {
  if (table_ == nullptr || !table_->numbers_rows())
    return {file_, row, std::move(text), std::move(hint)};
  const RowPlace place = table_->place(row);
  if (!place.words.empty()) text = place.words + ": " + text;
  return {place.file, place.line, std::move(text), std::move(hint)};
}

std::string ReadingsFindings::in_words(std::size_t row) const {
  if (table_ == nullptr || !table_->numbers_rows()) return "line " + std::to_string(row);
  const RowPlace place = table_->place(row);
  if (place.line == 0) return place.words;
  const std::string line = "line " + std::to_string(place.line);
  return place.file == file_ ? line : line + " of " + quoted(place.file, longest_field_shown);
}

void ReadingsFindings::note_oddity(const Reading& reading, const Place& place,
                                   std::string_view field, const ReadingGrammar& grammar) {
  if (reading.kind == ReadingKind::amount) return note_amount(reading.amount, place, field);
  const bool is_negative = reading.kind == ReadingKind::negative;
  field = trimmed(field);
  Wording text = (is_negative ? "negative reading " : "reading ") +
                 quoted(field, longest_field_shown) + " of station " +
                 quoted(stations_.id(place.station)) + text_of(reading, field, grammar);
  complaints_.add(at(place.line, std::move(text), hint_for(reading, field, grammar)));
}

/// What is wrong with a reading, as the rest of a sentence.
Wording ReadingsFindings::text_of(const Reading& reading, std::string_view field,
                                  const ReadingGrammar& grammar) {
  using Meant = ReadingGrammar::Meant;
  if (reading.kind == ReadingKind::negative) return {};
  if (reading.kind == ReadingKind::out_of_range) return " is outside the range of numbers";
  const Meant meant = grammar.meant_by(field);
  if (meant == Meant::decimal_comma) return no_number_for_its_comma(field);
  if (meant == Meant::decimal_point)
    return " has a decimal point, and numbers are read with decimal commas";
  return " is no number";
}

/// What may be done about a reading that is wrong. It is told once for each kind of fault: twenty
/// lines that say the same hide what differs.
Wording ReadingsFindings::hint_for(const Reading& reading, std::string_view field,
                                   const ReadingGrammar& grammar) {
  using Meant = ReadingGrammar::Meant;
  constexpr std::size_t longest_code = 20;
  if (reading.kind == ReadingKind::out_of_range) return {};
  const bool is_text = reading.kind == ReadingKind::not_a_number;
  const Meant meant = is_text ? grammar.meant_by(field) : Meant::code;
  if (meant == Meant::code && field.size() > longest_code) return {};
  return told_hints_.emplace(reading.kind, meant).second ? hint_for(meant, field) : Wording();
}

/// The same by what the text is meant for. To take it for a gap or a trace is the way only where it
/// cannot be what a gauge read.
Wording ReadingsFindings::hint_for(ReadingGrammar::Meant meant, std::string_view field) const {
  using Meant = ReadingGrammar::Meant;
  switch (meant) {
    case Meant::decimal_comma:
      return hint_for_its_comma(field, input_);
    case Meant::decimal_point:
      return hint_for_its_point(input_, commas_are_said_);
    case Meant::thousands:
      return "write it without what parts its thousands";
    case Meant::more:
      return "write the number alone, without what stands beside it";
    case Meant::code:
      break;
  }
  return setting("missing", field) + " takes it for a gap, " + setting("trace", field) + " for 0";
}

void ReadingsFindings::note_amount(double amount, const Place& place, std::string_view field) {
  heard_[index(place.station)] = Heard::yes;
  for (Code& code : codes_) {
    if (amount != code.number) continue;
    if (++code.count > 1) return;
    code.first = at(place.line, "", "");
    code.station = place.station;
    return;
  }
  const bool above_year = amount * millimetres_ > more_than_a_year;
  if (!above_year && amount * millimetres_ <= more_than_a_day) return;
  Absurd& absurd = above_year ? above_year_ : above_day_;
  if (++absurd.count > 1) return;
  absurd.first = at(place.line,
                    "reading " + quoted(trimmed(field), longest_field_shown) + " of station " +
                        quoted(stations_.id(place.station)) + " is more than falls anywhere in a ",
                    setting("missing", trimmed(field)) + " takes it for a gap");
}

void ReadingsFindings::note_unknown(std::string_view id, std::size_t line, const std::string& text,
                                    const Wording& hint) {
  if (!unknown_.emplace(id).second) return;
  if (!ignore_unknown_) {
    // The first id of each cause tells what may be done for all of its kind. What is not shown is
    // not looked for: that takes as long as there are stations.
    ReadingsStations::Meant meant;
    if (unknown_.size() <= Complaints::listed_at_most) meant = stations_.meant_by(id);
    const bool fresh = told_causes_.insert(meant.cause).second;
    if (meant.cause == ReadingsStations::Cause::none) meant.hint = hint;
    complaints_.add(at(line, text, fresh ? std::move(meant.hint) : Wording()));
  } else if (first_unknown_.size() < stations_named) {
    first_unknown_.emplace_back(id);
  }
}

void ReadingsFindings::note_format(const TimeStep& step) {
  if (!step.written || !step.written->breaks_format || std::exchange(told_format_, true)) return;
  complaints_.add(at(step.line,
                     "time " + quoted(step.time, longest_field_shown) + step.written->fault,
                     step.written->hint));
}

void ReadingsFindings::note_empty_time(std::size_t line) {
  complaints_.add(at(line, "the time is empty", ""));
}

void ReadingsFindings::note_passed(std::string_view text, std::size_t line) {
  if (++passed_ == 1) {
    first_passed_ = at(
        line, "the row " + quoted(text, longest_field_shown) + " has no time and no reading", "");
  }
}

Message ReadingsFindings::time_twice(std::string_view time, std::size_t line,
                                     std::size_t first_line) const {
  return at(line,
            "time " + quoted(time, longest_field_shown) + " is already in " + in_words(first_line),
            "each time stands once: keep the row that is meant");
}

void ReadingsFindings::conclude(std::size_t steps) {
  complaints_.throw_if_any();
  if (!steps_may_differ_) {
    if (const auto fault = steps_.fault(file_, stations_.all())) throw Error(*fault);
  }
  tell_passed();
  warn_of_unknown();
  if (steps > 0 && tells_silent_) warn_of_silent();
  warn_of_absurd();
  warn_of_codes();
}

void ReadingsFindings::tell_passed() {
  if (passed_ == 0) return;
  first_passed_.text += passed_ == 1 ? std::string(", and is passed over")
                                     : ", and is passed over, as are " +
                                           std::to_string(passed_ - 1) + " more such rows";
  warnings_.add_notice(std::exchange(first_passed_, {}));
}

void ReadingsFindings::warn_of_unknown() {
  if (unknown_.empty()) return;
  const bool one = unknown_.size() == 1;
  const std::string subject =
      one ? "an unknown station is" : std::to_string(unknown_.size()) + " unknown stations are";
  warnings_.add(
      {file_, 0, subject + " passed over: " + named(first_unknown_, unknown_.size()), ""});
}

void ReadingsFindings::warn_of_silent() {
  const auto count = static_cast<std::size_t>(std::count(heard_.begin(), heard_.end(), Heard::no));
  if (count == 0) return;
  std::vector<std::string> first;
  for (std::size_t i = 0; i < heard_.size() && first.size() < stations_named; ++i) {
    if (heard_[i] == Heard::no) first.push_back(stations_.all()[i].id);
  }
  warnings_.add({file_, 0, without_readings(first, count, ""), ""});
}

void ReadingsFindings::warn_of_absurd() {
  const auto warn = [&](Absurd& absurd, const char* period) {
    if (absurd.count == 0) return;
    absurd.first.text += period;
    if (absurd.count > 1)
      absurd.first.text += ", and so are " + std::to_string(absurd.count - 1) + " more";
    warnings_.add(std::exchange(absurd.first, {}));
  };
  const std::optional<StepLength> step = steps_.intervals().step();
  if (step && step->is_a_day_or_less()) warn(above_day_, "day");
  warn(above_year_, "year");
}

void ReadingsFindings::warn_of_codes() {
  for (const Code& code : codes_) {
    if (code.count < 2) continue;
    warnings_.add({code.first.file, code.first.line,
                   code.first.text + "reading " + std::string(code.text) + " of station " +
                       quoted(stations_.id(code.station)) + " comes " + std::to_string(code.count) +
                       " times in the file: it may stand for a gap",
                   setting("missing", code.text) + " takes it for one"});
  }
}

}  // namespace thiessen
