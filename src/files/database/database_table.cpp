#include "files/database/database_table.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/interrupt.h"
#include "base/secrets.h"
#include "base/spool.h"
#include "base/utf8.h"
#include "files/database/postgres.h"
#include "readings/published/published_format.h"
#include "text/text_lines.h"

namespace thiessen {
namespace {

/// PostgreSQL cuts longer names, and then takes two for one.
constexpr std::size_t most_bytes_of_name = 63;

void require_short(const std::string& file, const std::string& what, const std::string& name,
                   const Wording& hint) {
  if (name.size() <= most_bytes_of_name) return;
  throw Error(Message{file, 0,
                      "the name of " + what + " has " + std::to_string(name.size()) +
                          " bytes, and PostgreSQL takes " + std::to_string(most_bytes_of_name) +
                          ": " + quoted(name, 80),
                      hint});
}

/// Throws Error where a part of `SCHEMA.NAME` would be cut.
void require_short_table(const std::string& file, const std::string& table) {
  const std::size_t dot = table.find('.');
  const Wording hint = setting("output_layer", "NAME") + " with a shorter one";
  if (dot != std::string::npos) require_short(file, "the schema", table.substr(0, dot), hint);
  require_short(file, "the table", table.substr(dot == std::string::npos ? 0 : dot + 1), hint);
}

/// The schema in which a table is made that is named without one.
std::string schema_of(Postgres& database, const DatabaseTarget& target, const std::string& name) {
  std::string schema = libpq_connection(target.connection).schema;
  if (!schema.empty()) return schema;
  const auto current = database.value("SELECT current_schema()");
  if (current) return *current;
  throw Error(Message{name, 0, "no schema of the database's search_path is there to make it in",
                      setting("output_layer", "SCHEMA.NAME") + " names one"});
}

/// A table's name in SQL, always with its schema: without one, PostgreSQL would look for a table
/// in all schemas of its search_path, and make it in the first.
std::string in_sql(Postgres& database, const DatabaseTarget& target, const std::string& name) {
  const std::size_t dot = target.table.find('.');
  const bool has_schema = dot != std::string::npos;
  return Postgres::quoted_name(has_schema ? target.table.substr(0, dot)
                                          : schema_of(database, target, name)) +
         "." + Postgres::quoted_name(has_schema ? target.table.substr(dot + 1) : target.table);
}

enum class Found { nothing, ours };

/// Whether there is a table of the name. Throws Error where it may not be replaced.
Found look_for(Postgres& database, const std::string& table, bool overwrite,
               const std::string& name) {
  const std::string text = Postgres::quoted_text(table);
  if (!database.value("SELECT to_regclass(" + text + ")::text")) return Found::nothing;
  const auto comment =
      database.value("SELECT obj_description(to_regclass(" + text + "), 'pg_class')");
  if (!comment || !is_mark(*comment)) {
    throw Error(Message{name, 0, "it exists, and this program did not make it: it is never dropped",
                        "another name: " + setting("output_layer", "NAME")});
  }
  if (!overwrite)
    throw Error(Message{name, 0, "already exists", setting("overwrite") + " replaces it"});
  return Found::ours;
}

/// The commands that give others the rights on a table that they have now; empty where there are
/// none.
std::string grants_on(Postgres& database, const std::string& table) {
  const std::string text = Postgres::quoted_text(table);
  return database
      .value("SELECT string_agg(format('GRANT %s ON TABLE %s TO %s%s', privilege_type, " + text +
             ", CASE grantee WHEN 0 THEN 'PUBLIC' ELSE quote_ident(pg_get_userbyid(grantee)) END, "
             "CASE WHEN is_grantable THEN ' WITH GRANT OPTION' ELSE '' END), '; ') "
             "FROM pg_class, aclexplode(relacl) WHERE oid = to_regclass(" +
             text + ") AND grantee <> relowner")
      .value_or("");
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

/// Takes digits off the beginning of the text, and the sign after them; false where it has none.
bool take_number(std::string_view& text, char sign) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || digits == text.size() || text[digits] != sign) return false;
  text.remove_prefix(digits + 1);
  return true;
}

}  // namespace

bool is_mark(std::string_view comment) {
  constexpr std::string_view name = "thiessen ";
  if (!comment.starts_with(name)) return false;
  comment.remove_prefix(name.size());
  for (const char sign : {'.', '.', ';'}) {
    if (!take_number(comment, sign)) return false;
  }
  return comment.starts_with(" metric: ");
}

std::string sql_columns(const std::vector<std::string>& names, int srid, std::size_t own) {
  std::string columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    columns += (columns.empty() ? "" : ", ") + Postgres::quoted_name(name) + " ";
    columns += name == DatabaseTable::geometry_column
                   ? "geometry(MultiPolygon, " + std::to_string(srid) + ")"
                   : std::string(i < own ? sql_type_of(name) : "text");
  }
  return columns;
}

DatabaseTable::DatabaseTable(DatabaseTarget target)
    : target_(std::move(target)),
      name_(without_password(target_.connection) + ": table '" + target_.table + "'"),
      spool_(open_spool()),
      rows_(name_, spool_.twin(spool_name), OutputFile::Care::closed) {
  require_short_table(name_, target_.table);
  Postgres database(target_.connection);
  look_for(database, in_sql(database, target_, name_), target_.overwrite, name_);
}

void DatabaseTable::commit(const std::string& comment, std::vector<std::string> names, int srid,
                           std::size_t own) {
  rows_.finish();
  if (names.empty()) names = header_of(spool_);
  for (const std::string& name : names) {
    require_short(name_, "a column", name,
                  "the field needs a shorter one, or " + setting("attributes") + " left out");
  }
  Postgres database(target_.connection);
  const std::string table = in_sql(database, target_, name_);
  std::string grants;
  database.run("BEGIN");
  if (look_for(database, table, target_.overwrite, name_) == Found::ours) {
    grants = grants_on(database, table);
    database.run("DROP TABLE " + table);
  }
  database.run("CREATE TABLE " + table + " (" + sql_columns(names, srid, own) + ")");
  database.run("COPY " + table + " FROM STDIN (FORMAT csv, HEADER)");
  copy_spool(spool_, [&](std::string_view rows) { database.copy(rows); });
  database.end_copy();
  if (std::find(names.begin(), names.end(), geometry_column) != names.end()) {
    database.run("CREATE INDEX ON " + table + " USING gist (" +
                 Postgres::quoted_name(geometry_column) + ")");
  }
  if (!grants.empty()) database.run(grants);
  database.run("COMMENT ON TABLE " + table + " IS " + Postgres::quoted_text(comment));
  throw_if_interrupted();
  database.commit();
}

}  // namespace thiessen
