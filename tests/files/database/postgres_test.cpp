#include "files/database/postgres.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstring>
#include <string>
#include <thread>

#include "base/complaints.h"
#include "base/interrupt.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

/// A server that takes anybody, does nothing, and says that it has done it. While it is at the
/// last command Ctrl-C comes, and it is long about that.
class Server {
 public:
  enum class Answers { all, nothing };

  explicit Server(const TemporaryFolder& folder, Answers answers = Answers::all) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = folder.path(".s.PGSQL.5432");
    if (path.size() >= sizeof address.sun_path) return;
    std::memcpy(address.sun_path, path.data(), path.size());
    listening_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    is_ready_ = ::bind(listening_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
                ::listen(listening_, 4) == 0;
    if (is_ready_ && answers == Answers::all) thread_ = std::thread([this] { serve(); });
  }
  ~Server() {
    if (thread_.joinable()) thread_.join();
    ::close(listening_);
  }
  bool is_ready() const { return is_ready_; }

 private:
  static constexpr std::string_view done{"C\0\0\0\x07OK\0", 8};
  static constexpr std::string_view ready{"Z\0\0\0\x05I", 6};
  static constexpr std::string_view welcome{"R\0\0\0\x08\0\0\0\0", 9};

  void serve() {
    const int client = ::accept(listening_, nullptr, nullptr);
    if (take(client).empty()) return;  // who it is
    send(client, std::string(welcome) + std::string(ready));
    for (;;) {
      const std::string asked = take(client);
      if (asked.empty() || asked.front() == 'X') break;
      if (asked.find("COMMIT") != std::string::npos) {
        ask_to_stop();
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
      }
      send(client, std::string(done) + std::string(ready));
    }
    ::shutdown(listening_, SHUT_RDWR);  // who asks to cancel a command waits for no answer
    ::close(client);
  }
  static std::string take(int client) {
    std::string bytes(4096, '\0');
    const auto size = ::recv(client, bytes.data(), bytes.size(), 0);
    bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return bytes;
  }
  static void send(int client, const std::string& bytes) {
    ::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  int listening_ = -1;
  bool is_ready_ = false;
  std::thread thread_;
};

TEST(Postgres, ends_a_transaction_though_Ctrl_C_comes_meanwhile) {
  const TemporaryFolder folder;
  const Server server(folder);
  ASSERT_TRUE(server.is_ready());
  {
    Postgres database("PG:host=" + folder.path() +
                      " dbname=d user=u sslmode=disable gssencmode=disable");
    database.run("BEGIN");
    EXPECT_NO_THROW(database.commit());
  }
  EXPECT_NE(interrupt_signal(), 0) << "whoever asks next hears of it";
  forget_interrupt();
}

TEST(Postgres, a_server_that_answers_nothing_is_waited_for_until_Ctrl_C_comes_or_the_time_is_up) {
  const TemporaryFolder folder;
  const Server server(folder, Server::Answers::nothing);
  ASSERT_TRUE(server.is_ready());
  const std::string path =
      "PG:host=" + folder.path() + " dbname=d user=u sslmode=disable gssencmode=disable";
  const auto begin = std::chrono::steady_clock::now();
  std::thread user([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ask_to_stop();
  });
  EXPECT_THROW(Postgres{path}, Interrupted);
  user.join();
  forget_interrupt();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_EQ(complaint_of([&] { Postgres{path + " connect_timeout=1"}; }),
            path + " connect_timeout=1: the database cannot be reached: no answer within 1 s");
}

TEST(Postgres, a_connection_begins_with_PG) {
  EXPECT_TRUE(is_database("PG:dbname=rain"));
  EXPECT_TRUE(is_database("pg:postgresql://localhost/rain"));
  EXPECT_FALSE(is_database("PG.csv"));
  EXPECT_FALSE(is_database("PG"));
  EXPECT_FALSE(is_database(""));
}

TEST(Postgres, words_of_GDAL_alone_are_not_for_libpq) {
  const LibpqConnection found = libpq_connection(
      "PG:host=a  dbname='my rain' active_schema=results schemas=a,b tables=x(geom) "
      "password='it\\'s'");
  EXPECT_EQ(found.words, "host=a dbname='my rain' password='it\\'s'");
  EXPECT_EQ(found.schema, "results");
}

TEST(Postgres, a_URI_goes_over_as_it_is) {
  EXPECT_EQ(libpq_connection("PG:postgresql://u:tables=@h/d").words, "postgresql://u:tables=@h/d");
}

}  // namespace
}  // namespace thiessen
