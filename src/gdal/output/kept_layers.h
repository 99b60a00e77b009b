#pragma once

#include <span>
#include <string>

#include "base/error.h"

namespace thiessen {

/// What a GeoPackage keeps of an older one in which a study is to be written anew.
///
/// `ours` are the names of all layers that a study may have, `written` those that this one has. Of
/// the older file the layers in `written` go, whosever they are, and those in `ours` that an older
/// study made: its isohyets would else stand beside cells of another time. The latter are named in
/// a notice. Returns the bytes of the rest, or none where nothing is left, so that the new file has
/// the bytes of one that replaces none. `path` is for messages. Throws Error where GDAL fails.
std::string kept_layers(const std::string& older, std::span<const std::string> ours,
                        std::span<const std::string> written, const std::string& path,
                        Warnings& warnings);

}  // namespace thiessen
