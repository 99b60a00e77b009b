#include "gdal/output/side_files.h"

#include <array>
#include <string_view>

#include "gdal/output/layer_formats.h"

namespace thiessen {
namespace {

struct SideFiles {
  std::string_view extension;
  std::string_view instead;  ///< extensions in place of the file's own, parted by blanks
  std::string_view behind;   ///< extensions behind it
};

constexpr std::array formats = {
    SideFiles{"shp", "shx dbf prj cpg qpj qix sbn sbx fbn fbx ain aih idm ind", "xml"},
    SideFiles{"tab", "dat map id ind", ""},
    SideFiles{"mif", "mid", ""},
    SideFiles{"tif", "tfw qml", "aux.xml ovr msk"},
    SideFiles{"tiff", "tfw qml", "aux.xml ovr msk"},
    SideFiles{"nc", "", "aux.xml"},
    SideFiles{"png", "pgw", "aux.xml"},
    SideFiles{"jpg", "jgw", "aux.xml"},
    SideFiles{"jpeg", "jgw", "aux.xml"},
    SideFiles{"gml", "xsd gfs", ""},
    SideFiles{"csv", "csvt prj", ""},
    SideFiles{"gpkg", "", "aux.xml"},
    SideFiles{"sqlite", "", "aux.xml"}};

void append(std::vector<std::string>& files, const std::string& before, std::string_view names) {
  while (!names.empty()) {
    const std::size_t blank = names.find(' ');
    files.push_back(before + std::string(names.substr(0, blank)));
    names.remove_prefix(blank == std::string_view::npos ? names.size() : blank + 1);
  }
}

}  // namespace

std::vector<std::string> side_files_of(const std::string& path) {
  const std::string extension = extension_of(path);
  std::vector<std::string> files;
  for (const SideFiles& format : formats) {
    if (format.extension != extension) continue;
    append(files, path.substr(0, path.size() - extension.size()), format.instead);
    append(files, path + ".", format.behind);
  }
  return files;
}

}  // namespace thiessen
