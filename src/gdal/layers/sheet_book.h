#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gdal/layers/sheet_rows.h"

namespace thiessen {

/// The kinds of spreadsheets whose cells are read here, and not by GDAL.
enum class SheetKind : std::uint8_t { xlsx, ods };

/// A spreadsheet: which sheets it has, and their rows.
class SheetBook {
 public:
  struct Sheet {
    std::string name;
    bool is_hidden = false;
  };

  virtual ~SheetBook() = default;
  virtual const std::vector<Sheet>& sheets() const = 0;
  /// The rows of a sheet, from the first on. This object must outlive them. Throws Error.
  virtual std::unique_ptr<SheetRows> rows(std::size_t sheet) const = 0;
  /// Whether serial numbers of times count days from 1904 on.
  virtual bool counts_from_1904() const { return false; }
};

/// Opens a spreadsheet. `name` is the file as GDAL is given it, `file` as messages name it. Throws
/// Error where it is no whole one of the kind.
std::shared_ptr<const SheetBook> open_sheet_book(SheetKind kind, const std::string& file,
                                                 const std::string& name);

}  // namespace thiessen
