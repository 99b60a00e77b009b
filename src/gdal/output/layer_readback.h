#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

class GDALDriver;

namespace thiessen {

/// What a layer was asked to hold: rows of texts and numbers, under names.
struct LayerTexts {
  std::size_t rows = 0;
  std::vector<std::string> names;  ///< of all fields, in their order
  /// The text of a field in a row; empty for a field of numbers that are no whole ones.
  std::function<std::string(std::size_t row, std::size_t field)> text;
  /// The number of a field in a row; nothing for a field of texts, and where there is no number.
  std::function<std::optional<double>(std::size_t row, std::size_t field)> number;
};

/// Reads again what a driver wrote, and requires it to hold each row and text, blanks at their ends
/// apart. For formats cut texts at some length, or have letters that they cannot write, and not
/// every driver says so. Fields under another name are told in `warnings`, with both names, and so
/// are numbers that lose more than a billionth.
/// `written` is the layer as GDAL wrote it, `path` its name in messages. Throws Error. Cost: that
/// of reading.
void require_read_back(GDALDriver& driver, const std::string& written, const LayerTexts& wanted,
                       const std::string& path, Warnings& warnings);

}  // namespace thiessen
