#include "files/file_digest.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>

#include "base/error.h"
#include "base/file.h"
#include "base/hexadecimal.h"
#include "base/interrupt.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

namespace fs = std::filesystem;

std::string sha256_of(const fs::path& path) {
  InputFile file(path.string());
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> digest(EVP_MD_CTX_new(),
                                                                  EVP_MD_CTX_free);
  const auto check = [](bool done) {
    if (!done) throw std::bad_alloc();
  };
  check(digest != nullptr && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1);
  std::vector<char> bytes(std::size_t{1} << 16);
  while (const std::size_t count = file.read(bytes)) {
    throw_if_interrupted();
    check(EVP_DigestUpdate(digest.get(), bytes.data(), count) == 1);
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> result{};
  unsigned length = 0;
  check(EVP_DigestFinal_ex(digest.get(), result.data(), &length) == 1);
  std::string text;
  for (unsigned i = 0; i < length; ++i) append_hexadecimal(text, result.at(i));
  return text;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const bool is_hidden = entry.path().filename().string().starts_with('.');
    if (!is_hidden && entry.is_regular_file(error)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A shapefile's table, index and CRS lie beside its shapes.
std::vector<fs::path> with_parts(const fs::path& file) {
  std::vector<fs::path> files{file};
  if (lower_case(file.extension().string()) != ".shp") return files;
  std::error_code error;
  for (const char* part : {".shx", ".dbf", ".prj", ".cpg"}) {
    const fs::path beside = fs::path(file).replace_extension(part);
    if (fs::is_regular_file(beside, error)) files.push_back(beside);
  }
  return files;
}

}  // namespace

std::vector<FileDigest> digests_of(const std::string& input) {
  std::error_code error;
  const fs::path path(input);
  const fs::file_status status = fs::status(path, error);
  std::vector<fs::path> files;
  if (fs::is_directory(status)) {
    files = files_in(path);
  } else if (fs::is_regular_file(status)) {
    files = with_parts(path);
  } else {
    return {{"", "none: it is no plain file"}};
  }
  std::vector<FileDigest> digests;
  digests.reserve(files.size());
  for (const fs::path& file : files) digests.push_back({file.filename().string(), sha256_of(file)});
  return digests;
}

}  // namespace thiessen
