#pragma once

#include <string_view>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// How precisely the numbers of a mesh file state its coordinates: by default that of a binary file
/// of single precision; else what the numbers that are added show.
class NumberPrecision {
 public:
  /// word: a number of the file as it is written.
  void add(std::string_view word, double value);

  /// How far [m] two of the file's numbers for one coordinate lie apart at most, where they were
  /// computed on different ways and rounded: 4 ulp of the largest coordinate, which a
  /// transformation (three products and a sum) can leave between them, and in a text one and a half
  /// times the last digit. The ulp is that of single precision, in which nearly all modellers
  /// compute, unless the text has numbers of more than 9 digits that are none of single precision.
  /// The digits are as many as any number of the file has, at least 6, for zeros at the end are
  /// often left out.
  double rounding(const std::vector<Vector3d>& vertices) const;

 private:
  int digits_ = 0;  ///< significant ones; 0: not written in digits
  bool all_single_ = true;
};

}  // namespace rigid_body_sim
