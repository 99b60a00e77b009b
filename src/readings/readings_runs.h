#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/file.h"
#include "readings/readings_pieces.h"

namespace thiessen {

/// Writes a piece as bytes: its sizes, its time, its readings. The bytes are only for the memory
/// and the files of this process.
void append_piece(std::string& bytes, const ReadingsPiece& piece);
std::size_t bytes_of(const ReadingsPiece& piece);

/// The sizes and lines with which the bytes of a piece begin.
struct PieceHead {
  std::uint64_t first_line;
  std::uint64_t line;
  std::uint32_t time_bytes;
  std::uint32_t readings;

  std::size_t readings_bytes() const { return std::size_t{readings} * sizeof(PieceReading); }
};
PieceHead head_at(const char* bytes);
std::string_view time_at(const char* bytes);

/// Runs of pieces in a temporary file (see spool.h), written one after the other.
class PieceRuns {
 public:
  struct Run {
    std::uint64_t begin;
    std::uint64_t end;
  };

  void begin();
  /// Adds the bytes of a piece to the run. Throws Error if the disk is full.
  void add(std::string_view piece);
  /// Ends the last run: no more pieces are added.
  void finish();
  bool empty() const { return runs_.empty(); }
  const std::vector<Run>& runs() const { return runs_; }
  const Descriptor& file() const { return file_; }

 private:
  Descriptor file_;
  std::optional<OutputFile> writer_;
  std::vector<Run> runs_;
};

/// Reads a run from its beginning, through a buffer.
class PieceRunReader {
 public:
  /// `file` must outlive this object.
  PieceRunReader(const Descriptor& file, PieceRuns::Run run, std::size_t buffer_bytes);

  /// Goes to the next piece; returns false at the end. Requires that the piece before has been
  /// taken.
  bool next();
  std::uint64_t first_line() const { return head_.first_line; }
  std::string_view time() const { return time_; }
  /// Takes the piece that was reached. Its views are valid until `next` and as long as `readings`
  /// is not changed.
  ReadingsPiece take(std::vector<PieceReading>& readings);

 private:
  void read(char* into, std::size_t count);

  const Descriptor* file_;
  PieceRuns::Run rest_;  ///< the part that is not yet in the buffer
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t filled_ = 0;
  PieceHead head_ = {};
  std::string time_;
};

}  // namespace thiessen
