#include "io/surface_reader.hpp"

#include "core/input_error.hpp"
#include "io/byte_order.hpp"
#include "io/posix_file.hpp"
#include "io/xml_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace vesica {
namespace {

/// The arrays of one file. Only what Vesica writes need be understood: one piece, raw appended data, lengths
/// in eight bytes.
class SurfaceContent {
public:
    SurfaceContent(const std::filesystem::path& path, std::string_view bytes) : path_(path) {
        XmlTags tags(bytes, path.string());
        while (const std::optional<XmlTag> tag = tags.next()) {
            if (tag->path.empty() && (tag->name != "VTKFile" || attribute(*tag, "type") != "PolyData" ||
                                      attribute(*tag, "header_type") != "UInt64"))
                refuse("this is no VTK PolyData");
            if (tag->name == "DataArray" && !tag->path.empty())
                arrays_.emplace_back(tag->path.back(), *tag);
            if (tag->name != "AppendedData")
                continue;
            const std::size_t mark =
                bytes.find('_', static_cast<std::size_t>(tag->content.data() - bytes.data()));
            if (mark != std::string_view::npos)
                appended_ = bytes.substr(mark + 1);
            break; // what follows is not text
        }
    }

    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(fmt::format("{}: {}; expected a surface that Vesica wrote; it may be cut short",
                                     path_.string(), what));
    }

    /// All values of an array; its type is Value's.
    template <class Value>
    std::vector<Value> values(std::string_view where, std::string_view name) const {
        const std::string_view bytes = data_of(tag_of(where, name));
        std::vector<Value> all(bytes.size() / sizeof(Value));
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = from_bytes<Value>(bytes.data() + i * sizeof(Value), std::endian::little);
        return all;
    }

    struct Named {
        std::string name;
        int components = 1;
    };
    std::vector<Named> point_quantities() const {
        std::vector<Named> found;
        for (const auto& [where, tag] : arrays_)
            if (where == "PointData")
                found.push_back(
                    {attribute(tag, "Name"), attribute(tag, "NumberOfComponents") == "3" ? 3 : 1});
        return found;
    }

private:
    static std::string attribute(const XmlTag& tag, const char* name) {
        const std::string* value = tag.find(name);
        return value == nullptr ? std::string{} : *value;
    }

    const XmlTag& tag_of(std::string_view where, std::string_view name) const {
        for (const auto& [place, tag] : arrays_)
            if (place == where && attribute(tag, "Name") == name)
                return tag;
        refuse(fmt::format("there is no array {} in {}", name, where));
    }

    std::string_view data_of(const XmlTag& tag) const {
        const std::string text = attribute(tag, "offset");
        std::size_t offset = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
        if (error != std::errc{} || end != text.data() + text.size() || appended_.size() < 8 ||
            offset > appended_.size() - 8)
            refuse(fmt::format("the array {} is not there", attribute(tag, "Name")));
        const auto length = from_bytes<std::uint64_t>(appended_.data() + offset, std::endian::little);
        if (length > appended_.size() - offset - 8)
            refuse(fmt::format("the array {} is not complete", attribute(tag, "Name")));
        return appended_.substr(offset + 8, static_cast<std::size_t>(length));
    }

    std::filesystem::path path_;
    std::vector<std::pair<std::string, XmlTag>> arrays_;
    std::string_view appended_;
};

/// The vesicles' triangles, sorted out of the one piece; each surface counts its own points.
class SurfaceSorter {
public:
    SurfaceSorter(const SurfaceContent& content)
        : content_(content),
          points_(content.values<float>("Points", "Points")),
          quantities_(content.point_quantities()),
          place_(points_.size() / 3, {-1, -1}) {
        for (const auto& quantity : quantities_) {
            values_.push_back(content.values<float>("PointData", quantity.name));
            if (values_.back().size() != place_.size() * static_cast<std::size_t>(quantity.components))
                content.refuse(fmt::format("the array {} has another number of points", quantity.name));
        }
    }

    std::vector<SurfaceArrays> sorted() {
        const auto corners = content_.values<std::int64_t>("Polys", "connectivity");
        const auto vesicles = content_.values<std::int32_t>("CellData", "vesicle");
        const auto ends = content_.values<std::int64_t>("Polys", "offsets");
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (ends[i] != static_cast<std::int64_t>(3 * (i + 1)))
                content_.refuse("not all faces are triangles");
        if (ends.size() != vesicles.size() || corners.size() != 3 * vesicles.size())
            content_.refuse("its arrays do not have the same number of triangles");
        for (std::size_t i = 0; i < vesicles.size(); ++i) {
            SurfaceArrays& surface = surface_of(vesicles[i]);
            std::array<std::int32_t, 3> triangle{};
            for (std::size_t k = 0; k < 3; ++k)
                triangle[k] = own_point(surface, corners[3 * i + k]);
            surface.triangles.push_back(triangle);
        }
        std::vector<SurfaceArrays> surfaces;
        for (auto& [vesicle, surface] : surfaces_)
            surfaces.push_back(std::move(surface));
        return surfaces;
    }

private:
    SurfaceArrays& surface_of(std::int32_t vesicle) {
        const auto [found, is_new] = surfaces_.try_emplace(vesicle);
        if (is_new) {
            found->second.vesicle = vesicle;
            for (const auto& quantity : quantities_)
                found->second.quantities.push_back({quantity.name, quantity.components, {}});
        }
        return found->second;
    }

    std::int32_t own_point(SurfaceArrays& surface, std::int64_t corner) {
        if (corner < 0 || static_cast<std::size_t>(corner) >= place_.size())
            content_.refuse("a triangle has a corner that does not exist");
        const auto point = static_cast<std::size_t>(corner);
        auto& [vesicle, index] = place_[point];
        if (vesicle == surface.vesicle)
            return index;
        vesicle = surface.vesicle;
        index = static_cast<std::int32_t>(surface.points.size());
        const float* at = points_.data() + 3 * point;
        surface.points.push_back({at[0], at[1], at[2]});
        for (std::size_t q = 0; q < quantities_.size(); ++q) {
            const auto components = static_cast<std::size_t>(quantities_[q].components);
            const float* value = values_[q].data() + components * point;
            surface.quantities[q].values.insert(surface.quantities[q].values.end(), value,
                                                value + components);
        }
        return index;
    }

    const SurfaceContent& content_;
    std::vector<float> points_;
    std::vector<SurfaceContent::Named> quantities_;
    std::vector<std::vector<float>> values_;
    std::vector<std::pair<std::int32_t, std::int32_t>> place_; ///< of each point: vesicle, and index there
    std::map<std::int32_t, SurfaceArrays> surfaces_;
};

} // namespace

SurfaceStep read_surface_file(const std::filesystem::path& path) {
    const std::string bytes = read_whole_file(path);
    const SurfaceContent content(path, bytes);
    const auto times = content.values<double>("FieldData", "TimeValue");
    const auto steps = content.values<std::int64_t>("FieldData", "step");
    if (times.size() != 1 || steps.size() != 1)
        content.refuse("it does not say of which step it is");
    return {steps.front(), times.front(), SurfaceSorter(content).sorted()};
}

} // namespace vesica
