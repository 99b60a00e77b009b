#include "rainfall/series/held_totals.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/spool.h"

namespace thiessen {

void HeldTotals::add(std::span<const BasinTotal> totals) {
  bytes_.append(reinterpret_cast<const char*>(totals.data()), totals.size_bytes());
  if (bytes_.size() > memory_) spill();
}

void HeldTotals::spill() {
  if (!spool_.is_open()) {
    spool_ = open_spool();
    writer_.emplace(spool_name, spool_.twin(spool_name), OutputFile::Care::closed);
  }
  writer_->append(bytes_);
  bytes_.clear();
}

void HeldTotals::take(std::span<BasinTotal> totals) {
  if (!std::exchange(taking_, true) && writer_) {
    spill();
    writer_->finish();
  }
  const std::size_t wanted = totals.size_bytes();
  if (writer_ && bytes_.size() - at_ < wanted) {
    bytes_.resize(std::max(memory_, wanted));
    bytes_.resize(read_spool(spool_, read_at_, bytes_));
    at_ = 0;
    if (bytes_.size() < wanted) throw Error({spool_name, 0, "cannot be read back", ""});
    // A window begins with a whole period, and what it holds of the next is read once more.
    bytes_.resize(bytes_.size() / wanted * wanted);
    read_at_ += bytes_.size();
  }
  std::memcpy(totals.data(), bytes_.data() + at_, wanted);
  at_ += wanted;
}

}  // namespace thiessen
