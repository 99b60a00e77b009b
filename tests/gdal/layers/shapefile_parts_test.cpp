// Shapefiles by hand, as the ESRI Shapefile Technical Description (1998) and dBase III have them.
#include "gdal/layers/shapefile_parts.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/layers/number_bytes.h"

namespace thiessen {
namespace {

constexpr std::size_t point_bytes = 20;                // its type, x and y
constexpr std::size_t record_bytes = 8 + point_bytes;  // and its number and length before them

/// The header of a .shp or .shx of points, whose whole length is so many bytes.
std::string header(std::size_t bytes) {
  std::string text = big(9994, 4) + std::string(20, '\0') + big(bytes / 2, 4);
  text += little(1000, 4) + little(1, 4);
  for (int bound = 0; bound < 8; ++bound) text += little(0.0);
  return text;
}

std::string shp_of(std::size_t points) {
  std::string text = header(100 + points * record_bytes);
  for (std::size_t i = 0; i < points; ++i) {
    text += big(i + 1, 4) + big(point_bytes / 2, 4);
    text += little(1, 4) + little(static_cast<double>(i)) + little(0.5);
  }
  return text;
}

/// A .shx whose entries begin at these bytes of the .shp; at 0 there is no shape.
std::string shx_of(const std::vector<std::size_t>& places) {
  std::string text = header(100 + places.size() * 8);
  for (const std::size_t place : places)
    text += big(place / 2, 4) + big(place == 0 ? 0 : point_bytes / 2, 4);
  return text;
}

std::string shx_of(std::size_t points) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < points; ++i) places.push_back(100 + i * record_bytes);
  return shx_of(places);
}

/// A .dbf of one field of one letter, which declares so many records and holds these.
std::string dbf_of(std::size_t declared, std::size_t held) {
  std::string text = "\x03\x7d\x01\x01" + little(declared, 4) + little(65, 2) + little(2, 2);
  text += std::string(20, '\0');
  text += std::string("ID\0\0\0\0\0\0\0\0\0C\0\0\0\0\x01", 17) + std::string(15, '\0') + '\r';
  for (std::size_t i = 0; i < held; ++i) text += " a";
  return text + '\x1A';
}

struct Parts {
  std::string shp, shx, dbf;  ///< those that are empty are not there
};

Parts whole(std::size_t points) {
  return {shp_of(points), shx_of(points), dbf_of(points, points)};
}

/// What is said of a shapefile; nothing where it is whole.
std::string fault_of(const Parts& parts, std::vector<std::string>* oddities = nullptr) {
  const TemporaryFolder folder;
  if (!parts.shp.empty()) folder.write("a.shp", parts.shp);
  if (!parts.shx.empty()) folder.write("a.shx", parts.shx);
  if (!parts.dbf.empty()) folder.write("a.dbf", parts.dbf);
  std::vector<std::string> found;
  try {
    require_whole_shapefile("rain.shp", folder.path(parts.shp.empty() ? "a.dbf" : "a.shp"), found);
  } catch (const Error& error) {
    const std::string sentence = error.messages().at(0).sentence();
    EXPECT_TRUE(sentence.starts_with("rain.shp: ")) << sentence;
    EXPECT_EQ(error.messages()[0].hint.plain(),
              "its files are cut off or do not belong together: get all of them anew");
    return sentence.substr(10);
  }
  if (oddities != nullptr) *oddities = found;
  return {};
}

TEST(ShapefileParts, law_1_a_whole_shapefile_has_no_fault_whatever_it_holds) {
  for (const std::size_t points : {0U, 1U, 3U, 100U}) {
    std::vector<std::string> oddities;
    EXPECT_EQ(fault_of(whole(points), &oddities), "") << points;
    EXPECT_TRUE(oddities.empty());
  }
}

TEST(ShapefileParts, law_2_no_beginning_of_any_part_is_whole) {
  const Parts good = whole(3);
  for (std::size_t cut = 1; cut < good.shp.size(); ++cut)
    EXPECT_NE(fault_of({good.shp.substr(0, cut), good.shx, good.dbf}), "") << cut;
  for (std::size_t cut = 1; cut < good.shx.size(); ++cut)
    EXPECT_NE(fault_of({good.shp, good.shx.substr(0, cut), good.dbf}), "") << cut;
  // The sign at the end may be lacking.
  for (std::size_t cut = 1; cut + 1 < good.dbf.size(); ++cut)
    EXPECT_NE(fault_of({good.shp, good.shx, good.dbf.substr(0, cut)}), "") << cut;
  EXPECT_EQ(fault_of({good.shp, good.shx, good.dbf.substr(0, good.dbf.size() - 1)}), "");
}

TEST(ShapefileParts, name_both_lengths_of_a_part_that_is_cut_off) {
  const Parts good = whole(3);
  EXPECT_EQ(fault_of({good.shp.substr(0, 150), good.shx, good.dbf}),
            "a.shp has 150 bytes, and its header declares 184");
  EXPECT_EQ(fault_of({good.shp.substr(0, 99), good.shx, good.dbf}),
            "a.shp has 99 bytes, and its header alone has 100");
  EXPECT_EQ(fault_of({good.shp, good.shx, good.dbf.substr(0, 70)}),
            "a.dbf has 70 bytes, and its header declares 71");
  EXPECT_EQ(fault_of({good.shp, good.shx, good.dbf.substr(0, 31)}),
            "a.dbf has 31 bytes, and its header alone has 32");
}

TEST(ShapefileParts, hold_as_many_shapes_as_are_listed_and_as_there_are_records) {
  EXPECT_EQ(fault_of({shp_of(4), shx_of(3), dbf_of(3, 3)}),
            "a.shp holds 4 shapes, a.shx lists 3, and a.dbf holds 3 records");
  EXPECT_EQ(fault_of({shp_of(3), shx_of(3), dbf_of(4, 4)}),
            "a.shp holds 3 shapes, a.shx lists 3, and a.dbf holds 4 records");
  EXPECT_EQ(fault_of({shp_of(1), shx_of(1), dbf_of(0, 0)}),
            "a.shp holds 1 shape, a.shx lists 1, and a.dbf holds 0 records");
  EXPECT_EQ(fault_of({shp_of(1), shx_of(2), {}}), "a.shp holds 1 shape, a.shx lists 2")
      << "the second is listed behind the end";
}

TEST(ShapefileParts, list_no_shape_behind_the_end) {
  EXPECT_EQ(fault_of({shp_of(2), shx_of({100, 1000}), dbf_of(2, 2)}),
            "a.shx lists a shape at bytes 1000 to 1028, and a.shp has 156");
  // The largest that four bytes can say.
  EXPECT_EQ(fault_of({shp_of(2), shx_of({100, 8'589'934'590}), dbf_of(2, 2)}),
            "a.shx lists a shape at bytes 8589934590 to 8589934618, and a.shp has 156");
}

TEST(ShapefileParts, may_list_shapes_in_any_order_and_none_for_a_record) {
  EXPECT_EQ(fault_of({shp_of(2), shx_of({128, 100}), dbf_of(2, 2)}), "");
  EXPECT_EQ(fault_of({shp_of(2), shx_of({100, 0, 128}), dbf_of(3, 3)}), "");
}

TEST(ShapefileParts, of_a_dbf_are_the_records_that_it_declares_and_no_more) {
  EXPECT_EQ(fault_of({shp_of(3), shx_of(3), dbf_of(3, 4)}),
            "a.dbf holds 4 records, and its header declares 3");
}

TEST(ShapefileParts, deleted_records_are_there) {
  Parts parts = whole(2);
  parts.dbf.at(65) = '*';
  EXPECT_EQ(fault_of(parts), "");
}

TEST(ShapefileParts, a_dbf_of_records_without_bytes_is_taken_at_its_word) {
  Parts parts = whole(2);
  parts.dbf.replace(10, 2, 2, '\0');
  EXPECT_EQ(fault_of(parts), "");
}

// Blocks of 512 bytes are filled up with zeros, or with the sign that ends a .dbf.
TEST(ShapefileParts, may_be_filled_up_to_whole_blocks) {
  for (const std::size_t points : {1U, 3U}) {
    for (const std::size_t more : {1U, 300U, 512U}) {
      const Parts good = whole(points);
      const std::string zeros(more, '\0');
      EXPECT_EQ(fault_of({good.shp + zeros, good.shx, good.dbf}), "") << more;
      EXPECT_EQ(fault_of({good.shp, good.shx + zeros, good.dbf}), "") << more;
      EXPECT_EQ(fault_of({good.shp, good.shx, good.dbf + zeros}), "") << more;
      EXPECT_EQ(fault_of({good.shp, good.shx, good.dbf + std::string(more, '\x1A')}), "") << more;
    }
  }
}

TEST(ShapefileParts, go_on_with_nothing_else_behind_their_end) {
  const Parts good = whole(3);
  EXPECT_EQ(fault_of({good.shp + std::string(16, 'x'), good.shx, good.dbf}),
            "a.shp has 200 bytes, and its header declares 184");
  EXPECT_EQ(fault_of({good.shp, good.shx + std::string(16, 'x'), good.dbf}),
            "a.shx has 140 bytes, and its header declares 124");
}

TEST(ShapefileParts, of_zeros_alone_are_none) {
  const std::string zeros(512, '\0');
  EXPECT_NE(fault_of({shp_of(1), zeros, dbf_of(1, 1)}), "");
  EXPECT_NE(fault_of({zeros, shx_of(1), dbf_of(1, 1)}), "");
}

TEST(ShapefileParts, without_a_dbf_are_odd_and_a_dbf_may_stand_alone) {
  std::vector<std::string> oddities;
  EXPECT_EQ(fault_of({shp_of(2), shx_of(2), {}}, &oddities), "");
  EXPECT_EQ(oddities,
            std::vector<std::string>{"has no .dbf beside it: its shapes have no attributes"});
  EXPECT_EQ(fault_of({{}, {}, dbf_of(3, 3)}, &oddities), "");
  EXPECT_TRUE(oddities.empty());
  EXPECT_EQ(fault_of({{}, {}, dbf_of(4, 3)}), "a.dbf has 72 bytes, and its header declares 73");
}

TEST(ShapefileParts, may_have_their_names_in_capitals) {
  const TemporaryFolder folder;
  const Parts good = whole(2);
  const std::string shp = folder.write("A.SHP", good.shp);
  folder.write("A.SHX", good.shx);
  folder.write("A.DBF", dbf_of(1, 1));
  std::vector<std::string> oddities;
  EXPECT_TRUE(contains(complaint_of([&] { require_whole_shapefile("A.SHP", shp, oddities); }),
                       "A.SHP holds 2 shapes, A.SHX lists 2, and A.DBF holds 1 record"));
}

}  // namespace
}  // namespace thiessen
