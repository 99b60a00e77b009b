#include "gdal/layers/xml_reader.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

/// Writes down what it hears: `<name id="7">text</name>`, of the attributes `id` alone.
class Heard : public XmlListener {
 public:
  void begin(std::string_view element, const XmlAttributes& attributes) override {
    told += "<" + std::string(element);
    if (!attributes["id"].empty()) told += " id=\"" + std::string(attributes["id"]) + "\"";
    told += ">";
  }
  void end(std::string_view element) override { told += "</" + std::string(element) + ">"; }
  void text(std::string_view part) override { told += part; }

  std::string told;
};

std::string heard_of(const std::string& document) {
  const TemporaryFolder folder;
  Heard heard;
  XmlReader reader("a.xlsx", folder.write("a.xml", document), heard);
  reader.read_all();
  EXPECT_FALSE(reader.read_on()) << "the end stays the end";
  return heard.told;
}

std::string fault_of(const std::string& document) {
  return complaint_of([&] { heard_of(document); });
}

TEST(XmlReader, tells_names_without_their_prefixes) {
  EXPECT_EQ(heard_of("<x:row xmlns:x='u' x:id='7'><c/></x:row>"), "<row id=\"7\"><c></c></row>");
  EXPECT_EQ(heard_of("<row r='1' ids='2' hid='3'/>"), "<row></row>") << "no part of a name";
  EXPECT_EQ(heard_of("<row a='1' id='2' b:id='3'/>"), "<row id=\"2\"></row>") << "the first";
}

TEST(XmlReader, tells_text_in_utf_8_with_its_entities_resolved) {
  EXPECT_EQ(heard_of("<t>a &amp; b &lt;&#233;&#x1F327;<![CDATA[<&]]></t>"),
            "<t>a & b <é\U0001F327<&</t>");
  EXPECT_EQ(heard_of("<?xml version='1.0' encoding='ISO-8859-1'?><t>\xE9</t>"), "<t>é</t>");
  const std::string utf_16("\xFF\xFE<\0t\0>\0\xE9\0<\0/\0t\0>\0", 18);
  EXPECT_EQ(heard_of(utf_16), "<t>é</t>");
}

// It is read in pieces of 64 kB; a letter of three bytes lies across two of them.
TEST(XmlReader, law_1_hears_the_same_wherever_its_pieces_end) {
  for (std::size_t before = 0; before < 4; ++before) {
    std::string text(before, 'x');
    for (int i = 0; i < 70'000; ++i) text += "雨";
    EXPECT_TRUE(heard_of("<t>" + text + "</t>") == "<t>" + text + "</t>") << before;
  }
}

TEST(XmlReader, reads_no_further_than_it_is_asked) {
  const TemporaryFolder folder;
  const std::string text(200'000, 'x');
  Heard heard;
  XmlReader reader("a.xlsx", folder.write("a.xml", "<t>" + text + "</t>"), heard);
  EXPECT_TRUE(reader.read_on());
  EXPECT_GT(heard.told.size(), 3U);
  EXPECT_LT(heard.told.size(), 70'000U);
  reader.read_all();
  EXPECT_TRUE(heard.told == "<t>" + text + "</t>");
}

TEST(XmlReader, law_2_no_beginning_of_a_document_is_whole) {
  const std::string whole = "<?xml version='1.0'?><a id='1'>t&amp;é<b><![CDATA[x]]></b></a>";
  EXPECT_EQ(heard_of(whole), "<a id=\"1\">t&é<b>x</b></a>");
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    const std::string fault = fault_of(whole.substr(0, cut));
    EXPECT_TRUE(fault.starts_with("a.xlsx: is not whole, or no spreadsheet: ")) << cut << fault;
  }
  EXPECT_NE(fault_of(whole + "<a/>"), "") << "nor is one that goes on";
}

// An entity that stands for ten of another, and so on, would fill the memory.
TEST(XmlReader, refuses_a_document_type_and_with_it_entities) {
  for (const std::string type :
       {"<!DOCTYPE a>", "<!DOCTYPE a SYSTEM 'file:///etc/passwd'>",
        "<!DOCTYPE a [<!ENTITY b 'c'><!ENTITY d '&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;'>]>"}) {
    EXPECT_EQ(fault_of(type + "<a>&d;</a>"),
              "a.xlsx: is not whole, or no spreadsheet: it has a document type");
  }
}

/// Throws at an element, at its end or at its text, and hears nothing after that.
class Thrower : public XmlListener {
 public:
  explicit Thrower(std::string at) : at_(std::move(at)) {}
  void begin(std::string_view, const XmlAttributes&) override { throw_at("begin"); }
  void end(std::string_view) override { throw_at("end"); }
  void text(std::string_view) override { throw_at("text"); }

 private:
  void throw_at(const std::string& place) {
    EXPECT_FALSE(has_thrown_) << place;
    has_thrown_ = place == at_;
    if (has_thrown_) throw std::out_of_range("thrown at " + place);
  }

  std::string at_;
  bool has_thrown_ = false;
};

TEST(XmlReader, law_3_throws_what_its_listener_throws_and_tells_it_no_more) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.xml", "<a>t<b/>u<b/></a>");
  for (const std::string place : {"begin", "text", "end"}) {
    Thrower thrower(place);
    XmlReader reader("a.xlsx", file, thrower);
    try {
      reader.read_all();
      FAIL() << place;
    } catch (const std::out_of_range& thrown) {
      EXPECT_EQ(thrown.what(), "thrown at " + place);
    }
  }
}

TEST(XmlReader, of_a_document_that_is_not_there_is_an_error_by_the_users_name) {
  const TemporaryFolder folder;
  Heard heard;
  EXPECT_EQ(complaint_of([&] { XmlReader("a.xlsx", folder.path("no.xml"), heard); }),
            "a.xlsx: cannot be opened");
}

}  // namespace
}  // namespace thiessen
