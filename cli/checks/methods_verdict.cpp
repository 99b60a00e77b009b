#include "cli/checks/methods_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/number.h"

namespace thiessen::cli {
namespace {

/// Errors that are rounding beside the largest of them count as none.
constexpr double rounding = 1e-9;

/// The verdict over the errors at the steps.
class Verdict {
 public:
  Verdict(const MethodErrors& errors, const std::string& unit) : errors_(errors), unit_(unit) {
    for (std::size_t m = 0; m < errors.methods().size(); ++m)
      off_.push_back(errors.errors(m).steps.root_mean_square());
    const double largest = *std::max_element(off_.begin(), off_.end());
    for (double& off : off_) off = off > rounding * largest ? off : 0;
    best_ = least_but(off_.size());
    next_ = least_but(best_);
    decimals_ = decimals_for(off_);
  }

  std::string sentence() const {
    if (!(*std::max_element(off_.begin(), off_.end()) > 0))
      return "best here: none, for no method is off at any step\n";
    std::string text =
        "best here: " + name(best_) + ", off by " + amount(off_[best_]) + " at a step";
    if (best_ != 0)
      text += ", " + percent(1 - off_[best_] / off_[0]) + " less than " + named(0) + worth(0);
    if (off_[best_] > 0 && (best_ == 0 || next_ != 0)) {
      text += "; next is " + named(next_) + ", " + percent(off_[next_] / off_[best_] - 1) +
              " worse" + worth(next_);
    }
    return text + "\n";
  }

 private:
  std::size_t least_but(std::size_t other) const {
    std::size_t least = other == 0 ? 1 : 0;
    for (std::size_t m = 0; m < off_.size(); ++m) {
      if (m != other && off_[m] < off_[least]) least = m;
    }
    return least;
  }
  std::string amount(double value) const {
    return error_text(value, decimals_) + (unit_.empty() ? "" : " " + unit_);
  }
  std::string name(std::size_t method) const {
    return tried_name(errors_.methods()[method].method, errors_.methods()[method].with_normals);
  }
  std::string named(std::size_t method) const {
    return name(method) + " (" + amount(off_[method]) + ")";
  }
  static std::string percent(double share) {
    return fixed_text(100 * share, share < 0.01 ? 1 : 0) + " %";
  }
  /// What the difference between the best and another is worth.
  std::string worth(std::size_t other) const {
    const SquaredDifference difference = errors_.difference(best_, other);
    if (!difference.is_told) return ", which so few gauges cannot tell from chance";
    return std::string(difference.is_more_than_chance() ? ", which is more than chance"
                                                        : ", which is no more than chance") +
           " (t = " + fixed_text(std::abs(difference.t), 1) + ", where chance reaches " +
           fixed_text(difference.critical, 1) + ")";
  }

  const MethodErrors& errors_;
  std::string unit_;
  std::vector<double> off_;
  std::size_t best_ = 0;
  std::size_t next_ = 0;
  int decimals_ = 1;
};

}  // namespace

std::string tried_name(PointMethod method, bool with_normals) {
  return std::string(name_of(method)) + (with_normals ? " with normals" : "");
}

int decimals_for(const std::vector<double>& errors) {
  double largest = 0;
  for (const double error : errors)
    largest = std::isnan(error) ? largest : std::max(largest, error);
  double least = largest;
  for (const double error : errors) least = error > 1e-6 * largest ? std::min(least, error) : least;
  if (!(least > 0)) return 1;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(least))), 0, 9);
}

std::string error_text(double error, int decimals) {
  return std::isnan(error) ? "-" : fixed_text(error, decimals);
}

std::string verdict_on(const MethodErrors& errors, const std::string& unit) {
  return Verdict(errors, unit).sentence();
}

}  // namespace thiessen::cli
