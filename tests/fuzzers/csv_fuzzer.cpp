#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/memory_pipe.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_csv.h"
#include "geometry/coordinates.h"
#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "text/csv_reader.h"
#include "text/csv_writer.h"
#include "text/points_file.h"

namespace thiessen::fuzzers {
namespace {

using Rows = std::vector<PlainRow>;

/// What a reader makes of a text: rows with the header first, or complaints.
struct Outcome {
  std::optional<Rows> rows;
  std::vector<std::string> complaints;
};

/// Requires that a field is the same number whether the bytes after it may be read or not.
void require_padding(const Row& row) {
  require(row.padded, "a row of a CSV that is not padded");
  for (const std::string_view field : row.fields) {
    for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
      const Parsed<double> padded = parse_padded_number(field, mark);
      const Parsed<double> plain = parse_number(std::string(field), mark);
      require(padded.fault == plain.fault &&
                  std::memcmp(&padded.value, &plain.value, sizeof plain.value) == 0,
              "another number with padding");
    }
  }
}

Rows rows_of(CsvReader& reader) {
  Rows rows = {{reader.header_line(), reader.header()}};
  Row row;
  while (reader.next(row)) {
    require_padding(row);
    require(row.line > rows.back().line, "a row that begins before the one above ends");
    rows.push_back({row.line, {row.fields.begin(), row.fields.end()}});
    const double share = reader.share_read();
    require(std::isnan(share) || (share > 0 && share <= 1), "a share that is none");
  }
  require(!reader.next(row), "a row after the end");
  return rows;
}

Outcome read(const std::string& file, const CsvOptions& options, std::size_t lines) {
  Outcome outcome;
  try {
    CsvReader reader(file, options);
    outcome.rows = rows_of(reader);
    const std::unique_ptr<Table> again = reader.again();
    require(!again || again->header() == reader.header(), "another header when read again");
  } catch (const Error& error) {
    require_placed(error, file, lines);
    for (const Message& message : error.messages())
      outcome.complaints.push_back(std::to_string(message.line) + message.text.plain());
  }
  return outcome;
}

/// Requires that the rows, written by our own writer, are read as what they were. A row of one
/// empty field is left out: it is a blank line.
void require_read_back(const Rows& rows) {
  std::string text;
  Rows written;
  std::size_t line = 1;
  for (const PlainRow& row : rows) {
    if (row.fields == std::vector<std::string>{""}) continue;
    const std::size_t from = text.size();
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
      if (i > 0) text += ',';
      append_csv_field(text, row.fields[i]);
    }
    text += '\n';
    written.push_back({line, row.fields});
    // CRLF is one line end, so that each line is counted where it ends.
    for (std::size_t at = from; at < text.size(); ++at)
      line += text[at] == '\n' || (text[at] == '\r' && text[at + 1] != '\n') ? 1u : 0u;
  }
  if (written.empty()) return;
  const MemoryFile file(text);
  CsvReader reader(file.name(), {',', {}, false});
  require(rows_of(reader) == written, "other rows once written and read again");
}

/// The text, behind what brings it to the edge of the reader's window: blank lines, or one long
/// field of the header.
std::string at_the_window_edge(std::string_view text, std::size_t filling, char separator) {
  constexpr std::size_t window = std::size_t{256} << 10;
  const std::size_t before = window - std::min(text.size(), filling);
  if (filling % 2 == 0) return std::string(before, '\n') + std::string(text);
  return '"' + std::string(before, 'x') + '"' + separator + std::string(text);
}

void fuzz_table(Bytes& bytes) {
  CsvOptions options;
  options.separator = bytes.one_of(std::string_view(",;\t| :a"));
  const std::size_t flags = bytes.next();
  options.has_names = flags % 2 == 0;
  const bool limited = flags / 2 % 8 == 0;
  if (limited) options.limits = {bytes.below(20), bytes.below(60), bytes.below(8)};
  const bool filled = flags / 16 == 1;
  const std::size_t piece = 1 + bytes.below(8);
  const std::string text = filled ? at_the_window_edge(bytes.rest(), piece * 5, options.separator)
                                  : std::string(bytes.rest());
  const std::size_t lines = lines_of(text);

  const MemoryFile file(text);
  const Outcome outcome = read(file.name(), options, lines);
  const auto expected = PlainCsv(text, options.separator).read();
  const bool sound = expected && (!options.has_names ||
                                  PlainCsv::is_header(expected->front().fields, options.separator));
  require(!outcome.rows || (sound && *outcome.rows == *expected), "other rows than there are");
  require(outcome.rows || !sound || limited, "refused, and yet sound");
  if (outcome.rows) require_read_back(*outcome.rows);

  if (text.empty() || text.size() > MemoryPipe::longest_text) return;
  const MemoryPipe pipe(text, piece);
  const Outcome in_pieces = read(pipe.name(), options, lines);
  require(outcome.rows == in_pieces.rows, "other rows in pieces");
  const bool is_text = !find_invalid_utf8(text) && text.find('\0') == std::string::npos;
  require(limited || !is_text || outcome.complaints == in_pieces.complaints,
          "other complaints in pieces");
}

/// A table whose form is found out: whatever it is taken for, it is that once more, and from a pipe
/// in pieces of any size.
void fuzz_form(Bytes& bytes) {
  CsvOptions options;
  options.finds_form = true;
  options.separator = bytes.one_of(std::string_view("\0\0\0\0,;\t ", 8));
  options.encoding = bytes.below(8) == 0 ? "cp932" : "";
  if (bytes.below(8) == 0) options.skip = bytes.below(3);
  const std::size_t piece = 1 + bytes.below(8);
  const std::string text(bytes.rest());
  const MemoryFile file(text);
  // A text in another encoding may have another number of lines: UTF-16 of line ends is longer.
  const std::size_t lines = 2 * text.size() + 1;
  const Outcome once = read(file.name(), options, lines);
  const Outcome again = read(file.name(), options, lines);
  require(once.rows == again.rows && once.complaints == again.complaints, "another form");
  if (text.empty() || text.size() > MemoryPipe::longest_text) return;
  const MemoryPipe pipe(text, piece);
  const Outcome in_pieces = read(pipe.name(), options, lines);
  const MemoryPipe other(text, piece + 5);
  require(read(other.name(), options, lines).rows == in_pieces.rows,
          "another form in other pieces");
}

template <int Dimension>
void fuzz_points(std::string_view text) {
  const MemoryFile file(text);
  Warnings warnings;
  std::vector<PositionIn<Dimension>> points;
  try {
    points = read_points<Dimension>(file.name(), warnings);
  } catch (const Error& error) {
    return require_placed(error, file.name(), lines_of(text));
  }
  require(!points.empty(), "no points, and no error");
  std::string again;
  for (const auto& p : points) {
    require(in_exact_range(p), "a point outside the range");
    std::string row;
    for (const double c : coordinates(p)) {
      require(c != 0 || !std::signbit(c), "a negative zero");
      row += (row.empty() ? "" : ",") + shortest_text(c);
    }
    again += row + "\n";
  }
  require(read_points<Dimension>(MemoryFile(again).name(), warnings) == points,
          "other points once written and read again");
}

}  // namespace

void fuzz_csv(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(5)) {
    case 0:
      return fuzz_points<2>(bytes.rest());
    case 1:
      return fuzz_points<3>(bytes.rest());
    case 4:
      return fuzz_form(bytes);
    default:
      return fuzz_table(bytes);
  }
}

}  // namespace thiessen::fuzzers
