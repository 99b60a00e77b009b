#include "cli/options/blocks/colour_options.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

OptionValue breaks(ClassRule& rule) {
  OptionValue value;
  value.kind = "A,B,...|quantile|equal";
  value.choices = {"quantile", "equal"};
  value.read = [&rule](const std::string& text) {
    if (text == "quantile") {
      rule.kind = ClassRule::Kind::quantiles;
    } else if (text == "equal") {
      rule.kind = ClassRule::Kind::equal;
    } else {
      auto numbers = rising_numbers_in(text);
      if (!numbers)
        throw WrongValue{"wants rising numbers with commas between them, quantile or equal, not '" +
                         printable(text) + "'"};
      rule.kind = ClassRule::Kind::breaks;
      rule.breaks = std::move(*numbers);
    }
  };
  return value;
}

OptionValue range(std::optional<ClassRule::Range>& target) {
  OptionValue value;
  value.kind = "A,B";
  value.read = [&target](const std::string& text) {
    const auto numbers = rising_numbers_in(text);
    if (!numbers || numbers->size() != 2)
      throw WrongValue{"wants two rising numbers with a comma between them, not '" +
                       printable(text) + "'"};
    target = {numbers->front(), numbers->back()};
  };
  return value;
}

}  // namespace

void ColourOptions::declare(OptionList& options) {
  OptionGroup picture = options.group("Picture", *this);
  picture.add(
      "--breaks", breaks(rule),
      "where classes of rainfall meet; default quantile where the largest value is over four times "
      "the median, else equal; 0 is a class of its own");
  picture.add("--range", range(rule.range),
              "equal classes from A to B, the same whatever is shown");
  picture.add("--palette",
              choice(rule.palette, {{"viridis", Palette::viridis},
                                    {"blues", Palette::blues},
                                    {"browns", Palette::browns},
                                    {"greys", Palette::greys}}),
              "the colours of rainfall; default viridis");
}

void ColourOptions::check(bool has_rainfall) const {
  const Option* given = first_given();
  if (!has_rainfall && given != nullptr) {
    throw UsageError{given->name + " is about the colours of rainfall, and there is no RAINFALL",
                     "give RAINFALL, or leave it out"};
  }
  const bool others =
      rule.kind == ClassRule::Kind::breaks || rule.kind == ClassRule::Kind::quantiles;
  if (rule.range && others) {
    throw UsageError{"--range lays equal classes, and --breaks others", "leave one of them out"};
  }
}

}  // namespace thiessen::cli
