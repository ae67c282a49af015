#include "io/ply_format.hpp"

#include "core/input_error.hpp"
#include "io/byte_order.hpp"
#include "io/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vesica {
namespace {

constexpr double most_elements = 30'000'000;

enum class Scalar { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

Scalar scalar_named(std::string_view name) {
    if (name == "char" || name == "int8")
        return Scalar::int8;
    if (name == "uchar" || name == "uint8")
        return Scalar::uint8;
    if (name == "short" || name == "int16")
        return Scalar::int16;
    if (name == "ushort" || name == "uint16")
        return Scalar::uint16;
    if (name == "int" || name == "int32")
        return Scalar::int32;
    if (name == "uint" || name == "uint32")
        return Scalar::uint32;
    if (name == "float" || name == "float32")
        return Scalar::float32;
    if (name == "double" || name == "float64")
        return Scalar::float64;
    return Scalar::none;
}

std::size_t size_of(Scalar scalar) {
    constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<int>(scalar)];
}

struct Property {
    std::string name;
    Scalar count = Scalar::none; ///< of a list
    Scalar value = Scalar::none;
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    bool text = false;
    std::endian order = std::endian::little;
    std::vector<Element> elements;
    std::size_t size = 0;
    int lines = 0;
};

class Refusal {
public:
    explicit Refusal(const std::string& source) : source_(source) {}

    [[noreturn]] void operator()(int line, const std::string& message) const {
        throw InputError(SourcePlace{source_, line, line > 0 ? 1 : 0},
                         message + "; export the mesh anew as PLY or STL");
    }

private:
    const std::string& source_;
};

Header parse_header(std::string_view contents, const Refusal& refuse) {
    Header header;
    bool has_format = false;
    std::size_t begin = 0;
    for (int line = 1;; ++line) {
        const std::size_t end = contents.find('\n', begin);
        if (end == std::string_view::npos)
            refuse(line, "the header does not end; expected \"end_header\"");
        TextScanner scanner(contents.substr(begin, end - begin));
        begin = end + 1;
        const std::string_view keyword = scanner.word();
        if (line == 1 || keyword == "comment" || keyword == "obj_info" || keyword.empty())
            continue;
        if (keyword == "end_header") {
            header.size = begin;
            header.lines = line;
            break;
        }
        if (keyword == "format") {
            const std::string_view name = scanner.word();
            if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
                refuse(line, fmt::format("the format is \"{}\"; expected ascii, binary_little_endian or "
                                         "binary_big_endian",
                                         name));
            header.text = name == "ascii";
            header.order = name == "binary_big_endian" ? std::endian::big : std::endian::little;
            has_format = true;
        } else if (keyword == "element") {
            const std::string name(scanner.word());
            const std::optional<double> count = scanner.number();
            if (!count || *count < 0.0 || *count > most_elements)
                refuse(line, fmt::format("the element \"{}\" has the count \"{}\"; expected 0 to {:.0f}",
                                         name, scanner.last_word(), most_elements));
            header.elements.push_back({name, static_cast<std::size_t>(*count), {}});
        } else if (keyword == "property" && !header.elements.empty()) {
            Property property;
            std::string_view type = scanner.word();
            if (type == "list") {
                property.count = scalar_named(scanner.word());
                type = scanner.word();
                if (property.count == Scalar::none || size_of(property.count) > 4 ||
                    property.count == Scalar::float32)
                    refuse(line, "a list's count has no integer type");
            }
            property.value = scalar_named(type);
            if (property.value == Scalar::none)
                refuse(line,
                       fmt::format(
                           "the property type \"{}\" is unknown; expected char, uchar, short, ushort, int, "
                           "uint, float or double",
                           type));
            property.name = scanner.word();
            header.elements.back().properties.push_back(property);
        } else
            refuse(line,
                   fmt::format(
                       "the header has \"{}\"; expected format, element, property, comment or end_header",
                       keyword.substr(0, 40)));
    }
    if (!has_format)
        refuse(2, "the header has no format; expected \"format ascii 1.0\" or a binary one");
    return header;
}

/// The numbers after the header, one after the other, whatever their encoding.
class Body {
public:
    Body(std::string_view contents, const Header& header, const Refusal& refuse)
        : bytes_(contents.substr(header.size)),
          text_(bytes_, header.lines + 1),
          is_text_(header.text),
          order_(header.order),
          refuse_(refuse) {}

    double number(Scalar type, const Element& element, std::size_t index) {
        if (is_text_) {
            const std::optional<double> value = text_.number();
            if (!value && text_.last_word().empty())
                refuse_ends(element, index);
            if (!value)
                refuse_(text_.line(), fmt::format("{} {} has \"{}\"; expected a number", element.name, index,
                                                  text_.last_word().substr(0, 40)));
            return *value;
        }
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size)
            refuse_ends(element, index);
        const char* p = bytes_.data() + at_;
        at_ += size;
        switch (type) {
        case Scalar::int8:
            return from_bytes<std::int8_t>(p, order_);
        case Scalar::uint8:
            return from_bytes<std::uint8_t>(p, order_);
        case Scalar::int16:
            return from_bytes<std::int16_t>(p, order_);
        case Scalar::uint16:
            return from_bytes<std::uint16_t>(p, order_);
        case Scalar::int32:
            return from_bytes<std::int32_t>(p, order_);
        case Scalar::uint32:
            return from_bytes<std::uint32_t>(p, order_);
        case Scalar::float32:
            return static_cast<double>(from_bytes<float>(p, order_));
        case Scalar::float64:
            return from_bytes<double>(p, order_);
        case Scalar::none:
            break;
        }
        return 0.0;
    }

private:
    [[noreturn]] void refuse_ends(const Element& element, std::size_t index) const {
        refuse_(0, fmt::format("the file ends in {} {} of {}; it is cut short", element.name, index,
                               element.count));
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    TextScanner text_;
    bool is_text_;
    std::endian order_;
    const Refusal& refuse_;
};

void add_fan(TriangleMesh& mesh, const std::vector<double>& corners, std::size_t face,
             const Refusal& refuse) {
    if (corners.size() < 3)
        refuse(0, fmt::format("face {} has {} corners; expected at least 3", face, corners.size()));
    for (const double corner : corners)
        if (!(corner >= 0.0 && corner < static_cast<double>(mesh.vertices.size())))
            refuse(0, fmt::format("face {} has the vertex {}; expected 0 to {}", face, corner,
                                  static_cast<double>(mesh.vertices.size()) - 1.0));
    for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back(
            {static_cast<int>(corners[0]), static_cast<int>(corners[k - 1]), static_cast<int>(corners[k])});
}

} // namespace

bool is_ply(std::string_view contents) {
    return contents.starts_with("ply\n") || contents.starts_with("ply\r\n");
}

TriangleMesh parse_ply(std::string_view contents, const std::string& source) {
    const Refusal refuse(source);
    const Header header = parse_header(contents, refuse);
    Body body(contents, header, refuse);
    TriangleMesh mesh;
    mesh.source = source;
    const auto has = [](const Element& element, std::string_view name) {
        return std::any_of(element.properties.begin(), element.properties.end(),
                           [&](const Property& p) { return p.name == name; });
    };
    for (const Element& element : header.elements) {
        const bool vertices = element.name == "vertex", faces = element.name == "face";
        if (vertices && !(has(element, "x") && has(element, "y") && has(element, "z")))
            refuse(0, "vertices lack one of the properties x, y, z");
        if (faces && !has(element, "vertex_indices") && !has(element, "vertex_index"))
            refuse(0, "faces lack the property vertex_indices");
        for (std::size_t i = 0; i < element.count; ++i) {
            Vec3<double> vertex{};
            for (const Property& property : element.properties) {
                if (property.count == Scalar::none) {
                    const double value = body.number(property.value, element, i);
                    if (property.name == "x")
                        vertex.x = value;
                    if (property.name == "y")
                        vertex.y = value;
                    if (property.name == "z")
                        vertex.z = value;
                    continue;
                }
                const double count = body.number(property.count, element, i);
                if (!(count >= 0.0 && count <= 1000.0))
                    refuse(0, fmt::format("{} {} has a list of {} entries; expected at most 1000",
                                          element.name, i, count));
                std::vector<double> list;
                for (int k = 0; k < static_cast<int>(count); ++k)
                    list.push_back(body.number(property.value, element, i));
                if (faces && (property.name == "vertex_indices" || property.name == "vertex_index"))
                    add_fan(mesh, list, i, refuse);
            }
            if (vertices)
                mesh.vertices.push_back(vertex);
        }
    }
    if (mesh.triangles.empty())
        refuse(0, "the file holds no faces; expected a closed surface");
    return mesh;
}

} // namespace vesica
