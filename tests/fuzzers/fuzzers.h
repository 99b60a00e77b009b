#pragma once

#include <cstdint>
#include <span>

namespace thiessen::fuzzers {

/// Each takes any bytes, and throws std::logic_error where something is not as it must be.

/// Bytes as operations: on a History, or on a Tessellation with nested Trials, in the plane or in
/// space; audited after every one.
void fuzz_operations(std::span<const std::uint8_t> bytes);
/// Bytes as a CSV, read whole and in pieces, written and read again; or as a file of points.
void fuzz_csv(std::span<const std::uint8_t> bytes);
/// Bytes as JSON and GeoJSON, as strings and cells that are written so and read again.
void fuzz_json(std::span<const std::uint8_t> bytes);
/// Bytes as a number, a time, several times in their order, or a field of rainfall.
void fuzz_values(std::span<const std::uint8_t> bytes);
/// Bytes as characters, as what messages show, as names of fields and of files.
void fuzz_texts(std::span<const std::uint8_t> bytes);
/// Bytes as a table of readings; or as readings, written wide, long and long in any order, and read
/// again.
void fuzz_readings(std::span<const std::uint8_t> bytes);
/// Bytes as a `.dly` file of GHCN-Daily; or as its records, written in any order, and read again.
void fuzz_dly(std::span<const std::uint8_t> bytes);
/// Bytes as several files of readings that are joined, as readings parted over files, or as the
/// name of a file that tells a station.
void fuzz_joined(std::span<const std::uint8_t> bytes);
/// Bytes as a sheet of a .xlsx, or as the form of its cells.
void fuzz_xlsx(std::span<const std::uint8_t> bytes);
/// Bytes as a file of readings in a published format.
void fuzz_published(std::span<const std::uint8_t> bytes);
/// Bytes as the script of a session and a CSV of points that it loads. Nothing is written anywhere.
void fuzz_script(std::span<const std::uint8_t> bytes);

/// Bytes as a study in memory: gauges that may be silent and basins, measured beside brute force.
void fuzz_study(std::span<const std::uint8_t> bytes);
/// Bytes as any file that a command reads, as damages of a sound one, as the text of an option, or
/// as the names that a command writes and draws; the whole program runs on them, in this process.
void fuzz_program(std::span<const std::uint8_t> bytes);

}  // namespace thiessen::fuzzers
