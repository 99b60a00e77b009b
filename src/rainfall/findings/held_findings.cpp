#include "rainfall/findings/held_findings.h"

#include <cstring>

#include "base/spool.h"

namespace thiessen {
namespace {

constexpr std::size_t most_held = 1'000'000;

/// A finding but for its time, whose text follows it.
struct Head {
  double value;
  double expected;
  double excess;
  StationIndex station;
  FindingKind kind;
  std::size_t time_bytes;
};

}  // namespace

void HeldFindings::add(const ReadingFinding& finding) {
  const Head head{finding.value,   finding.expected, finding.excess,
                  finding.station, finding.kind,     finding.time.size()};
  held_.append(reinterpret_cast<const char*>(&head), sizeof head);
  held_ += finding.time;
  if (held_.size() > most_held) spill();
}

void HeldFindings::spill() {
  if (!writer_) {
    file_ = open_spool();
    writer_.emplace(spool_name, file_.twin(spool_name), OutputFile::Care::closed);
  }
  writer_->append(held_);
  held_.clear();
}

std::size_t HeldFindings::pass_on(std::string_view bytes, const TakeFinding& take) {
  std::size_t at = 0;
  Head head{};
  while (bytes.size() - at >= sizeof head) {
    std::memcpy(&head, bytes.data() + at, sizeof head);
    if (bytes.size() - at - sizeof head < head.time_bytes) break;
    ReadingFinding finding{
        head.station, head.kind,     std::string(bytes.substr(at + sizeof head, head.time_bytes)),
        head.value,   head.expected, 0,
        head.excess};
    at += sizeof head + head.time_bytes;
    take(std::move(finding));
  }
  return at;
}

void HeldFindings::pass_on(const TakeFinding& take) {
  if (writer_) {
    writer_->finish();
    writer_.reset();
    std::string rest;
    copy_spool(file_, [&](std::string_view piece) {
      rest += piece;
      rest.erase(0, pass_on(rest, take));
    });
  }
  pass_on(held_, take);
  held_.clear();
}

}  // namespace thiessen
