#include "readings/readings_findings.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t names_listed = 10;
constexpr std::size_t longest_field_shown = 80;

/// Lists the names, as in "'A', 'B' and 3 more" where there are more than are shown.
std::string list(const std::vector<std::string>& first, std::size_t count) {
  std::string all;
  for (const std::string& name : first) all += (all.empty() ? "" : ", ") + quoted(name);
  if (count > first.size()) all += " and " + std::to_string(count - first.size()) + " more";
  return all;
}

}  // namespace

ReadingsFindings::ReadingsFindings(std::string file, const ReadingsStations& stations,
                                   bool ignore_unknown, Warnings& warnings)
    : file_(std::move(file)),
      stations_(stations),
      ignore_unknown_(ignore_unknown),
      warnings_(warnings),
      heard_(stations.all().size()) {}

void ReadingsFindings::note_oddity(const Reading& reading, const Place& place,
                                   std::string_view field, const ReadingGrammar& grammar) {
  const std::string& id = stations_.id(place.station);
  const std::string shown = quoted(trimmed(field), longest_field_shown);
  Message message{file_, place.line, "", ""};
  if (reading.kind == ReadingKind::amount) {
    heard_[index(place.station)] = Heard::yes;
    if (++absurd_count_ > 1) return;
    message.text =
        "reading " + shown + " of station " + quoted(id) + " is more than falls anywhere in a year";
    first_absurd_ = std::move(message);
    return;
  }
  if (reading.kind == ReadingKind::negative) {
    message.text = "negative reading " + shown + " of station " + quoted(id);
    message.hint = setting("missing", trimmed(field)) + " takes it for a gap";
  } else {
    message.text = "reading " + shown + " of station " + quoted(id) +
                   (reading.kind == ReadingKind::out_of_range ? " is outside the range of numbers"
                                                              : " is no number");
    if (grammar.wants_decimal_comma(field)) {
      message.hint = setting("decimal_comma") + " reads 1,5 as 1.5";
    }
  }
  complaints_.add(std::move(message));
}

void ReadingsFindings::note_unknown(std::string_view id, std::size_t line, const std::string& text,
                                    const Wording& hint) {
  if (!unknown_.emplace(id).second) return;
  if (!ignore_unknown_) {
    complaints_.add({file_, line, text, unknown_.size() == 1 ? hint : Wording()});
  } else if (first_unknown_.size() < names_listed) {
    first_unknown_.emplace_back(id);
  }
}

void ReadingsFindings::note_empty_time(std::size_t line) {
  complaints_.add({file_, line, "the time is empty", ""});
}

Message ReadingsFindings::time_twice(std::string_view time, std::size_t line,
                                     std::size_t first_line) const {
  return {file_, line,
          "time " + quoted(time, longest_field_shown) + " is already in line " +
              std::to_string(first_line),
          ""};
}

void ReadingsFindings::conclude(std::size_t steps) {
  complaints_.throw_if_any();
  warn_of_unknown();
  if (steps > 0) warn_of_silent();
  warn_of_absurd();
}

void ReadingsFindings::warn_of_unknown() {
  if (unknown_.empty()) return;
  const bool one = unknown_.size() == 1;
  const std::string subject =
      one ? "an unknown station is" : std::to_string(unknown_.size()) + " unknown stations are";
  warnings_.add({file_, 0, subject + " passed over: " + list(first_unknown_, unknown_.size()), ""});
}

void ReadingsFindings::warn_of_silent() {
  std::vector<std::string> first;
  const auto count = static_cast<std::size_t>(std::count(heard_.begin(), heard_.end(), Heard::no));
  for (std::size_t i = 0; i < heard_.size() && first.size() < names_listed; ++i) {
    if (heard_[i] == Heard::no) first.push_back(stations_.all()[i].id);
  }
  if (count == 0) return;
  const std::string text =
      count == 1 ? "station " + quoted(first[0]) + " has no readings"
                 : std::to_string(count) + " stations have no readings: " + list(first, count);
  warnings_.add({file_, 0, text, ""});
}

void ReadingsFindings::warn_of_absurd() {
  if (absurd_count_ == 0) return;
  if (absurd_count_ > 1) {
    first_absurd_.text += ", and so are " + std::to_string(absurd_count_ - 1) + " more";
  }
  warnings_.add(std::exchange(first_absurd_, {}));
}

}  // namespace thiessen
