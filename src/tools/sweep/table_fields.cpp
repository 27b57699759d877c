#include "tools/sweep/table_fields.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

[[noreturn]] void failForm(const std::string& place, const std::string& rule,
                           std::string_view field) {
  throw std::runtime_error(place + ": " + rule + ", got '" +
                           printable(std::string(field.substr(0, 80))) +
                           "'; somebody has changed the table: remove it, and make its runs anew");
}

}  // namespace

void splitFields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(',', begin);
    fields.push_back(line.substr(begin, end - begin));
    if (end == std::string_view::npos) return;
    begin = end + 1;
  }
}

double numberInField(std::string_view field) {
  double x = 0;
  const bool is_number = readNumberText(field.data(), field.data() + field.size(), x);
  return is_number && std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN();
}

bool isDone(std::string_view status, const std::string& place) {
  if (status == "done") return true;
  if (status.rfind("refused: ", 0) == 0 || status.rfind("diverged: ", 0) == 0) return false;
  failForm(place, "status must be done, refused: or diverged: with why", status);
}

bool requireForm(const std::vector<std::string_view>& fields, const RowForm& form,
                 const std::string& place) {
  if (fields.size() != form.columns)
    failForm(place, "must have " + std::to_string(form.columns) + " fields",
             std::to_string(fields.size()));
  const bool is_done = isDone(fields.back(), place);
  constexpr std::size_t kErrors = 2;
  const std::size_t results = form.varied + 1, end = form.columns - 1;
  const auto fieldName = [](std::size_t i) { return "field " + std::to_string(i + 1); };
  for (std::size_t i = 1; i < end; ++i) {
    const bool is_result = i >= results;
    if (is_result && !is_done && !fields[i].empty())
      failForm(place, fieldName(i) + " must be empty, as the run has no result", fields[i]);
    const bool may_be_empty = is_result && (!is_done || i + kErrors + form.records >= end);
    const bool may_be_word = !is_result && (form.is_number.empty() || !form.is_number[i - 1]);
    if (may_be_word || (may_be_empty && fields[i].empty())) continue;
    if (std::isnan(numberInField(fields[i])))
      failForm(place, fieldName(i) + " must be a number", fields[i]);
  }
  return is_done;
}

}  // namespace rigid_body_sim
