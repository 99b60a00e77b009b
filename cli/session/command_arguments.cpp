#include "cli/session/command_arguments.h"

#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "geometry/exact_range.h"
#include "geometry/predicates.h"

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

SpacePoint read_space_point(const std::string& option, std::string_view text) {
  std::array<double, 3> coordinates{};
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (axis == 2))
      refuse(option + " takes three coordinates, X,Y,Z");
    coordinates.at(axis) =
        read_coordinate(option + ": " + std::string(axis_names.at(axis)), text.substr(0, comma));
    if (axis < 2) text.remove_prefix(comma + 1);
  }
  return {coordinates[0], coordinates[1], coordinates[2]};
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

ShowArguments read_show_arguments(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  std::optional<SpacePoint> view;
  std::optional<SpacePoint> site;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word != "--view" && word != "--site") {
      files.push_back(word);
      continue;
    }
    if (++i == words.size()) refuse(word + " needs X,Y,Z");
    std::optional<SpacePoint>& target = word == "--view" ? view : site;
    if (target) refuse(word + " is given twice");
    target = read_space_point(word, words[i]);
  }
  ShowArguments arguments{require_file("show", files), {}};
  if (!lower_case(arguments.file).ends_with(".png"))
    refuse("show writes a .png, not " + quoted(arguments.file, 80));
  if (view.has_value() != site.has_value())
    refuse(view ? "--view needs --site, the point to look at"
                : "--site needs --view, the point to look from");
  if (view) arguments.view = View{*view, *site};
  return arguments;
}

}  // namespace thiessen::cli
