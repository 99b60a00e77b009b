#pragma once

#include <string>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The options that write what the cells say of the gauges: which three meet, and who borders whom.
class DualOptions : public OptionBlock {
 public:
  /// The file of triangles; empty: none. Where no FILE is given, it is `-o`: they are written in
  /// the place of the cells.
  std::string delaunay;
  std::string neighbours;  ///< the file of borders; empty: none

  void declare(OptionList& options);
  bool takes_place_of_cells() const { return delaunay == in_place; }
  bool any() const { return delaunay_option_->is_given() || neighbours_option_->is_given(); }
  /// Throws UsageError where two outputs go to the standard output; `output_is_stream` says whether
  /// -o does, with cells or triangles.
  void check(bool output_is_stream) const;

 private:
  static constexpr const char* in_place = "-o";

  const Option* delaunay_option_ = nullptr;
  const Option* neighbours_option_ = nullptr;
};

}  // namespace thiessen::cli
