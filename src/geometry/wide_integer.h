#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace thiessen {

__extension__ using LongInteger = __int128;
__extension__ using UnsignedLongInteger = unsigned __int128;

/// A whole number of fixed width in two's complement: 64 bits a limb, lowest limb first. A product
/// is as wide as its factors together, so it never overflows. A sum or difference is as wide as its
/// terms, and the caller must see to it that it fits. Cost: a sum takes time in proportion to the
/// number of limbs, and a product in proportion to the product of the factors' numbers of limbs.
template <std::size_t Limbs>
class WideInteger {
  static_assert(Limbs > 0);

 public:
  WideInteger() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a widening that loses nothing
  constexpr WideInteger(std::int64_t value) {
    limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(value);
  }
  static constexpr WideInteger of(LongInteger value) requires(Limbs >= 2) {
    WideInteger result = value < 0 ? -1 : 0;
    result.limbs_[0] = static_cast<std::uint64_t>(value);
    result.limbs_[1] = static_cast<std::uint64_t>(value >> 64);
    return result;
  }

  /// The number digits * 2^shift, modulo 2^(64 Limbs), that is, without the bits that do not fit.
  /// Requires shift >= 0.
  static constexpr WideInteger shifted(std::int64_t digits, int shift) {
    const auto low = static_cast<std::uint64_t>(digits);
    if constexpr (Limbs == 1) return static_cast<std::int64_t>(shift < 64 ? low << shift : 0);
    WideInteger result = 0;
    const LongInteger pair = LongInteger{digits} << (shift % 64);
    for (auto i = static_cast<std::size_t>(shift / 64), k = std::size_t{0}; i < Limbs; ++i, ++k)
      result.limbs_[i] = static_cast<std::uint64_t>(k < 2 ? pair >> (64 * k) : pair >> 127);
    return result;
  }

  std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  constexpr bool is_negative() const { return static_cast<std::int64_t>(limbs_[Limbs - 1]) < 0; }
  constexpr int sign() const {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs_) any |= limb;
    return static_cast<int>(any != 0) - 2 * static_cast<int>(is_negative());
  }

  /// The double nearest to the value times 2^exponent; of two equally near ones the even one.
  /// Requires that the result is zero or a normal double.
  double to_double(int exponent = 0) const {
    if (is_negative()) return -magnitude_to_double(-*this, exponent);
    return magnitude_to_double(*this, exponent);
  }

  friend bool operator==(const WideInteger&, const WideInteger&) = default;

  WideInteger operator-() const { return WideInteger(0) - *this; }
  friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    if constexpr (Limbs <= 2) return of_native(a.native() + b.native());
    WideInteger sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < Limbs; ++i) {
      const UnsignedLongInteger t = UnsignedLongInteger{a.limbs_[i]} + b.limbs_[i] + carry;
      sum.limbs_[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    return sum;
  }
  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    if constexpr (Limbs <= 2) return of_native(a.native() - b.native());
    WideInteger difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < Limbs; ++i) {
      const UnsignedLongInteger t = UnsignedLongInteger{a.limbs_[i]} - b.limbs_[i] - borrow;
      difference.limbs_[i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
    return difference;
  }

  // Short products are put in line, because half their time would go into calls.
  template <std::size_t M>
  [[gnu::always_inline]] WideInteger<Limbs + M> operator*(const WideInteger<M>& b) const
      requires(Limbs <= 6 / M) {
    return product(*this, b);
  }
  template <std::size_t M>
  WideInteger<Limbs + M> operator*(const WideInteger<M>& b) const {
    return product(*this, b);
  }

 private:
  template <std::size_t>
  friend class WideInteger;

  // The limbs as one built-in integer, where there is one as wide. Its sums wrap around.
  auto native() const requires(Limbs <= 2) {
    if constexpr (Limbs == 1) return limbs_[0];
    if constexpr (Limbs == 2) return UnsignedLongInteger{limbs_[1]} << 64 | limbs_[0];
  }
  static WideInteger of_native(UnsignedLongInteger native) requires(Limbs <= 2) {
    if constexpr (Limbs == 1) return static_cast<std::int64_t>(native);
    if constexpr (Limbs == 2) return of(static_cast<LongInteger>(native));
  }

  template <std::size_t M>
  [[gnu::always_inline]] static WideInteger<Limbs + M> product(const WideInteger& a,
                                                               const WideInteger<M>& b) {
    if constexpr (Limbs == 1 && M == 1)
      return WideInteger<2>::of(LongInteger{static_cast<std::int64_t>(a.limbs_[0])} *
                                static_cast<std::int64_t>(b.limbs_[0]));
    WideInteger<Limbs + M> result = 0;
    for (std::size_t i = 0; i < Limbs; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < M; ++j) {
        const UnsignedLongInteger t =
            UnsignedLongInteger{a.limbs_[i]} * b.limbs_[j] + result.limbs_[i + j] + carry;
        result.limbs_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      result.limbs_[i + M] = carry;
    }
    // The product of the limbs as unsigned numbers is too large where a factor is negative: as an
    // unsigned number, the factor exceeds its value by 2^(64 of its limbs).
    const auto take_from_high = [&result](std::size_t low, const auto& factor, bool negative) {
      const std::uint64_t mask = negative ? ~std::uint64_t{0} : 0;
      std::uint64_t borrow = 0;
      for (std::size_t i = 0; i < factor.size(); ++i) {
        const UnsignedLongInteger t =
            UnsignedLongInteger{result.limbs_[low + i]} - (factor[i] & mask) - borrow;
        result.limbs_[low + i] = static_cast<std::uint64_t>(t);
        borrow = static_cast<std::uint64_t>(t >> 64) & 1;
      }
    };
    take_from_high(Limbs, b.limbs_, a.is_negative());
    take_from_high(M, a.limbs_, b.is_negative());
    return result;
  }

  static double magnitude_to_double(const WideInteger& value, int exponent) {
    std::size_t top = Limbs - 1;
    while (top > 0 && value.limbs_[top] == 0) --top;
    const int zeros = std::countl_zero(value.limbs_[top]);
    std::uint64_t digits = value.limbs_[top];
    // Keeps the highest 64 digits, and makes the last of them 1 where any digit that is left out is
    // 1, so that the rounding is right.
    if (top > 0) {
      const UnsignedLongInteger two = (UnsignedLongInteger{digits} << 64 | value.limbs_[top - 1])
                                      << zeros;
      digits = static_cast<std::uint64_t>(two >> 64);
      std::uint64_t rest = static_cast<std::uint64_t>(two);
      for (std::size_t i = 0; i + 1 < top; ++i) rest |= value.limbs_[i];
      digits |= static_cast<std::uint64_t>(rest != 0);
      exponent += static_cast<int>(top) * 64 - zeros;
    }
    return std::ldexp(static_cast<double>(digits), exponent);
  }

  std::array<std::uint64_t, Limbs> limbs_;
};

}  // namespace thiessen
