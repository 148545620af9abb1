#pragma once

#include <string>
#include <type_traits>

#include "libCCMorse/Types.h"

namespace CCMorse {

/// What a cell or a line of the canvas is painted with, in any of the ways the thesis lists
/// (4.2.2): channels as whole numbers 0..255 or as decimals 0..1, or "#34AAFF"; each with or
/// without alpha, which mixes the colour with what is there: 0 leaves it, the highest value covers
/// it. Numbers beyond their range are held within, no number counts as 0. A plain value.
///
/// Channels of mixed types are all taken as decimals when one of them is; alpha has a type of its
/// own, whole 0..255 or decimal 0..1.
class Paint_t {
 public:
  template <class R, class G, class B,
            class = std::enable_if_t<std::is_arithmetic_v<R> && std::is_arithmetic_v<G> &&
                                     std::is_arithmetic_v<B>>>
  Paint_t(R r, G g, B b) {
    if constexpr (std::is_floating_point_v<R> || std::is_floating_point_v<G> ||
                  std::is_floating_point_v<B>) {
      color_ = FromDecimals(static_cast<double>(r), static_cast<double>(g), static_cast<double>(b));
    } else {
      color_ = FromBytes(static_cast<int>(r), static_cast<int>(g), static_cast<int>(b));
    }
  }
  template <class R, class G, class B, class Alpha>
  Paint_t(R r, G g, B b, Alpha alpha) : Paint_t(r, g, b) {
    SetAlpha(alpha);
  }
  /// `color` as "#34AAFF". Throws MorseError when the text is no such colour.
  explicit Paint_t(const std::string& color) : color_(FromText(color)) {}
  template <class Alpha>
  Paint_t(const std::string& color, Alpha alpha) : color_(FromText(color)) {
    SetAlpha(alpha);
  }

  const Color_t& color() const { return color_; }
  double alpha() const { return alpha_; }  ///< 0..1

 private:
  template <class Alpha>
  void SetAlpha(Alpha alpha) {
    static_assert(std::is_arithmetic_v<Alpha>, "alpha is a number");
    const double part = std::is_floating_point_v<Alpha> ? static_cast<double>(alpha)
                                                        : static_cast<double>(alpha) / 255;
    alpha_ = part > 0.0 ? (part < 1.0 ? part : 1.0) : 0.0;
  }
  static Color_t FromBytes(int r, int g, int b);
  static Color_t FromDecimals(double r, double g, double b);
  static Color_t FromText(const std::string& text);

  Color_t color_;
  double alpha_ = 1.0;
};

}  // namespace CCMorse
