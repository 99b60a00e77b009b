#include "files/tables/netcdf_unit.h"

#include <cstddef>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::string_view between = " .*\t";  ///< what factors are parted by

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A factor and its power, such as m-2: how many characters are its name, and what the power is.
struct Factor {
  std::size_t letters = 0;
  std::string_view power;
  std::size_t size = 0;  ///< of all of it
};

Factor factor_at(std::string_view text) {
  Factor found;
  while (found.letters < text.size() && is_letter(text[found.letters])) ++found.letters;
  std::size_t at = found.letters;
  if (text.substr(at).starts_with("**")) {
    at += 2;
  } else if (text.substr(at).starts_with('^')) {
    ++at;
  }
  std::size_t end = at;
  while (end < text.size() && (text[end] == '-' || (text[end] >= '0' && text[end] <= '9'))) ++end;
  found.power = text.substr(at, end - at);
  found.size = found.power.empty() ? found.letters : end;
  return found;
}

}  // namespace

std::string udunits_with_quotients(std::string_view unit) {
  std::string made;
  std::string_view rest = trimmed(unit);
  while (!rest.empty()) {
    const Factor factor = factor_at(rest);
    if (factor.letters == 0) {
      made += rest.front();
      rest.remove_prefix(1);
      continue;
    }
    std::string_view power = factor.power;
    if (power.starts_with('-') && !made.empty()) {
      power.remove_prefix(1);
      made.resize(made.find_last_not_of(between) + 1);
      made += '/';
    }
    made += rest.substr(0, factor.letters);
    if (power != "1") made += power;
    rest.remove_prefix(factor.size);
  }
  return made;
}

}  // namespace thiessen
