#include "text/file_kind.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

using namespace std::string_view_literals;

std::string kind(std::string_view bytes) {
  const auto found = unread_kind(bytes);
  return found ? std::string(found->name) : "";
}

TEST(FileKind, what_is_not_read_is_named) {
  EXPECT_EQ(kind("\x89PNG\r\n\x1a\n...."sv), "a picture (PNG)");
  EXPECT_EQ(kind("%PDF-1.7\n"sv), "a PDF document");
  EXPECT_EQ(kind("CDF\x01...."sv), "a NetCDF");
  EXPECT_EQ(kind("\x89HDF\r\n\x1a\n"sv), "a NetCDF-4 or HDF5");
  EXPECT_EQ(kind("II*\0...."sv), "a TIFF");
  EXPECT_EQ(kind("!table\n!version 300"sv), "a MapInfo .tab");
  EXPECT_EQ(kind("Version 300\nCharset \"Neutral\"\n"sv), "a MapInfo .mif");
  EXPECT_EQ(kind("\n<!doctype html><p>"sv), "a web page (HTML)");
  EXPECT_EQ(kind("<?xml version='1.0'?><a xmlns:gml='http://www.opengis.net/gml'>"sv), "a GML");
  EXPECT_EQ(kind("<?xml version='1.0'?><a/>"sv), "an XML, and no KML");
  EXPECT_EQ(kind(std::string(257, '\0') + "ustar"), "a tar archive");
}

TEST(FileKind, what_may_be_read_is_not) {
  for (const std::string_view bytes :
       {""sv, "id,x,y\n"sv, "GRIB,x,y\n1,2,3\n"sv, "{\"type\":\"Point\"}"sv, "PK\3\4"sv,
        "\x1f\x8b"sv, "SQLite format 3\0"sv, "fgb\3fgb"sv, "\0\0\x27\x0a"sv, "version,x,y\n"sv,
        "<a>,x\n"sv, "<?xml version='1.0'?><kml xmlns='http://www.opengis.net/kml/2.2'>"sv,
        "\xff\xfe"
        "i\0"sv}) {
    EXPECT_EQ(kind(bytes), "") << bytes;
  }
}

TEST(FileKind, documents_are_told_from_archives_of_data) {
  const auto of = [](std::string_view only) {
    return unread_archive([&](std::string_view name) { return name == only; });
  };
  EXPECT_EQ(of("word/document.xml")->name, "a text document (.docx)");
  EXPECT_EQ(of("ppt/presentation.xml")->name, "a presentation (.pptx)");
  EXPECT_FALSE(of("stations.csv"));
}

}  // namespace
}  // namespace thiessen
