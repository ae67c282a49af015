#include "io/base64.hpp"
#include "voxel_samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

using namespace voxel_samples;

namespace {

/// A number before its bytes, as VTK has it.
template <class Length>
std::string counted(const std::string& bytes) {
    const auto length = static_cast<Length>(bytes.size());
    return std::string(reinterpret_cast<const char*>(&length), sizeof(length)) + bytes;
}

std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= left ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

/// A file of image data with one array on the cells, or what `more` and `appended` make of it.
std::string vti(const std::string& attributes, const std::string& array, const std::string& appended = "",
                const std::string& place = "CellData", const std::string& extent = "0 5 0 4 0 3") {
    return "<?xml version=\"1.0\"?>\n<!-- a sample -->\n<VTKFile type=\"ImageData\" version=\"1.0\" " +
           attributes + ">\n  <ImageData WholeExtent=\"" + extent +
           "\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n  <FieldData><DataArray type=\"Float64\" Name=\"time\" "
           "NumberOfTuples=\"1\" format=\"ascii\">0.5</DataArray></FieldData>\n  <Piece Extent=\"" +
           extent + "\">\n    <" + place + ">\n" + array + "    </" + place + ">\n" + "  </Piece>\n" +
           "  </ImageData>\n" + appended + "</VTKFile>\n";
}

const std::string little32 = "byte_order=\"LittleEndian\" header_type=\"UInt32\"";
const std::string little64 = "byte_order=\"LittleEndian\" header_type=\"UInt64\"";

std::string array_tag(const std::string& type, const std::string& format, const std::string& content) {
    return "<DataArray type=\"" + type + "\" Name=\"solid\" format=\"" + format + "\" RangeMin=\"0\">" +
           content + "</DataArray>\n";
}

std::string text_of_values() {
    std::string text;
    for (const int value : values_of(1))
        text += std::to_string(value) + "\n ";
    return text;
}

std::string sample_vti() {
    return vti(little32, array_tag("UInt8", "ascii", text_of_values()));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEMPLATE_TEST_CASE("Every type of VTK is read in every format", "", std::int8_t, std::uint8_t, std::int16_t,
                   std::uint16_t, std::int32_t, std::uint32_t, std::int64_t, std::uint64_t, float, double) {
    constexpr bool is_real = std::is_floating_point_v<TestType>;
    const std::string type = fmt::format("{}{}",
                                         is_real                      ? "Float"
                                         : std::is_signed_v<TestType> ? "Int"
                                                                      : "UInt",
                                         8 * sizeof(TestType));
    // Only in the highest byte of integers is there anything.
    const auto value = static_cast<TestType>(
        is_real ? TestType(0.25) : TestType(std::uint64_t{1} << (8 * sizeof(TestType) - 2)));
    const std::string bytes = bytes_of(values_of(value));

    CHECK(read("a.vti", vti(little32, array_tag(type, "ascii", text_of_values()))) == expected());
    CHECK(read("b.vti", vti(little32, array_tag(type, "binary",
                                                "\n " + base64(counted<std::uint32_t>(bytes)) + "\n "))) ==
          expected());
    CHECK(read("c.vti", vti(little64, array_tag(type, "binary", base64(counted<std::uint64_t>(bytes))))) ==
          expected());
    const std::string length = counted<std::uint32_t>(bytes).substr(0, 4);
    CHECK(read("d.vti", vti(little32, array_tag(type, "binary", base64(length) + base64(bytes)))) ==
          expected());

    const std::string tag =
        "<DataArray type=\"" + type + "\" Name=\"solid\" format=\"appended\" offset=\"16\"/>\n";
    const std::string junk = "</AppendedData>&";
    const auto raw = junk + counted<std::uint64_t>(bytes);
    CHECK(read("e.vti",
               vti(little64, tag, "<AppendedData encoding=\"raw\">\n   _" + raw + "</AppendedData>")) ==
          expected());
    const std::string before = base64(counted<std::uint32_t>("12345678")); // 16 characters
    CHECK(read("f.vti", vti(little32, tag,
                            "<AppendedData encoding=\"base64\">\n   _" + before +
                                base64(counted<std::uint32_t>(bytes)) + "\n</AppendedData>")) == expected());
}

TEST_CASE("Image data may be on points, may begin anywhere and need not say what is usual") {
    const std::string array = array_tag("Int32", "ascii", text_of_values());
    CHECK(read("points.vti", vti(little32, array, "", "PointData", "0 4 0 3 0 2")) == expected());
    CHECK(read("shifted.vti", vti(little32, array, "", "CellData", "-7 -2 3 7 10 13")) == expected());
    CHECK(read("plain.vti", vti("", array)) == expected());
    CHECK(read("entity.vti", replaced(sample_vti(), "\"solid\"", "'is &lt;1&gt; &amp; &quot;solid&quot;'"),
               "is <1> & \"solid\"") == expected());
}

TEST_CASE("Of several arrays one is named; vectors do not count") {
    const std::string vectors =
        "<DataArray type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\" format=\"ascii\"/>\n";
    const std::string solid = array_tag("UInt8", "ascii", text_of_values());
    CHECK(read("vectors.vti", vti(little32, vectors + solid)) == expected());
    const std::string other = "<DataArray type=\"Float32\" Name=\"density\" format=\"ascii\">1</DataArray>\n";
    CHECK(read("two.vti", vti(little32, other + solid), "solid") == expected());
    CHECK(refusal("two.vti", vti(little32, other + solid)) ==
          " there are several scalar arrays: density (CellData), solid (CellData); expected one; try to name "
          "the one that marks solid cells");
    CHECK(refusal("two.vti", vti(little32, other + solid), "rock") ==
          " there is no scalar array \"rock\"; expected one of: density (CellData), solid (CellData)");
    CHECK(refusal("twice.vti", vti(little32, solid + solid), "solid") ==
          " there are several scalar arrays of that name: solid (CellData), solid (CellData); expected one; "
          "try to pass fewer arrays");
    CHECK(refusal("none.vti", vti(little32, vectors)) ==
          " there is no scalar array on points or cells; expected one; save it in ParaView as .vti with an "
          "array that is not zero in solid cells");
}

TEST_CASE("Image data of another size are refused with what would help") {
    const std::string array = array_tag("UInt8", "ascii", text_of_values());
    CHECK(
        refusal("size.vti", vti(little32, array, "", "CellData", "0 8 0 4 0 3")) ==
        "8:1: the array \"solid\" has 8 x 4 x 3 cells; expected 5 x 4 x 3, one for each cell of the lattice; "
        "try another resolution of the image, or change the lattice's size");
    CHECK(refusal("points.vti", vti(little32, array, "", "PointData")) ==
          "8:1: the array \"solid\" has 6 x 5 x 4 points; expected 5 x 4 x 3, one for each cell of the "
          "lattice; try the values on cells: in ParaView, Point Data to Cell Data");
    CHECK(
        refusal("cells.vti", vti(little32, array, "", "CellData", "0 4 0 3 0 2")) ==
        "8:1: the array \"solid\" has 4 x 3 x 2 cells; expected 5 x 4 x 3, one for each cell of the lattice; "
        "try the values on points: in ParaView, Cell Data to Point Data");
    CHECK(refusal("extent.vti", replaced(sample_vti(), "\"0 5 0 4 0 3\"", "\"0 5 0 4 0\"")) ==
          "4:1: WholeExtent is \"0 5 0 4 0\"; expected six numbers, the first and last point along x, y, z; "
          "save it in ParaView as .vti");
    CHECK(refusal("pieces.vti", replaced(sample_vti(), "<Piece Extent=\"0 5", "<Piece Extent=\"0 2")) ==
          "6:1: the image comes in several pieces; expected one with the WholeExtent; save it in ParaView as "
          ".vti in one process");
}

TEST_CASE("Image data that are written in other ways are refused with the remedy") {
    const std::string binary =
        array_tag("UInt8", "binary", base64(counted<std::uint32_t>(std::string(60, 1))));
    CHECK(refusal("zip.vti", vti(little32 + " compressor=\"vtkZLibDataCompressor\"", binary)) ==
          " the values are compressed by vtkZLibDataCompressor; expected plain ones; save it in ParaView "
          "with Compressor Type None");
    CHECK(refusal("kind.vti", replaced(sample_vti(), "ImageData", "PolyData")) ==
          "3:1: found <VTKFile type=\"PolyData\">; expected <VTKFile type=\"ImageData\">; in ParaView, "
          "Resample To Image makes image data of other kinds");
    CHECK(refusal("order.vti", replaced(sample_vti(), "LittleEndian", "BigEndian")) ==
          "3:1: byte_order is \"BigEndian\"; expected LittleEndian; save it in ParaView as .vti on a "
          "little-endian machine");
    CHECK(refusal("length.vti", replaced(sample_vti(), "UInt32", "UInt16")) ==
          "3:1: header_type is \"UInt16\"; expected UInt32 or UInt64; save it in ParaView as .vti");
    CHECK(
        refusal("type.vti", replaced(sample_vti(), "UInt8", "String")) ==
        "8:1: the array \"solid\" has the type \"String\"; expected Int8 to UInt64, Float32 or Float64; save "
        "it in ParaView as .vti with another type");
    CHECK(refusal("format.vti",
                  replaced(sample_vti(), "format=\"ascii\" RangeMin", "format=\"hex\" RangeMin")) ==
          "8:1: the array \"solid\" has the format \"hex\"; expected ascii, binary or appended; save it in "
          "ParaView as .vti");
}

TEST_CASE("Image data that lack values are refused with the number found") {
    const auto plain = [](const std::string& content) {
        return vti(little32, array_tag("UInt8", "ascii", content));
    };
    const std::string wanted = "; expected 5 x 4 x 3 numbers in the array \"solid\"; save it in ParaView as "
                               ".vti anew";
    CHECK(refusal("few.vti", plain("0 0\n1")) == "9:1: the array ends after 3 values" + wanted);
    CHECK(refusal("many.vti", plain(text_of_values() + "1")) == "68:1: the array goes on" + wanted);
    CHECK(refusal("word.vti", plain("0 0 1,0")) == "8:1: value 2 is \"1,0\"" + wanted);

    const std::string bytes =
        "; expected 60 bytes for the array \"solid\"; the file may be cut short: save it "
        "in ParaView as .vti anew";
    const auto encoded = [](const std::string& text) {
        return vti(little32, array_tag("UInt8", "binary", text));
    };
    CHECK(refusal("length.vti", encoded(base64(counted<std::uint32_t>(std::string(59, 1))))) ==
          "8:1: the array says that it has 59 bytes" + bytes);
    CHECK(refusal("short.vti", encoded(base64(counted<std::uint32_t>(std::string(60, 1)).substr(0, 40)))) ==
          "8:1: the array ends after 36 bytes" + bytes);
    CHECK(refusal("empty.vti", encoded("")) == "8:1: the array is empty" + bytes);
    CHECK(refusal("noise.vti", encoded("AAAA?AAA")) == "8:1: the array is not written in base64" + bytes);

    const auto appended = [](const std::string& offset, const std::string& section) {
        return vti(little32,
                   "<DataArray type=\"UInt8\" Name=\"solid\" format=\"appended\" offset=\"" + offset +
                       "\"/>\n",
                   section);
    };
    CHECK(refusal("gone.vti", appended("0", "")) == "8:1: there is no <AppendedData>" + bytes);
    CHECK(refusal("code.vti", appended("0", "<AppendedData encoding=\"hex\">_00</AppendedData>")) ==
          "8:1: the encoding is \"hex\"" + bytes);
    const std::string section = "<AppendedData encoding=\"raw\">_" +
                                counted<std::uint32_t>(std::string(60, 1)).substr(0, 20) + "</AppendedData>";
    CHECK(refusal("far.vti", appended("1000", section)) == "8:1: the offset is \"1000\"" + bytes);
    CHECK(refusal("minus.vti", appended("-4", section)) == "8:1: the offset is \"-4\"" + bytes);
    CHECK(refusal("cut.vti", appended("0", section)) == "8:1: the array ends after 16 bytes" + bytes);
    CHECK(refusal("mark.vti", appended("0", "<AppendedData encoding=\"raw\">AAAA</AppendedData>")) ==
          "12:1: the appended data do not begin with an underscore; save it in ParaView as .vti anew");
    CHECK(refusal("end.vti", replaced(appended("0", section), "</AppendedData>", "")) ==
          "12:1: the appended data do not end; expected </AppendedData>; the file may be cut short: save it "
          "in ParaView as .vti anew");
    const double nothing = std::nan("");
    CHECK(refusal("nan.vti", vti(little32, array_tag("Float64", "binary",
                                                     base64(counted<std::uint32_t>(
                                                         bytes_of(std::vector<double>(60, nothing))))))) ==
          "8:1: value 0 of the array \"solid\" is not a number; expected zero in the fluid and anything else "
          "in solids");
}

TEST_CASE("What is not XML, or not the XML of image data, is refused with its line") {
    const std::string damaged = "; the file may be damaged: write it anew";
    CHECK(refusal("empty.vti", "") ==
          " the file is empty; expected <VTKFile type=\"ImageData\">; save it in ParaView as .vti");
    CHECK(refusal("text.vti", "hello <b>") ==
          "1:1: found text outside of all elements; expected <VTKFile ...>" + damaged);
    CHECK(refusal("cut.vti", sample_vti().substr(0, sample_vti().find("</Piece>"))) ==
          "70:1: found the end of the file; expected </Piece>" + damaged);
    CHECK(refusal("close.vti", replaced(sample_vti(), "</CellData>", "</PointData>")) ==
          "69:1: found </PointData; expected </CellData>" + damaged);
    CHECK(refusal("quote.vti", replaced(sample_vti(), "Name=\"solid\"", "Name=solid")) ==
          "8:1: found an attribute without quotes; expected =\"...\"" + damaged);
    CHECK(refusal("open.vti", "<VTKFile type=\"ImageData") ==
          "1:1: found an attribute whose quotes do not close; expected \"" + damaged);
    CHECK(refusal("value.vti", "<VTKFile type>") ==
          "1:1: found the attribute type without a value; expected =\"...\"" + damaged);
    CHECK(refusal("twice.vti", "<VTKFile type=\"a\" type=\"b\">") ==
          "1:1: found the attribute type twice; expected it once" + damaged);
    CHECK(refusal("reference.vti", "<VTKFile type=\"&#65;\">") ==
          "1:1: found the reference &#65;; expected &lt; &gt; &amp; &quot; or &apos;" + damaged);
    CHECK(refusal("comment.vti", "\n<!-- <VTKFile>") ==
          "2:1: found a comment without end; expected -->" + damaged);
    CHECK(refusal("doctype.vti", "<!DOCTYPE VTKFile>") ==
          "1:1: found a character that begins no name; expected the name of an element or attribute" +
              damaged);
    CHECK(refusal("piece.vti", "<VTKFile type='ImageData'/>") ==
          " there is no <Piece>; expected one in <ImageData>; save it in ParaView as .vti");
}

TEST_CASE("Base64 is decoded as RFC 4648 has it") {
    CHECK(decode_base64("Zm9vYmFy", 6) == "foobar");
    CHECK(decode_base64("Zm9vYmE=", 6) == "fooba");
    CHECK(decode_base64("Zm9v\nYg==", 6) == "foob");
    CHECK(decode_base64("Zg==Zm9v", 6) == "ffoo");
    CHECK(decode_base64("Zm9vYmFy", 4) == "foob");
    CHECK(decode_base64("Zm9v*", 3) == "foo");
    CHECK(decode_base64("", 5) == "");
    for (const char* wrong : {"Zm9", "Z===", "Zm=v", "=", "Zm9v*m9v"})
        CHECK(!decode_base64(wrong, 6));
}
