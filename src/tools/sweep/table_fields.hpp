#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rigid_body_sim {

/// The fields of a line, in place.
void splitFields(std::string_view line, std::vector<std::string_view>& fields);

/// Not a number of a field that is none.
double numberInField(std::string_view field);

/// Whether a run has a result by its status. Throws std::runtime_error, which begins with the
/// place, for a status that no sweep writes.
bool isDone(std::string_view status, const std::string& place);

/// What the fields of a row are.
struct RowForm {
  std::size_t columns = 0, varied = 0, records = 0;  ///< varied: after the first
  std::vector<bool> is_number{};  ///< of the varied ones; empty: any may be a word
};

/// Throws std::runtime_error, which begins with the place, for a row that no sweep writes; returns
/// whether its run has a result.
bool requireForm(const std::vector<std::string_view>& fields, const RowForm& form,
                 const std::string& place);

}  // namespace rigid_body_sim
