#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// A format of readings as an agency publishes it, one row of the table of those that are read
/// without an option. Names of columns compare as same_name says; where a column has several names,
/// these are parted by a bar.
struct PublishedFormat {
  std::string_view name;     ///< what it is called in messages and in the manual
  std::string_view columns;  ///< that the header has in this order, others between; after commas
  std::string_view station;
  std::string_view time;  ///< one column, or several after commas
  std::string_view value;
  std::string_view unit = {};     ///< of the values; empty where the column's name says it
  std::string_view missing = {};  ///< texts that mean no reading, parted by blanks
  std::string_view trace = {};    ///< a text that means 0
  std::string_view kept = {};     ///< ELEMENT=PRCP: the rows that are read, and no others
  std::string_view flags = {};    ///< the column of flags of quality: one means no reading
  std::size_t flag_place = 0;     ///< which of the texts between commas the flag is, from 0
  std::string_view period = {};   ///< the column of days that an amount is of, if not of one
  bool whole_numbers = false;     ///< values have no fractions: one that has is of another unit
  bool ids_as_numbers = false;    ///< ids have leading zeros in the list of stations alone
  bool unit_is_ordered = false;   ///< who orders the file chooses the unit, and it does not say
};

/// The formats that are tables, known by their header. The first that fits is taken.
std::span<const PublishedFormat> published_formats();

/// The same columns as a file of GHCN-Daily by year has them that begins without a header, as
/// columns without a header are called: 1, 2, 3...
const PublishedFormat& ghcn_without_header();
/// Whether these are the fields of a row of such a file.
bool is_ghcn_row(const std::vector<std::string>& fields);

/// The index of a column of a header, which may have one of several names; nothing where it lacks
/// them all.
std::optional<std::size_t> published_column(const std::vector<std::string>& header,
                                            std::string_view names);

/// The texts that a separator parts, without the blanks at their ends.
std::vector<std::string_view> parted(std::string_view text, char separator);

/// The format that a header belongs to, or null.
const PublishedFormat* format_of_header(const std::vector<std::string>& header);

}  // namespace thiessen
