#include "files/normals/normal_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = 1 << 20;

/// What is read of the only row of a file, and what is wrong with it.
struct Found {
  std::vector<double> normals = {};
  std::vector<std::string> faults = {};
};

Found found_in(const std::string& text, const std::string& name = "normal") {
  const TemporaryFolder folder;
  Source source;
  source.file = folder.write("s.csv", text);
  Warnings warnings;
  Features features(source, longest_field, warnings);
  const NormalColumns columns(features, name);
  EXPECT_EQ(columns.any(), !name.empty());
  Complaints complaints;
  EXPECT_TRUE(features.next(complaints));
  Found found{columns.read(features, "station 'a'", complaints)};
  try {
    complaints.throw_if_any();
  } catch (const Error& error) {
    for (const Message& message : error.messages()) found.faults.push_back(message.text.plain());
  }
  return found;
}

std::string fault_of(const std::string& text) {
  const std::string fault = complaint_of([&] { found_in(text); });
  return fault.substr(fault.rfind("s.csv"));
}

TEST(NormalColumns, are_one_or_twelve_whatever_their_case) {
  EXPECT_EQ(found_in("id,Normal\na, 40 \n").normals, std::vector<double>{40});
  EXPECT_EQ(
      found_in("NORMAL_12,normal_01,normal_02,normal_03,normal_04,normal_05,normal_06,normal_07,"
               "normal_08,normal_09,normal_10,normal_11\n12,1,2,3,4,5,6,7,8,9,10,11\n")
          .normals,
      (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_TRUE(found_in("id,normal\na,40\n", "").normals.empty());
}

// The year's is asked for by its own name, and counts where both are there.
TEST(NormalColumns, of_the_name_itself_come_first) {
  EXPECT_EQ(found_in("normal_01,normal\n7,40\n").normals, std::vector<double>{40});
}

TEST(NormalColumns, have_none_where_a_field_is_empty_and_a_fault_where_it_is_no_number) {
  const Found empty = found_in("id,normal\na,\n");
  EXPECT_TRUE(std::isnan(empty.normals.at(0)));
  EXPECT_TRUE(empty.faults.empty());
  const Found text = found_in("id,normal\na,much\n");
  EXPECT_TRUE(std::isnan(text.normals.at(0)));
  EXPECT_EQ(text.faults, std::vector<std::string>{
                             "station 'a' has a normal in 'normal' that is no number: 'much'"});
}

TEST(NormalColumns, have_the_decimal_mark_of_their_file) {
  EXPECT_EQ(found_in("id;normal\na;40,5\n").normals, std::vector<double>{40.5});
}

TEST(NormalColumns, that_are_not_there_are_an_error) {
  EXPECT_EQ(fault_of("id,rain\na,40\n"),
            "s.csv:1: 'normal_field': no field 'normal'; found 'id', 'rain'");
  EXPECT_EQ(fault_of("id,normal_01,normal_02\na,1,2\n"),
            "s.csv:1: has 2 of the twelve fields 'normal_01' to 'normal_12' | calendar months have "
            "normals all together, or one field has the year's");
}

}  // namespace
}  // namespace thiessen
