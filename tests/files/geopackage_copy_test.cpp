#include "files/geopackage_copy.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

class GeoPackage : public testing::Test {
 protected:
  void sql(const std::string& statements) const {
    ASSERT_EQ(std::system(("sqlite3 '" + file_ + "' \"" + statements + "\"").c_str()), 0);
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.path("a.gpkg");
};

TEST_F(GeoPackage, is_copied_whole) {
  sql("CREATE TABLE a (b); INSERT INTO a VALUES (1), (2)");
  const GeoPackageCopy copy(file_);
  folder_.write("b.gpkg", copy.bytes());
  file_ = folder_.path("b.gpkg");
  sql("INSERT INTO a VALUES (3)");
  EXPECT_TRUE(copy.bytes().starts_with("SQLite format 3"));
}

TEST_F(GeoPackage, nobody_else_changes_it_meanwhile) {
  sql("CREATE TABLE a (b)");
  {
    const GeoPackageCopy copy(file_);
    EXPECT_NE(
        std::system(("sqlite3 '" + file_ + "' 'INSERT INTO a VALUES (1)' 2>/dev/null").c_str()), 0);
  }
  sql("INSERT INTO a VALUES (1)");
  EXPECT_EQ(folder_.names(), std::set<std::string>{"a.gpkg"});
}

// As one run of the program that replaces the file is waited for by the next.
TEST_F(GeoPackage, that_is_replaced_meanwhile_is_the_new_one) {
  sql("CREATE TABLE old (b)");
  auto first = std::make_unique<GeoPackageCopy>(file_);
  const std::string earlier = std::exchange(file_, folder_.path("new.gpkg"));
  sql("CREATE TABLE fresh (b)");
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::filesystem::rename(file_, earlier);
    first.reset();
  });
  const GeoPackageCopy second(earlier);
  other.join();
  EXPECT_TRUE(contains(second.bytes(), "CREATE TABLE fresh"));
  EXPECT_FALSE(contains(second.bytes(), "CREATE TABLE old"));
}

TEST_F(GeoPackage, with_changes_in_a_log_beside_it_is_in_use) {
  sql("CREATE TABLE a (b)");
  for (const char* suffix : {"-wal", "-journal"}) {
    folder_.write(std::string("a.gpkg") + suffix, "changes");
    EXPECT_TRUE(contains(complaint_of([&] { copy_of_geopackage(file_); }),
                         std::string(suffix) + " holds changes"));
    std::filesystem::remove(file_ + suffix);
  }
}

TEST_F(GeoPackage, that_is_none_is_not_copied) {
  EXPECT_EQ(copy_of_geopackage(file_), nullptr);
  folder_.write("a.gpkg", "old");
  EXPECT_EQ(copy_of_geopackage(file_), nullptr);
}

TEST_F(GeoPackage, that_is_damaged_is_an_error) {
  sql("CREATE TABLE a (b); INSERT INTO a VALUES (randomblob(100000))");
  folder_.write("a.gpkg", folder_.read("a.gpkg").substr(0, 9000));
  EXPECT_TRUE(contains(complaint_of([&] { copy_of_geopackage(file_); }), "cannot be kept"));
}

}  // namespace
}  // namespace thiessen
