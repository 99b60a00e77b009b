#pragma once

#include <string>
#include <vector>

#include "gdal/layers/cell_form.h"

namespace thiessen {

/// What the parts of a .xlsx file beside its sheets say: it is a zip of XML documents.
struct XlsxBook {
  struct Sheet {
    std::string name;
    std::string document;  ///< as GDAL is given it
    bool is_hidden = false;
  };
  std::vector<Sheet> sheets;
  std::vector<std::string> texts;  ///< that cells name by their number
  std::vector<CellForm> forms;     ///< that cells name by their number
  bool from_1904 = false;          ///< whether days are counted from 1904 on
};

/// Reads them. `name` is the file as GDAL is given it, `file` as messages name it. Throws Error
/// where it is no whole .xlsx.
XlsxBook read_xlsx_book(const std::string& file, const std::string& name);

}  // namespace thiessen
