#include "core/input_error.hpp"
#include "io/mesh_file.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

using namespace vesica;

namespace {

/// A file that goes away with its owner.
class ScratchFile {
public:
    ScratchFile(const std::string& name, const std::string& contents)
        : path_(std::filesystem::temp_directory_path() /
                ("vesica_mesh_file_test_" + std::to_string(::getpid()) + "_" + name)) {
        std::ofstream(path_, std::ios::binary) << contents;
    }
    ~ScratchFile() { std::filesystem::remove(path_); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

template <class T>
std::string bytes(T value, std::endian order) {
    std::string raw(sizeof(T), '\0');
    std::memcpy(raw.data(), &value, sizeof(T));
    return order == std::endian::native ? raw : std::string(raw.rbegin(), raw.rend());
}

const Vec3<double> points[4] = {{0.0, 0.0, 0.0}, {1.5, 0.0, 0.0}, {0.0, 2.25, 0.0}, {0.0, 0.0, -3.0}};
const std::array<int, 3> faces[4] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};

std::string text_stl() {
    std::string text = "solid a tetrahedron\n";
    for (const auto& face : faces) {
        text += " facet normal nan 0 0\n  outer loop\n";
        for (const int i : face)
            text += "   vertex " + std::to_string(points[i].x) + " " + std::to_string(points[i].y) + " " +
                    std::to_string(points[i].z) + "\n";
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid a tetrahedron\n";
}

std::string binary_stl() {
    const auto little = std::endian::little;
    std::string text = "solid in name only";
    text.resize(80, ' ');
    text += bytes<std::uint32_t>(4, little);
    for (const auto& face : faces) {
        text += std::string(12, '\0');
        for (const int i : face)
            for (int k = 0; k < 3; ++k)
                text += bytes(static_cast<float>(points[i][k]), little);
        text += std::string(2, '\0');
    }
    return text;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty double y\nproperty "
           "uchar red\n"
           "property float z\nelement face 4\nproperty list uchar int vertex_indices\nproperty ushort "
           "mark\nend_header\n";
}

std::string text_ply() {
    std::string text = ply_header("ascii");
    for (const Vec3<double>& p : points)
        text += std::to_string(p.x) + " " + std::to_string(p.y) + " 7 " + std::to_string(p.z) + "\n";
    for (const auto& f : faces)
        text +=
            "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + " 9\n";
    return text;
}

std::string binary_ply(std::endian order) {
    std::string text = ply_header(order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
    for (const Vec3<double>& p : points)
        text += bytes(static_cast<float>(p.x), order) + bytes(p.y, order) + bytes<std::uint8_t>(7, order) +
                bytes(static_cast<float>(p.z), order);
    for (const auto& f : faces) {
        text += bytes<std::uint8_t>(3, order);
        for (const int i : f)
            text += bytes<std::int32_t>(i, order);
        text += bytes<std::uint16_t>(9, order);
    }
    return text;
}

std::string message_for(const std::string& name, const std::string& contents) {
    const ScratchFile file(name, contents);
    try {
        read_triangle_mesh(file.path());
    } catch (const InputError& error) {
        const std::string text = error.what();
        REQUIRE(text.starts_with(file.path().string() + ":"));
        return text.substr(file.path().string().size() + 1);
    }
    return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("The same tetrahedron is read from every format, with its vertices merged") {
    int files = 0;
    for (const std::string& contents :
         {text_stl(), binary_stl(), text_ply(), binary_ply(std::endian::little), binary_ply(std::endian::big),
          replaced(text_ply(), "ply\n", "ply\r\n")}) {
        const ScratchFile file("format" + std::to_string(files++), contents);
        const TriangleMesh mesh = read_triangle_mesh(file.path());
        CHECK(mesh.source == file.path().string());
        REQUIRE(mesh.vertices.size() == 4);
        REQUIRE(mesh.triangles.size() == 4);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                CHECK(mesh.vertices[static_cast<std::size_t>(mesh.triangles[i][k])] == points[faces[i][k]]);
    }
}

TEST_CASE("A face with four corners becomes two triangles, a vertex without a face goes") {
    const ScratchFile file(
        "quad", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar uint vertex_index\nend_header\n"
                "9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 1 2 3 4\n");
    const TriangleMesh mesh = read_triangle_mesh(file.path());
    CHECK(mesh.vertices.size() == 4);
    CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("Files that are not there or not meshes are refused") {
    CHECK_THROWS_WITH(
        read_triangle_mesh("no/such/cell.stl"),
        "no/such/cell.stl: the mesh file does not exist; expected an STL or PLY file; try a path relative to "
        "the case file's folder or an absolute one");
    CHECK_THROWS_WITH(read_triangle_mesh(std::filesystem::temp_directory_path()),
                      Catch::EndsWith(": this is not a file; expected an STL or PLY file"));
    CHECK(message_for("short", "hello") == " the file has 5 bytes and is neither PLY nor text STL; expected "
                                           "at least 84 for binary STL; export the mesh "
                                           "as STL or PLY");
    CHECK(message_for("noise", std::string(200, '~')) ==
          " the file is neither PLY nor text STL, and as binary STL it would have 2122219134 triangles; "
          "expected at most "
          "10000000; export the mesh as STL or PLY");
    CHECK(message_for("empty", std::string(84, '\0')) ==
          " the file holds no triangles; expected a closed surface");
}

TEST_CASE("Files that are cut short are refused") {
    CHECK(message_for("cut_binary", binary_stl().substr(0, 200)) ==
          " the file has 200 bytes; expected 284 for the 4 triangles that its header announces; it may be "
          "cut short, or no "
          "STL file: export the mesh anew");
    CHECK(message_for("cut_text", text_stl().substr(0, text_stl().find("endsolid"))) ==
          "30:1: the file ends; expected \"facet\" or \"endsolid\"; export the mesh anew as STL");
    CHECK(message_for("cut_ply",
                      binary_ply(std::endian::big).substr(0, ply_header("binary_big_endian").size() + 40)) ==
          " the file ends in vertex 2 of 4; it is cut short; export the mesh anew as PLY or STL");
    CHECK(message_for("cut_header", "ply\nformat ascii 1.0\n") ==
          "3:1: the header does not end; expected \"end_header\"; export the mesh anew as PLY or STL");
}

TEST_CASE("Wrong words and numbers are refused with their line") {
    CHECK(message_for("word", replaced(text_stl(), "endloop", "vertex")) ==
          "7:1: found \"vertex\"; expected \"endloop\"; export the mesh anew as STL");
    CHECK(message_for("number", replaced(text_stl(), "1.500000", "1,5")) ==
          "5:1: found \"1,5\"; expected a number; export the mesh anew as STL");
    CHECK(message_for("infinite", replaced(text_stl(), "1.500000", "inf")) ==
          " vertex 1 is (inf, 0, 0); expected finite numbers; export the mesh anew");
    CHECK(message_for("ply_number", replaced(text_ply(), "1.500000", "1,5")) ==
          "14:1: vertex 1 has \"1,5\"; expected a number; export the mesh anew as PLY or STL");
    CHECK(message_for("ply_format", replaced(text_ply(), "ascii", "xml")) ==
          "2:1: the format is \"xml\"; expected ascii, binary_little_endian or binary_big_endian; export the "
          "mesh anew as "
          "PLY or STL");
    CHECK(message_for("ply_type", replaced(text_ply(), "property float x", "property quad x")) ==
          "5:1: the property type \"quad\" is unknown; expected char, uchar, short, ushort, int, uint, float "
          "or double; "
          "export the mesh anew as PLY or STL");
    CHECK(message_for("ply_count", replaced(text_ply(), "vertex 4", "vertex 4e9")) ==
          "4:1: the element \"vertex\" has the count \"4e9\"; expected 0 to 30000000; export the mesh anew "
          "as PLY or STL");
    CHECK(message_for("ply_keyword", replaced(text_ply(), "comment", "remark")) ==
          "3:1: the header has \"remark\"; expected format, element, property, comment or end_header; export "
          "the mesh anew "
          "as PLY or STL");
    CHECK(message_for("ply_no_z", replaced(text_ply(), "float z", "float w")) ==
          " vertices lack one of the properties x, y, z; export the mesh anew as PLY or STL");
    CHECK(message_for("ply_index", replaced(text_ply(), "3 1 3 2", "3 1 4 2")) ==
          " face 3 has the vertex 4; expected 0 to 3; export the mesh anew as PLY or STL");
    CHECK(message_for("ply_no_faces", replaced(text_ply(), "element face", "element edge")) ==
          " the file holds no faces; expected a closed surface; export the mesh anew as PLY or STL");
}
