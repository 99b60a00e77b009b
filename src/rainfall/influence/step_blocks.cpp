#include "rainfall/influence/step_blocks.h"

#include <future>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

/// A block of steps, whose memory is used again for the next block.
class Block {
 public:
  void read(Readings& readings, std::size_t most) {
    readings_.clear();
    rows_.clear();
    std::size_t count = 0;
    std::size_t stations = 0;
    for (TimeStep step; count < most && readings.next(step); ++count) {
      readings_.insert(readings_.end(), step.readings.begin(), step.readings.end());
      stations = step.readings.size();
    }
    for (std::size_t i = 0; i < count; ++i)
      rows_.push_back(std::span(readings_).subspan(i * stations, stations));
  }
  StepRows rows() const { return rows_; }

 private:
  std::vector<double> readings_;
  std::vector<std::span<const double>> rows_;
};

}  // namespace

void for_each_block(Readings& readings, std::size_t most, unsigned threads,
                    const std::function<void(StepRows)>& take) {
  Block block;
  Block ahead;
  for (block.read(readings, most); !block.rows().empty(); std::swap(block, ahead)) {
    if (threads > 1) {
      auto taking = std::async(std::launch::async, [&] { take(block.rows()); });
      ahead.read(readings, most);
      taking.get();
    } else {
      take(block.rows());
      ahead.read(readings, most);
    }
  }
}

}  // namespace thiessen
