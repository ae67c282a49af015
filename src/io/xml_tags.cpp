#include "io/xml_tags.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vesica {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == ':';
}

/// The character that a reference such as `&lt;` stands for; 0 if unknown.
char referenced(std::string_view name) {
    constexpr std::pair<std::string_view, char> known[] = {
        {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
    for (const auto& [word, character] : known)
        if (word == name)
            return character;
    return 0;
}

} // namespace

const std::string* XmlTag::find(const std::string& attribute) const {
    const auto place = attributes.find(attribute);
    return place == attributes.end() ? nullptr : &place->second;
}

XmlTags::XmlTags(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {
    skip("\xEF\xBB\xBF"); // the mark of UTF-8
}

std::optional<XmlTag> XmlTags::next() {
    for (;;) {
        const std::size_t tag = text_.find('<', at_);
        if (open_.empty()) { // before or behind the root
            skip_space();
            if (at_ < std::min(tag, text_.size()))
                refuse("text outside of all elements", "<VTKFile ...>");
        }
        if (tag == std::string_view::npos) {
            at_ = text_.size();
            if (!open_.empty())
                refuse("the end of the file", fmt::format("</{}>", open_.back()));
            return std::nullopt;
        }
        at_ = tag;
        if (skip("<!--"))
            skip_behind("-->", "comment");
        else if (skip("<?"))
            skip_behind("?>", "declaration");
        else if (skip("</"))
            close();
        else
            break;
    }
    XmlTag tag;
    tag.line = line_at(at_);
    tag.path = open_;
    ++at_;
    tag.name = read_name();
    for (;;) {
        skip_space();
        if (skip("/>")) {
            tag.content = text_.substr(at_, 0);
            return tag;
        }
        if (skip(">"))
            break;
        std::string attribute = read_name();
        skip_space();
        if (!skip("="))
            refuse(fmt::format("the attribute {} without a value", attribute), "=\"...\"");
        skip_space();
        std::string value = read_value();
        if (!tag.attributes.try_emplace(attribute, std::move(value)).second)
            refuse(fmt::format("the attribute {} twice", attribute), "it once");
    }
    open_.push_back(tag.name);
    tag.content = text_.substr(at_, std::min(text_.find('<', at_), text_.size()) - at_);
    return tag;
}

void XmlTags::refuse(const std::string& found, const std::string& expected) const {
    throw InputError(
        SourcePlace{source_, line_at(at_), 1},
        fmt::format("found {}; expected {}; the file may be damaged: write it anew", found, expected));
}

int XmlTags::line_at(std::size_t position) const {
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(position), '\n'));
}

bool XmlTags::skip(std::string_view word) {
    const bool here = text_.substr(at_).starts_with(word);
    if (here)
        at_ += word.size();
    return here;
}

void XmlTags::skip_space() {
    while (at_ < text_.size() && is_space(text_[at_]))
        ++at_;
}

void XmlTags::skip_behind(std::string_view end, const std::string& what) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos)
        refuse(fmt::format("a {} without end", what), fmt::format("{}", end));
    at_ = found + end.size();
}

std::string XmlTags::read_name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_name(text_[at_]))
        ++at_;
    if (at_ == begin)
        refuse(at_ < text_.size() ? "a character that begins no name" : "the end of the file",
               "the name of an element or attribute");
    return std::string(text_.substr(begin, at_ - begin));
}

std::string XmlTags::read_value() {
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'')
        refuse("an attribute without quotes", "=\"...\"");
    const std::size_t end = text_.find(quote, at_ + 1);
    const std::string_view raw = text_.substr(at_ + 1, std::min(end, text_.size()) - at_ - 1);
    if (end == std::string_view::npos || raw.find('<') != std::string_view::npos)
        refuse("an attribute whose quotes do not close", fmt::format("{}", quote));
    std::string value;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '&') {
            value += raw[i];
            continue;
        }
        const std::size_t stop = std::min(raw.find(';', i), raw.size());
        const char character = referenced(raw.substr(i + 1, stop - i - 1));
        if (character == 0)
            refuse(fmt::format("the reference {}", raw.substr(i, std::min<std::size_t>(stop - i + 1, 20))),
                   "&lt; &gt; &amp; &quot; or &apos;");
        value += character;
        i = stop;
    }
    at_ = end + 1;
    return value;
}

void XmlTags::close() {
    const std::string name = read_name();
    skip_space();
    if (open_.empty() || name != open_.back() || !skip(">"))
        refuse(fmt::format("</{}", name),
               open_.empty() ? "no more tags" : fmt::format("</{}>", open_.back()));
    open_.pop_back();
}

} // namespace vesica
