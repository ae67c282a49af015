#include "simulation/run_case_text.hpp"

#include "core/input_error.hpp"
#include "io/case_file.hpp"

#include <string_view>
#include <vector>

namespace vesica {

namespace {

constexpr std::string_view file_mark = "\n#@ file ";
constexpr std::string_view set_mark = "\n#@ set ";
constexpr std::string_view line_break_mark = "\\n";

/// An override may hold line breaks, a comment may not.
std::string on_one_line(const std::string& text)
{
    std::string line;
    for (const char letter : text) {
        if (letter == '\n')
            line += line_break_mark;
        else if (letter == '\\')
            line += "\\\\";
        else
            line += letter;
    }
    return line;
}

std::string from_one_line(std::string_view line)
{
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] != '\\' || i + 1 == line.size())
            text += line[i];
        else
            text += line[++i] == 'n' ? '\n' : line[i];
    }
    return text;
}

std::string_view line_from(const std::string& text, std::size_t begin)
{
    const std::size_t end = text.find('\n', begin);
    return std::string_view(text).substr(begin, end == std::string::npos ? end : end - begin);
}

} // namespace

std::string case_text_of(const Case& what)
{
    std::string text = what.source_text;
    text += file_mark;
    text += on_one_line(what.source_file);
    for (const std::string& change : what.overrides) {
        text += set_mark;
        text += on_one_line(change);
    }
    return text + "\n";
}

Case case_of_text(const std::string& text)
{
    // The author's own text may hold anything, so the last mark counts.
    const std::size_t end = text.rfind(file_mark);
    if (end == std::string::npos) throw InputError("the checkpoint does not say which case it belongs to");
    const std::string file = from_one_line(line_from(text, end + file_mark.size()));
    std::vector<std::string> overrides;
    for (std::size_t at = text.find(set_mark, end); at != std::string::npos; at = text.find(set_mark, at + 1))
        overrides.push_back(from_one_line(line_from(text, at + set_mark.size())));
    return read_case_text(text.substr(0, end), file, overrides);
}

} // namespace vesica
