// FlatGeobufs by hand, as version 3 of their specification has them.
#include "gdal/layers/flatgeobuf_length.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/layers/number_bytes.h"

namespace thiessen {
namespace {

constexpr std::size_t node_bytes = 40;

/// A header: a flatbuffer of a root table whose fields 8 and 9 are the number of features and the
/// size of the index's nodes. A size that is not given is not there.
std::string header_of(std::uint64_t features, std::optional<std::size_t> node_size) {
  const std::size_t fields = node_size ? 10 : 9;
  const std::size_t names = 4 + 2 * fields;  // the bytes of the list of where each field stands
  std::string list = little(names, 2) + little(14, 2);
  for (std::size_t field = 0; field < fields; ++field)
    list += little(field == 8 ? 4U : field == 9 ? 12U : 0U, 2);
  return little(4 + names, 4) + list + little(names, 4) + little(features, 8) +
         (node_size ? little(*node_size, 2) : "");
}

struct Parts {
  std::uint64_t declared = 0;
  std::optional<std::size_t> node_size = 0;  ///< 0: there is no index
  std::size_t nodes = 0;                     ///< of the index
  std::vector<std::size_t> features;         ///< their lengths
};

std::string file_of(const Parts& parts) {
  const std::string header = header_of(parts.declared, parts.node_size);
  std::string bytes = std::string(
                          "fgb\x03"
                          "fgb\0",
                          8) +
                      little(header.size(), 4) + header +
                      std::string(parts.nodes * node_bytes, 'n');
  for (const std::size_t length : parts.features)
    bytes += little(length, 4) + std::string(length, 'f');
  return bytes;
}

/// What is said of the bytes; nothing where they are whole.
std::string fault_of(const std::string& bytes) {
  const TemporaryFolder folder;
  try {
    require_whole_flatgeobuf("a.fgb", folder.write("b.fgb", bytes));
  } catch (const Error& error) {
    const std::string sentence = error.messages().at(0).sentence();
    EXPECT_TRUE(sentence.starts_with("a.fgb: ")) << sentence;
    return sentence.substr(7);
  }
  return {};
}

// Of an index every node but the root has a parent, which has up to so many children:
// 17 leaves in sixteens have 2 parents and a root; 5 in fours have 2 and a root.
TEST(FlatgeobufLength, law_1_a_whole_file_has_no_fault_whatever_its_index) {
  const auto features = [](std::size_t count) { return std::vector<std::size_t>(count, 9); };
  EXPECT_EQ(fault_of(file_of({3, 0, 0, features(3)})), "");
  EXPECT_EQ(fault_of(file_of({1, 16, 1 + 1, features(1)})), "");
  EXPECT_EQ(fault_of(file_of({16, 16, 16 + 1, features(16)})), "");
  EXPECT_EQ(fault_of(file_of({17, 16, 17 + 2 + 1, features(17)})), "");
  EXPECT_EQ(fault_of(file_of({300, 16, 300 + 19 + 2 + 1, features(300)})), "");
  EXPECT_EQ(fault_of(file_of({5, 4, 5 + 2 + 1, features(5)})), "");
  EXPECT_EQ(fault_of(file_of({3, std::nullopt, 3 + 1, features(3)})), "") << "16 by default";
  EXPECT_EQ(fault_of(file_of({3, 1, 3 + 2 + 1, features(3)})), "") << "at least two children";
  EXPECT_EQ(fault_of(file_of({2, 0, 0, {1, 70'000}})), "");
}

TEST(FlatgeobufLength, law_2_no_beginning_of_a_file_is_whole) {
  for (const Parts& parts :
       {Parts{3, 0, 0, {5, 7, 9}}, Parts{3, 16, 4, {5, 7, 9}}, Parts{1, std::nullopt, 2, {30}}}) {
    const std::string whole = file_of(parts);
    // What is shorter than the beginning is no such file, as GDAL says.
    for (std::size_t cut = 12; cut < whole.size(); ++cut)
      EXPECT_NE(fault_of(whole.substr(0, cut)), "") << cut;
    EXPECT_EQ(fault_of(whole.substr(0, 11)), "");
  }
}

TEST(FlatgeobufLength, names_both_numbers) {
  const std::string whole = file_of({3, 0, 0, {5, 7, 9}});
  EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 1)),
            "is not whole: its header declares 3 features, and it holds 2");
  EXPECT_EQ(fault_of(file_of({1, 0, 0, {}})),
            "is not whole: its header declares 1 feature, and it holds 0");
  EXPECT_EQ(fault_of(file_of({2, 0, 0, {5, 7, 9}})),
            "is not whole: its header declares 2 features, and it holds more");
  EXPECT_EQ(fault_of(whole + "x"),
            "goes on after the last of the 3 features that its header declares");
}

// Whoever writes to a pipe does not know it ahead.
TEST(FlatgeobufLength, that_is_not_declared_is_the_end_of_a_feature) {
  EXPECT_EQ(fault_of(file_of({0, 0, 0, {}})), "");
  const std::string whole = file_of({0, 0, 0, {5, 7, 9}});
  EXPECT_EQ(fault_of(whole), "");
  EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 1)),
            "is cut off: after 2 whole features comes a part of one");
  EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 14)),
            "is cut off: after 1 whole feature comes a part of one");
}

TEST(FlatgeobufLength, a_feature_has_a_byte_at_least) {
  EXPECT_EQ(fault_of(file_of({3, 0, 0, {5, 0, 9}})),
            "is not whole: its header declares 3 features, and it holds 1");
}

TEST(FlatgeobufLength, a_header_may_not_be_longer_than_the_file_or_hold_more_features_than_bytes) {
  std::string bytes = file_of({1, 0, 0, {5}});
  bytes.replace(8, 4, little(0x7FFFFFFF, 4));
  EXPECT_EQ(fault_of(bytes), "is cut off: it has " + std::to_string(bytes.size()) +
                                 " bytes, and its header alone has 2147483659");
  EXPECT_EQ(fault_of(file_of({0x8000'0000'0000'0000, 16, 0, {5}})),
            "is not whole: its header declares 9223372036854775808 features, and it holds 0");
}

// Whatever the header's places point to, the answer is a sentence or none.
TEST(FlatgeobufLength, law_3_no_byte_of_a_header_leads_out_of_it) {
  const std::string whole = file_of({1, 16, 2, {5}});
  const std::size_t end = 12 + header_of(1, 16).size();
  for (std::size_t at = 8; at < end; ++at) {
    for (const char byte : {'\x00', '\x01', '\x7F', '\x80', '\xFF'}) {
      std::string bytes = whole;
      bytes[at] = byte;
      const std::string fault = fault_of(bytes);
      EXPECT_TRUE(bytes != whole || fault.empty()) << at;
      EXPECT_TRUE(fault.empty() || contains(fault, "is cut off") || contains(fault, "header"))
          << fault;
    }
  }
}

TEST(FlatgeobufLength, other_files_are_not_looked_at) {
  EXPECT_EQ(fault_of(""), "");
  EXPECT_EQ(fault_of("fgb\x03"
                     "fgx\x01 and much more of it"),
            "");
}

// Points of GDAL's making, one in each of so many rows, with an index and without.
TEST(FlatgeobufLength, law_4_files_of_another_program_are_whole_and_no_byte_shorter) {
  for (const std::size_t count : {1U, 16U, 17U, 300U}) {
    const TemporaryFolder folder;
    std::string rows = "id,x,y\n";
    for (std::size_t i = 0; i < count; ++i) rows += "a," + std::to_string(i) + ",2\n";
    folder.write("in.csv", rows);
    for (const std::string index : {"YES", "NO"}) {
      const std::string command =
          "cd '" + folder.path() + "' && ogr2ogr -lco SPATIAL_INDEX=" + index +
          " -oo X_POSSIBLE_NAMES=x -oo Y_POSSIBLE_NAMES=y " + index + ".fgb in.csv >/dev/null 2>&1";
      ASSERT_EQ(std::system(command.c_str()), 0);
      const std::string whole = folder.read(index + ".fgb");
      EXPECT_EQ(fault_of(whole), "") << count << index;
      EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 1)),
                "is not whole: its header declares " + std::to_string(count) +
                    (count == 1 ? " feature" : " features") + ", and it holds " +
                    std::to_string(count - 1));
    }
  }
}

}  // namespace
}  // namespace thiessen
