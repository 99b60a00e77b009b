#pragma once

#include <array>
#include <cstddef>

namespace thiessen {

/// An exact number: the unevaluated sum of up to N doubles that do not overlap, smallest first and
/// without zeros, so that its sign is that of the last (Shewchuk, Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates, 1997). Sums and products are exact as long as
/// nothing overflows and no product underflows: see the range in predicates.h.
/// Cost: a sum takes time in proportion to its terms; a product to the product of their numbers.
template <std::size_t N>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double value) { append(value); }

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return terms_[i]; }
  /// Leaves zeros out. Requires terms in growing order of magnitude.
  void append(double term) {
    if (term != 0) terms_[size_++] = term;
  }

  int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }
  /// The nearest double or one next to it: relative error 2^-52 at most.
  double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }
  Expansion operator-() const {
    Expansion negated;
    for (std::size_t i = 0; i < size_; ++i) negated.append(-terms_[i]);
    return negated;
  }

 private:
  std::array<double, N> terms_;
  std::size_t size_ = 0;
};

namespace exact {

struct Pair {
  double rounded;
  double error;
};

inline Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// Requires |a| >= |b| or a == 0.
inline Pair fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

struct Halves {
  double high;
  double low;
};

inline Halves split(double a) {
  const double spread = 134217729.0 * a;  // 2^27 + 1
  const double high = spread - (spread - a);
  return {high, a - high};
}

inline Pair two_product(double a, Halves b_halves, double b) {
  const double product = a * b;
  const Halves h = split(a);
  const double rest =
      product - h.high * b_halves.high - h.low * b_halves.high - h.high * b_halves.low;
  return {product, h.low * b_halves.low - rest};
}

inline Pair two_product(double a, double b) {
  return two_product(a, split(b), b);
}

/// a - b as an expansion of at most two terms.
inline Expansion<2> difference(double a, double b) {
  const Pair d = two_sum(a, -b);
  Expansion<2> result;
  result.append(d.error);
  result.append(d.rounded);
  return result;
}

template <std::size_t N>
Expansion<2 * N> scaled(const Expansion<N>& e, double factor) {
  Expansion<2 * N> result;
  if (e.size() == 0 || factor == 0) return result;
  const Halves halves = split(factor);
  Pair carry = two_product(e[0], halves, factor);
  result.append(carry.error);
  for (std::size_t i = 1; i < e.size(); ++i) {
    const Pair product = two_product(e[i], halves, factor);
    const Pair low = two_sum(carry.rounded, product.error);
    result.append(low.error);
    carry = fast_two_sum(product.rounded, low.rounded);
    result.append(carry.error);
  }
  result.append(carry.rounded);
  return result;
}

}  // namespace exact

template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> result;
  std::size_t i = 0;
  std::size_t j = 0;
  const auto smaller = [&]() {
    if (j == b.size()) return a[i++];
    if (i == a.size()) return b[j++];
    const bool take_a = (a[i] < 0 ? -a[i] : a[i]) < (b[j] < 0 ? -b[j] : b[j]);
    return take_a ? a[i++] : b[j++];
  };
  if (a.size() + b.size() == 0) return result;
  double carry = smaller();
  while (i < a.size() || j < b.size()) {
    const exact::Pair sum = exact::two_sum(carry, smaller());
    result.append(sum.error);
    carry = sum.rounded;
  }
  result.append(carry);
  return result;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

template <std::size_t N, std::size_t M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> result;
  for (std::size_t j = 0; j < b.size(); ++j) {
    const auto grown = result + exact::scaled(a, b[j]);
    result = {};
    for (std::size_t k = 0; k < grown.size(); ++k) result.append(grown[k]);
  }
  return result;
}

}  // namespace thiessen
