#include "io/vti_format.hpp"

#include "core/input_error.hpp"
#include "io/base64.hpp"
#include "io/byte_order.hpp"
#include "io/text_scanner.hpp"
#include "io/xml_tags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace vesica {
namespace {

constexpr std::string_view save_anew = "save it in ParaView as .vti";

/// What the file says before its values.
struct VtiHeader {
    std::string source;
    std::string compressor; ///< empty: none
    std::size_t length_bytes = 4;
    std::array<int, 6> extent{};   ///< the first and last point along x, y, z
    std::vector<XmlTag> arrays;    ///< the scalar ones; the last of their path says where
    std::string appended_encoding; ///< empty: no appended data
    std::string_view appended;     ///< from behind the underscore to the last end tag
};

[[noreturn]] void refuse(const std::string& source, int line, const std::string& message) {
    throw InputError(SourcePlace{source, line, 1}, message);
}

std::string attribute_of(const XmlTag& tag, const std::string& name, const std::string& otherwise) {
    const std::string* value = tag.find(name);
    return value == nullptr ? otherwise : *value;
}

template <class Number>
std::optional<Number> whole_number(std::string_view word) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

std::array<int, 6> extent_of(const XmlTag& tag, const std::string& attribute, const std::string& source) {
    const std::string text = attribute_of(tag, attribute, "");
    TextScanner scanner(text);
    std::array<int, 6> extent{};
    bool good = true;
    for (int& bound : extent) {
        const auto number = whole_number<int>(scanner.word());
        good = good && number && std::abs(*number) < 1'000'000'000;
        bound = number.value_or(0);
    }
    for (std::size_t k = 0; k < 6; k += 2)
        good = good && extent[k] <= extent[k + 1];
    if (!good || !scanner.word().empty())
        refuse(source, tag.line,
               fmt::format("{} is \"{}\"; expected six numbers, the first and last point along x, y, z; {}",
                           attribute, text, save_anew));
    return extent;
}

/// The root: which kind of file, and how its values are written.
void read_root(const XmlTag& tag, VtiHeader& header) {
    const std::string type = attribute_of(tag, "type", "");
    if (tag.name != "VTKFile" || type != "ImageData")
        refuse(header.source, tag.line,
               fmt::format("found <{}{}>; expected <VTKFile type=\"ImageData\">; {}", tag.name,
                           type.empty() ? "" : fmt::format(" type=\"{}\"", type),
                           "in ParaView, Resample To Image makes image data of other kinds"));
    if (const std::string order = attribute_of(tag, "byte_order", "LittleEndian"); order != "LittleEndian")
        refuse(header.source, tag.line,
               fmt::format("byte_order is \"{}\"; expected LittleEndian; {} on a little-endian machine",
                           order, save_anew));
    const std::string length = attribute_of(tag, "header_type", "UInt32");
    if (length != "UInt32" && length != "UInt64")
        refuse(header.source, tag.line,
               fmt::format("header_type is \"{}\"; expected UInt32 or UInt64; {}", length, save_anew));
    header.length_bytes = length == "UInt32" ? 4 : 8;
    header.compressor = attribute_of(tag, "compressor", "");
}

VtiHeader read_header(std::string_view contents, const std::string& source) {
    VtiHeader header;
    header.source = source;
    XmlTags tags(contents, source);
    int pieces = 0;
    std::optional<XmlTag> tag = tags.next();
    if (!tag)
        refuse(source, 0,
               fmt::format("the file is empty; expected <VTKFile type=\"ImageData\">; {}", save_anew));
    read_root(*tag, header);
    const std::vector<std::string> in_file{"VTKFile"}, in_image{"VTKFile", "ImageData"};
    const std::vector<std::string> on_points{"VTKFile", "ImageData", "Piece", "PointData"};
    const std::vector<std::string> on_cells{"VTKFile", "ImageData", "Piece", "CellData"};
    while ((tag = tags.next())) {
        if (tag->name == "ImageData" && tag->path == in_file)
            header.extent = extent_of(*tag, "WholeExtent", source);
        if (tag->name == "Piece" && tag->path == in_image) {
            if (++pieces > 1 || extent_of(*tag, "Extent", source) != header.extent)
                refuse(source, tag->line,
                       fmt::format("the image comes in several pieces; expected one with the WholeExtent; {} "
                                   "in one process",
                                   save_anew));
        }
        if (tag->name == "DataArray" && (tag->path == on_points || tag->path == on_cells) &&
            attribute_of(*tag, "NumberOfComponents", "1") == "1")
            header.arrays.push_back(*tag);
        if (tag->name == "AppendedData" && tag->path == in_file) {
            // What follows the underscore need not be text, let alone XML.
            header.appended_encoding = attribute_of(*tag, "encoding", "base64");
            const std::size_t begin = static_cast<std::size_t>(tag->content.data() - contents.data());
            const std::size_t mark = contents.find('_', begin);
            if (contents.find_first_not_of(" \t\r\n", begin) != mark || mark == std::string_view::npos)
                refuse(source, tag->line,
                       fmt::format("the appended data do not begin with an underscore; {} anew", save_anew));
            const std::size_t end = contents.rfind("</AppendedData");
            if (end == std::string_view::npos || end < mark)
                refuse(source, tag->line,
                       fmt::format("the appended data do not end; expected </AppendedData>; the file may be "
                                   "cut short: {} anew",
                                   save_anew));
            header.appended = contents.substr(mark + 1, end - mark - 1);
            break;
        }
    }
    if (pieces == 0)
        refuse(source, 0, fmt::format("there is no <Piece>; expected one in <ImageData>; {}", save_anew));
    return header;
}

std::string name_of(const XmlTag& array) {
    return attribute_of(array, "Name", "(without a name)");
}

const XmlTag& chosen(const VtiHeader& header, const std::string& name) {
    std::vector<const XmlTag*> found;
    std::vector<std::string> names;
    for (const XmlTag& array : header.arrays) {
        names.push_back(fmt::format("{} ({})", name_of(array), array.path.back()));
        if (name.empty() || name_of(array) == name)
            found.push_back(&array);
    }
    const std::string all = names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
    if (found.empty())
        refuse(header.source, 0,
               name.empty()
                   ? fmt::format("there is no scalar array on points or cells; expected one; {} with "
                                 "an array that is not zero in solid cells",
                                 save_anew)
                   : fmt::format("there is no scalar array \"{}\"; expected one of: {}", name, all));
    if (found.size() > 1)
        refuse(header.source, 0,
               fmt::format("there are several scalar arrays{}: {}; expected one; try {}",
                           name.empty() ? "" : " of that name", all,
                           name.empty() ? "to name the one that marks solid cells" : "to pass fewer arrays"));
    return *found.front();
}

void check_extent(const VtiHeader& header, const XmlTag& array, const Vec3<int>& size) {
    const bool points = array.path.back() == "PointData";
    Vec3<int> count{};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t k = 2 * static_cast<std::size_t>(axis);
        count[axis] = header.extent[k + 1] - header.extent[k] + (points ? 1 : 0);
    }
    if (!(count == size))
        refuse(
            header.source, array.line,
            fmt::format("the array \"{}\" has {} x {} x {} {}; expected {} x {} x {}, one for each cell of "
                        "the lattice; try {}",
                        name_of(array), count.x, count.y, count.z, points ? "points" : "cells", size.x,
                        size.y, size.z,
                        count - size == (points ? Vec3<int>{1, 1, 1} : Vec3<int>{-1, -1, -1})
                            ? (points ? "the values on cells: in ParaView, Point Data to Cell Data"
                                      : "the values on points: in ParaView, Cell Data to Point Data")
                            : "another resolution of the image, or change the lattice's size"));
}

/// Values in the order of the file; each asks for its place k.
template <class ValueAt>
SolidVoxels marked(const Vec3<int>& size, const ValueAt& value_at) {
    SolidVoxels solid(size);
    std::size_t k = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (value_at(k++))
                    solid.set({x, y, z});
    return solid;
}

SolidVoxels from_text(const VtiHeader& header, const XmlTag& array, const Vec3<int>& size) {
    TextScanner scanner(array.content, array.line);
    const auto complain = [&](const std::string& found) {
        refuse(header.source, scanner.line(),
               fmt::format("{}; expected {} x {} x {} numbers in the array \"{}\"; {} anew", found, size.x,
                           size.y, size.z, name_of(array), save_anew));
    };
    SolidVoxels solid = marked(size, [&](std::size_t k) {
        const std::optional<double> value = scanner.number();
        if (!value || std::isnan(*value))
            complain(scanner.last_word().empty()
                         ? fmt::format("the array ends after {} values", k)
                         : fmt::format("value {} is \"{}\"", k, scanner.last_word().substr(0, 40)));
        return *value != 0.0;
    });
    if (!scanner.word().empty())
        complain("the array goes on");
    return solid;
}

/// The bytes of an array's values, after their length was found to be right.
std::string bytes_of(const VtiHeader& header, const XmlTag& array, std::uint64_t expected) {
    const auto complain = [&](const std::string& found) {
        refuse(header.source, array.line,
               fmt::format("{}; expected {} bytes for the array \"{}\"; the file may be cut short: {} anew",
                           found, expected, name_of(array), save_anew));
    };
    const bool appended = attribute_of(array, "format", "") == "appended";
    const bool raw = appended && header.appended_encoding == "raw";
    std::string_view text = array.content;
    if (appended) {
        if (header.appended_encoding != "raw" && header.appended_encoding != "base64")
            complain(header.appended_encoding.empty()
                         ? "there is no <AppendedData>"
                         : fmt::format("the encoding is \"{}\"", header.appended_encoding));
        const std::string offset = attribute_of(array, "offset", "");
        const auto begin = whole_number<std::uint64_t>(offset);
        if (!begin || *begin > header.appended.size())
            complain(fmt::format("the offset is \"{}\"", offset));
        text = header.appended.substr(static_cast<std::size_t>(*begin));
    }
    const auto total = static_cast<std::size_t>(header.length_bytes + expected);
    std::optional<std::string> bytes = raw ? std::string(text.substr(0, total)) : decode_base64(text, total);
    if (!bytes)
        complain("the array is not written in base64");
    if (bytes->size() < header.length_bytes)
        complain("the array is empty");
    const std::uint64_t length = header.length_bytes == 4
                                     ? from_bytes<std::uint32_t>(bytes->data(), std::endian::little)
                                     : from_bytes<std::uint64_t>(bytes->data(), std::endian::little);
    if (length != expected)
        complain(fmt::format("the array says that it has {} bytes", length));
    if (bytes->size() != total)
        complain(fmt::format("the array ends after {} bytes", bytes->size() - header.length_bytes));
    bytes->erase(0, header.length_bytes);
    return std::move(*bytes);
}

template <class Value>
SolidVoxels from_binary(const VtiHeader& header, const XmlTag& array, const Vec3<int>& size) {
    const std::uint64_t cells = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    const std::string bytes = bytes_of(header, array, cells * sizeof(Value));
    return marked(size, [&](std::size_t k) {
        const auto value = from_bytes<Value>(bytes.data() + k * sizeof(Value), std::endian::little);
        if constexpr (std::is_floating_point_v<Value>)
            if (std::isnan(value))
                refuse(header.source, array.line,
                       fmt::format(
                           "value {} of the array \"{}\" is not a number; expected zero in the fluid and "
                           "anything else in solids",
                           k, name_of(array)));
        return value != Value{0};
    });
}

} // namespace

SolidVoxels parse_vti(std::string_view contents, const Vec3<int>& size, const std::string& name,
                      const std::string& source) {
    const VtiHeader header = read_header(contents, source);
    const XmlTag& array = chosen(header, name);
    check_extent(header, array, size);
    using Reader = SolidVoxels (*)(const VtiHeader&, const XmlTag&, const Vec3<int>&);
    constexpr std::pair<std::string_view, Reader> types[] = {
        {"Int8", from_binary<std::int8_t>},   {"UInt8", from_binary<std::uint8_t>},
        {"Int16", from_binary<std::int16_t>}, {"UInt16", from_binary<std::uint16_t>},
        {"Int32", from_binary<std::int32_t>}, {"UInt32", from_binary<std::uint32_t>},
        {"Int64", from_binary<std::int64_t>}, {"UInt64", from_binary<std::uint64_t>},
        {"Float32", from_binary<float>},      {"Float64", from_binary<double>}};
    const std::string type = attribute_of(array, "type", "");
    const std::string format = attribute_of(array, "format", "");
    Reader reader = nullptr;
    for (const auto& [known, its_reader] : types)
        if (known == type)
            reader = its_reader;
    if (reader == nullptr)
        refuse(
            source, array.line,
            fmt::format("the array \"{}\" has the type \"{}\"; expected Int8 to UInt64, Float32 or Float64; "
                        "{} with another type",
                        name_of(array), type, save_anew));
    if (format == "ascii")
        return from_text(header, array, size);
    if (format != "binary" && format != "appended")
        refuse(source, array.line,
               fmt::format("the array \"{}\" has the format \"{}\"; expected ascii, binary or appended; {}",
                           name_of(array), format, save_anew));
    if (!header.compressor.empty())
        refuse(source, 0,
               fmt::format("the values are compressed by {}; expected plain ones; save it in ParaView with "
                           "Compressor Type None",
                           header.compressor));
    return reader(header, array, size);
}

} // namespace vesica
