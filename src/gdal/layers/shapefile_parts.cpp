#include "gdal/layers/shapefile_parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "gdal/layers/byte_order.h"
#include "gdal/layers/vsi_bytes.h"

namespace thiessen {
namespace {

constexpr std::uint64_t header_bytes = 100;  // of a .shp and a .shx
constexpr std::uint64_t dbf_header_bytes = 32;
constexpr std::uint64_t entry_bytes = 8;  // of a .shx, and the header of a record in a .shp
constexpr std::uint64_t entries_at_once = 8192;
constexpr char end_of_dbf = '\x1A';

std::string name_in_folder(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

/// One of the files.
struct Part {
  std::string name;  ///< without its folder
  std::unique_ptr<VsiBytes> bytes;

  std::uint64_t size() const { return bytes->size(); }
};

struct Span {
  std::uint64_t begin;
  std::uint64_t end;
};

class Shapefile {
 public:
  Shapefile(const std::string& file, const std::string& name)
      : file_(file), stem_(name.substr(0, name.rfind('.'))) {
    shp_ = part({".shp", ".SHP"});
    shx_ = part({".shx", ".SHX"});
    dbf_ = part({".dbf", ".DBF"});
  }

  bool lacks_dbf() const { return !dbf_; }

  void require_whole() {
    if (dbf_) count_records();
    if (!shp_ || !shx_) return;  // GDAL says what a .shp without a .shx lacks
    require_length(*shp_, 2 * number_at(*shp_, 24));
    const std::uint64_t shx_bytes = 2 * number_at(*shx_, 24);
    require_length(*shx_, shx_bytes);
    const std::uint64_t listed = (shx_bytes - header_bytes) / entry_bytes;
    const std::uint64_t shapes = count_shapes(listed);
    if (shapes == listed && (!dbf_ || records_ == listed)) {
      if (beyond_)
        fail(shx_->name + " lists a shape at bytes " + said(*beyond_) + ", and " + shp_->name +
             " has " + std::to_string(shp_->size()));
      return;
    }
    fail(shp_->name + " holds " + counted(shapes, "shape") + ", " + shx_->name + " lists " +
         std::to_string(listed) +
         (dbf_ ? ", and " + dbf_->name + " holds " + counted(records_, "record") : ""));
  }

 private:
  static std::string said(Span span) {
    return std::to_string(span.begin) + " to " + std::to_string(span.end);
  }

  [[noreturn]] void fail(std::string text) const {
    throw Error(Message{file_, 0, std::move(text),
                        "its files are cut off or do not belong together: get all of them anew"});
  }

  std::optional<Part> part(std::array<const char*, 2> extensions) const {
    for (const char* extension : extensions) {
      const std::string name = stem_ + extension;
      if (vsi_exists(name))
        return Part{name_in_folder(name), std::make_unique<VsiBytes>(file_, name)};
    }
    return std::nullopt;
  }

  std::uint64_t number_at(const Part& part, std::uint64_t place) const {
    require_header(part, header_bytes);
    return big_endian(part.bytes->read_at(place, 4));
  }

  void require_header(const Part& part, std::uint64_t bytes) const {
    if (part.size() >= bytes) return;
    fail(part.name + " has " + std::to_string(part.size()) + " bytes, and its header alone has " +
         std::to_string(bytes));
  }

  /// Whether zeros, or the signs that end a .dbf, are all that stands behind a place: disks and
  /// tapes of old padded files so.
  static bool is_padding(const Part& part, std::uint64_t from) {
    constexpr std::uint64_t most = 65536;
    if (part.size() - from > most) return false;
    const std::string rest = part.bytes->read_at(from, part.size() - from);
    return std::all_of(rest.begin(), rest.end(),
                       [](char c) { return c == '\0' || c == end_of_dbf; });
  }

  void require_length(const Part& part, std::uint64_t declared) const {
    // Bytes that are no record do no harm at the end.
    const bool is_whole = declared >= header_bytes && part.size() >= declared;
    if (is_whole && (part.size() < declared + entry_bytes || is_padding(part, declared))) return;
    fail(part.name + " has " + std::to_string(part.size()) + " bytes, and its header declares " +
         std::to_string(declared));
  }

  void count_records() {
    require_header(*dbf_, dbf_header_bytes);
    const std::string header = dbf_->bytes->read_at(0, dbf_header_bytes);
    const std::string_view view = header;
    const std::uint64_t declared = little_endian(view.substr(4, 4));
    const std::uint64_t before = little_endian(view.substr(8, 2));
    const std::uint64_t record = little_endian(view.substr(10, 2));
    const std::uint64_t whole = before + declared * record;
    if (dbf_->size() < whole) {
      fail(dbf_->name + " has " + std::to_string(dbf_->size()) +
           " bytes, and its header declares " + std::to_string(whole));
    }
    const bool ended = dbf_->bytes->read_at(dbf_->size() - 1, 1)[0] == end_of_dbf;
    records_ = record == 0 ? declared : (dbf_->size() - before - (ended ? 1 : 0)) / record;
    // A file may end without the sign, and one of a byte a record may seem to hold one fewer.
    if (records_ > declared && !is_padding(*dbf_, whole)) {
      fail(dbf_->name + " holds " + counted(records_, "record") + ", and its header declares " +
           std::to_string(declared));
    }
    records_ = declared;
  }

  /// How many shapes the .shp holds. Where it agrees with the .shx that is known without a walk
  /// through it: shapes are appended, so what the .shx lacks stands behind all that it lists.
  std::uint64_t count_shapes(std::uint64_t listed) {
    std::uint64_t end = header_bytes;
    for (std::uint64_t first = 0; first < listed; first += entries_at_once) {
      const std::uint64_t count = std::min(entries_at_once, listed - first);
      const std::string entries =
          shx_->bytes->read_at(header_bytes + first * entry_bytes, count * entry_bytes);
      for (std::size_t at = 0; at + entry_bytes <= entries.size(); at += entry_bytes) {
        const Span span = span_of(std::string_view(entries).substr(at, entry_bytes));
        if (span.end > shp_->size() && !beyond_) beyond_ = span;
        end = std::max(end, span.end);
      }
    }
    if (beyond_) return walk(header_bytes);
    return listed + walk(end);
  }

  /// Where a shape lies, by its entry in the .shx. An entry of zeros stands for no shape.
  static Span span_of(std::string_view entry) {
    const std::uint64_t begin = 2 * big_endian(entry.substr(0, 4));
    const std::uint64_t length = 2 * big_endian(entry.substr(4, 4));
    return begin == 0 ? Span{0, 0} : Span{begin, begin + entry_bytes + length};
  }

  /// Counts the records that follow one another from a place on.
  std::uint64_t walk(std::uint64_t place) const {
    constexpr std::uint64_t type_bytes = 4;
    std::uint64_t count = 0;
    while (place + entry_bytes + type_bytes <= shp_->size()) {
      const std::string header = shp_->bytes->read_at(place, entry_bytes);
      const std::uint64_t length = 2 * big_endian(std::string_view(header).substr(4, 4));
      if (length < type_bytes || place + entry_bytes + length > shp_->size()) break;
      place += entry_bytes + length;
      ++count;
    }
    return count;
  }

  const std::string& file_;
  std::string stem_;
  std::optional<Part> shp_;
  std::optional<Part> shx_;
  std::optional<Part> dbf_;
  std::uint64_t records_ = 0;
  std::optional<Span> beyond_;  ///< a shape that the .shx places behind the end of the .shp
};

}  // namespace

void require_whole_shapefile(const std::string& file, const std::string& name,
                             std::vector<std::string>& oddities) {
  Shapefile shapefile(file, name);
  if (shapefile.lacks_dbf())
    oddities.emplace_back("has no .dbf beside it: its shapes have no attributes");
  shapefile.require_whole();
}

}  // namespace thiessen
