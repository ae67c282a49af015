#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace vesica {

/// Where in the user's input something stands. Line and column count from 1; 0 means unknown.
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;
};

/// The user's input is wrong: exit status 2. The message reads
/// `FILE:LINE:COLUMN: path.key is VALUE; expected ...; try ...`.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;

    InputError(const SourcePlace& place, const std::string& message)
        : std::runtime_error(prefix(place) + message) {}

private:
    static std::string prefix(const SourcePlace& place) {
        if (place.file.empty())
            return {};
        std::string text = place.file + ":";
        if (place.line > 0)
            text += std::to_string(place.line) + ":" + std::to_string(place.column) + ":";
        return text + " ";
    }
};

/// The run failed although the input was right (instability, a full disk): exit status 1.
class RunError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What to tell of anything that went wrong.
inline std::string words_of(const std::exception& error) {
    const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    return memory ? "not enough memory" : error.what();
}

} // namespace vesica
