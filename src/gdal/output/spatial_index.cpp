#include "gdal/output/spatial_index.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "geometry/hilbert.h"

namespace thiessen {
namespace {

constexpr std::size_t node_head = 4;     // the tree's depth and the number of entries
constexpr std::size_t entry_bytes = 24;  // a number of 8 bytes, and four coordinates as floats

/// A text in SQL, between quotes of that kind.
std::string in_quotes(const std::string& text, char quote) {
  std::string quoted(1, quote);
  for (const char c : text) {
    if (c == quote) quoted += quote;
    quoted += c;
  }
  return quoted + quote;
}

/// The greatest float that is not above the value.
float float_below(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) > value
             ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
             : nearest;
}
float float_above(double value) {
  return -float_below(-value);
}

/// Appends a number, its highest byte first.
void append_bytes(std::string& out, std::uint64_t number, int bytes) {
  for (int i = bytes - 1; i >= 0; --i) out += static_cast<char>(number >> (8 * i));
}

void append_float(std::string& out, float value) {
  append_bytes(out, std::bit_cast<std::uint32_t>(value), 4);
}

struct FinishStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

}  // namespace

/// A statement that puts a row of two columns into a table, made once for all rows: GDAL would look
/// through the text of each.
class SpatialIndex::RowInserted {
 public:
  RowInserted(const SpatialIndex& index, const std::string& into) : index_(index) {
    auto* const database = static_cast<sqlite3*>(index.dataset_.GetInternalHandle("SQLITE_HANDLE"));
    sqlite3_stmt* made = nullptr;
    const std::string text = into + " VALUES (?,?)";
    index_.require(database != nullptr &&
                   sqlite3_prepare_v2(database, text.c_str(), -1, &made, nullptr) == SQLITE_OK);
    statement_.reset(made);
  }

  void add(std::int64_t first, std::int64_t second) {
    index_.require(sqlite3_bind_int64(statement_.get(), 2, second) == SQLITE_OK);
    put(first);
  }
  void add(std::int64_t first, const std::string& bytes) {
    index_.require(sqlite3_bind_blob64(statement_.get(), 2, bytes.data(), bytes.size(),
                                       SQLITE_STATIC) == SQLITE_OK);
    put(first);
  }

 private:
  void put(std::int64_t first) {
    index_.require(sqlite3_bind_int64(statement_.get(), 1, first) == SQLITE_OK);
    index_.require(sqlite3_step(statement_.get()) == SQLITE_DONE);
    index_.require(sqlite3_reset(statement_.get()) == SQLITE_OK);
  }

  const SpatialIndex& index_;
  std::unique_ptr<sqlite3_stmt, FinishStatement> statement_;
};

SpatialIndex::SpatialIndex(GDALDataset& dataset, OGRLayer& layer, std::string path)
    : dataset_(dataset),
      path_(std::move(path)),
      table_(layer.GetName()),
      tree_("rtree_" + table_ + "_" + layer.GetGeometryColumn()) {
  const auto made = texts("SELECT CreateSpatialIndex(" + in_quotes(table_, '\'') + "," +
                          in_quotes(layer.GetGeometryColumn(), '\'') + ")");
  if (made != std::vector<std::string>{"1"})
    throw Error(Message{path_, 0, "GDAL makes no spatial index", {}});
  take_triggers_away();
  capacity_ = (node_bytes() - node_head) / entry_bytes;
}

void SpatialIndex::take_triggers_away() {
  const std::string prefix = in_quotes(tree_ + "_", '\'');
  const std::string of_tree =
      " FROM sqlite_master WHERE type = 'trigger' AND tbl_name = " + in_quotes(table_, '\'') +
      " AND substr(name, 1, length(" + prefix + ")) = " + prefix + " ORDER BY rowid";
  triggers_ = texts("SELECT sql" + of_tree);
  for (const std::string& name : texts("SELECT name" + of_tree))
    run("DROP TRIGGER " + in_quotes(name, '"'));
}

std::size_t SpatialIndex::node_bytes() const {
  const auto found =
      texts("SELECT length(data) FROM " + in_quotes(tree_ + "_node", '"') + " WHERE nodeno = 1");
  const std::size_t bytes = found.size() == 1 ? std::stoul(found.front()) : 0;
  if (bytes < node_head + 2 * entry_bytes)
    throw Error(Message{path_, 0, "GDAL's spatial index has no nodes", {}});
  return bytes;
}

void SpatialIndex::write() {
  std::vector<Entry> level = std::move(entries_);
  Box all;
  for (const Entry& entry : level) all.take_in(entry.box);
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  order.reserve(level.size());
  for (const Entry& entry : level)
    order.emplace_back(hilbert_distance(all, entry.box.centre()), order.size());
  std::sort(order.begin(), order.end());
  std::vector<Entry> sorted;
  sorted.reserve(level.size());
  for (const auto& [distance, at] : order) sorted.push_back(level[at]);
  level = std::move(sorted);
  int depth = 0;
  for (; level.size() > capacity_; ++depth) level = write_level(level, depth, false);
  write_level(level, depth, true);
  for (const std::string& trigger : triggers_) run(trigger);
}

// Writes nodes over the entries, as evenly filled as can be, and returns them as entries of the
// level above. Entries of the lowest level are rows.
std::vector<SpatialIndex::Entry> SpatialIndex::write_level(const std::vector<Entry>& entries,
                                                           int depth, bool is_root) {
  RowInserted node_row(*this, "REPLACE INTO " + in_quotes(tree_ + "_node", '"'));
  const std::size_t nodes = is_root ? 1 : (entries.size() + capacity_ - 1) / capacity_;
  std::vector<Entry> above;
  above.reserve(nodes);
  std::vector<std::pair<std::int64_t, std::int64_t>> node_of;  // of each entry
  node_of.reserve(entries.size());
  std::string row;
  for (std::size_t n = 0; n < nodes; ++n) {
    const std::size_t begin = entries.size() * n / nodes;
    const std::size_t end = entries.size() * (n + 1) / nodes;
    Entry& node = above.emplace_back(Entry{is_root ? 1 : ++last_node_, {}});
    row.clear();
    append_bytes(row, is_root ? static_cast<std::uint64_t>(depth) : 0, 2);
    append_bytes(row, end - begin, 2);
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [entry, box] = entries[i];
      append_bytes(row, static_cast<std::uint64_t>(entry), 8);
      append_float(row, float_below(box.low.x));
      append_float(row, float_above(box.high.x));
      append_float(row, float_below(box.low.y));
      append_float(row, float_above(box.high.y));
      node.box.take_in(box);
      node_of.emplace_back(entry, node.number);
    }
    row.append(entry_bytes * (capacity_ - (end - begin)), '\0');
    node_row.add(node.number, row);
  }
  std::sort(node_of.begin(), node_of.end());  // a table grows fastest at its end
  RowInserted entry_row(
      *this, "INSERT INTO " + in_quotes(tree_ + (depth == 0 ? "_rowid" : "_parent"), '"'));
  for (const auto& [entry, node] : node_of) entry_row.add(entry, node);
  return above;
}

void SpatialIndex::run(const std::string& statement) const {
  CPLErrorReset();
  if (OGRLayer* const answer = dataset_.ExecuteSQL(statement.c_str(), nullptr, nullptr))
    dataset_.ReleaseResultSet(answer);
  require(CPLGetLastErrorType() < CE_Failure);
}

void SpatialIndex::require(bool done) const {
  if (done) return;
  throw_if_interrupted();  // which makes SQLite fail
  throw Error(Message{path_, 0, "GDAL cannot write the spatial index", {}});
}

std::vector<std::string> SpatialIndex::texts(const std::string& query) const {
  std::vector<std::string> found;
  OGRLayer* const answer = dataset_.ExecuteSQL(query.c_str(), nullptr, nullptr);
  if (answer == nullptr) return found;
  for (const auto& feature : *answer) found.emplace_back(feature->GetFieldAsString(0));
  dataset_.ReleaseResultSet(answer);
  return found;
}

}  // namespace thiessen
