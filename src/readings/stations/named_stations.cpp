#include "readings/stations/named_stations.h"

#include "base/enumeration.h"
#include "base/utf8.h"

namespace thiessen {

std::string named(const std::vector<std::string>& first, std::size_t count) {
  std::vector<std::string> names;
  names.reserve(first.size());
  for (const std::string& name : first) names.push_back(quoted(name));
  return enumerated(names, count);
}

std::string without_readings(const std::vector<std::string>& first, std::size_t count,
                             const std::string& what_comes_of_it) {
  if (count == 1) return "station " + quoted(first.front()) + " has no readings" + what_comes_of_it;
  return std::to_string(count) + " stations have no readings" + what_comes_of_it + ": " +
         named(first, count);
}

}  // namespace thiessen
