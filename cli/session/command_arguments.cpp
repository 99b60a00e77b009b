#include "cli/session/command_arguments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/picture_size.h"
#include "cli/options/usage_error.h"
#include "geometry/exact_range.h"
#include "geometry/predicates.h"
#include "map/sheet/picture.h"

namespace thiessen::cli {
namespace {

constexpr const char* blanks_hint =
    "coordinates are parted by blanks, and a decimal mark is a point";

[[noreturn]] void refuse(std::string text, std::string hint = {}) {
  throw Error(Message{"", 0, std::move(text), std::move(hint)});
}

double read_coordinate(const std::string& name, std::string_view text) {
  const auto number = parse_number(text);
  if (number && in_exact_range(number.value))
    return number.value + 0.0;  // adding zero turns -0 into 0
  if (number.fault != NumberFault::not_a_number)
    refuse(name + " is " + std::string(outside_exact_range) + ": " + quoted(text, 60));
  const bool has_comma = text.find(',') != std::string_view::npos;
  refuse(name + " is no number: " + quoted(text, 60), has_comma ? blanks_hint : "");
}

/// Reads numbers parted by commas, as many as there are names for them.
template <std::size_t Count>
std::array<double, Count> read_numbers(const std::string& option, std::string_view text,
                                       const std::array<std::string_view, Count>& names,
                                       const std::string& form) {
  if (static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1 != Count)
    refuse(option + " takes " + form + ", not " + quoted(text, 60));
  std::array<double, Count> numbers{};
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t comma = std::min(text.find(','), text.size());
    numbers.at(i) =
        read_coordinate(option + ": " + std::string(names.at(i)), text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return numbers;
}

SpacePoint read_space_point(const std::string& option, std::string_view text) {
  const auto [x, y, z] = read_numbers<3>(option, text, {"x", "y", "z"}, "three coordinates, X,Y,Z");
  return {x, y, z};
}

PlaneWindow read_window(std::string_view text) {
  // Below this share of its coordinates a window is only some hundreds of their doubles wide, too
  // few for a picture.
  constexpr double narrowest = 1e-13;
  constexpr const char* order =
      "first the lower left corner, then the upper right: XMIN,YMIN,XMAX,YMAX";
  const auto [x_min, y_min, x_max, y_max] = read_numbers<4>(
      "--window", text, {"XMIN", "YMIN", "XMAX", "YMAX"}, "four numbers, XMIN,YMIN,XMAX,YMAX");
  const auto check = [](char axis, double low, double high) {
    const std::string name(1, axis);
    if (!(low < high)) {
      refuse("--window is empty: " + name + "MIN, " + shortest_text(low) + ", is not below " +
                 name + "MAX, " + shortest_text(high),
             order);
    }
    if (high - low < narrowest * std::max(std::abs(low), std::abs(high)))
      refuse("--window is too narrow to tell coordinates in it apart, from " + name + "MIN to " +
             name + "MAX");
  };
  check('X', x_min, x_max);
  check('Y', y_min, y_max);
  return {{x_min, y_min}, {x_max, y_max}};
}

/// Reads a value as the option of this name of `thiessen map`.
void read_value(const std::string& option, const OptionValue& value, const std::string& text) {
  try {
    value.read(text);
  } catch (const WrongValue& wrong) {
    refuse(option + " " + wrong.complaint);
  }
}

PlotSize plot_size(const PictureSize& size) {
  try {
    size.check_size();
  } catch (const UsageError& error) {
    refuse(error.text, error.hint);
  }
  return {size.width(), size.height(), size.dots_to_the_inch()};
}

constexpr std::array<std::string_view, 5> show_options = {"--window", "--size", "--dpi", "--view",
                                                          "--site"};

/// Where an option's name ends: at a `=`, behind which its value stands, or with the word.
std::size_t end_of_name(const std::string& word) {
  return word.starts_with("--") ? std::min(word.find('='), word.size()) : word.size();
}

/// The words of `show` or `watch`: the names of files, and options with their values.
struct ShowWords {
  std::vector<std::string> files;
  std::map<std::string, std::string> options;

  explicit ShowWords(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string word = words[i].substr(0, end_of_name(words[i]));
      const bool is_option =
          std::find(show_options.begin(), show_options.end(), word) != show_options.end();
      if (!is_option && word.starts_with("--"))
        refuse("there is no option " + quoted(word, 40),
               "the options are --window, --size, --dpi, --view and --site");
      if (!is_option) {
        files.push_back(words[i]);
        continue;
      }
      std::string value;
      if (word.size() < words[i].size()) {
        value = words[i].substr(word.size() + 1);
      } else if (++i < words.size()) {
        value = words[i];
      } else {
        refuse(word + " needs a value");
      }
      if (!options.emplace(word, value).second) refuse(word + " is given twice");
    }
  }
  const std::string* find(const std::string& option) const {
    const auto found = options.find(option);
    return found == options.end() ? nullptr : &found->second;
  }
};

std::optional<View> read_view(const ShowWords& words, int dimension) {
  const std::string* view = words.find("--view");
  const std::string* site = words.find("--site");
  if (view == nullptr && site == nullptr) return std::nullopt;
  if (dimension == 2)
    refuse("--view and --site are for three dimensions",
           "--window says which part of the plane is shown");
  if (site == nullptr) refuse("--view needs --site, the point to look at");
  if (view == nullptr) refuse("--site needs --view, the point to look from");
  return View{read_space_point("--view", *view), read_space_point("--site", *site)};
}

}  // namespace

template <int Dimension>
CoordinatesIn<Dimension> read_coordinates(const std::string& command,
                                          const std::vector<std::string>& words) {
  CoordinatesIn<Dimension> coordinates{};
  if (words.size() != coordinates.size()) {
    const bool has_comma = !words.empty() && words[0].find(',') != std::string::npos;
    refuse(command + " takes " + std::to_string(coordinates.size()) + " coordinates, not " +
               std::to_string(words.size()),
           has_comma                             ? blanks_hint
           : Dimension == 2 && words.size() == 3 ? "--dim 3 is for points in space"
                                                 : "");
  }
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis)
    coordinates.at(axis) = read_coordinate(std::string(axis_names.at(axis)), words[axis]);
  return coordinates;
}

template CoordinatesIn<2> read_coordinates<2>(const std::string&, const std::vector<std::string>&);
template CoordinatesIn<3> read_coordinates<3>(const std::string&, const std::vector<std::string>&);

std::string require_file(const std::string& command, const std::vector<std::string>& words) {
  if (words.size() == 1 && !words.front().empty()) return words.front();
  if (words.size() > 1)
    refuse(command + " takes one file, not " + std::to_string(words.size()),
           "a name with blanks stands in quotes");
  refuse(command + " needs the name of a file");
}

void require_none(const std::string& command, const std::vector<std::string>& words) {
  if (!words.empty())
    refuse(command + " takes nothing, but " + quoted(words.front(), 40) + " follows it");
}

ShowArguments read_show_arguments(const std::string& command, int dimension,
                                  const std::vector<std::string>& words) {
  const ShowWords said(words);
  ShowArguments arguments;
  arguments.file = require_file(command, said.files);
  if (!lower_case(arguments.file).ends_with(".png"))
    refuse(command + " writes a .png, not " + quoted(arguments.file, 80));
  if (const std::string* window = said.find("--window")) {
    if (dimension == 3)
      refuse("--window is for two dimensions", "--view and --site say what is seen in space");
    arguments.window = read_window(*window);
  }
  arguments.view = read_view(said, dimension);
  PictureSize size;
  if (const std::string* text = said.find("--size"))
    read_value("--size", pixel_size(size.size), *text);
  if (const std::string* text = said.find("--dpi"))
    read_value("--dpi", whole_number(size.dpi, 1, max_dots_to_the_inch), *text);
  arguments.size = plot_size(size);
  return arguments;
}

}  // namespace thiessen::cli
