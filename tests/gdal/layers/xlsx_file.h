#pragma once

#include <cpl_conv.h>
#include <cpl_string.h>

#include <string>
#include <utility>
#include <vector>

namespace thiessen {

/// Writes a .xlsx of these sheets, each a name and the XML of its rows. Cells of the style 1 are
/// dates (DD/MM/YY), of style 2 times (yyyy-mm-dd h:mm); shared texts are `time` and `A`.
inline void write_xlsx(const std::string& path,
                       const std::vector<std::pair<std::string, std::string>>& sheets,
                       const std::string& workbook = "") {
  void* const zip = CPLCreateZip(path.c_str(), nullptr);
  const auto add = [&](const std::string& name, const std::string& text) {
    CPLCreateFileInZip(zip, name.c_str(), nullptr);
    CPLWriteFileInZip(zip, text.data(), static_cast<int>(text.size()));
    CPLCloseFileInZip(zip);
  };
  std::string names, relations;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    names += "<sheet name=\"" + sheets[i].first + "\" sheetId=\"" + number + "\" r:id=\"rId" +
             number + "\"/>";
    relations += "<Relationship Id=\"rId" + number +
                 "\" Type=\"x/worksheet\" Target=\"worksheets/" + number + ".xml\"/>";
    add("xl/worksheets/" + number + ".xml",
        "<worksheet><sheetData>" + sheets[i].second + "</sheetData></worksheet>");
  }
  add("xl/workbook.xml",
      "<workbook xmlns:r=\"r\">" + workbook + "<sheets>" + names + "</sheets></workbook>");
  add("xl/_rels/workbook.xml.rels", "<Relationships>" + relations + "</Relationships>");
  add("xl/sharedStrings.xml",
      "<sst><si><t>time</t></si><si><r><t>A</t></r><rPh><t>ei</t></rPh></si></sst>");
  add("xl/styles.xml",
      "<styleSheet><numFmts><numFmt numFmtId=\"165\" formatCode=\"DD/MM/YY\"/><numFmt "
      "numFmtId=\"166\" formatCode=\"yyyy-mm-dd h:mm\"/></numFmts><cellStyleXfs><xf "
      "numFmtId=\"22\"/></cellStyleXfs><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"165\"/><xf "
      "numFmtId=\"166\"/></cellXfs></styleSheet>");
  CPLCloseZip(zip);
}

}  // namespace thiessen
