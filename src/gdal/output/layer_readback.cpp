#include "gdal/output/layer_readback.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/number.h"
#include "base/utf8.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

constexpr const char* roomy = "a .gpkg holds texts of any length and names of any kind";

/// A date as ISO 8601 writes it, where GDAL says 2001/01/31; any other text as it is.
std::string in_iso(std::string text) {
  if (text.size() < 10 || text[4] != '/' || text[7] != '/') return text;
  text[4] = text[7] = '-';
  return text;
}

class LayerReadback {
 public:
  LayerReadback(OGRLayer& layer, const LayerTexts& wanted, const std::string& path)
      : layer_(layer), wanted_(wanted), path_(path), first_field_(first_field()) {}

  /// Finds each field, and tells those to which the format gave another name.
  void find_fields(Warnings& warnings) {
    for (std::size_t i = 0; i < wanted_.names.size(); ++i) {
      const std::string& name = wanted_.names[i];
      const int at = place_of(i);
      if (at >= count()) fail("the format has no field " + quoted(name, 80));
      const std::string actual = name_at(at);
      if (actual != name) {
        warnings.add({path_,
                      0,
                      "the field " + quoted(name, 80) + " is called " + quoted(actual, 80) +
                          ": the format has no longer names, or not such",
                      {}});
      }
      places_.push_back(at);
    }
  }

  void compare(Warnings& warnings) {
    rounded_.resize(places_.size());
    std::size_t row = 0;
    for (const auto& feature : layer_) {
      if (row == wanted_.rows) break;
      for (std::size_t i = 0; i < places_.size(); ++i) compare(*feature, row, i);
      ++row;
    }
    tell_rounded(warnings);
    if (row != wanted_.rows) {
      fail("the format holds " + std::to_string(row) + " of " + std::to_string(wanted_.rows) +
           " rows");
    }
  }

 private:
  [[noreturn]] void fail(std::string text) const {
    throw Error(Message{path_, 0, std::move(text), roomy});
  }

  int count() const { return layer_.GetLayerDefn()->GetFieldCount(); }
  std::string name_at(int place) const {
    return layer_.GetLayerDefn()->GetFieldDefn(place)->GetNameRef();
  }

  /// The first field of this name that is not another's; `count()` where there is none.
  int place_of_name(const std::string& name) const {
    int at = 0;
    while (at < count() && (name_at(at) != name || std::ranges::count(places_, at) > 0)) ++at;
    return at;
  }

  /// Some formats put fields of their own before those that are asked for.
  int first_field() const {
    const int at = place_of_name(wanted_.names.front());
    return at < count() ? at : 0;
  }

  /// Where a field is: in its turn, unless there is one of its name elsewhere. A name alone does
  /// not tell, for a format that cuts names may make of another's name this one.
  int place_of(std::size_t field) const {
    const int in_turn = static_cast<int>(field) + first_field_;
    const std::string& name = wanted_.names[field];
    if (in_turn < count() && name_at(in_turn) == name) return in_turn;
    const int by_name = place_of_name(name);
    return by_name < count() ? by_name : in_turn;
  }

  /// The numbers of a field that the format rounds.
  struct Rounded {
    std::size_t count = 0;
    std::string first;
  };

  void compare_number(OGRFeature& feature, std::size_t row, std::size_t field, double number) {
    // Formats that write 15 digits, or 15 decimals of a usual number, lose what nobody measures.
    constexpr double digits = 1e-9;  // of the number
    const bool is_there = feature.IsFieldSetAndNotNull(places_[field]) != FALSE;
    const double found = is_there ? feature.GetFieldAsDouble(places_[field]) : 0;
    if (is_there && std::abs(found - number) <= digits * std::abs(number)) return;
    if (++rounded_[field].count > 1) return;
    rounded_[field].first = quoted(wanted_.names[field], 80) + " of row " +
                            std::to_string(row + 1) +
                            " is rounded by the format: " + shortest_text(number) + " becomes " +
                            (is_there ? shortest_text(found) : "no value");
  }

  void tell_rounded(Warnings& warnings) {
    for (const Rounded& rounded : rounded_) {
      if (rounded.count == 0) continue;
      std::string text = rounded.first;
      if (rounded.count > 1) text += ", and " + std::to_string(rounded.count - 1) + " more";
      warnings.add({path_, 0, std::move(text), "a .gpkg keeps every digit"});
    }
  }

  void compare(OGRFeature& feature, std::size_t row, std::size_t field) {
    if (const auto number = wanted_.number(row, field))
      return compare_number(feature, row, field, *number);
    const std::string text = wanted_.text(row, field);
    if (text.empty()) return;
    const bool is_there = feature.IsFieldSetAndNotNull(places_[field]) != FALSE;
    const std::string found = is_there ? feature.GetFieldAsString(places_[field]) : "";
    if (trimmed(found) == trimmed(text) || in_iso(found) == in_iso(text)) return;
    const std::string what =
        quoted(wanted_.names[field], 80) + " of row " + std::to_string(row + 1);
    if (text.starts_with(found)) {
      fail(what + " is cut to " + std::to_string(found.size()) + " of its " +
           std::to_string(text.size()) + " bytes by the format: " + quoted(text, 60));
    }
    fail(what + " cannot be written in the format: " + quoted(text, 60) + " becomes " +
         quoted(found, 60));
  }

  OGRLayer& layer_;
  const LayerTexts& wanted_;
  const std::string& path_;
  std::vector<int> places_;  ///< of the fields in the layer, as far as they are found
  int first_field_;
  std::vector<Rounded> rounded_;  ///< by field
};

}  // namespace

void require_read_back(GDALDriver& driver, const std::string& written, const LayerTexts& wanted,
                       const std::string& path, Warnings& warnings) {
  const char* drivers[] = {driver.GetDescription(), nullptr};
  const GdalErrors errors;
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
      written.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  const bool has_layer = dataset && dataset->GetLayerCount() > 0;
  if (!has_layer && wanted.rows == 0) return;  // some formats hold no layer without a feature
  if (!has_layer) {
    throw Error(Message{path, 0, "GDAL cannot read again what it wrote: " + errors.text(), {}});
  }
  LayerReadback readback(*dataset->GetLayer(0), wanted, path);
  readback.find_fields(warnings);
  readback.compare(warnings);
}

}  // namespace thiessen
