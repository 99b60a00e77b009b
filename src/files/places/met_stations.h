#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// The stations of a file that were met so far, found by their ids. Of a million stations, a map of
/// nodes would take a tenth of the time of all that cells take, and memory that does not go back to
/// the system in one piece. Memory: some 100 bytes a station.
class MetStations {
 public:
  /// Takes note of a station. Returns the one of the same id that was met before, which stays as it
  /// was; null where there is none. What is returned stands until the next call.
  const Station* meet(const Station& station);

 private:
  /// Where in the table the id stands, or may be put.
  std::size_t place_of(std::string_view id) const;
  void grow();

  std::vector<Station> stations_;
  /// Positions among the stations, with open addressing, no more than half full; its size is a
  /// power of two.
  std::vector<std::uint32_t> table_;
};

}  // namespace thiessen
