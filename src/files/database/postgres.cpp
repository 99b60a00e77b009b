#include "files/database/postgres.h"

#include <libpq-fe.h>

#include <poll.h>

#include <array>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/secrets.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::string_view prefix = "PG:";

/// The words of the server or of libpq on one line, without their label, and without the line of
/// SQL that a server may show: it is this program's own.
std::string on_one_line(std::string_view reason) {
  reason = reason.substr(0, reason.find("\nLINE "));
  std::string text;
  for (const char c : reason) {
    if (c != '\n') text += c;
    if (c == '\n' && !text.empty() && text.back() != ' ') text += ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (text.starts_with("ERROR:")) text.erase(0, text.find_first_not_of(' ', 6));
  return text;
}

std::string in_quotes(std::string_view text, char quote) {
  std::string quoted(1, quote);
  for (const char c : text) {
    if (c == quote) quoted += quote;
    quoted += c;
  }
  return quoted + quote;
}

/// Where the word of a connection that begins at `at` ends: at the next blank outside quotes.
std::size_t end_of_word(std::string_view words, std::size_t at) {
  for (bool in_quotes = false; at < words.size(); ++at) {
    if (words[at] == '\\' && at + 1 < words.size()) {
      ++at;
    } else if (words[at] == '\'') {
      in_quotes = !in_quotes;
    } else if (!in_quotes && std::isspace(static_cast<unsigned char>(words[at])) != 0) {
      break;
    }
  }
  return at;
}

}  // namespace

bool is_database(const std::string& path) {
  return equal_ignoring_case(std::string_view(path).substr(0, prefix.size()), prefix);
}

LibpqConnection libpq_connection(const std::string& path) {
  LibpqConnection connection;
  const std::string words = path.substr(prefix.size());
  if (words.find("://") != std::string::npos) return {words, ""};
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = end_of_word(words, at);
    const std::string word = words.substr(at, end - at);
    const std::string name = lower_case(word.substr(0, word.find('=')));
    if (name == "active_schema" && word.size() > name.size()) {
      connection.schema = word.substr(name.size() + 1);
      std::erase(connection.schema, '\'');
    } else if (name != "schemas" && name != "tables" && !word.empty()) {
      connection.words += (connection.words.empty() ? "" : " ") + word;
    }
    at = end + 1;
  }
  return connection;
}

struct Postgres::Connection {
  PGconn* handle;
  explicit Connection(PGconn* made) : handle(made) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { PQfinish(handle); }
};

struct Postgres::Answer {
  std::unique_ptr<PGresult, void (*)(PGresult*)> result;
};

// A server may take minutes over an index, and Ctrl-C is heard all the while: the server is then
// asked to stop, and what it has begun is gone with the connection.
void Postgres::wait_for_answer(Hears hears) {
  constexpr int pause = 100;  // milliseconds
  while (PQisBusy(connection_->handle) != 0) {
    if (hears == Hears::interrupts && interrupt_signal() != 0) {
      const std::unique_ptr<PGcancel, void (*)(PGcancel*)> cancel(PQgetCancel(connection_->handle),
                                                                  PQfreeCancel);
      std::array<char, 256> reason;
      if (cancel) PQcancel(cancel.get(), reason.data(), static_cast<int>(reason.size()));
      throw_if_interrupted();
    }
    pollfd waiting{PQsocket(connection_->handle), POLLIN, 0};
    ::poll(&waiting, 1, pause);
    if (PQconsumeInput(connection_->handle) != 1) return;  // the answer then says why
  }
}

/// How long the user has a server waited for at most; 0 is as long as the network does.
int Postgres::patience_seconds() const {
  const std::unique_ptr<PQconninfoOption, void (*)(PQconninfoOption*)> options(
      PQconninfo(connection_->handle), PQconninfoFree);
  constexpr std::string_view wanted = "connect_timeout";
  for (const PQconninfoOption* option = options.get();
       option != nullptr && option->keyword != nullptr; ++option) {
    if (option->keyword == wanted && option->val != nullptr)
      return static_cast<int>(std::strtol(option->val, nullptr, 10));
  }
  return 0;
}

// Ctrl-C is heard while a server is waited for. The library itself minds its limit of time only
// where it is waited for without.
void Postgres::wait_for_connection() {
  constexpr int pause = 100;  // milliseconds
  const std::chrono::seconds patience(patience_seconds());
  const auto begin = std::chrono::steady_clock::now();
  for (PostgresPollingStatusType next = PGRES_POLLING_WRITING;;) {
    throw_if_interrupted();
    if (patience.count() > 0 && std::chrono::steady_clock::now() - begin > patience) {
      throw Error(Message{without_password(path_),
                          0,
                          "the database cannot be reached: no answer within " +
                              std::to_string(patience.count()) + " s",
                          {}});
    }
    const short event = next == PGRES_POLLING_READING ? POLLIN : POLLOUT;
    pollfd waiting{PQsocket(connection_->handle), event, 0};
    if (::poll(&waiting, 1, pause) <= 0) continue;
    next = PQconnectPoll(connection_->handle);
    if (next == PGRES_POLLING_OK || next == PGRES_POLLING_FAILED) return;
  }
}

Postgres::Postgres(const std::string& path) : path_(path) {
  const LibpqConnection wanted = libpq_connection(path);
  connection_ = std::make_unique<Connection>(PQconnectStart(wanted.words.c_str()));
  if (connection_->handle == nullptr) throw std::bad_alloc();
  if (PQstatus(connection_->handle) != CONNECTION_BAD) wait_for_connection();
  if (PQstatus(connection_->handle) != CONNECTION_OK) {
    throw Error(
        Message{without_password(path_),
                0,
                "the database cannot be reached: " +
                    without_secrets(on_one_line(PQerrorMessage(connection_->handle)), path_),
                {}});
  }
  // The server's notices are no messages of ours.
  PQsetNoticeProcessor(
      connection_->handle, [](void*, const char*) {}, nullptr);
  PQsetClientEncoding(connection_->handle, "UTF8");
  if (!wanted.schema.empty()) run("SET search_path TO " + quoted_name(wanted.schema) + ", public");
}

Postgres::~Postgres() = default;

void Postgres::fail(const char* reason, const char* state) const {
  const std::string code = state == nullptr ? "" : state;
  Wording hint;
  if (code == "42704") hint = "geometries need PostGIS: CREATE EXTENSION postgis";
  if (code == "3F000") hint = "CREATE SCHEMA makes a schema";
  if (code == "2BP01") hint = "what depends on the older table, such as a view, has to go first";
  throw Error(Message{without_password(path_), 0,
                      "the database refuses: " + without_secrets(on_one_line(reason), path_),
                      std::move(hint)});
}

Postgres::Answer Postgres::ask(const std::string& sql, Hears hears) {
  Answer answer{{nullptr, PQclear}};
  if (PQsendQuery(connection_->handle, sql.c_str()) != 1)
    fail(PQerrorMessage(connection_->handle), nullptr);
  do {  // the last answer tells: there is one a command, and COPY waits for its rows
    wait_for_answer(hears);
    PGresult* const next = PQgetResult(connection_->handle);
    if (next == nullptr) break;
    answer.result.reset(next);
  } while (PQresultStatus(answer.result.get()) != PGRES_COPY_IN);
  const ExecStatusType status = PQresultStatus(answer.result.get());
  const bool done =
      status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK || status == PGRES_COPY_IN;
  if (!done) {
    fail(answer.result ? PQresultErrorMessage(answer.result.get())
                       : PQerrorMessage(connection_->handle),
         PQresultErrorField(answer.result.get(), PG_DIAG_SQLSTATE));
  }
  return answer;
}

void Postgres::run(const std::string& sql) {
  ask(sql);
}

void Postgres::commit() {
  ask("COMMIT", Hears::nothing);
}

std::optional<std::string> Postgres::value(const std::string& sql) {
  const Answer answer = ask(sql);
  if (PQntuples(answer.result.get()) == 0 || PQgetisnull(answer.result.get(), 0, 0) != 0)
    return std::nullopt;
  return PQgetvalue(answer.result.get(), 0, 0);
}

void Postgres::copy(std::string_view rows) {
  constexpr std::size_t at_once = std::size_t{1} << 18U;
  while (!rows.empty()) {
    throw_if_interrupted();
    const std::string_view part = rows.substr(0, at_once);
    if (PQputCopyData(connection_->handle, part.data(), static_cast<int>(part.size())) != 1)
      fail(PQerrorMessage(connection_->handle), nullptr);
    rows.remove_prefix(part.size());
  }
}

void Postgres::end_copy() {
  if (PQputCopyEnd(connection_->handle, nullptr) != 1)
    fail(PQerrorMessage(connection_->handle), nullptr);
  for (;;) {
    wait_for_answer();
    const Answer answer{{PQgetResult(connection_->handle), PQclear}};
    if (answer.result == nullptr) return;
    if (PQresultStatus(answer.result.get()) != PGRES_COMMAND_OK) {
      fail(PQresultErrorMessage(answer.result.get()),
           PQresultErrorField(answer.result.get(), PG_DIAG_SQLSTATE));
    }
  }
}

std::string Postgres::quoted_name(std::string_view name) {
  return in_quotes(name, '"');
}

std::string Postgres::quoted_text(std::string_view text) {
  return in_quotes(text, '\'');
}

}  // namespace thiessen
