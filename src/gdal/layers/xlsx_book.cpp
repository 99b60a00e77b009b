#include "gdal/layers/xlsx_book.h"

#include <map>

#include "base/error.h"
#include "base/number.h"
#include "gdal/layers/vsi_bytes.h"
#include "gdal/layers/xml_reader.h"

namespace thiessen {
namespace {

/// Which document each relation of the workbook means.
class Relations : public XmlListener {
 public:
  std::map<std::string, std::string, std::less<>> targets;

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element == "Relationship") targets.emplace(attributes["Id"], attributes["Target"]);
  }
  void end(std::string_view /*element*/) override {}
  void text(std::string_view /*part*/) override {}
};

class Workbook : public XmlListener {
 public:
  Workbook(XlsxBook& book, const std::string& archive, const Relations& relations)
      : book_(book), archive_(archive), relations_(relations) {}

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element == "workbookPr") {
      const std::string_view from = attributes["date1904"];
      book_.from_1904 = from == "1" || from == "true";
    }
    if (element != "sheet") return;
    const auto target = relations_.targets.find(attributes["id"]);
    if (target == relations_.targets.end()) return;
    const std::string& path = target->second;
    book_.sheets.push_back({std::string(attributes["name"]),
                            archive_ + (path.starts_with('/') ? path : "/xl/" + path),
                            !attributes["state"].empty() && attributes["state"] != "visible"});
  }
  void end(std::string_view /*element*/) override {}
  void text(std::string_view /*part*/) override {}

 private:
  XlsxBook& book_;
  const std::string& archive_;
  const Relations& relations_;
};

/// The texts; how they are said, which stands beside words of Japanese, does not count.
class Texts : public XmlListener {
 public:
  explicit Texts(XlsxBook& book) : book_(book) {}

  void begin(std::string_view element, const XmlAttributes& /*attributes*/) override {
    if (element == "si") book_.texts.emplace_back();
    if (element == "rPh") in_sound_ = true;
    in_text_ = element == "t" && !in_sound_;
  }
  void end(std::string_view element) override {
    in_text_ = false;
    if (element == "rPh") in_sound_ = false;
  }
  void text(std::string_view part) override {
    if (in_text_ && !book_.texts.empty()) book_.texts.back() += part;
  }

 private:
  XlsxBook& book_;
  bool in_text_ = false;
  bool in_sound_ = false;
};

class Styles : public XmlListener {
 public:
  explicit Styles(XlsxBook& book) : book_(book) {}

  void begin(std::string_view element, const XmlAttributes& attributes) override {
    if (element == "cellXfs") in_forms_ = true;
    if (element == "numFmt")
      codes_.emplace(attributes["numFmtId"], form_of_code(attributes["formatCode"]));
    if (element != "xf" || !in_forms_) return;
    const auto code = codes_.find(attributes["numFmtId"]);
    const auto number = parse_size(attributes["numFmtId"]);
    book_.forms.push_back(code != codes_.end() ? code->second
                          : number ? built_in_form(static_cast<int>(number.value % 1000))
                                   : CellForm{});
  }
  void end(std::string_view element) override {
    if (element == "cellXfs") in_forms_ = false;
  }
  void text(std::string_view /*part*/) override {}

 private:
  XlsxBook& book_;
  std::map<std::string, CellForm, std::less<>> codes_;
  bool in_forms_ = false;
};

}  // namespace

XlsxBook read_xlsx_book(const std::string& file, const std::string& name) {
  const std::string archive = "/vsizip/{" + name + "}";
  XlsxBook book;
  const auto read = [&](const std::string& document, XmlListener& listener) {
    XmlReader(file, archive + "/xl/" + document, listener).read_all();
  };
  if (!vsi_exists(archive + "/xl/workbook.xml"))
    throw Error(Message{file, 0, "cannot be read as XLSX: it has no workbook", {}});
  Relations relations;
  read("_rels/workbook.xml.rels", relations);
  Workbook workbook(book, archive, relations);
  read("workbook.xml", workbook);
  if (vsi_exists(archive + "/xl/sharedStrings.xml")) {
    Texts texts(book);
    read("sharedStrings.xml", texts);
  }
  if (vsi_exists(archive + "/xl/styles.xml")) {
    Styles styles(book);
    read("styles.xml", styles);
  }
  return book;
}

}  // namespace thiessen
