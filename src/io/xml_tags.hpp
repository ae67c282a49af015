#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// A start tag of an XML element.
struct XmlTag {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::vector<std::string> path; ///< the names of the elements around it, outermost first
    std::string_view content;      ///< the text up to the next tag or comment
    int line = 0;                  ///< counted from 1

    /// An attribute's value, or nothing.
    const std::string* find(const std::string& attribute) const;
};

/// Walks over the start tags of an XML document (W3C XML 1.0), as far as VTK's files need them: no document
/// type, no CDATA sections, of references only those to <, >, &, " and '. Throws InputError with the line
/// where it meets something else, or tags that do not match.
class XmlTags {
public:
    /// `text` must outlive it and what it returns. `source` names the file in messages.
    XmlTags(std::string_view text, std::string source);

    /// The next start tag; nothing at the document's end.
    std::optional<XmlTag> next();

private:
    [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;
    int line_at(std::size_t position) const;
    bool skip(std::string_view word);
    void skip_space();
    void skip_behind(std::string_view end, const std::string& what);
    std::string read_name();
    std::string read_value();
    void close();

    std::string_view text_;
    std::string source_;
    std::size_t at_ = 0;
    std::vector<std::string> open_;
};

} // namespace vesica
