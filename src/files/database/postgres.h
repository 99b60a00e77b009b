#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// Whether a name is a connection to a PostgreSQL database.
bool is_database(const std::string& path);

/// A connection without the words that only GDAL knows (active_schema, schemas, tables), as libpq
/// takes it, and the value of active_schema.
struct LibpqConnection {
  std::string words;
  std::string schema;
};
LibpqConnection libpq_connection(const std::string& path);

/// A connection to a PostgreSQL database, by libpq. A transaction that has begun and not ended is
/// undone by the server when the connection closes.
class Postgres {
 public:
  /// `path` is the connection as the user names it, with `PG:` in front. Throws Error where the
  /// database cannot be reached.
  explicit Postgres(const std::string& path);
  ~Postgres();
  Postgres(const Postgres&) = delete;
  Postgres& operator=(const Postgres&) = delete;

  /// Has the database carry out a command. Throws Error with its words where it does not, and
  /// Interrupted, whereupon what it has begun is given up with the connection. After a
  /// `COPY ... FROM STDIN` it waits for rows.
  void run(const std::string& sql);
  /// Ends the transaction, and waits until the server says that it has: Ctrl-C is not heard, for
  /// nobody would know then whether it has.
  void commit();
  /// The first value of the first row of an answer; nothing where there is none, or it is null.
  std::optional<std::string> value(const std::string& sql);
  /// Hands rows over that the database waits for, until end_copy.
  void copy(std::string_view rows);
  void end_copy();

  /// A name within quotes, so that every letter of it counts.
  static std::string quoted_name(std::string_view name);
  /// A text within quotes.
  static std::string quoted_text(std::string_view text);

 private:
  struct Answer;

  enum class Hears { interrupts, nothing };

  Answer ask(const std::string& sql, Hears hears = Hears::interrupts);
  int patience_seconds() const;
  void wait_for_connection();
  void wait_for_answer(Hears hears = Hears::interrupts);
  [[noreturn]] void fail(const char* reason, const char* state) const;

  struct Connection;
  std::unique_ptr<Connection> connection_;
  std::string path_;
};

}  // namespace thiessen
