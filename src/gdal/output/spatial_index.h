#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/box.h"

class GDALDataset;
class OGRLayer;

namespace thiessen {

/// The spatial index of a layer that is written into a GeoPackage. GDAL's own takes row after row
/// into SQLite's R*-tree, which is two fifths of the time of writing; here the tree is packed along
/// Hilbert's curve when all rows are there (Kamel and Faloutsos, On packing R-trees, 1993), and its
/// nodes are written as SQLite documents them (The SQLite R*Tree Module, 5, shadow tables).
///
/// The layer is created with SPATIAL_INDEX=NO. While rows are written, the triggers that keep the
/// index true are away.
class SpatialIndex {
 public:
  /// Requires a layer without rows. Throws Error, naming `path`, where GDAL makes no index.
  SpatialIndex(GDALDataset& dataset, OGRLayer& layer, std::string path);

  /// Takes in a row with a shape.
  void add(std::int64_t row, const Box& box) { entries_.push_back({row, box}); }
  /// Writes the index, and puts the triggers back. Throws Error. Cost: n log n.
  void write();

 private:
  struct Entry {
    std::int64_t number;  ///< of a row, or of a node of the tree
    Box box;
  };

  class RowInserted;

  void take_triggers_away();
  std::size_t node_bytes() const;
  std::vector<Entry> write_level(const std::vector<Entry>& entries, int depth, bool is_root);
  void run(const std::string& statement) const;
  /// Throws Error, or Interrupted, where SQLite has not done what it was to do.
  void require(bool done) const;
  std::vector<std::string> texts(const std::string& query) const;

  GDALDataset& dataset_;
  std::string path_;
  std::string table_;
  std::string tree_;
  std::vector<std::string> triggers_;
  std::vector<Entry> entries_;
  std::size_t capacity_ = 0;  ///< of a node
  std::int64_t last_node_ = 1;
};

}  // namespace thiessen
