#include "gdal/output/layer_readback.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/output/layer_formats.h"

namespace thiessen {
namespace {

/// A layer of cells as a test wants it, and a CSV that stands for what a format made of it.
struct Readback {
  std::vector<std::string> names = {"station", "n"};
  std::vector<std::vector<std::string>> texts = {{"a", "1"}, {"b", "2"}};
  std::vector<std::vector<std::optional<double>>> numbers = {};  ///< none: all are texts
  Warnings warnings = {};

  void of(const std::string& written, const std::string& name = "w.csv") {
    const TemporaryFolder folder;
    LayerTexts wanted;
    wanted.rows = texts.size();
    wanted.names = names;
    wanted.text = [&](std::size_t row, std::size_t field) { return texts.at(row).at(field); };
    wanted.number = [&](std::size_t row, std::size_t field) {
      return numbers.empty() ? std::nullopt : numbers.at(row).at(field);
    };
    require_read_back(require_vector_driver(name), folder.write(name, written), wanted, "c.x",
                      warnings);
  }
};

TEST(LayerReadback, is_silent_where_the_format_holds_everything) {
  Readback readback;
  readback.of("station,n\na,1\nb,2\n");
  EXPECT_TRUE(readback.warnings.messages().empty());
}

TEST(LayerReadback, lets_blanks_at_ends_and_the_form_of_dates_pass) {
  Readback readback;
  readback.texts = {{"a  ", "2001-01-31"}, {"b", ""}};
  readback.of("station,n\n a,2001/01/31\nb,anything\n");
  EXPECT_TRUE(readback.warnings.messages().empty());
  EXPECT_TRUE(contains(complaint_of([&] { readback.of("station,n\na,2001/02/31\nb,\n"); }),
                       "'2001-01-31' becomes '2001/02/31'"));
}

TEST(LayerReadback, refuses_a_text_that_is_cut_and_one_that_became_another) {
  Readback readback;
  readback.texts = {{"a", "long text"}, {"b", "2"}};
  EXPECT_EQ(complaint_of([&] { readback.of("station,n\na,long\nb,2\n"); }),
            "c.x: 'n' of row 1 is cut to 4 of its 9 bytes by the format: 'long text' | a .gpkg "
            "holds texts of any length and names of any kind");
  EXPECT_TRUE(complaint_of([&] { readback.of("station,n\na,long text\nb,?\n"); })
                  .starts_with("c.x: 'n' of row 2 cannot be written in the format: '2' becomes "
                               "'?' | "));
}

TEST(LayerReadback, refuses_a_format_that_holds_fewer_rows) {
  EXPECT_TRUE(contains(complaint_of([] { Readback().of("station,n\na,1\n"); }),
                       "c.x: the format holds 1 of 2 rows"));
}

TEST(LayerReadback, tells_a_field_to_which_the_format_gave_another_name) {
  Readback readback;
  readback.of("station,N_1\na,1\nb,2\n");
  EXPECT_EQ(sentences_of(readback.warnings),
            (std::vector<std::string>{"c.x: the field 'n' is called 'N_1': the format has no "
                                      "longer names, or not such"}));
  readback.names.push_back("m");
  EXPECT_TRUE(contains(complaint_of([&] { readback.of("station,n\na,1\nb,2\n"); }),
                       "c.x: the format has no field 'm'"));
}

TEST(LayerReadback, a_format_may_put_fields_of_its_own_before) {
  Readback readback;
  readback.of("WKT,station,m\nx,a,1\ny,b,2\n");
  EXPECT_EQ(sentences_of(readback.warnings).size(), 1U);
  EXPECT_TRUE(contains(sentences_of(readback.warnings).at(0), "'n' is called 'm'"));
}

// A shapefile's names end after ten letters: the first name, cut, is the second one.
TEST(LayerReadback, a_name_that_is_cut_may_become_that_of_another_field) {
  Readback readback;
  readback.names = {"station", "longfieldname", "longfieldn", "n"};
  readback.texts = {{"a", "one", "two", "3"}};
  readback.of("station,longfieldn,longfiel_1,n\na,one,two,3\n");
  EXPECT_EQ(sentences_of(readback.warnings).size(), 2U);
}

TEST(LayerReadback, finds_a_field_that_the_format_has_elsewhere) {
  Readback readback;
  readback.names = {"station", "Name", "n"};
  readback.texts = {{"a", "x", "1"}};
  readback.of("Name,begin,station,n\nx,,a,1\n");
  EXPECT_TRUE(readback.warnings.messages().empty());
}

TEST(LayerReadback, tells_numbers_that_lose_more_than_a_billionth) {
  Readback readback;
  readback.numbers = {{std::nullopt, 1e9}, {std::nullopt, -2.0}};
  readback.of("station,n\na,1000000000.9\nb,-2\n");
  EXPECT_TRUE(readback.warnings.messages().empty());
  readback.of("station,n\na,1000000001.1\nb,\n");
  EXPECT_EQ(sentences_of(readback.warnings),
            (std::vector<std::string>{"c.x: 'n' of row 1 is rounded by the format: 1000000000 "
                                      "becomes 1000000001.1, and 1 more"}));
}

TEST(LayerReadback, a_number_that_is_gone_is_told_even_where_it_was_0) {
  Readback readback;
  readback.texts = {{"a", ""}};
  readback.numbers = {{std::nullopt, 0.0}};
  readback.of(R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":null,
                  "properties":{"station":"a","n":null}}]})",
              "w.geojson");
  EXPECT_TRUE(contains(sentences_of(readback.warnings).at(0), "0 becomes no value"));
}

TEST(LayerReadback, needs_a_layer_where_there_are_rows) {
  Readback none;
  none.texts.clear();
  EXPECT_NO_THROW(none.of("nothing", "w.geojson"));
  EXPECT_TRUE(complaint_of([] {
                Readback().of("nothing", "w.geojson");
              }).starts_with("c.x: GDAL cannot read again what it wrote: "));
}

}  // namespace
}  // namespace thiessen
