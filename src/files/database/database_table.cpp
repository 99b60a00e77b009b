#include "files/database/database_table.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/interrupt.h"
#include "base/secrets.h"
#include "base/spool.h"
#include "files/database/postgres.h"
#include "readings/published/published_format.h"
#include "text/text_lines.h"

namespace thiessen {
namespace {

constexpr std::string_view mark = "thiessen";

/// A table's name in SQL: with its schema, where one is named.
std::string in_sql(const std::string& table) {
  const std::size_t dot = table.find('.');
  if (dot == std::string::npos) return Postgres::quoted_name(table);
  return Postgres::quoted_name(table.substr(0, dot)) + "." +
         Postgres::quoted_name(table.substr(dot + 1));
}

enum class Found { nothing, ours };

/// Whether there is a table of the name. Throws Error where it may not be replaced.
Found look_for(Postgres& database, const DatabaseTarget& target, const std::string& name) {
  const std::string table = Postgres::quoted_text(in_sql(target.table));
  if (!database.value("SELECT to_regclass(" + table + ")::text")) return Found::nothing;
  const auto comment =
      database.value("SELECT obj_description(to_regclass(" + table + "), 'pg_class')");
  const bool is_ours =
      comment && (*comment == mark || comment->starts_with(std::string(mark) + " "));
  if (!is_ours) {
    throw Error(Message{name, 0, "it exists, and this program did not make it: it is never dropped",
                        "another name: " + setting("output_layer", "NAME")});
  }
  if (!target.overwrite)
    throw Error(Message{name, 0, "already exists", setting("overwrite") + " replaces it"});
  return Found::ours;
}

std::string_view sql_type_of(std::string_view name) {
  constexpr std::array<std::string_view, 11> real = {
      "area_km2", "area_km2_after", "area", "area_after", "weight",     "weight_after",
      "rainfall", "coverage",       "se",   "rms_change", "mean_change"};
  constexpr std::array<std::string_view, 3> whole = {"gauges", "pattern", "missing"};
  const auto is_in = [&](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is_in(real)) return "double precision";
  return is_in(whole) ? "bigint" : "text";
}

/// The fields of the first line of the rows, which are names of this program's own.
std::vector<std::string> header_of(const Descriptor& spool) {
  std::string beginning(1024, '\0');
  beginning.resize(read_spool(spool, 0, beginning));
  std::string_view rest = beginning;
  const auto names = parted(take_line(rest), ',');
  return {names.begin(), names.end()};
}

}  // namespace

std::string sql_columns(const std::vector<std::string>& names, int srid) {
  std::string columns;
  for (const std::string& name : names) {
    columns += (columns.empty() ? "" : ", ") + Postgres::quoted_name(name) + " ";
    columns += name == DatabaseTable::geometry_column
                   ? "geometry(MultiPolygon, " + std::to_string(srid) + ")"
                   : std::string(sql_type_of(name));
  }
  return columns;
}

DatabaseTable::DatabaseTable(DatabaseTarget target)
    : target_(std::move(target)),
      name_(without_password(target_.connection) + ": table '" + target_.table + "'"),
      spool_(open_spool()),
      rows_(name_, spool_.twin(spool_name), OutputFile::Care::closed) {
  Postgres database(target_.connection);
  look_for(database, target_, name_);
}

void DatabaseTable::commit(const std::string& comment, std::vector<std::string> names, int srid) {
  rows_.finish();
  if (names.empty()) names = header_of(spool_);
  const std::string table = in_sql(target_.table);
  Postgres database(target_.connection);
  database.run("BEGIN");
  if (look_for(database, target_, name_) == Found::ours) database.run("DROP TABLE " + table);
  database.run("CREATE TABLE " + table + " (" + sql_columns(names, srid) + ")");
  database.run("COPY " + table + " FROM STDIN (FORMAT csv, HEADER)");
  copy_spool(spool_, [&](std::string_view rows) { database.copy(rows); });
  database.end_copy();
  if (std::find(names.begin(), names.end(), geometry_column) != names.end()) {
    database.run("CREATE INDEX ON " + table + " USING gist (" +
                 Postgres::quoted_name(geometry_column) + ")");
  }
  database.run("COMMENT ON TABLE " + table + " IS " + Postgres::quoted_text(comment));
  throw_if_interrupted();
  database.run("COMMIT");
}

}  // namespace thiessen
