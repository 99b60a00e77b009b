#pragma once

#include <cpl_conv.h>
#include <cpl_string.h>

#include <string>
#include <utility>
#include <vector>

namespace thiessen {

/// Writes a .ods of these sheets, each a name and the XML of its rows.
inline void write_ods(const std::string& path,
                      const std::vector<std::pair<std::string, std::string>>& sheets) {
  void* const zip = CPLCreateZip(path.c_str(), nullptr);
  const auto add = [&](const std::string& name, const std::string& text) {
    CPLCreateFileInZip(zip, name.c_str(), nullptr);
    CPLWriteFileInZip(zip, text.data(), static_cast<int>(text.size()));
    CPLCloseFileInZip(zip);
  };
  std::string tables;
  for (const auto& [name, rows] : sheets)
    tables += "<table:table table:name=\"" + name + "\">" + rows + "</table:table>";
  add("mimetype", "application/vnd.oasis.opendocument.spreadsheet");
  add("content.xml",
      "<office:document-content xmlns:office=\"o\" xmlns:table=\"t\" xmlns:text=\"x\"><office:body>"
      "<office:spreadsheet>" +
          tables + "</office:spreadsheet></office:body></office:document-content>");
  CPLCloseZip(zip);
}

}  // namespace thiessen
