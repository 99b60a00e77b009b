#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "readings/readings_order.h"
#include "readings/readings_sorter.h"
#include "readings/times/time_columns.h"
#include "text/table.h"

namespace thiessen {

/// Finds the times that a wide table gives twice, in bounded memory.
///
/// Where the table can be read once more, no times are kept. If TimeOrder cannot tell at the end
/// that all times differ, they are then read again and sorted. Where the table cannot be read once
/// more, times are gathered as they come.
class RepeatedTimes {
 public:
  static constexpr std::size_t usual_memory = std::size_t{32} << 20;

  /// `again` is the table once more (see Table::again), or null where it cannot be read twice.
  RepeatedTimes(std::unique_ptr<Table> again, TimeColumns columns,
                std::size_t memory = usual_memory);

  /// Takes the next time and its line.
  void note(std::string_view time, std::size_t line);
  struct Repeat {
    std::string_view time;  ///< valid until the next call
    std::size_t line;
    std::size_t first_line;
  };
  /// Finds the next time that has been given before, in no particular order; returns false if there
  /// is none. Requires that all times have been taken.
  bool next(Repeat& repeat);

 private:
  void gather(std::string_view time, std::size_t line);
  void read_again();

  std::unique_ptr<Table> again_;
  TimeColumns columns_;
  TimeOrder order_;
  PieceSorter times_;
  bool begun_ = false;
  std::string time_;
  std::size_t first_line_ = 0;  ///< line of `time_`; 0: none yet
};

}  // namespace thiessen
