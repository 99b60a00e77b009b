#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "readings/published/published_format.h"
#include "text/csv_dialect.h"

namespace thiessen {

/// What the first bytes of a text tell of a published format, before it is opened as a table.
struct TextBeginning {
  std::string text;             ///< the bytes as UTF-8; those that are not count as Latin-1
  CsvDialect dialect;           ///< what the user says, and what is known of the format's files
  bool tells_encoding = false;  ///< the format, and not the user, says the encoding
};

/// Looks at the bytes with which a text begins. The encoding that a format is published in counts
/// only where they are not UTF-8. Cost: none but that of checking for UTF-8, where the text is that
/// and begins with the lines of no format.
TextBeginning look_at_beginning(std::string_view bytes, const CsvDialect& said);

/// Whether a text is surely one of readings, by its first bytes: in a published format (see
/// PublishedFormat, and the readers of those that are no tables), or a table with columns of
/// stations, times and values by their usual names.
bool begins_as_readings(std::string_view bytes);

/// What the lines above a header and the file's name call the one station that a file is of, the
/// first first; empty where neither tells.
std::vector<std::string> stations_told(const PublishedFormat& format, std::string_view beginning,
                                       const std::string& file);

}  // namespace thiessen
