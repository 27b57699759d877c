#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace rigid_body_sim {

/// Whether a file of a run is a bag (.bag); any other is a CSV file of simulate.
bool isBag(const std::string& path);

/// A row of a CSV file of simulate: the fields time, body (where the file has it) and the others.
struct CsvRow {
  double time = 0;  ///< [s]
  std::string body;
  std::vector<double> numbers;
};

/// Reads a line, which may end as those of Windows do. False where there is none.
bool readCsvLine(std::istream& file, std::string& line);

/// Reads the rows that follow the header, which has been read already. A last line without an end
/// has been cut, perhaps within a number, and is left out; returns what to say of it, one line,
/// empty where there is none. Throws std::runtime_error, one line that begins with the line's
/// number, for another row of another number of fields, a number that is not finite, and what
/// `take` throws.
[[nodiscard]] std::string readCsvRows(std::istream& file, const std::string& header,
                                      const std::function<void(const CsvRow&)>& take);

}  // namespace rigid_body_sim
