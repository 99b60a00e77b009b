#pragma once

#include <cstdint>
#include <span>

namespace thiessen::fuzzers {

/// Each takes any bytes, and throws std::logic_error where something is not as it must be.

/// Bytes as operations: on a History, or on a Tessellation with nested Trials, in the plane or in
/// space; audited after every one.
void fuzz_operations(std::span<const std::uint8_t> bytes);
/// Bytes as the text of a session's script, of a CSV of points that it loads, or of a GeoJSON file,
/// or as numbers. Nothing is written anywhere.
void fuzz_script(std::span<const std::uint8_t> bytes);

}  // namespace thiessen::fuzzers
