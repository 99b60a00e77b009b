#include "gdal/layers/flatgeobuf_length.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/layers/byte_order.h"
#include "gdal/layers/vsi_bytes.h"

namespace thiessen {
namespace {

// The file: 8 bytes of magic; the length of the header, in 4; the header, a flatbuffer; the index,
// a packed tree of nodes; features, each after its length, in 4.
constexpr std::string_view magic =
    "fgb\x03"
    "fgb";
constexpr std::uint64_t header_begins = 12;
constexpr std::uint64_t longest_header = std::uint64_t{64} << 20U;
constexpr std::uint64_t length_bytes = 4;
constexpr std::uint64_t node_bytes = 40;
constexpr std::size_t field_of_count = 8;  // of the header's table
constexpr std::size_t field_of_node_size = 9;
constexpr std::uint64_t usual_node_size = 16;

/// A field of the flatbuffer's root table; nothing where it has its default or cannot be read.
std::optional<std::uint64_t> field(std::string_view buffer, std::size_t number, std::size_t bytes) {
  const auto at = [&](std::uint64_t place, std::size_t count) -> std::optional<std::uint64_t> {
    if (place + count > buffer.size()) return std::nullopt;
    return little_endian(buffer.substr(place, count));
  };
  const auto table = at(0, 4);
  const auto back = table ? at(*table, 4) : std::nullopt;
  if (!back) return std::nullopt;
  const std::uint64_t names =
      *table -
      static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(*back)));
  if (names > buffer.size()) return std::nullopt;
  const auto names_bytes = at(names, 2);
  const std::uint64_t entry = 4 + 2 * number;
  if (!names_bytes || entry + 2 > *names_bytes) return std::nullopt;
  const auto offset = at(names + entry, 2);
  return offset && *offset != 0 ? at(*table + *offset, bytes) : std::nullopt;
}

/// The length of the index of so many features. Requires fewer features than the file has bytes.
std::uint64_t index_bytes(std::uint64_t features, std::uint64_t node_size) {
  if (features == 0 || node_size == 0) return 0;
  node_size = std::max<std::uint64_t>(node_size, 2);
  std::uint64_t nodes = features;
  for (std::uint64_t level = features;;) {
    level = (level + node_size - 1) / node_size;
    nodes += level;
    if (level == 1) return nodes * node_bytes;
  }
}

struct Walk {
  std::uint64_t whole = 0;  ///< features
  bool ends_well = false;   ///< the file ends with the last of them
};

Walk walk(VsiBytes& bytes, std::uint64_t place, std::uint64_t most) {
  Walk walk;
  while (place + length_bytes <= bytes.size() && walk.whole <= most) {
    throw_if_interrupted();
    const std::uint64_t length = little_endian(bytes.read_at(place, length_bytes));
    if (length == 0 || place + length_bytes + length > bytes.size()) return walk;
    place += length_bytes + length;
    ++walk.whole;
  }
  walk.ends_well = place == bytes.size();
  return walk;
}

}  // namespace

void require_whole_flatgeobuf(const std::string& file, const std::string& name) {
  VsiBytes bytes(file, name);
  const std::string head = bytes.read_at(0, header_begins);
  if (head.size() < header_begins || !head.starts_with(magic)) return;  // GDAL says what it is
  const std::uint64_t header_bytes = little_endian(std::string_view(head).substr(8));
  if (header_bytes > longest_header || header_begins + header_bytes > bytes.size()) {
    throw Error(Message{file,
                        0,
                        "is cut off: it has " + std::to_string(bytes.size()) +
                            " bytes, and its header alone has " +
                            std::to_string(header_begins + header_bytes),
                        {}});
  }
  const std::string header = bytes.read_at(header_begins, header_bytes);
  const std::uint64_t declared = field(header, field_of_count, 8).value_or(0);
  const std::uint64_t node_size = field(header, field_of_node_size, 2).value_or(usual_node_size);
  Walk found;
  if (declared < bytes.size()) {
    const std::uint64_t begin = header_begins + header_bytes + index_bytes(declared, node_size);
    found = walk(bytes, begin, declared == 0 ? bytes.size() : declared);
  }
  if (declared == 0) {  // not known when it was written
    if (found.ends_well) return;
    throw Error(Message{file,
                        0,
                        "is cut off: after " + std::to_string(found.whole) +
                            (found.whole == 1 ? " whole feature" : " whole features") +
                            " comes a part of one",
                        {}});
  }
  if (found.whole == declared && found.ends_well) return;
  if (found.whole == declared) {
    throw Error(Message{file,
                        0,
                        "goes on after the last of the " + std::to_string(declared) +
                            " features that its header declares",
                        {}});
  }
  throw Error(Message{file, 0,
                      "is not whole: its header declares " + std::to_string(declared) +
                          (declared == 1 ? " feature" : " features") + ", and it holds " +
                          (found.whole > declared ? "more" : std::to_string(found.whole)),
                      "a copy or a download was cut off: get it anew"});
}

}  // namespace thiessen
