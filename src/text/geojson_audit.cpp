#include "text/geojson_audit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "text/json_scanner.h"

namespace thiessen {
namespace {

using Kind = JsonScanner::Kind;

constexpr std::size_t deepest = 30;       // GDAL's own reader stops at 32
constexpr std::size_t most_brackets = 4;  // those of a MultiPolygon's coordinates
// GDAL compares each further name of a property with all before it, and gives each feature room for
// all.
constexpr std::size_t most_names = 10'000;

/// How many brackets deep the numbers of a geometry are nested: 1 for [x, y]; 0 for an unknown
/// type.
std::size_t nesting(const std::string& type) {
  static const std::unordered_map<std::string, std::size_t> known = {
      {"Point", 1},   {"MultiPoint", 2},      {"LineString", 2},
      {"Polygon", 3}, {"MultiLineString", 3}, {"MultiPolygon", 4}};
  const auto found = known.find(type);
  return found == known.end() ? 0 : found->second;
}

class Audit {
 public:
  Audit(const std::string& file, ByteSource& source) : scanner_(file, source) {}

  GeoJsonFindings run() {
    if (scanner_.peek() != Kind::object) scanner_.fail("an object is expected");
    value(Part::root);
    scanner_.require_end();
    complaints_.throw_if_any();
    return findings_;
  }

 private:
  enum class Part {
    root,
    features,
    feature,
    properties,
    geometry,
    geometries,
    coordinates,
    crs,
    crs_properties,
    other
  };

  struct Step {
    std::string key;
    std::size_t index = 0;
    bool in_array = false;
  };

  struct Shape {
    std::string type;
    std::size_t depth = 0;  ///< nesting of the numbers; 0 where none were seen
    bool given = false;
    bool uneven = false;  ///< whether it is, and was reported
    /// The path of the first list without elements within so many brackets; empty where there is
    /// none. Whether it should be a position is known only with the type, which may follow.
    std::array<std::string, most_brackets> bare;
  };

  static Part part_of(Part outer, const std::string& key) {
    if (outer == Part::crs && key == "properties") return Part::crs_properties;
    if (outer != Part::root && outer != Part::feature && outer != Part::geometry)
      return Part::other;
    if (outer != Part::feature) {
      if (key == "coordinates") return Part::coordinates;
      if (key == "geometries") return Part::geometries;
    }
    if (outer != Part::geometry && key == "geometry") return Part::geometry;
    if (outer != Part::geometry && key == "properties") return Part::properties;
    if (outer != Part::root) return Part::other;
    if (key == "features") return Part::features;
    return key == "crs" ? Part::crs : Part::other;
  }

  static Part element_of(Part outer) {
    if (outer == Part::features) return Part::feature;
    return outer == Part::geometries ? Part::geometry : Part::other;
  }

  std::string path() const {
    std::string text;
    for (const Step& step : steps_) {
      if (step.in_array) {
        text += "[" + std::to_string(step.index) + "]";
      } else {
        text += (text.empty() ? "" : ".") + printable(step.key);
      }
    }
    return text;
  }

  void complain(const std::string& text) { complain(path(), text); }
  void complain(const std::string& where, const std::string& text) {
    complaints_.add(Message{scanner_.file(), 0, where.empty() ? text : where + ": " + text, {}});
  }

  void value(Part part) {
    if (steps_.size() > deepest) scanner_.fail("brackets nest deeper than 30");
    const Kind kind = scanner_.peek();
    if (kind == Kind::object) return object(part);
    if (part == Part::crs) findings_.crs = GeoJsonFindings::CrsMember::other;
    if (kind == Kind::array) return array(part);
    if (kind == Kind::end) scanner_.fail("the file ends too early");
    scalar(kind, part);
  }

  void scalar(Kind kind, Part part) {
    if (kind == Kind::string) {
      scanner_.string();
    } else if (kind == Kind::number) {
      scanner_.number();
    } else {
      const std::string word = scanner_.literal();
      if (word != "true" && word != "false" && word != "null") {
        scanner_.fail("'" + word + "' is no value");
      }
      if (part == Part::crs && word == "null") findings_.crs = GeoJsonFindings::CrsMember::null;
    }
    if (part == Part::features) complain("not a list of features");
  }

  void object(Part part) {
    if (part == Part::crs) findings_.crs = GeoJsonFindings::CrsMember::other;
    const bool geometric = part == Part::root || part == Part::feature || part == Part::geometry;
    Shape shape;
    std::unordered_set<std::uint64_t> keys;
    bool going = scanner_.open('{', '}');
    while (going) {
      steps_.push_back({scanner_.string(), 0, false});
      if (!keys.insert(scanner_.hash()).second) scanner_.fail("'" + path() + "' is given twice");
      if (part == Part::properties) see_property(scanner_.hash());
      scanner_.colon();
      member(part, geometric ? &shape : nullptr);
      steps_.pop_back();
      going = scanner_.more('}');
    }
    if (geometric) judge(part, shape);
  }

  void see_property(std::uint64_t name) {
    if (!names_.insert(name).second || names_.size() <= most_names) return;
    throw Error(
        Message{scanner_.file(), 0, "features have more than 10,000 different properties", {}});
  }

  void member(Part outer, Shape* shape) {
    const std::string key = steps_.back().key;
    const Part part = part_of(outer, key);
    if (part == Part::coordinates && shape != nullptr) {
      shape->given = true;
      return coordinates(*shape, 0);
    }
    if (key == "type" && scanner_.peek() == Kind::string) {
      const std::string& type = scanner_.string();
      if (shape != nullptr) shape->type = type;
      if (outer == Part::crs && type == "name") findings_.crs = GeoJsonFindings::CrsMember::name;
      if (outer == Part::crs && type == "link") findings_.crs = GeoJsonFindings::CrsMember::link;
      return;
    }
    if (outer == Part::crs_properties && key == "name" && scanner_.peek() == Kind::string) {
      findings_.crs_name = scanner_.string();
      return;
    }
    if (part == Part::features) has_features_ = true;
    value(part);
  }

  void array(Part part) {
    const Part inner = element_of(part);
    bool going = scanner_.open('[', ']');
    steps_.push_back({{}, 0, true});
    for (; going; going = scanner_.more(']'), ++steps_.back().index) {
      if (part == Part::features) ++findings_.features;
      if (inner != Part::other && scanner_.peek() != Kind::object && !null_geometry(part)) {
        complain("not an object");
      }
      value(inner);
    }
    steps_.pop_back();
  }

  bool null_geometry(Part part) {
    return part == Part::geometries && scanner_.peek() == Kind::literal;
  }

  /// Reads nested brackets down to the positions. What nests deeper than a MultiPolygon is refused,
  /// so that recursion is bounded.
  void coordinates(Shape& shape, std::size_t depth) {
    if (scanner_.peek() != Kind::array) {
      complain("coordinates are a list");
      return value(Part::other);
    }
    if (depth == most_brackets) {
      scanner_.fail("'" + path() + "' nests deeper than a geometry's coordinates");
    }
    bool going = scanner_.open('[', ']');
    steps_.push_back({{}, 0, true});
    bool position = false;
    bool list = false;
    for (; going; going = scanner_.more(']'), ++steps_.back().index) {
      if (scanner_.peek() == Kind::array) {
        list = true;
        coordinates(shape, depth + 1);
      } else {
        position = true;
        number();
      }
    }
    const std::size_t length = steps_.back().index;
    steps_.pop_back();
    if (std::string& bare = shape.bare.at(depth); length == 0 && depth > 0 && bare.empty()) {
      bare = path();
    }
    if (!position) return;
    if (list) return complain_of_nesting(shape, "a list stands beside numbers");
    if (length < 2) complain("a position has two numbers, not one");
    if (shape.depth != 0 && shape.depth != depth + 1) {
      complain_of_nesting(shape, "lies in more or fewer brackets than the positions before");
    }
    shape.depth = depth + 1;
  }

  void complain_of_nesting(Shape& shape, const std::string& text) {
    if (!shape.uneven) complain(text);
    shape.uneven = true;
  }

  void number() {
    const Kind kind = scanner_.peek();
    if (kind == Kind::number) {
      const std::string& text = scanner_.number();
      double read = 0;
      const auto result = std::from_chars(text.data(), text.data() + text.size(), read);
      if (result.ec != std::errc())
        complain("'" + text.substr(0, 40) + "' is outside a double's range");
      return;
    }
    if (kind == Kind::literal) {
      complain("'" + printable(scanner_.literal()) + "' is no number");
    } else {
      complain(std::string(kind == Kind::string ? "a text" : "an object") +
               " stands where a number should");
      value(Part::other);
    }
  }

  void judge(Part part, const Shape& shape) {
    if (shape.type.empty()) return complain("has no type");
    const bool is_all = part == Part::root && shape.type == "Feature" && !has_features_;
    if (part == Part::feature || is_all) {
      if (shape.type != "Feature") complain("type is '" + printable(shape.type) + "', not Feature");
      if (part == Part::root) findings_.features = 1;
      return;
    }
    if (part == Part::root && (has_features_ || shape.type == "FeatureCollection")) {
      if (!has_features_) complain("a FeatureCollection without features");
      if (shape.type != "FeatureCollection") {
        complain("type is '" + printable(shape.type) + "', not FeatureCollection");
      }
      return;
    }
    if (part == Part::root) findings_.features = 1;
    judge_geometry(shape);
  }

  void judge_geometry(const Shape& shape) {
    if (shape.type == "GeometryCollection") return;
    const std::size_t wanted = nesting(shape.type);
    if (wanted == 0) return complain("'" + printable(shape.type) + "' is no type of geometry");
    if (!shape.given) return complain("a " + shape.type + " without coordinates");
    const std::string& bare = shape.bare.at(wanted - 1);
    if (!bare.empty()) complain(bare, "a position has two numbers, not none");
    const auto deeper = shape.bare.begin() + static_cast<std::ptrdiff_t>(wanted);
    const bool too_deep = std::any_of(deeper, shape.bare.end(),
                                      [](const std::string& where) { return !where.empty(); });
    if (!shape.uneven && ((shape.depth != 0 && shape.depth != wanted) || too_deep)) {
      complain("coordinates are not nested as those of a " + shape.type);
    }
  }

  JsonScanner scanner_;
  Complaints complaints_;
  GeoJsonFindings findings_;
  std::vector<Step> steps_;
  std::unordered_set<std::uint64_t> names_;  ///< of properties, by their hash
  bool has_features_ = false;
};

}  // namespace

GeoJsonFindings audit_geojson(const std::string& file, ByteSource& source) {
  return Audit(file, source).run();
}

}  // namespace thiessen
