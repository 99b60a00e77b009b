#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// A format of readings as an agency publishes it, one row of the table of those that are read
/// without an option. Names of columns compare as same_name says; where a column has several names,
/// these are parted by a bar, and one that ends in a star is how the name begins.
struct PublishedFormat {
  std::string_view name;     ///< what it is called in messages and in the manual
  std::string_view columns;  ///< that the header has in this order, others between; after commas
  std::string_view station;  ///< empty: a file is of one station, which no column tells
  std::string_view time;     ///< one column, or several after commas
  std::string_view value;
  std::string_view unit = {};     ///< of the values; empty where the column's name says it
  std::string_view missing = {};  ///< texts that mean no reading, parted by blanks
  std::string_view trace = {};    ///< a text that means 0
  std::string_view kept = {};     ///< ELEMENT=PRCP: the rows that are read, and no others
  std::string_view flags = {};    ///< the column of flags of quality: one means no reading
  std::size_t flag_place = 0;     ///< which of the texts between commas the flag is, from 0
  std::string_view marks = {};    ///< the column right before the value that is 0 for a usual one;
                                  ///< values of any other mark count, and are told
  std::string_view key = {};      ///< 4=estimated: what other marks mean; several after bars
  std::string_view trace_marks = {};  ///< those of a trace, which counts as 0, parted by blanks
  std::string_view period = {};       ///< the column of days that an amount is of, if not of one
  std::string_view source = {};       ///< the column that tells where a value comes from
  std::string_view models = {};    ///< what stands in it where that is no gauge, parted by blanks
  std::string_view begins = {};    ///< how the lines above the header begin; several after bars
  std::string_view label = {};     ///< what stands before the station's id in one of these lines
  std::string_view prefixes = {};  ///< of the file's name before the id; several after bars
  std::string_view repeated = {};  ///< a name that the header may have more than once
  std::string_view ordered_units = {};  ///< in which an order may be, parted by blanks
  std::string_view encoding = {};       ///< what its publisher writes where it is not UTF-8
  bool whole_numbers = false;    ///< values have no fractions: one that has is of another unit
  bool ids_as_numbers = false;   ///< ids have leading zeros in the list of stations alone
  bool unit_is_ordered = false;  ///< who orders the file chooses the unit, and it does not say
  bool times_end_steps = false;  ///< a time is the end of its step
  bool day_first = false;        ///< dates such as 01.02.2010 have the day before the month
  bool is_of_basins = false;     ///< values are means over the basin of a river gauge
};

/// Whether a column has one of these names.
bool has_published_name(std::string_view column, std::string_view names);

/// The index of a column of a header, which may have one of several names; nothing where it lacks
/// them all.
std::optional<std::size_t> published_column(const std::vector<std::string>& header,
                                            std::string_view names);

/// The texts that a separator parts, without the blanks at their ends.
std::vector<std::string_view> parted(std::string_view text, char separator);

}  // namespace thiessen
