#include "cli/options/option_values.h"

#include <algorithm>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "cli/options/name_lists.h"
#include "map/sheet/picture.h"
#include "readings/times/time_format.h"
#include "text/decoder.h"

namespace thiessen::cli {
namespace {

[[noreturn]] void refuse(const std::string& wanted, const std::string& text) {
  throw WrongValue{"wants " + wanted + ", not '" + printable(text) + "'"};
}

OptionValue value_of(std::string kind, std::function<void(const std::string& text)> read) {
  OptionValue value;
  value.kind = std::move(kind);
  value.read = std::move(read);
  return value;
}

Point read_point(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto x = parse_number(trimmed(text.substr(0, comma)));
  const auto y = parse_number(trimmed(text.substr(std::min(comma + 1, text.size()))));
  if (!x || !y) refuse("two numbers such as 8.25,47.5", text);
  return {x.value, y.value};
}

PixelSize read_pixel_size(const std::string& text) {
  constexpr std::size_t most_millimetres = 5'000;
  const bool millimetres = text.ends_with("mm");
  const std::string sides = millimetres ? text.substr(0, text.size() - 2) : text;
  const std::size_t cross = sides.find('x');
  const auto width = parse_size(sides.substr(0, cross));
  const auto height = cross == std::string::npos ? Parsed<std::size_t>{0, NumberFault::none}
                                                 : parse_size(sides.substr(cross + 1));
  const auto fits = [&](std::size_t side) {
    if (millimetres) return side > 0 && side <= most_millimetres;
    return side >= min_picture_side && side <= max_picture_side;
  };
  const bool good = width && height && fits(width.value) &&
                    (cross == std::string::npos || fits(height.value)) &&
                    width.value * height.value <= max_picture_pixels;
  if (!good) {
    refuse("WIDTH or WIDTHxHEIGHT in pixels, " + std::to_string(min_picture_side) + " to " +
               std::to_string(max_picture_side) + " a side and at most " +
               std::to_string(max_picture_pixels) + " in all, or in mm such as 297x210mm",
           text);
  }
  return {width.value, height.value, millimetres};
}

}  // namespace

OptionValue flag(bool& target) {
  OptionValue value = value_of("", [&target](const std::string&) { target = true; });
  value.may_be_repeated = true;
  return value;
}

OptionValue sign() {
  OptionValue value = value_of("", [](const std::string&) {});
  value.may_be_repeated = true;
  return value;
}

OptionValue number(double& target, NumberRange range) {
  return value_of("NUMBER", [range, &target](const std::string& text) {
    const auto number = parse_number(text);
    if (!number || !(number.value >= range.low && number.value <= range.high))
      refuse(range.text, text);
    target = number.value;
  });
}

OptionValue whole_number(std::size_t& target, std::size_t low, std::size_t high) {
  return value_of("N", [low, high, &target](const std::string& text) {
    const auto number = parse_size(text);
    if (!number || number.value < low || number.value > high) {
      refuse("a whole number from " + std::to_string(low) + " to " + std::to_string(high), text);
    }
    target = number.value;
  });
}

OptionValue text(std::string& target, const std::string& kind) {
  return value_of(kind, [&target](const std::string& text) {
    if (text.empty()) throw WrongValue{"is empty"};
    target = text;
  });
}

OptionValue any_text(std::string& target, const std::string& kind) {
  return value_of(kind, [&target](const std::string& text) { target = text; });
}

OptionValue texts(std::vector<std::string>& target, const std::string& kind) {
  OptionValue value =
      value_of(kind, [&target](const std::string& text) { target.push_back(text); });
  value.may_be_repeated = true;
  return value;
}

OptionValue file(std::string& target, const std::string& kind) {
  OptionValue value = any_text(target, kind);
  value.completion = Completion::file;
  return value;
}

OptionValue folder(std::string& target, const std::string& kind) {
  OptionValue value = any_text(target, kind);
  value.completion = Completion::folder;
  return value;
}

OptionValue iso_time(std::optional<IsoTime>& target) {
  return value_of("TIME", [&target](const std::string& text) {
    const ParsedTime parsed = parse_iso_time(text);
    if (parsed.fault == IsoTimeFault::value) throw WrongValue{quoted(text, 80) + " does not exist"};
    if (!parsed) refuse(std::string("an ISO 8601 time such as ") + iso_time_forms, text);
    target = parsed.time;
  });
}

OptionValue clock_time(std::optional<int>& target) {
  return value_of("HH:MM", [&target](const std::string& text) {
    const std::size_t colon = text.find(':');
    const bool has_form =
        colon != std::string::npos && colon > 0 && colon < 3 && text.size() == colon + 3;
    const auto hour = parse_size(has_form ? text.substr(0, colon) : "");
    const auto minute = parse_size(has_form ? text.substr(colon + 1) : "");
    const bool good = hour && minute && minute.value < 60 &&
                      (hour.value < 24 || (hour.value == 24 && minute.value == 0));
    if (!good) refuse("a clock such as 09:00, to 24:00", text);
    target = static_cast<int>(60 * hour.value + minute.value);
  });
}

OptionValue rain_unit_of(std::optional<RainUnit>& target) {
  std::vector<std::pair<std::string, std::optional<RainUnit>>> units;
  for (const char* name : {"mm", "cm", "m", "in", "ft", "0.1mm", "0.01in"})
    units.emplace_back(name, rain_unit(name));
  return choice<std::optional<RainUnit>>(target, std::move(units));
}

OptionValue points(std::vector<Point>& target) {
  OptionValue value =
      value_of("X,Y", [&target](const std::string& text) { target.push_back(read_point(text)); });
  value.may_be_repeated = true;
  return value;
}

OptionValue separator(char& target) {
  return value_of("C", [&target](const std::string& text) {
    const bool is_tab = text == "tab" || text == "\\t";
    const bool is_character = text.size() == 1 && static_cast<unsigned char>(text[0]) < 0x80 &&
                              std::string("\"\r\n").find(text[0]) == std::string::npos;
    const bool is_blank = text == "blank";
    if (!is_tab && !is_blank && !is_character)
      refuse("one character, such as ';', or tab or blank", text);
    target = is_tab ? '\t' : is_blank ? ' ' : text[0];
  });
}

OptionValue time_format(std::string& target) {
  return value_of("FORMAT", [&target](const std::string& text) {
    if (!TimeFormat::is_sound(text))
      refuse("a format with year, month and day, such as '%d/%m/%Y %H:%M', or excel", text);
    target = text;
  });
}

OptionValue encoding(std::string& target) {
  return value_of("ENCODING", [&target](const std::string& text) {
    if (!is_encoding(text)) refuse("an encoding such as Latin-1 or cp932", text);
    target = text;
  });
}

OptionValue lines(std::optional<std::size_t>& target) {
  return value_of("N", [&target](const std::string& text) {
    constexpr std::size_t most = 10'000;
    const auto number = parse_size(text);
    if (!number || number.value > most) refuse("a number of lines, at most 10000", text);
    target = number.value;
  });
}

OptionValue pixel_size(PixelSize& target) {
  return value_of("WxH", [&target](const std::string& text) { target = read_pixel_size(text); });
}

std::optional<std::vector<double>> rising_numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse_number(text.substr(begin, end - begin));
    if (!number || (!numbers.empty() && !(number.value > numbers.back()))) return std::nullopt;
    numbers.push_back(number.value);
    begin = end + 1;
  }
  return numbers;
}

std::string listed_choices(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "|") + name;
  return text;
}

void refuse_choice(const std::vector<std::string>& names, const std::string& text) {
  refuse(or_list(names), text);
}

}  // namespace thiessen::cli
