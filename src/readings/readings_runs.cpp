#include "readings/readings_runs.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "base/spool.h"

namespace thiessen {
namespace {

template <typename T>
std::string_view bytes_in(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

std::size_t bytes_of(const ReadingsPiece& piece) {
  return sizeof(PieceHead) + piece.time.size() + piece.readings.size_bytes();
}

void append_piece(std::string& bytes, const ReadingsPiece& piece) {
  const PieceHead head = {piece.first_line, piece.line,
                          static_cast<std::uint32_t>(piece.time.size()),
                          static_cast<std::uint32_t>(piece.readings.size())};
  bytes += bytes_in(std::span(&head, 1));
  bytes += piece.time;
  bytes += bytes_in(piece.readings);
}

PieceHead head_at(const char* bytes) {
  PieceHead head;
  std::memcpy(&head, bytes, sizeof head);
  return head;
}

std::string_view time_at(const char* bytes) {
  return {bytes + sizeof(PieceHead), head_at(bytes).time_bytes};
}

void PieceRuns::begin() {
  if (!file_.is_open()) {
    file_ = open_spool();
    writer_.emplace(spool_name, file_.twin(spool_name), OutputFile::Care::closed);
  }
  const std::uint64_t end = runs_.empty() ? 0 : runs_.back().end;
  runs_.push_back({end, end});
}

void PieceRuns::add(std::string_view piece) {
  writer_->append(piece);
  runs_.back().end += piece.size();
}

void PieceRuns::finish() {
  if (writer_) writer_->finish();
  writer_.reset();
}

PieceRunReader::PieceRunReader(const Descriptor& file, PieceRuns::Run run, std::size_t buffer_bytes)
    : file_(&file), rest_(run), buffer_(buffer_bytes, '\0') {}

bool PieceRunReader::next() {
  if (at_ == filled_ && rest_.begin == rest_.end) return false;
  char head[sizeof(PieceHead)];
  read(head, sizeof head);
  head_ = head_at(head);
  time_.resize(head_.time_bytes);
  read(time_.data(), time_.size());
  return true;
}

ReadingsPiece PieceRunReader::take(std::vector<PieceReading>& readings) {
  readings.resize(head_.readings);
  read(reinterpret_cast<char*>(readings.data()), head_.readings_bytes());
  return {head_.first_line, head_.line, time_, readings};
}

void PieceRunReader::read(char* into, std::size_t count) {
  while (count > 0) {
    if (at_ == filled_) {
      const std::uint64_t wanted = std::min<std::uint64_t>(buffer_.size(), rest_.end - rest_.begin);
      at_ = 0;
      filled_ = read_spool(*file_, rest_.begin, std::span(buffer_).first(wanted));
      if (filled_ == 0) throw Error(Message{spool_name, 0, "is shorter than was written", ""});
      rest_.begin += filled_;
    }
    const std::size_t taken = std::min(count, filled_ - at_);
    std::memcpy(into, buffer_.data() + at_, taken);
    at_ += taken;
    into += taken;
    count -= taken;
  }
}

}  // namespace thiessen
