#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "readings/published/published_format.h"
#include "readings/readings_reader.h"
#include "text/table_over.h"

namespace thiessen {

/// The rows of a table of a known format that are readings of rain. Values with a flag of quality,
/// unless they are kept, and amounts of several days are empty; how many there are is told once the
/// last row has been read, and of how many it is told that they are a model's or have a mark.
/// Throws Error where a value shows that it is in another unit.
class PublishedTable : public TableOver {
 public:
  /// Requires a table of this format. `warnings` must outlive the table.
  PublishedTable(std::unique_ptr<Table> table, const PublishedFormat& format,
                 const ReadingsOptions& options, Warnings& warnings);

  bool next(Row& row) override;
  bool is_waiting(std::chrono::milliseconds patience) override;

 private:
  /// What all readers of the file have together.
  struct Told {
    bool at_end = false;
  };

  PublishedTable(const PublishedTable& other, std::unique_ptr<Table> table);
  std::unique_ptr<Table> over(std::unique_ptr<Table> table) const override;
  bool takes(Row& row);
  bool has_flag(const Row& row) const;
  bool is_of_days(const Row& row) const;
  bool is_of_model(const Row& row) const;
  void note_mark(Row& row);
  void require_whole(const Row& row) const;
  void tell();
  void tell_marks();

  PublishedFormat format_;
  Warnings& warnings_;
  std::size_t value_;
  std::optional<std::size_t> kept_;
  std::optional<std::size_t> flags_;
  std::optional<std::size_t> marks_;
  std::optional<std::size_t> period_;
  std::optional<std::size_t> source_;
  std::string_view kept_text_;
  bool requires_whole_;
  std::size_t flagged_ = 0;
  std::size_t of_days_ = 0;
  std::size_t of_models_ = 0;
  std::map<std::string, std::size_t, std::less<>> marked_;  ///< values that count, by their mark
  std::size_t otherwise_marked_ = 0;  ///< with marks beyond the first different ones
  Row ahead_;  ///< the next row, where it was read to see whether it has come
  bool has_ahead_ = false;
  std::shared_ptr<Told> told_ = std::make_shared<Told>();
};

/// What the user says of readings, and beside it what is known of their format. Throws Error where
/// the unit is one that only the user knows.
ReadingsOptions options_of(const PublishedFormat& format, const Table& table,
                           ReadingsOptions options);

/// Tells what a file was taken for, and its encoding where the format and not the user tells that.
void tell_format(const PublishedFormat& format, const Table& table, const ReadingsOptions& said,
                 bool tells_encoding, Warnings& warnings);

}  // namespace thiessen
