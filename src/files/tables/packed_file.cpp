#include "files/tables/packed_file.h"

#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/tables/gzip_bytes.h"
#include "gdal/layers/opening.h"
#include "gdal/layers/vsi_bytes.h"
#include "text/byte_source.h"

namespace thiessen {
namespace {

InputFile packed(const std::string& file, std::shared_ptr<ByteSource> bytes) {
  return {file, [bytes = std::move(bytes)](std::span<char> into) {
            return bytes->read(into.data(), into.size());
          }};
}

InputFile open_as(const std::string& file, const Opening& opening) {
  switch (opening.packing) {
    case Opening::Packing::gzip:
      return packed(file, std::make_shared<GzipBytes>(file));
    case Opening::Packing::archived:
      return packed(file, std::make_shared<VsiBytes>(file, opening.name));
    case Opening::Packing::none:
      break;
  }
  return InputFile(file);
}

/// Whether a file is a plain one, or one in an archive.
bool can_be_opened_again(const std::string& file) {
  std::error_code none;
  return file.starts_with("/vsi") || std::filesystem::is_regular_file(file, none);
}

}  // namespace

InputFile open_text(const std::string& file) {
  return file == "-" ? InputFile(file) : open_as(file, find_opening(file));
}

std::string beginning_of_text(const std::string& file, std::size_t bytes) {
  if (!can_be_opened_again(file)) return {};
  std::string beginning(bytes, '\0');
  std::size_t count = 0;
  try {
    const Opening opening = find_opening(file);
    if (!opening.drivers.empty()) return {};
    InputFile input = open_as(file, opening);
    while (count < bytes) {
      const std::size_t more = input.read(std::span<char>(beginning).subspan(count));
      if (more == 0) break;
      count += more;
    }
  } catch (const Error&) {
    return {};
  }
  beginning.resize(count);
  return beginning;
}

}  // namespace thiessen
