#include "results/models/held_steps.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/spool.h"

namespace thiessen {
namespace {

constexpr std::size_t window_bytes = std::size_t{1} << 20;

}  // namespace

HeldSteps::HeldSteps(std::size_t basins, std::size_t memory)
    : basins_(basins), memory_(memory), spool_(open_spool()) {
  Descriptor copy(::fcntl(spool_.number(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!copy.is_open()) throw system_error(spool_name, "cannot write", errno);
  writer_.emplace(spool_name, std::move(copy), OutputFile::Care::closed);
}

void HeldSteps::add(std::int64_t seconds, std::span<const double> values) {
  writer_->append({reinterpret_cast<const char*>(&seconds), sizeof seconds});
  writer_->append({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  ++count_;
}

void HeldSteps::write_rest() {
  if (!writer_) return;
  writer_->finish();
  writer_.reset();
}

void HeldSteps::by_step(const TakeStep& take) {
  write_rest();
  const std::size_t row = sizeof(std::int64_t) + basins_ * sizeof(double);
  std::string window(std::max<std::size_t>(1, window_bytes / row) * row, '\0');
  std::vector<double> values(basins_);
  std::size_t done = 0;
  for (std::uint64_t at = 0; done < count_;) {
    throw_if_interrupted();
    const std::size_t read = read_spool(spool_, at, window) / row;
    if (read == 0) throw Error({spool_name, 0, "cannot be read back", ""});
    for (std::size_t i = 0; i < read; ++i) {
      std::int64_t seconds = 0;
      std::memcpy(&seconds, window.data() + i * row, sizeof seconds);
      std::memcpy(values.data(), window.data() + i * row + sizeof seconds, row - sizeof seconds);
      take(seconds, values);
    }
    done += read;
    at += read * row;
  }
}

void HeldSteps::by_basin(const TakeBasin& take) {
  const std::size_t bytes_a_basin = std::max<std::size_t>(1, count_) * sizeof(double);
  const std::size_t at_once = std::clamp<std::size_t>(memory_ / bytes_a_basin, 1, basins_);
  std::vector<double> values(at_once * count_);
  for (std::size_t first = 0; first < basins_; first += at_once) {
    const std::size_t basins = std::min(at_once, basins_ - first);
    std::size_t step = 0;
    by_step([&](std::int64_t, std::span<const double> row) {
      for (std::size_t b = 0; b < basins; ++b) values[b * count_ + step] = row[first + b];
      ++step;
    });
    for (std::size_t b = 0; b < basins; ++b)
      take(first + b, std::span(values).subspan(b * count_, count_));
  }
}

}  // namespace thiessen
