// The fuzzer's short form: some thousands of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

using namespace std::literals;

constexpr std::array words = {"{"sv,
                              "}"sv,
                              "["sv,
                              "]"sv,
                              ","sv,
                              ":"sv,
                              "\""sv,
                              "\"type\":"sv,
                              "\"Feature\""sv,
                              "\"FeatureCollection\""sv,
                              "\"features\":"sv,
                              "\"geometry\":"sv,
                              "\"coordinates\":"sv,
                              "\"Polygon\""sv,
                              "\"Point\""sv,
                              "\"crs\":"sv,
                              "\"properties\":"sv,
                              "null"sv,
                              "1"sv,
                              "-1.5e3"sv,
                              " "sv,
                              "\\u0041"sv,
                              "\\ud83d\\ude00"sv,
                              "{\"type\":\"Point\",\"coordinates\":[1,2]}"sv,
                              "true"sv,
                              "NaN"sv,
                              "\"name\""sv};

/// A number of JSON, or nearly so.
std::string any_number(Seeded& seeded) {
  constexpr std::array numbers = {"0"sv,    "-0"sv,    "1.5"sv, "-105.25"sv, "2e3"sv,
                                  "1E-7"sv, "180"sv,   "01"sv,  "1e999"sv,   "null"sv,
                                  "NaN"sv,  "\"1\""sv, "1."sv,  "[1]"sv,     "1e-400"sv};
  return std::string(numbers[seeded.below(seeded.below(20) == 0 ? numbers.size() : 7)]);
}

/// Lists nested so deep around positions.
std::string any_list(Seeded& seeded, std::uint64_t depth) {
  if (seeded.below(60) == 0) depth = seeded.below(6);
  if (depth == 0) return any_number(seeded);
  std::string list = "[";
  const std::uint64_t count = depth == 1 ? 2 + seeded.below(8) / 7 : seeded.below(4);
  for (std::uint64_t i = 0; i < count; ++i)
    list += (i > 0 ? "," : "") + any_list(seeded, depth - 1);
  return list + "]";
}

std::string any_geometry(Seeded& seeded) {
  constexpr std::array types = {"Point"sv,   "MultiPoint"sv,   "LineString"sv, "MultiLineString"sv,
                                "Polygon"sv, "MultiPolygon"sv, "Nothing"sv};
  constexpr std::array<std::uint64_t, 7> depths = {1, 2, 2, 3, 3, 4, 1};
  if (seeded.below(10) == 0) return "null";
  if (seeded.below(8) == 0)
    return R"({"type":"GeometryCollection","geometries":[)" + any_geometry(seeded) + "," +
           any_geometry(seeded) + "]}";
  const std::size_t type = seeded.below(seeded.below(20) == 0 ? 7 : 6);
  return R"({"coordinates":)" + any_list(seeded, depths[type]) + R"(,"type":")" +
         std::string(types[type]) + "\"}";
}

std::string any_geojson(Seeded& seeded) {
  constexpr std::array names = {"name"sv, "a.b"sv, "[0]"sv, ": "sv, "\\u00e9\xC3\xA9"sv, "type"sv};
  if (seeded.below(4) == 0) return any_geometry(seeded);
  std::string text = R"({"type":"FeatureCollection",)";
  if (seeded.below(4) == 0)
    text += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)";
  text += "\"features\":[";
  const std::uint64_t count = seeded.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    text += i > 0 ? ",\n" : "";
    text += R"({"type":"Feature","properties":{")" +
            std::string(names[seeded.below(names.size())]) + "\":" + any_number(seeded) +
            R"(},"geometry":)" + any_geometry(seeded) + "}";
  }
  return text + "]}\n";
}

TEST(JsonFuzzer, finds_nothing_in_random_geojson) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2500); ++round) {
    const std::string text = round % 3 == 0   ? any_words(seeded, words, 60)
                             : round % 3 == 1 ? any_geojson(seeded)
                                              : damaged(seeded, any_geojson(seeded));
    expect_no_complaint(fuzz_json, input_of({2, seeded.below(20)}, text));
    if (HasFailure()) return;
  }
}

TEST(JsonFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1500); ++round) {
    expect_no_complaint(fuzz_json, any_bytes(seeded, 300));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
