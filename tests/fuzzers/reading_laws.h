#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "fuzzers/bytes.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_readings.h"
#include "fuzzers/plain_steps.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "readings/stations/heard_stations.h"

namespace thiessen::fuzzers {

constexpr std::size_t most_steps = 4'000;  // damaged .dly files may begin in 1700

/// The steps that a reader gives, up to its end or so many. Requires that times differ and that
/// amounts are some.
inline Steps steps_of(Readings& readings, std::size_t stations) {
  Steps steps;
  TimeStep step;
  while (steps.size() < most_steps && readings.next(step)) {
    require(step.readings.size() == stations, "not a reading a station");
    steps.push_back({step.time, {}});
    for (const double amount : step.readings) {
      require(std::isnan(amount) || (std::isfinite(amount) && !std::signbit(amount)),
              "a reading that is none");
      steps.back().amounts.push_back(std::isnan(amount) ? silent : amount);
    }
    const double share = readings.share_read();
    require(std::isnan(share) || (share >= 0 && share <= 1), "a share that is none");
  }
  if (steps.size() == most_steps) return steps;
  require(!readings.next(step), "a step after the end");
  std::set<std::string> times;
  for (const Step& s : steps) require(times.insert(s.time).second, "a time that comes twice");
  return steps;
}

/// The steps that a reader gives. Requires that it refuses those whose lengths or zones are mixed,
/// and no others; then there are none.
inline Steps sound_steps_of(const std::function<Steps()>& read, const Steps& expected,
                            const std::string& file) {
  const PlainSteps judge(expected);
  const bool are_mixed = judge.are_mixed();
  try {
    Steps steps = read();
    require(!are_mixed || judge.has_other_forms(), "mixed steps that are not refused");
    return steps;
  } catch (const Error& error) {
    require_sentences(error);
    require(are_mixed || judge.has_other_forms(),
            std::string("readings that are refused: ") + error.what());
    const Message& message = error.messages().front();
    require(error.messages().size() == 1 && message.file == file, "another refusal of mixed steps");
    return expected;
  }
}

/// Requires that a look through a file hears the stations of these steps that report.
inline void require_heard(const HeardStations& heard, const Steps& steps) {
  for (std::uint32_t station = 0; station < heard.heard().size(); ++station) {
    const bool reports = std::any_of(steps.begin(), steps.end(), [station](const Step& step) {
      return step.amounts[station] != silent;
    });
    require(heard.heard()[StationIndex{station}] == reports, "a station heard, and not read");
  }
}

inline std::vector<Station> stations_called(const std::vector<std::string>& ids) {
  std::vector<Station> stations;
  for (const std::string& id : ids) stations.push_back({id, {}, stations.size() + 2});
  return stations;
}

}  // namespace thiessen::fuzzers
