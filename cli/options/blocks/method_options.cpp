#include "cli/options/blocks/method_options.h"

#include <algorithm>
#include <string>
#include <utility>

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

namespace {

struct NamedMethods {
  std::string name;
  std::vector<RainMethod> methods;
};

std::vector<NamedMethods> known_methods() {
  std::vector<NamedMethods> known;
  known.reserve(all_methods.size() + 2);
  for (const RainMethod method : all_methods) known.push_back({name_of(method), {method}});
  known.push_back({name_of(RainMethod::isohyetal), {RainMethod::isohyetal}});
  known.push_back({"all", {all_methods.begin(), all_methods.end()}});
  return known;
}

void add_methods(const std::string& name, std::vector<RainMethod>& methods) {
  std::vector<std::string> names;
  for (const NamedMethods& known : known_methods()) {
    names.push_back(known.name);
    if (known.name != name) continue;
    for (const RainMethod method : known.methods) {
      if (std::find(methods.begin(), methods.end(), method) != methods.end())
        throw WrongValue{"names " + std::string(name_of(method)) + " twice"};
      methods.push_back(method);
    }
    return;
  }
  refuse_choice(names, name);
}

/// One method, or several with commas between them.
OptionValue method_list(std::vector<RainMethod>& target) {
  OptionValue value;
  for (const NamedMethods& known : known_methods()) value.choices.push_back(known.name);
  value.kind = listed_choices(value.choices);
  value.read = [&target](const std::string& text) {
    std::vector<RainMethod> chosen;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t comma = std::min(text.find(',', at), text.size());
      add_methods(text.substr(at, comma - at), chosen);
      at = comma + 1;
    }
    target = std::move(chosen);
  };
  return value;
}

}  // namespace

void MethodOptions::declare(OptionList& options) {
  OptionGroup group = options.group("Method", *this);
  group.add("--method", method_list(methods_),
            "the cells (default), the mean of the gauges inside, inverse distance squared of the "
            "12 nearest, natural neighbours (outside the gauges' hull the nearest gauge), the "
            "areas between isohyets of natural neighbours times their mid-levels, or, parted by "
            "commas (all: the first four), a column for each, BASIN_thiessen and so on; with "
            "--long rows with a column method");
  points_option_ = &group.add(
      "--grid", whole_number(points_.points, 1, 100'000),
      "over how many points of a basin idw, natural and isohyetal look, to 100000; default 2000");
  interval_option_ = &group.add(
      "--interval", number(points_.interval, above_zero),
      "the step between isohyets, at its multiples; default a rounded one for each basin and step "
      "that makes about eight");
}

void MethodOptions::check(const GapOptions& gaps) const {
  if (!has_isohyets() || gaps.settings().gaps != Gaps::renormalise) return;
  throw UsageError{"--gaps renormalise scales weights, and isohyets have none",
                   "retessellate and strict go with them"};
}

void MethodOptions::check_errors() const {
  if (!has_isohyets()) return;
  throw UsageError{"--error is of methods that weigh gauges, and isohyets do not",
                   "give one of thiessen, arithmetic, idw and natural"};
}

bool MethodOptions::has_isohyets() const {
  return std::find(methods_.begin(), methods_.end(), RainMethod::isohyetal) != methods_.end();
}

void MethodOptions::check() const {
  if (points_option_->is_given() &&
      std::none_of(methods_.begin(), methods_.end(), averages_points)) {
    throw UsageError{"--grid is about --method idw, natural, isohyetal or all", "leave it out"};
  }
  if (interval_option_->is_given() && !has_isohyets())
    throw UsageError{"--interval is about --method isohyetal", "leave it out"};
}

}  // namespace thiessen::cli
