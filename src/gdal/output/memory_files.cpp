#include "gdal/output/memory_files.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <atomic>
#include <cstring>

#include "base/error.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

// GDAL is given this name rather than the user's, which may hold any characters.
constexpr const char* stem = "cells";

std::size_t name_begins(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? 0 : slash + 1;
}

/// The extension with its dot; `.shp.zip` counts as one.
std::string extension_of(const std::string& path) {
  const std::string name = path.substr(name_begins(path));
  if (name.ends_with(".shp.zip")) return ".shp.zip";
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? "" : name.substr(dot);
}

std::string bytes_of(const std::string& file) {
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(file.c_str(), &size, FALSE);
  if (bytes == nullptr) return {};
  std::string copy(static_cast<std::size_t>(size), '\0');
  std::memcpy(copy.data(), bytes, copy.size());
  return copy;
}

}  // namespace

MemoryFolder::MemoryFolder(const std::string& path) : path_(path) {
  start_gdal();
  static std::atomic<unsigned> count = 0;
  folder_ = "/vsimem/thiessen-" + std::to_string(count++);
  VSIMkdir(folder_.c_str(), 0755);
  file_ = folder_ + "/" + stem + extension_of(path);
}

MemoryFolder::~MemoryFolder() {
  const GdalErrors errors;
  VSIRmdirRecursive(folder_.c_str());
}

void MemoryFolder::put(const std::string& bytes) const {
  const GdalErrors errors;
  VSILFILE* file = VSIFOpenL(file_.c_str(), "wb");
  const std::size_t written = file == nullptr ? 0 : VSIFWriteL(bytes.data(), 1, bytes.size(), file);
  if (file != nullptr) VSIFCloseL(file);
  if (written != bytes.size()) throw Error(Message{path_, 0, "not enough memory", {}});
}

std::vector<EncodedFile> MemoryFolder::take() const {
  const CPLStringList entries(VSIReadDirRecursive(folder_.c_str()));
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(entries.Count()));
  for (int i = 0; i < entries.Count(); ++i) names.emplace_back(entries[i]);
  const std::string main = file_.substr(folder_.size() + 1);
  std::sort(names.begin(), names.end());
  const auto first = std::find(names.begin(), names.end(), main);
  if (first == names.end()) throw Error(Message{path_, 0, "GDAL wrote nothing", {}});
  std::rotate(names.begin(), first, first + 1);
  const std::string user_stem = path_.substr(0, path_.size() - extension_of(path_).size());
  std::vector<EncodedFile> files;
  for (const std::string& name : names) {
    if (name.find('/') != std::string::npos || !name.starts_with(stem)) {
      throw Error(Message{path_, 0, "this format is a folder, which is not written", {}});
    }
    files.push_back({user_stem + name.substr(std::strlen(stem)), bytes_of(folder_ + "/" + name)});
  }
  return files;
}

}  // namespace thiessen
