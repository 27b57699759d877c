#include "tools/common/csv_rows.hpp"

#include <cmath>
#include <istream>
#include <sstream>
#include <stdexcept>

#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

double finiteNumber(const std::string& field) {
  double number = 0;
  if (!readNumberText(field.data(), field.data() + field.size(), number) || !std::isfinite(number))
    throw std::runtime_error("a finite number is expected, got '" + printable(field) + "'");
  return number;
}

CsvRow rowOf(const std::string& line, std::size_t count, bool has_body) {
  const std::vector<std::string> fields = fieldsOf(line);
  if (fields.size() != count)
    throw std::runtime_error(std::to_string(count) + " fields are expected, got " +
                             std::to_string(fields.size()));
  CsvRow row;
  row.time = finiteNumber(fields[0]);
  if (has_body) row.body = fields[1];
  for (std::size_t i = has_body ? 2 : 1; i < count; ++i)
    row.numbers.push_back(finiteNumber(fields[i]));
  return row;
}

}  // namespace

bool isBag(const std::string& path) {
  const std::string extension = ".bag";
  return path.size() >= extension.size() &&
         path.compare(path.size() - extension.size(), extension.size(), extension) == 0;
}

bool readCsvLine(std::istream& file, std::string& line) {
  if (!std::getline(file, line)) return false;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

std::string readCsvRows(std::istream& file, const std::string& header,
                        const std::function<void(const CsvRow&)>& take) {
  const std::vector<std::string> names = fieldsOf(header);
  const bool has_body = names.size() > 1 && names[1] == "body";
  std::string line;
  for (int number = 2; readCsvLine(file, line); ++number) {
    if (file.eof())
      return "line " + std::to_string(number) +
             " does not end: the file was cut there, or is still being written";
    try {
      take(rowOf(line, names.size(), has_body));
    } catch (const std::exception& fault) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + fault.what());
    }
  }
  return "";
}

}  // namespace rigid_body_sim
