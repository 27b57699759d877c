#pragma once

#include <locale.h>

namespace rigid_body_sim {

/// The locale in which numbers are read: with a decimal point, whatever the user's is.
inline locale_t classicLocale() {
  static const locale_t classic = newlocale(LC_ALL_MASK, "C", locale_t());
  return classic;
}

}  // namespace rigid_body_sim
