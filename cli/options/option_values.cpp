#include "cli/options/option_values.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "map/sheet/picture.h"

namespace thiessen::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& wanted,
                         const std::string& value) {
  throw CLI::ValidationError(option, "wants " + wanted + ", not '" + printable(value) + "'");
}

}  // namespace

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, NumberRange range,
                        const std::string& help) {
  const auto read = [name, range, &target](const std::string& text) {
    const auto number = parse_number(text);
    if (!number || !(number.value >= range.low && number.value <= range.high))
      refuse(name, range.text, text);
    target = number.value;
  };
  return app.add_option_function<std::string>(name, read, help)->type_name("NUMBER");
}

CLI::Option* add_count(CLI::App& app, const std::string& name, std::size_t& target, std::size_t low,
                       std::size_t high, const std::string& help) {
  const auto read = [name, low, high, &target](const std::string& text) {
    const auto number = parse_size(text);
    if (!number || number.value < low || number.value > high) {
      refuse(name, "a whole number from " + std::to_string(low) + " to " + std::to_string(high),
             text);
    }
    target = number.value;
  };
  return app.add_option_function<std::string>(name, read, help)->type_name("N");
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& kind, const std::string& help) {
  const auto read = [name, &target](const std::string& text) {
    if (text.empty()) throw CLI::ValidationError(name, "is empty");
    target = text;
  };
  return app.add_option_function<std::string>(name, read, help)->type_name(kind);
}

CLI::Option* add_time(CLI::App& app, const std::string& name, std::optional<IsoTime>& target,
                      const std::string& help) {
  const auto read = [name, &target](const std::string& text) {
    const ParsedTime parsed = parse_iso_time(text);
    if (parsed.fault == IsoTimeFault::value)
      throw CLI::ValidationError(name, quoted(text, 80) + " does not exist");
    if (!parsed) refuse(name, std::string("an ISO 8601 time such as ") + iso_time_forms, text);
    target = parsed.time;
  };
  return app.add_option_function<std::string>(name, read, help)->type_name("TIME");
}

CLI::Option* add_points(CLI::App& app, const std::string& name, std::vector<Point>& target,
                        const std::string& help) {
  const auto read = [name, &target](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const std::size_t comma = std::min(text.find(','), text.size());
      const auto x = parse_number(trimmed(text.substr(0, comma)));
      const auto y = parse_number(trimmed(text.substr(std::min(comma + 1, text.size()))));
      if (!x || !y) refuse(name, "two numbers such as 8.25,47.5", text);
      target.push_back({x.value, y.value});
    }
    return true;
  };
  return app.add_option_function<std::vector<std::string>>(name, read, help)
      ->type_name("X,Y")
      ->allow_extra_args(false);
}

CLI::Option* add_size(CLI::App& app, PixelSize& target) {
  const auto read = [&target](const std::string& text) {
    const std::size_t cross = text.find('x');
    const auto width = parse_size(text.substr(0, cross));
    const auto height = cross == std::string::npos ? Parsed<std::size_t>{0, NumberFault::none}
                                                   : parse_size(text.substr(cross + 1));
    const auto fits = [](std::size_t side) {
      return side >= min_picture_side && side <= max_picture_side;
    };
    const bool good = width && height && fits(width.value) &&
                      (cross == std::string::npos || fits(height.value)) &&
                      width.value * height.value <= max_picture_pixels;
    if (!good) {
      refuse("--size",
             "WIDTH or WIDTHxHEIGHT in pixels, " + std::to_string(min_picture_side) + " to " +
                 std::to_string(max_picture_side) + " a side and at most " +
                 std::to_string(max_picture_pixels) + " in all",
             text);
    }
    target = {width.value, height.value};
  };
  return app
      .add_option_function<std::string>("--size", read, "the picture's pixels; default 1600 wide")
      ->type_name("WxH");
}

CLI::Option* add_separator(CLI::App& app, char& target) {
  const auto read = [&target](const std::string& text) {
    const bool is_tab = text == "tab" || text == "\\t";
    const bool is_character = text.size() == 1 && static_cast<unsigned char>(text[0]) < 0x80 &&
                              std::string("\"\r\n").find(text[0]) == std::string::npos;
    if (!is_tab && !is_character) refuse("--separator", "one character, such as ';', or tab", text);
    target = is_tab ? '\t' : text[0];
  };
  return app
      .add_option_function<std::string>("--separator", read, "what parts the fields of CSV files")
      ->type_name("C");
}

}  // namespace thiessen::cli
