#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/outputs.h"
#include "files/geopackage_copy.h"
#include "gdal/output/encoded_file.h"

namespace thiessen::cli {

/// Appends the files of an output: the first to `file`, which is open, the others beside it. Side
/// files of an older output that this one lacks are removed with it.
void append_files(Outputs& outputs, OutputFile& file, const std::vector<EncodedFile>& encoded);

/// Appends the files that lie beside the first one of an output, which stands on the disk already,
/// and removes those of an older output as append_files does.
void append_side_files(Outputs& outputs, const std::vector<EncodedFile>& encoded);

/// A copy of the GeoPackage that is at `path`, whose other layers are kept; null where none is
/// there, or where the output is of another format.
std::unique_ptr<GeoPackageCopy> older_layers(const std::string& path);

/// Has the side files of an older output at `path` removed with it; none is written anew.
void remove_side_files(Outputs& outputs, const std::string& path);

}  // namespace thiessen::cli
