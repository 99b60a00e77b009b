#include "cli/options/blocks/what_if_options.h"

#include <set>
#include <string_view>

#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void WhatIfOptions::declare(OptionList& options) {
  OptionGroup what_if = options.group("What if", *this);
  what_if.add(
      "--without", texts(closed_, "ID"),
      "what if this station closed: the weights with columns area_km2_after (area_after where "
      "the unit is unknown) and weight_after; may be repeated");
  what_if.add("--with", points(opened_),
              "what if a gauge opened here, in the coordinates of STATIONS; the first is called "
              "'with 1'; may be repeated, and beside --without");
}

void WhatIfOptions::check() const {
  std::set<std::string_view> seen;
  for (const std::string& id : closed_) {
    if (!seen.insert(id).second)
      throw UsageError{"--without names station " + quoted(id, 80) + " twice", ""};
  }
}

}  // namespace thiessen::cli
