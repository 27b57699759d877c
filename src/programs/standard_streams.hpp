#pragma once

#include <cstdio>
#include <string>

namespace rigid_body_sim {

/// Occupies the descriptors of standard input, output and error where the program was started
/// without them: else the next file opened takes the number, and messages are written into it. What
/// is then written to standard output fails, and requireWritten reports it. To be called first in
/// main; ends the program where /dev/null cannot be opened.
void reserveStandardStreams();

/// Makes a write beyond the size that a file may have (`ulimit -f`) fail, as one on a full disk
/// does, where it would end the process without a word.
void failBeyondFileSize();

/// Throws std::runtime_error where what was written to a stream does not get there. name: as the
/// message calls it.
void requireWritten(std::FILE* stream, const std::string& name = "standard output");

/// Whether the program was started with the stream.
bool isOpen(std::FILE* stream);

/// Writes a text to standard output, to its end. Throws std::runtime_error.
void print(const std::string& text);

}  // namespace rigid_body_sim
