#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "readings/joined_readings.h"

namespace thiessen {

/// Opens the files of several one after the other, and passes over those of a known format that
/// hold no rain (NoRain). With the last one a notice names them; that none of all has rain is
/// NoRain, too, with what is said of each.
class FilesWithoutRain {
 public:
  /// `count` files are to be opened; `name` is that of all in messages.
  FilesWithoutRain(std::size_t count, std::string name) : count_(count), name_(std::move(name)) {}

  using Open = std::function<JoinedReadings::Opened(Warnings&)>;
  /// Opens the next one; without readings where it is passed over. Throws Error as `open` does.
  JoinedReadings::Opened open_next(const Open& open, const std::string& file, Warnings& warnings);

 private:
  void fail();
  void tell(Warnings& warnings) const;

  std::size_t count_;
  std::string name_;
  std::size_t opened_ = 0;
  std::vector<std::string> passed_over_;
  Complaints faults_;
};

}  // namespace thiessen
