#pragma once
/// Elementary functions that give the same bits on every processor, with every compiler and C library. They
/// use only + - * /, square roots and exact functions, whose results IEEE 754 defines to the last bit. The
/// functions of <cmath> do not: the C library chooses among variants by the processor's instruction sets.
///
/// Compile with -ffp-contract=off, as burin_add_brush() does. Errors are below 1 unit in the last place,
/// below 4 for tan, expm1 and hypot, and below 1 + |y log(x)| for pow; float results are rounded from double.
/// All functions may be called on any thread.
///
/// Polynomials and argument reductions are those of fdlibm, whose notice must be kept:
/// Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunSoft, a Sun
/// Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is freely
/// granted, provided that this notice is preserved.
#include <cmath>
#include <limits>

namespace burin::math {
namespace detail {

/// The value of a polynomial by Horner's rule, the coefficient of x^0 first.
template <typename... Rest>
constexpr double polynomial(double x, double first, Rest... rest) {
  if constexpr (sizeof...(rest) == 0)
    return first;
  else
    return first + x * polynomial(x, rest...);
}

/// An angle in radians as quarters * pi / 2 + high + low, where |high + low| is at most pi / 4.
struct Reduced {
  double quarters, high, low;

  bool odd() const { return std::fmod(quarters, 2) != 0; }
};

/// Reduces an angle. From 2^20 on it first takes the remainder modulo the double nearest to 2 pi, so the
/// error grows with the angle: by 2^-54 times its value.
inline Reduced reduced(double angle) {
  constexpr double pi2_first = 0x1.921fb544p+0, pi2_second = 0x1.0b4611a6p-34,
                   pi2_rest = 0x1.3198a2e037073p-69;
  if (!(std::abs(angle) < 0x1p20)) angle = std::remainder(angle, 0x1.921fb54442d18p+2);
  const double quarters = std::floor(angle * 0x1.45f306dc9c883p-1 + 0.5);
  const double first = angle - quarters * pi2_first, second = quarters * pi2_second;
  const double most = first - second, rest = quarters * pi2_rest - ((first - most) - second);
  const double high = most - rest;
  return {quarters, high, (most - high) - rest};
}

inline double sin_near_0(double x, double low) {
  const double z = x * x, v = z * x;
  const double r =
      polynomial(z, 8.33333333332248946124e-03, -1.98412698298579493134e-04, 2.75573137070700676789e-06,
                 -2.50507602534068634195e-08, 1.58969099521155010221e-10);
  return x - ((z * (0.5 * low - v * r) - low) + v * 1.66666666666666324348e-01);
}

inline double cos_near_0(double x, double low) {
  const double z = x * x, half = 0.5 * z, w = 1 - half;
  const double r =
      z * polynomial(z, 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                     -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11);
  return w + (((1 - w) - half) + (z * r - x * low));
}

/// The sine of angle + quarters * pi / 2.
inline double turned_sin(double angle, int quarters) {
  const Reduced r = reduced(angle);
  if (std::isnan(r.quarters)) return r.quarters;
  const int quarter = static_cast<int>(r.quarters + quarters) & 3;
  const double value = quarter & 1 ? cos_near_0(r.high, r.low) : sin_near_0(r.high, r.low);
  return quarter & 2 ? -value : value;
}

/// exp(high - low) - 1 for |high - low| <= log(2) / 2.
inline double expm1_near_0(double high, double low) {
  const double x = high - low, z = x * x;
  const double c =
      x - z * polynomial(z, 1.66666666666666019037e-01, -2.77777777770155933842e-03,
                         6.61375632143793436117e-05, -1.65339022054652515390e-06, 4.13813679705723846039e-08);
  return high - (low - x * c / (2 - c));
}

inline constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;

/// x - atan(x) for 0 <= x < 7 / 16.
inline double atan_missing(double x) {
  const double z = x * x;
  return x * z *
         polynomial(z, 3.33333333333329318027e-01, -1.99999999998764832476e-01, 1.42857142725034663711e-01,
                    -1.11111104054623557880e-01, 9.09088713343650656196e-02, -7.69187620504482999495e-02,
                    6.66107313738753120669e-02, -5.83357013379057348645e-02, 4.97687799461593236017e-02,
                    -3.65315727442169155270e-02, 1.62858201153657823623e-02);
}

/// The arc high + low plus atan(left), where `left` is small.
inline double atan_from(double high, double low, double left) {
  return high - ((atan_missing(left) - low) - left);
}

inline double atan_of_positive(double x) {
  if (x < 0.4375) return x - atan_missing(x);
  if (x < 0.6875)
    return atan_from(4.63647609000806093515e-01, 2.26987774529616870924e-17, (2 * x - 1) / (2 + x));
  if (x < 1.1875) return atan_from(7.85398163397448278999e-01, 3.06161699786838301793e-17, (x - 1) / (x + 1));
  if (x < 2.4375)
    return atan_from(9.82793723247329054082e-01, 1.39033110312309984516e-17, (x - 1.5) / (1 + 1.5 * x));
  return atan_from(1.57079632679489655800e+00, 6.12323399573676603587e-17, -1 / x);
}

}  // namespace detail

/// Of an angle in radians.
inline double sin(double angle) { return detail::turned_sin(angle, 0); }
inline double cos(double angle) { return detail::turned_sin(angle, 1); }

/// Of an angle in radians.
inline double tan(double angle) {
  const detail::Reduced r = detail::reduced(angle);
  const double sine = detail::sin_near_0(r.high, r.low), cosine = detail::cos_near_0(r.high, r.low);
  return r.odd() ? -cosine / sine : sine / cosine;
}

/// Radians.
inline double atan(double x) { return std::copysign(detail::atan_of_positive(std::abs(x)), x); }

/// The angle of the vector (x, y) from the x axis, -pi to pi.
inline double atan2(double y, double x) {
  constexpr double pi_high = 3.1415926535897931160e+00, pi_low = 1.2246467991473531772e-16;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double up = std::abs(y), side = std::abs(x);
  const double quotient = up == side && up != 0 ? 1 : up / side;
  const double angle = up == 0 ? 0 : detail::atan_of_positive(quotient);
  return std::copysign(std::signbit(x) ? pi_high - (angle - pi_low) : angle, y);
}

/// e to the power of x.
inline double exp(double x) {
  if (!(x < 710)) return x > 0 ? std::numeric_limits<double>::infinity() : x;
  if (x < -746) return 0;
  const double twos = std::floor(x * 1.44269504088896338700e+00 + 0.5);
  const double rest = detail::expm1_near_0(x - twos * detail::ln2_high, twos * detail::ln2_low);
  return std::ldexp(1 + rest, static_cast<int>(twos));
}

/// exp(x) - 1, accurate near 0, too.
inline double expm1(double x) { return std::abs(x) < 0.34 ? detail::expm1_near_0(x, 0) : exp(x) - 1; }

/// The natural logarithm.
inline double log(double x) {
  if (!(x > 0))
    return x == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(x)) return x;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < 0x1.6a09e667f3bcdp-1) mantissa *= 2, --exponent;
  const double f = mantissa - 1, s = f / (2 + f), z = s * s, half = 0.5 * f * f;
  const double r =
      z * detail::polynomial(z, 6.666666666666735130e-01, 3.999999999940941908e-01, 2.857142874366239149e-01,
                             2.222219843214978396e-01, 1.818357216161805012e-01, 1.531383769920937332e-01,
                             1.479819860511658591e-01);
  return exponent * detail::ln2_high - ((half - (s * (half + r) + exponent * detail::ln2_low)) - f);
}

/// x to the power of y; x >= 0.
inline double pow(double x, double y) { return y == 0 ? 1 : exp(y * log(x)); }

/// The length of (x, y). The squares of x and y must not overflow or underflow.
inline double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

/// The same of floats.
inline float sin(float angle) { return static_cast<float>(sin(double{angle})); }
inline float cos(float angle) { return static_cast<float>(cos(double{angle})); }
inline float tan(float angle) { return static_cast<float>(tan(double{angle})); }
inline float atan(float x) { return static_cast<float>(atan(double{x})); }
inline float atan2(float y, float x) { return static_cast<float>(atan2(double{y}, double{x})); }
inline float exp(float x) { return static_cast<float>(exp(double{x})); }
inline float expm1(float x) { return static_cast<float>(expm1(double{x})); }
inline float log(float x) { return static_cast<float>(log(double{x})); }
inline float pow(float x, float y) { return static_cast<float>(pow(double{x}, double{y})); }
inline float hypot(float x, float y) { return static_cast<float>(hypot(double{x}, double{y})); }

}  // namespace burin::math
