#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace vesica::test {

/// What a test has found, beyond its being right: a line of JSON appended to the file that VESICA_MEASURED
/// names; nothing when it names none. `validation/numerics` collects them.
inline void measured(const std::string& law, const std::string& conditions, double value) {
    const char* path = std::getenv("VESICA_MEASURED");
    if (path == nullptr)
        return;
    std::FILE* file = std::fopen(path, "a");
    if (file == nullptr)
        return;
    std::fprintf(file, "{\"law\": \"%s\", \"conditions\": \"%s\", \"value\": %.9g}\n", law.c_str(),
                 conditions.c_str(), value);
    std::fclose(file);
}

} // namespace vesica::test
