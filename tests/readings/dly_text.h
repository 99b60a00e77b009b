#pragma once

#include <cstdio>
#include <map>
#include <string>

namespace thiessen {

/// What a day holds in a `.dly` line: "   12", and three flags.
struct DlyColumns {
  std::string value = "-9999";
  std::string flags = "   ";
};

/// A line of a `.dly` file, without its end; days that are not given are missing.
inline std::string dly_line(const std::string& id, int year, int month,
                            const std::map<int, DlyColumns>& days,
                            const std::string& element = "PRCP") {
  char head[16];
  std::snprintf(head, sizeof head, "%04d%02d", year, month);
  std::string line = id + head + element;
  for (int day = 1; day <= 31; ++day) {
    const auto found = days.find(day);
    const DlyColumns columns = found == days.end() ? DlyColumns{} : found->second;
    line += std::string(5 - columns.value.size(), ' ') + columns.value + columns.flags;
  }
  return line;
}

}  // namespace thiessen
