#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file.h"

namespace thiessen {

/// The place of a table in a PostgreSQL database.
struct DatabaseTarget {
  std::string connection;  ///< `PG:` and what libpq takes: keywords, or a URI
  std::string table;       ///< `name`, or `schema.name`
  bool overwrite = false;  ///< whether a table that this program made may be replaced
};

/// A table that appears in a PostgreSQL database whole, or not at all.
///
/// Its rows are written as CSV, and wait in a temporary file (spool.h) until all are there.
/// `commit` then makes the table, fills and marks it, in one transaction. The mark is the table's
/// comment, which begins with the program's name and version: a table without it is somebody
/// else's, and is never dropped. One that is replaced leaves its rights to the new one. A table
/// that is named without a schema is looked for where it would be made, and nowhere else. Numbers
/// go over as text, in the digits that the rows have.
class DatabaseTable {
 public:
  /// A geometry, in the hexadecimal digits of EWKB.
  static constexpr const char* geometry_column = "geom";

  /// Looks whether the database can be reached and the table may be made. Throws Error where it
  /// cannot, or PostgreSQL would cut its name, with a hint.
  explicit DatabaseTable(DatabaseTarget target);

  /// The rows: CSV with a header. An empty field without quotes is no value.
  OutputFile& rows() { return rows_; }
  /// Makes the table of the rows. `comment` tells by what it is made, as sentence_of has it.
  /// `names` are those of the columns in their order; without them the rows' header counts, which
  /// then has names of this program's own alone; of those that are given the first `own` are, and
  /// the others, but for the geometry's, are of texts. Geometries are in `srid`, and have an index.
  /// Throws Error where the database refuses it, and Interrupted; the database is then as before.
  /// Cost: linear in the rows.
  void commit(const std::string& comment, std::vector<std::string> names = {}, int srid = 0,
              std::size_t own = SIZE_MAX);
  /// The database and the table, as messages name them.
  const std::string& name() const { return name_; }

 private:
  DatabaseTarget target_;
  std::string name_;
  Descriptor spool_;
  OutputFile rows_;
};

/// Whether a table's comment is of the form that this program's have: `thiessen 0.1.0; metric: `,
/// and more.
bool is_mark(std::string_view comment);

/// The columns of a table in SQL, by the header of its CSV: `"time" text, "weight" double
/// precision`. Areas, weights, rainfall, errors and shares are numbers, counts whole ones, all else
/// is text, and so is all behind the first `own` names but a geometry.
std::string sql_columns(const std::vector<std::string>& names, int srid,
                        std::size_t own = SIZE_MAX);

}  // namespace thiessen
