#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "readings/readings_order.h"
#include "readings/readings_sorter.h"
#include "text/table.h"

namespace thiessen {

/// Finds the times that a wide table gives twice, in bounded memory. Nothing is kept as long as
/// TimeOrder can tell that there are none; else all times are sorted at the end, read once more
/// from the table or, where that is not possible, gathered as they come.
class RepeatedTimes {
 public:
  static constexpr std::size_t usual_memory = std::size_t{32} << 20;

  /// `again`: the table once more (see Table::again), or nothing.
  RepeatedTimes(std::unique_ptr<Table> again, std::size_t time_field,
                std::size_t memory = usual_memory);

  /// Takes the next time.
  void note(std::string_view time, std::size_t line);
  struct Repeat {
    std::string_view time;  ///< valid until the next
    std::size_t line;
    std::size_t first_line;
  };
  /// After all times: the next that is given before, in no order; false where there is none.
  bool next(Repeat& repeat);

 private:
  void gather(std::string_view time, std::size_t line);
  void read_again();

  std::unique_ptr<Table> again_;
  std::size_t time_field_;
  TimeOrder order_;
  PieceSorter times_;
  bool begun_ = false;
  std::string time_;
  std::size_t first_line_ = 0;  ///< of `time_`; 0: none yet
};

}  // namespace thiessen
