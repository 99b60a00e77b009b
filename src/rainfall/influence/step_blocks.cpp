#include "rainfall/influence/step_blocks.h"

#include <utility>
#include <vector>

#include "base/parallel.h"

namespace thiessen {
namespace {

/// A block of steps, whose memory is used again for the next block.
class Block {
 public:
  void read(Readings& readings, std::size_t most, const MonthOfTime& month_of) {
    readings_.clear();
    rows_.clear();
    months_.clear();
    std::size_t count = 0;
    std::size_t stations = 0;
    for (TimeStep step; count < most && readings.next(step); ++count) {
      readings_.insert(readings_.end(), step.readings.begin(), step.readings.end());
      stations = step.readings.size();
      if (month_of) months_.push_back(month_of(step));
    }
    for (std::size_t i = 0; i < count; ++i)
      rows_.push_back(std::span(readings_).subspan(i * stations, stations));
  }
  StepBlock steps() const { return {rows_, months_}; }
  bool empty() const { return rows_.empty(); }

 private:
  std::vector<double> readings_;
  std::vector<std::span<const double>> rows_;
  std::vector<std::size_t> months_;
};

}  // namespace

void for_each_block(Readings& readings, std::size_t most, unsigned threads,
                    const MonthOfTime& month_of,
                    const std::function<void(const StepBlock&)>& take) {
  Block block;
  Block ahead;
  for (block.read(readings, most, month_of); !block.empty(); std::swap(block, ahead)) {
    if (threads > 1) {
      side_by_side([&] { take(block.steps()); }, [&] { ahead.read(readings, most, month_of); });
    } else {
      take(block.steps());
      ahead.read(readings, most, month_of);
    }
  }
}

}  // namespace thiessen
