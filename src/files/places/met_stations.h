#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// The stations of a file that were met so far, found by their ids. They are in a list that grows
/// behind them. While each id is beyond all before it, longer or as long and greater, as those of
/// most files are, none can have come before, and there is nothing to look up. Else there is a
/// table: of a million stations, a map of nodes would take a tenth of the time of all that cells
/// take, and memory that does not go back to the system in one piece. Memory of it: some 32 bytes a
/// station.
class MetStations {
 public:
  /// The list must outlive this object.
  explicit MetStations(const std::vector<Station>& stations) : stations_(stations) {}

  /// The station of the list that has this id; null where there is none. In that case a station
  /// with the id has to be put at the end of the list before the next call. What is returned stands
  /// until then.
  const Station* meet(std::string_view id);

 private:
  struct Entry {
    std::uint32_t station;
    std::uint32_t tag;  ///< of the id's hash, so that other ids are seldom looked at
  };

  /// Where in the table the id stands, or may be put.
  Entry& entry_of(std::string_view id, std::uint64_t hash);
  void grow();

  const std::vector<Station>& stations_;
  /// With open addressing, no more than half full; its size is a power of two. It is empty while
  /// ids ascend.
  std::vector<Entry> table_;
};

}  // namespace thiessen
