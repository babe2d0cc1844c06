// What the programs read from files, tested in memory and without CGAL. Files are written here by other code, in every
// way that their formats allow, and must give back what was written; what is wrong in them is refused at its place.

#include "../../examples/Frame_fields/programs/shared/formats/read_raw_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef std::vector<std::vector<std::size_t> > Polygons;

struct Model
{
  std::vector<Coordinates> points;
  Polygons polygons;
};

Polygons polygons_of(const Raw_soup& soup)
{
  Polygons result;
  std::size_t start = 0;
  for(const std::size_t end : soup.ends)
  {
    result.emplace_back(soup.corners.begin() + start, soup.corners.begin() + end);
    start = end;
  }
  return result;
}

Raw_soup read(const std::string& path, const std::string& content) { return read_raw_soup(path, content); }

void expect_model(const Model& expected, const std::string& path, const std::string& content)
try
{
  const Raw_soup soup = read(path, content);
  EXPECT_EQ(soup.points, expected.points) << path;
  EXPECT_EQ(polygons_of(soup), expected.polygons) << path;
}
catch(const Failure& failure)
{
  ADD_FAILURE() << failure.what() << "\n" << content.substr(0, 300);
}

// The message of the failure, or nothing.
std::string failure_of(const std::string& path, const std::string& content)
try
{
  read(path, content);
  return "";
}
catch(const Failure& failure)
{
  EXPECT_EQ(failure.exit_code, BAD_FILE);
  return failure.what();
}

// Expects a failure whose message goes on like this after the path.
void expect_failure(const std::string& start, const std::string& path, const std::string& content)
{
  const std::string message = failure_of(path, content);
  EXPECT_EQ(message.substr(0, path.size() + 2 + start.size()), path + ": " + start) << content.substr(0, 300);
}

void expect_warnings(const std::vector<std::string>& expected, const std::string& path, const std::string& content)
{
  EXPECT_EQ(read(path, content).warnings, expected);
}

// ---------------------------------------------------------------- models

Model random_model(const unsigned int seed, const std::size_t minimum_degree, const std::size_t maximum_degree)
{
  std::mt19937 random(seed);
  Model model;
  const std::size_t number_of_points = 5 + random() % 40, number_of_polygons = 1 + random() % 60;
  for(std::size_t k = 0; k < number_of_points; ++k)
  {
    const auto coordinate = [&] { return static_cast<float>(std::ldexp(static_cast<double>(random()) - 2e9,
                                                                       static_cast<int>(random() % 60) - 60)); };
    model.points.push_back({ coordinate(), coordinate(), coordinate() });
  }
  for(std::size_t k = 0; k < number_of_polygons; ++k)
  {
    std::vector<std::size_t> polygon(minimum_degree + random() % (maximum_degree - minimum_degree + 1));
    for(std::size_t& vertex : polygon)
      vertex = random() % number_of_points;
    model.polygons.push_back(polygon);
  }
  return model;
}

Model triangle_model() { return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } }; }

// What STL keeps: corners in the order of the file.
Model with_corners_numbered(const Model& model)
{
  Model result;
  for(const auto& polygon : model.polygons)
  {
    result.polygons.emplace_back();
    for(const std::size_t vertex : polygon)
    {
      const auto found = std::find(result.points.begin(), result.points.end(), model.points[vertex]);
      result.polygons.back().push_back(found - result.points.begin());
      if(found == result.points.end())
        result.points.push_back(model.points[vertex]);
    }
  }
  return result;
}

// ---------------------------------------------------------------- writers of text

std::string text_of(const double number)
{
  std::ostringstream out;
  out << std::setprecision(17) << number;
  return out.str();
}

std::string text_of(const Coordinates& point)
{
  return text_of(point[0]) + " " + text_of(point[1]) + " " + text_of(point[2]);
}

std::string indices(const std::vector<std::size_t>& polygon, const std::size_t first = 0)
{
  std::string result;
  for(const std::size_t vertex : polygon)
    result += " " + std::to_string(vertex + first);
  return result;
}

std::string counts(const Model& model)
{
  return std::to_string(model.points.size()) + " " + std::to_string(model.polygons.size());
}

// The lines of the points, with something after each, and of the polygons with their degree.
std::string rows(const Model& model, const std::string& after_point = "", const std::string& after_polygon = "")
{
  std::string result;
  for(const Coordinates& point : model.points)
    result += text_of(point) + after_point + "\n";
  for(const auto& polygon : model.polygons)
    result += std::to_string(polygon.size()) + indices(polygon) + after_polygon + "\n";
  return result;
}

std::string off(const Model& model) { return "OFF\n" + counts(model) + " 0\n" + rows(model); }

std::string obj(const Model& model)
{
  std::string result;
  for(const Coordinates& point : model.points)
    result += "v " + text_of(point) + "\n";
  for(const auto& polygon : model.polygons)
    result += "f" + indices(polygon, 1) + "\n";
  return result;
}

std::string ply_header(const std::string& format, const Model& model, const std::string& type = "double",
                       const std::string& list = "list uchar int")
{
  return "ply\nformat " + format + " 1.0\ncomment written by a test\nelement vertex "
         + std::to_string(model.points.size()) + "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type
         + " z\nelement face " + std::to_string(model.polygons.size()) + "\nproperty " + list
         + " vertex_indices\nend_header\n";
}

std::string ply(const Model& model) { return ply_header("ascii", model) + rows(model); }

std::string stl(const Model& model, const std::string& name = "model")
{
  std::string result = "solid " + name + "\n";
  for(const auto& polygon : model.polygons)
  {
    result += "facet normal 0 nan 1\n  outer loop\n";
    for(const std::size_t vertex : polygon)
      result += "    vertex " + text_of(model.points[vertex]) + "\n";
    result += "  endloop\nendfacet\n";
  }
  return result + "endsolid " + name + "\n";
}

std::string gocad(const Model& model, const std::size_t first = 1)
{
  std::string result = "GOCAD TSurf 1\nHEADER {\nname:surface\n}\nTFACE\n";
  for(std::size_t v = 0; v < model.points.size(); ++v)
    result += "VRTX " + std::to_string(v + first) + " " + text_of(model.points[v]) + "\n";
  for(const auto& polygon : model.polygons)
    result += "TRGL" + indices(polygon, first) + "\n";
  return result + "BSTONE 2\nEND\n";
}

std::string vtp(const Model& model)
{
  std::string points, vertices, ends;
  std::size_t end = 0;
  for(const Coordinates& point : model.points)
    points += text_of(point) + "\n";
  for(const auto& polygon : model.polygons)
  {
    vertices += indices(polygon) + "\n";
    ends += std::to_string(end += polygon.size()) + "\n";
  }
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData>\n<Piece NumberOfPoints=\""
         + std::to_string(model.points.size()) + "\" NumberOfPolys=\"" + std::to_string(model.polygons.size())
         + "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n" + points
         + "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
         + vertices + "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n" + ends
         + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string replaced(std::string text, const std::string& old, const std::string& replacement)
{
  for(std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += replacement.size())
    text.replace(at, old.size(), replacement);
  return text;
}

std::string replaced_first(std::string text, const std::string& old, const std::string& replacement)
{
  return text.replace(text.find(old), old.size(), replacement);
}

// ---------------------------------------------------------------- writers of bytes

template <typename Number>
std::string bytes_of(const Number number, const bool is_big_endian)
{
  std::string result(sizeof(Number), '\0');
  std::memcpy(&result[0], &number, sizeof(Number));
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  if(is_big_endian == (first == 1))
    std::reverse(result.begin(), result.end());
  return result;
}

std::string base64_of(std::string bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t number_of_fillers = (3 - bytes.size() % 3) % 3;
  bytes.append(number_of_fillers, '\0');
  std::string result;
  for(std::size_t k = 0; k < bytes.size(); k += 3)
  {
    unsigned int bits = 0;
    for(const std::size_t l : { k, k + 1, k + 2 })
      bits = 256 * bits + static_cast<unsigned char>(bytes[l]);
    for(const unsigned int shift : { 18, 12, 6, 0 })
      result += digits[bits >> shift & 63];
  }
  return result.replace(result.size() - number_of_fillers, number_of_fillers, number_of_fillers, '=');
}

std::string bytes_of(const std::string& type, const long long value, const bool is_big_endian)
{
  if(type == "char" || type == "int8" || type == "uchar" || type == "uint8")
    return bytes_of(static_cast<std::int8_t>(value), is_big_endian);
  if(type == "short" || type == "int16" || type == "ushort" || type == "uint16")
    return bytes_of(static_cast<std::int16_t>(value), is_big_endian);
  if(type == "int" || type == "int32" || type == "uint" || type == "uint32")
    return bytes_of(static_cast<std::int32_t>(value), is_big_endian);
  return bytes_of(static_cast<std::int64_t>(value), is_big_endian);
}

std::string binary_off(const Model& model, const std::string& keyword, const std::size_t numbers_after_point,
                       const std::vector<int>& colors_of_faces)
{
  const auto integer = [](const std::size_t value) { return bytes_of(static_cast<std::int32_t>(value), true); };
  std::string result = keyword + " BINARY\n" + integer(model.points.size()) + integer(model.polygons.size())
                       + integer(7);
  for(const Coordinates& point : model.points)
  {
    for(const double coordinate : point)
      result += bytes_of(static_cast<float>(coordinate), true);
    for(std::size_t k = 0; k < numbers_after_point; ++k)
      result += bytes_of(0.25f, true);
  }
  for(std::size_t f = 0; f < model.polygons.size(); ++f)
  {
    result += integer(model.polygons[f].size());
    for(const std::size_t vertex : model.polygons[f])
      result += integer(vertex);
    if(colors_of_faces.empty())
      continue;
    const int number = colors_of_faces[f % colors_of_faces.size()];
    result += integer(number);
    for(int k = 0; k < number; ++k)
      result += bytes_of(0.5f, true);
  }
  return result;
}

std::string binary_stl(const Model& model, const std::string& start_of_header)
{
  std::string result = start_of_header;
  result.resize(80, '\0');
  result += bytes_of(static_cast<std::uint32_t>(model.polygons.size()), false);
  for(const auto& polygon : model.polygons)
  {
    result += std::string(12, '\xFF'); // a normal that is not finite
    for(const std::size_t vertex : polygon)
      for(const double coordinate : model.points[vertex])
        result += bytes_of(static_cast<float>(coordinate), false);
    result += "ab";
  }
  return result;
}

std::string binary_ply(const Model& model, const bool is_big_endian, const std::string& count_type = "uchar",
                       const std::string& index_type = "int")
{
  std::string result = ply_header(is_big_endian ? "binary_big_endian" : "binary_little_endian", model, "double",
                                  "list " + count_type + " " + index_type);
  for(const Coordinates& point : model.points)
    for(const double coordinate : point)
      result += bytes_of(coordinate, is_big_endian);
  for(const auto& polygon : model.polygons)
  {
    result += bytes_of(count_type, static_cast<long long>(polygon.size()), is_big_endian);
    for(const std::size_t vertex : polygon)
      result += bytes_of(index_type, static_cast<long long>(vertex), is_big_endian);
  }
  return result;
}

// Writes VTP with arrays as bytes: in their places in base64, or appended as such or in base64.
std::string binary_vtp(const Model& model, const bool is_big_endian, const bool is_appended, const bool is_base64)
{
  const auto encoded = [&](const std::string& data)
  {
    const std::string size = bytes_of(static_cast<std::uint32_t>(data.size()), is_big_endian);
    if(is_base64 && is_big_endian) // some writers encode them apart
      return base64_of(size) + base64_of(data);
    return is_base64 ? base64_of(size + data) : size + data;
  };
  std::string points, vertices, ends;
  std::size_t end = 0;
  for(const Coordinates& point : model.points)
    for(const double coordinate : point)
      points += bytes_of(coordinate, is_big_endian);
  for(const auto& polygon : model.polygons)
  {
    for(const std::size_t vertex : polygon)
      vertices += bytes_of(static_cast<std::uint8_t>(vertex), is_big_endian);
    ends += bytes_of(static_cast<std::int32_t>(end += polygon.size()), is_big_endian);
  }
  std::string appended;
  const auto array = [&](const std::string& attributes, const std::string& data)
  {
    const std::string tag = "<DataArray " + attributes + " format=\"" + (is_appended ? "appended" : "binary");
    if(!is_appended)
      return tag + "\">\n" + encoded(data) + "\n</DataArray>\n";
    const std::string offset = std::to_string(appended.size());
    appended += encoded(data);
    return tag + "\" offset=\"" + offset + "\"/>\n";
  };
  std::string result = std::string("<VTKFile type='PolyData' byte_order='") + (is_big_endian ? "Big" : "Little")
                       + "Endian'>\n<!-- <Piece> --><PolyData><Piece NumberOfPoints='"
                       + std::to_string(model.points.size()) + "' NumberOfLines='1' NumberOfPolys='"
                       + std::to_string(model.polygons.size()) + "'>\n<PointData>";
  result += array("type='UInt8' Name='connectivity'", "123") + "</PointData><Points>";
  result += array("type='Float64' NumberOfComponents='3'", points) + "</Points>\n<Lines>";
  result += array("type='UInt8' Name='connectivity'", "12");
  result += array("type='UInt8' Name='offsets'", "1") + "</Lines>\n<Polys>";
  result += array("type='Int32' Name='offsets'", ends);
  result += array("type='UInt8' Name='connectivity'", vertices) + "</Polys>\n</Piece></PolyData>\n";
  if(is_appended)
    result += std::string("<AppendedData encoding='") + (is_base64 ? "base64" : "raw") + "'>\n _" + appended
              + "\n</AppendedData>\n";
  return result + "</VTKFile>\n";
}

// ---------------------------------------------------------------- all formats

struct Text_format
{
  const char* path;
  std::function<std::string(const Model&)> write;
  bool is_of_triangles, numbers_corners;
};

std::vector<Text_format> text_formats()
{
  return { { "model.off", off, false, false },
           { "model.Obj", obj, false, false },
           { "model.ply", ply, false, false },
           { "model.STL", [](const Model& model) { return stl(model); }, false, true },
           { "model.ts", [](const Model& model) { return gocad(model); }, true, false },
           { "model.vtp", vtp, false, false } };
}

TEST(Readers, All_ways_to_separate_words_and_lines_are_the_same)
{
  const std::function<std::string(const std::string&)> ways[] = {
    [](const std::string& text) { return text; },
    [](const std::string& text) { return replaced(text, "\n", "\r\n"); },
    [](const std::string& text) { return replaced(text, "\n", "\r"); },
    [](const std::string& text) { return replaced(text, " ", "\t"); },
    [](const std::string& text) { return replaced(text, " ", "   \t "); },
    [](const std::string& text) { return replaced(text, "\n", " \t\n"); },
    [](const std::string& text) { return replaced(text, "\n", " \r\n\t"); },
    [](const std::string& text) { return "\xEF\xBB\xBF" + text; },
    [](const std::string& text) { return text.substr(0, text.size() - 1); },
    [](const std::string& text) { return text + "\n \t\r\n"; } };
  for(unsigned int seed = 0; seed < 20; ++seed)
    for(const Text_format& format : text_formats())
    {
      const Model model = random_model(seed, 3, format.is_of_triangles ? 3 : 7);
      for(const auto& way : ways)
        expect_model(format.numbers_corners ? with_corners_numbered(model) : model, format.path,
                     way(format.write(model)));
    }
}

TEST(Readers, Keywords_have_small_or_large_letters)
{
  const auto in_small_letters = [](std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const char c)
                   { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
  };
  const auto in_capitals = [](std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const char c)
                   { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return text;
  };
  for(const Text_format& format : text_formats())
  {
    if(std::string(format.path) == "model.vtp") // as in all XML, letters differ
      continue;
    expect_model(triangle_model(), format.path, in_small_letters(format.write(triangle_model())));
    expect_model(triangle_model(), format.path, in_capitals(format.write(triangle_model())));
  }
}

TEST(Readers, Numbers_that_are_none_or_not_finite_are_refused_with_their_line)
{
  Model model = triangle_model();
  model.points[1] = { 77, 0, 0 };
  const std::pair<const char*, int> line_in[] = { { "model.off", 4 }, { "model.Obj", 2 }, { "model.ply", 12 },
                                                  { "model.STL", 5 }, { "model.ts", 7 },
                                                  { "model.vtp", 8 } };
  for(const Text_format& format : text_formats())
    for(const char* const number : { "nan", "-NaN", "inf", "-Infinity", "1e400", "-1e999999999", "1,5", "0x10", "1.5.5",
                                     "7-7", "1e", "--1", "+-1", "e5", ".", "1d5", "77\xC2\xA0" })
    {
      const auto* const line = std::find_if(std::begin(line_in), std::end(line_in), [&](const auto& pair)
                                            { return std::string(pair.first) == format.path; });
      expect_failure("line " + std::to_string(line->second), format.path,
                     replaced(format.write(model), "77", number));
    }
}

TEST(Readers, Numbers_have_many_forms)
{
  const std::pair<const char*, double> forms[] = {
    { "77.", 77 }, { "+77", 77 }, { "077", 77 }, { "7.7E1", 77 }, { "7.7e+01", 77 }, { "770e-1", 77 }, { ".77e2", 77 },
    { "-.5", -0.5 }, { "1e-400", 0 }, { "-1e-400", 0 }, { "4.9e-324", 4.9e-324 },
    { "1.7976931348623157e308", 1.7976931348623157e308 },
    { "0.1000000000000000055511151231257827021181583404541015625", 0.1 } };
  Model model = triangle_model();
  for(const auto& [text, value] : forms)
    for(const Text_format& format : text_formats())
    {
      model.points[1] = { 77, 0, 0 };
      const std::string content = replaced(format.write(model), "77", text);
      model.points[1] = { value, 0, 0 };
      const Model expected = format.numbers_corners ? with_corners_numbered(model) : model;
      expect_model(expected, format.path, content);
    }
}

TEST(Readers, Text_in_utf_16_is_refused)
{
  for(const Text_format& format : text_formats())
  {
    std::string little = "\xFF\xFE", big = "\xFE\xFF";
    for(const char c : format.write(triangle_model()))
    {
      little += std::string(1, c) + '\0';
      big += '\0' + std::string(1, c);
    }
    expect_failure("byte 0: this is text in UTF-16", format.path, little);
    expect_failure("byte 0: this is text in UTF-16", format.path, big);
  }
}

// A file that was cut is refused, or has all elements; only the last number may have lost digits.
TEST(Readers, Files_cut_at_any_byte_are_refused)
{
  const Model polygons = random_model(3, 3, 7), triangles = random_model(4, 3, 3);
  const std::pair<const char*, std::string> files[] = {
    { "model.off", off(polygons) }, { "model.ply", ply(polygons) }, { "model.stl", stl(polygons) },
    { "model.ts", gocad(triangles) }, { "model.off", binary_off(polygons, "OFF", 0, { 0 }) },
    { "model.off", binary_off(polygons, "CNOFF", 7, { 3, 4 }) }, { "model.ply", binary_ply(polygons, false) },
    { "model.ply", binary_ply(polygons, true, "int", "ushort") }, { "model.stl", binary_stl(triangles, "solid") },
    { "model.vtp", vtp(polygons) }, { "model.vtp", binary_vtp(polygons, false, false, true) } };
  for(const auto& [path, content] : files)
  {
    const Raw_soup whole = read(path, content);
    for(std::size_t size = 0; size < content.size(); ++size)
      try
      {
        const Raw_soup soup = read(path, content.substr(0, size));
        EXPECT_EQ(soup.points, whole.points) << path << " " << size;
        EXPECT_EQ(soup.ends, whole.ends) << path << " " << size;
        EXPECT_TRUE(std::equal(soup.corners.begin(), soup.corners.end() - 1, whole.corners.begin()));
        EXPECT_GE(size + 12, content.size()) << path;
      }
      catch(const Failure&) {}
  }
}

TEST(Readers, Data_left_over_are_refused)
{
  const Model model = random_model(5, 3, 5), triangles = random_model(6, 3, 3);
  Model shorter = model;
  shorter.polygons.pop_back();
  const std::string last_line = std::to_string(model.polygons.back().size()) + indices(model.polygons.back()) + "\n";
  const std::size_t lines = model.points.size() + model.polygons.size();
  expect_failure("line " + std::to_string(2 + lines) + ",", "model.off", off(shorter) + last_line);
  expect_failure("line " + std::to_string(10 + lines) + ",", "model.ply", ply(shorter) + last_line);
  expect_failure("line ", "model.stl", stl(triangles) + "facet normal 0 0 1\n");
  expect_failure("line ", "model.ts", gocad(triangles) + "TRGL 1 2 3\n");
  for(const bool is_big_endian : { false, true })
    expect_failure("byte " + std::to_string(binary_ply(model, is_big_endian).size()) + ":", "model.ply",
                   binary_ply(model, is_big_endian) + "\3");
  expect_failure("byte " + std::to_string(binary_off(model, "OFF", 0, { 0 }).size()) + ":", "model.off",
                 binary_off(model, "OFF", 0, { 0 }) + "\3");
  expect_failure("byte 80:", "model.stl", binary_stl(triangles, "solid") + std::string(50, '\1'));
  for(const char* const padding : { "\n", "\r\n", " " }) // as an editor or a tape appends
  {
    expect_model(model, "model.ply", binary_ply(model, false) + padding);
    expect_model(with_corners_numbered(triangles), "model.stl", binary_stl(triangles, "") + std::string(3, '\0'));
  }
}

TEST(Readers, Counts_out_of_all_proportion_are_refused_at_once)
{
  for(const char* const count : { "-1", "1000000", "4294967297", "1000000000000", "9223372036854775807",
                                  "99999999999999999999" })
  {
    expect_failure("line 2", "model.off", replaced_first(off(triangle_model()), "3 1 0", std::string(count) + " 1 0"));
    expect_failure("line 2", "model.off", replaced_first(off(triangle_model()), "3 1 0", std::string("3 ") + count));
    expect_failure("line 6", "model.off", replaced_first(off(triangle_model()), "3 0 1 2",
                                                         std::string(count) + " 0 1 2"));
    for(const bool is_binary : { false, true })
    {
      const std::string content = is_binary ? binary_ply(triangle_model(), false) : ply(triangle_model());
      EXPECT_NE(failure_of("model.ply", replaced_first(content, "vertex 3", std::string("vertex ") + count)), "");
      EXPECT_NE(failure_of("model.ply", replaced_first(content, "face 1", std::string("face ") + count)), "");
    }
    expect_failure("line 14", "model.ply", replaced_first(ply(triangle_model()), "3 0 1 2",
                                                          std::string(count) + " 0 1 2"));
  }
  std::string content = binary_off(triangle_model(), "OFF", 0, { 0 });
  content.replace(11, 4, bytes_of(std::int32_t(2000000000), true));
  expect_failure("byte 15: 2000000000 vertices", "model.off", content);
  content = binary_stl(triangle_model(), "");
  content.replace(80, 4, bytes_of(std::uint32_t(4000000000u), false));
  expect_failure("byte 80: 4000000000 facets", "model.stl", content);
}

TEST(Readers, Files_of_another_kind_are_refused)
{
  for(const Text_format& format : text_formats())
    for(const Text_format& other : text_formats())
      if(format.path != other.path)
      {
        EXPECT_NE(failure_of(other.path, format.write(triangle_model())), "") << format.path << " " << other.path;
      }
  expect_failure("byte 0: the file is empty", "model.off", "");
  expect_failure("the kind of file is unknown", "model.xyz", "OFF");
}

// ---------------------------------------------------------------- OBJ

TEST(Obj, Corners_have_any_of_their_forms)
{
  const Model model{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
                     { { 0, 1, 2 }, { 2, 3, 0 }, { 0, 1, 2, 3 } } };
  for(const char* const faces : { "f 1 2 3\nf 3 4 1\nf 1 2 3 4\n", "f 1/7 2/8 3/9\nf 3// 4/ 1\nf 1/1/1 2//2 3/3 4\n",
                                  "f -4 -3 -2\nf -2//-1 -1/5 -4\nf 1 -3 +3 -1\n",
                                  "f 1 2 3\nf 3 4 1\nf 1 2 3 4",
                                  "f 1 \\\n2 \\\r\n 3\nf 3 \\\n\\ \n4 1\nf\t1\\\n2 3 4 \\",
                                  "f 1 2 3 # 4\nf 3 4 1#2\n#f 1 2 4\\\nf 1 2 3 4\n" })
    expect_model(model, "m.obj", std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n") + faces);
  expect_model(model, "m.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0 0 0 0 1\nf 3 4 1\n"
                               "f -4 -3 -2 -1\n");
  expect_model(model, "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -2 -1 -4\nf -4 -3 -2 -1\n");
}

TEST(Obj, Other_statements_are_left_out_and_counted)
{
  const std::string text = obj(triangle_model());
  const std::string of_no_shape = "mtllib C:\\folder\\\nvn 0 0 1\nvt 0 0\no C:\\\ng a b\ns off\nusemtl m\\\n# v \\\n";
  expect_model(triangle_model(), "m.obj", of_no_shape + text);
  expect_warnings({}, "m.obj", of_no_shape + text);
  const std::string others = "l 1 2 \\\n 3\np 1\nsm 34 4476\nl 2 3\ncurv 0.0 1.0 -2 \\\n-1\nvp 1 2\nfo 1 2 3\nL 1 3\n";
  expect_model(triangle_model(), "m.obj", others + text);
  expect_warnings({ "lines left out: 3 of kind 'l', 1 of kind 'p', 1 of kind 'sm', 1 of kind 'curv', 1 of kind 'vp', "
                    "1 of kind 'fo'" }, "m.obj", text + others);
  std::string many;
  for(int k = 0; k < 1000; ++k)
    many += "key" + std::string(1, static_cast<char>('a' + k % 26)) + "\n";
  EXPECT_LT(read("m.obj", text + many).warnings.front().size(), 250u);
}

TEST(Obj, Faults_are_refused_with_their_line)
{
  const std::string text = "v 0 0 0\nv 1 0 0\r\nv 0 1 0\n";
  for(const char* const line : { "f 1 2 4", "f 1 2 0", "f 1 2 -4", "f 1 2 3.0", "f 1 2 3a", "f 1 2 a", "f",
                                 "f 1/2/3/4 2 3", "f 1/x 2 3", "f 1,2,3", "f 1 2 99999999999999999999", "f 1 2 \\ 3",
                                 "f /1 2 3", "v", "v 1", "v 1 2", "v 1.04.0 0.0", "v 1 2 3 4 5",
                                 "v 1 2 3 4 5 6 7 8", "v 1 2 x", "v 1 2 3 x",
                                 "1 2 3", "-1", ".5", "\x80 1", "v\xC2\xA0" "1 2 3" })
  {
    expect_failure("line 4", "m.obj", text + line + "\nf 1 2 3\n");
    expect_failure("line 4", "m.obj", text + line);
  }
  expect_failure("line 5", "m.obj", text + "# a comment \\\nf 1 2 5\nv 0 0 0\n");
  expect_failure("line 6", "m.obj", text + "f 1 \\\n2 3\nf 9 2 1");
  expect_failure("line 1", "m.obj", "f 1 1 1\n");
  expect_failure("line 1", "m.obj", "f 1 2 1\nv 0 0 0\n");
}

// ---------------------------------------------------------------- OFF

TEST(Off, Headers_have_many_forms)
{
  const Model model = random_model(8, 3, 6);
  const std::string number = counts(model);
  for(const std::string& header : { "OFF\n" + number + " 0\n", "OFF " + number + " 0\n", "OFF" + number + " 0\n",
                                    "off\n" + number + " 99\n", "OFF\n" + number + "\n", "OFF\n" + number + "\n0\n",
                                    "# first\n\nOFF # second\n\n# third\n" + number + " 0# fourth\n\n", number + " 0\n",
                                    "nOFF\n3\n" + number + " 0\n", "nOFF 3 " + number + " 0\n",
                                    "OFF\n" + replaced(number, " ", "\n") + "\n0\n" })
    expect_model(model, "m.off", header + rows(model));
  expect_failure("line 2", "m.off", "nOFF\n4\n" + number + " 0\n" + rows(model));
  for(const char* const keyword : { "OFFX", "SKEL", "XOFF", "OFFBINARY", "ply", "STNCOFF" })
    expect_failure("line 1", "m.off", keyword + ("\n" + number) + " 0\n" + rows(model));
}

TEST(Off, Numbers_after_points_and_faces_are_no_coordinates)
{
  const Model model = random_model(9, 3, 6);
  const std::string number = "\n" + counts(model) + " 0\n";
  for(const auto& [keyword, after] : std::vector<std::pair<std::string, std::string> >{
        { "COFF", " 1 0 0 1" }, { "COFF", " 255 0 0" }, { "COFF", " 7" }, { "COFF", "" }, { "NOFF", " 0 0 1" },
        { "STOFF", " 0.5 0.5" }, { "STCNOFF", " 0 nan 1 255 0 0 0.5 0.5" }, { "CNOFF", " 0 0 1 0.1 0.2 0.3 1" },
        { "coff", " 1 0 0 1" }, { "noff", " 0 0 1" }, { "4OFF", " 1" }, { "C4OFF", " 1.0 255 0 0" },
        { "NOFF", "\n0 0 1" }, { "COFF", " 1\n0 0 1" } })
    for(const char* const after_face : { "", " 3", " 255 0 0", " 0.1 0.2 0.3 1 # red" })
    {
      expect_model(model, "m.off", keyword + number + rows(model, after, after_face));
      expect_warnings({}, "m.off", keyword + number + rows(model, after, after_face));
    }
  expect_model(model, "m.off", "OFF" + number + rows(model, " 255 0 0"));
  expect_warnings({ "numbers after the coordinates of vertices left out: 3 of each" }, "m.off",
                  "OFF" + number + rows(model, " 255 0 0"));
  Model twice = model;
  for(Coordinates& point : twice.points)
    for(double& coordinate : point)
      coordinate *= 2;
  expect_model(model, "m.off", "4OFF" + number + rows(twice, " 2"));
  expect_failure("line 3", "m.off", "4OFF" + number + rows(model, " 0"));
}

TEST(Off, Lines_may_end_anywhere_before_the_end_of_a_face)
{
  const Model model = random_model(10, 3, 6);
  std::string points;
  for(const Coordinates& point : model.points)
    points += text_of(point) + " ";
  Model faces = model;
  faces.points.clear();
  expect_model(model, "m.off", "OFF\n" + counts(model) + " 0\n" + points + "\n" + rows(faces));
  expect_model(model, "m.off", "OFF\n" + counts(model) + " 0\n" + replaced(points, " ", "\n") + rows(faces));
  expect_model(model, "m.off", "OFF\n" + counts(model) + " 0\n" + replaced(points, " ", "\n# 1\n")
                               + replaced(rows(faces), " ", "\n"));
}

TEST(Off, Faults_are_refused_with_their_line)
{
  const Model model{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 3, 3, 3 } }, { { 0, 1, 2 }, { 3, 2, 1 } } };
  const std::string text = off(model);
  EXPECT_EQ(text, "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n3 3 3\n3 0 1 2\n3 3 2 1\n");
  for(const auto& [old, replacement, line] : std::vector<std::tuple<const char*, const char*, int> >{
        { "1 0 0\n", "1 00\n", 5 }, { "1 0 0\n", "1. 0 0 0\n", 4 }, { "0 1 0\n", "0 1 x\n", 5 },
        { "3 0 1 2", "3 0 1 4", 7 }, { "3 0 1 2", "3 0 1 -1", 7 }, { "3 0 1 2", "3 0 1 2.0", 7 },
        { "3 0 1 2", "0", 7 }, { "3 0 1 2", "-3 0 1 2", 7 }, { "3 0 1 2", "3 0 1 2 1 1 1 1 1", 7 },
        { "3 0 1 2", "3 0 1 2 red", 7 }, { "3 0 1 2\n", "", 7 }, { "4 2 0", "4 1 0", 8 }, { "4 2 0", "x 2 0", 2 },
        { "4 2 0", "4 2 x", 2 } })
    expect_failure("line " + std::to_string(line), "m.off", replaced_first(text, old, replacement));
}

TEST(Off, Binary_files_of_several_writers)
{
  int number_of_unclear_files = 0;
  for(unsigned int seed = 0; seed < 50; ++seed)
  {
    const Model model = random_model(seed, 3, 6);
    const auto expect_it_or_doubt = [&](const std::string& content)
    {
      if(failure_of("m.off", content).find("does not become clear") != std::string::npos)
        ++number_of_unclear_files;
      else
        expect_model(model, "m.off", content);
    };
    for(const std::vector<int>& colors : { std::vector<int>{}, { 0 }, { 3 }, { 4 }, { 0, 1, 3, 4 } })
    {
      expect_it_or_doubt(binary_off(model, "OFF", 0, colors));
      expect_it_or_doubt(binary_off(model, "NOFF", 3, colors));
      expect_it_or_doubt(binary_off(model, "COFF", 4, colors));
      expect_it_or_doubt(binary_off(model, "STCNOFF", 9, colors));
    }
    expect_it_or_doubt(binary_off(model, "COFF", 3, { 0 }));
  }
  EXPECT_LE(number_of_unclear_files, 3);
  // Six numbers more of vertices and no colours of faces fit, too: "3 0 1 2 1 0" is either one face or two.
  const Model doubtful{ std::vector<Coordinates>(6, Coordinates{ 1, 2, 3 }), { { 0, 1, 2 }, { 3, 2, 1 } } };
  expect_failure("byte 12: it does not become clear", "m.off",
                 replaced(binary_off(doubtful, "COFF", 3, { 1 }), bytes_of(0.5f, true), std::string(4, '\0')));
  std::string content = binary_off(triangle_model(), "OFF", 0, { 0 });
  expect_model(triangle_model(), "m.off", replaced_first(content, "BINARY\n", "binary \r\n"));
  expect_failure("byte " + std::to_string(content.size() - 4), "m.off",
                 content.replace(content.size() - 8, 4, bytes_of(std::int32_t(3), true)));
  content = binary_off(triangle_model(), "OFF", 0, { 0 });
  expect_failure("byte 23: vertex 0 ", "m.off",
                 content.replace(23, 4, bytes_of(std::numeric_limits<float>::quiet_NaN(), true)));
}

// ---------------------------------------------------------------- PLY

TEST(Ply, Counts_and_indices_have_any_integer_type)
{
  const Model model = random_model(11, 3, 9);
  for(const bool is_big_endian : { false, true })
    for(const char* const count_type : { "char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16",
                                         "uint16", "int32", "uint32", "int64", "uint64" })
      for(const char* const index_type : { "char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16",
                                           "uint16", "int32", "uint32", "int64", "uint64" })
      {
        expect_model(model, "m.ply", binary_ply(model, is_big_endian, count_type, index_type));
        expect_model(model, "m.ply", ply_header("ascii", model, "float", std::string("list ") + count_type + " "
                                                                         + index_type) + rows(model));
      }
}

TEST(Ply, Elements_and_properties_have_any_order)
{
  const std::string header = "element face 1\nproperty list uchar float texcoord\nproperty uchar flag\n"
                             "property list short ushort vertex_index\nproperty double quality\n"
                             "element material 2\nproperty list int int ids\nproperty int kind\n"
                             "element vertex 3\nproperty short z\nproperty uchar red\nproperty list uchar uchar tags\n"
                             "property double y\nproperty float x\nelement edge 1\nproperty int vertex1\n"
                             "property int vertex2\nobj_info nothing\nend_header\n";
  const Model model{ { { 1.5, 2.25, -3 }, { 4.5, 5, 6 }, { -7.5, 8, 9 } }, { { 2, 0, 1 } } };
  const auto float_4 = [](const float value) { return bytes_of(value, true); };
  const auto float_8 = [](const double value) { return bytes_of(value, true); };
  const auto integer = [](const char* const type, const long long value) { return bytes_of(type, value, true); };
  std::string body = integer("uchar", 2) + float_4(1) + float_4(2) + integer("uchar", 9) + integer("short", 3)
                     + integer("ushort", 2) + integer("ushort", 0) + integer("ushort", 1) + float_8(0.5)
                     + integer("int", 1) + integer("int", 7) + integer("int", 8) + integer("int", 0)
                     + integer("int", 8);
  for(const Coordinates& point : model.points)
    body += integer("short", static_cast<long long>(point[2])) + integer("uchar", 255) + integer("uchar", 1)
            + integer("uchar", 4) + float_8(point[1]) + float_4(static_cast<float>(point[0]));
  body += integer("int", 0) + integer("int", 1);
  expect_model(model, "m.ply", "ply\nformat binary_big_endian 1.0\n" + header + body);
  const std::string text = "2 1 2 9 3 2 0 1 0.5\n1 7 8\n0 8\n-3 255 1 4 2.25 1.5\n6 255 1 4 5 4.5\n"
                           "9 255 0 8 -7.5\n0 1\n";
  expect_model(model, "m.ply", "ply\nformat ascii 1.0\n" + header + text);
  expect_failure("line 24, '0 8x'", "m.ply", "ply\nformat ascii 1.0\n" + header + replaced_first(text, "0 8", "0 8x"));
  expect_warnings({ "elements left out: 2 of kind 'material'" }, "m.ply", "ply\nformat ascii 1.0\n" + header + text);
}

TEST(Ply, The_end_of_the_header_is_that_of_its_lines)
{
  for(const char first_byte : { '\n', '\r', ' ', '\0' })
  {
    Model model = triangle_model();
    const std::string content = binary_ply(model, false);
    const std::size_t start = content.find("end_header\n") + 11;
    std::string body = content.substr(start);
    body[0] = first_byte;
    double x;
    std::memcpy(&x, body.data(), sizeof(x));
    model.points[0][0] = x;
    const std::string header = content.substr(0, start);
    for(const char* const line_end : { "\n", "\r\n", "\r", " \n" })
      expect_model(model, "m.ply", replaced(header, "\n", line_end) + body);
    expect_model(model, "m.ply", replaced_first(header, "end_header\n", "end_header\r\n") + body);
  }
}

TEST(Ply, Elements_of_text_are_lines_or_flow_freely)
{
  const Model model = random_model(12, 3, 6);
  const std::string header = ply_header("ascii", model);
  Model points = model, faces = model;
  points.polygons.clear();
  faces.points.clear();
  for(const char* const separator : { "\n", " ", "\n\n" })
    expect_model(model, "m.ply", header + replaced(replaced(rows(points), "\n", " "), " ", separator) + "\n"
                                 + replaced(replaced(rows(faces), "\n", " "), " ", separator));
  expect_model(model, "m.ply", replaced_first(header + rows(model), text_of(model.points[3]),
                                              replaced(text_of(model.points[3]), " ", "\n")));
}

TEST(Ply, Faults_are_refused_with_their_line)
{
  const Model model{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 3, 3, 3 } }, { { 0, 1, 2 }, { 3, 2, 1 } } };
  const std::string text = ply(model);
  for(const auto& [old, replacement, line] : std::vector<std::tuple<const char*, const char*, int> >{
        { "1 0 0\n", "1 00\n", 13 }, { "1 0 0\n", "1. 0 0 0\n", 12 }, { "0 1 0\n", "0 1 x\n", 13 },
        { "3 0 1 2", "3 0 1 4", 15 }, { "3 0 1 2", "3 0 1 -1", 15 }, { "3 0 1 2", "3 0 1 2.0", 15 },
        { "3 0 1 2", "0", 15 }, { "3 0 1 2\n", "3 0 1\n", 16 }, { "3 3 2 1", "3 3 2 1 1", 16 },
        { "3 0 1 2\n", "", 15 }, { "face 2", "face 1", 16 }, { "ply\n", "plx\n", 1 }, { "ascii", "ebcdic", 2 },
        { "comment", "remark", 3 }, { "vertex 4", "vertex four", 4 }, { "vertex 4", "vertex 4 4", 4 },
        { "vertex 4", "vertex", 4 }, { "vertex 4", "vertex -4", 4 }, { "double x", "real x", 5 },
        { "double x", "double", 5 }, { "element face", "element vertex", 8 }, { "uchar int", "float int", 9 },
        { "uchar int", "uchar", 9 }, { "comment written by a test", "property float x", 3 },
        { "end_header\n", "", 10 }, { "format ascii 1.0\n", "", 9 }, { "format ascii 1.0\n",
          "format ascii 1.0\nformat ascii 1.0\n", 3 } })
    expect_failure("line " + std::to_string(line), "m.ply", replaced_first(text, old, replacement));
  for(const auto& [old, replacement] : std::vector<std::pair<const char*, const char*> >{
        { "double x", "double w" }, { "double x", "double y" }, { "double x", "list uchar double x" },
        { "vertex_indices", "indices" }, { "list uchar int", "int" }, { "uchar int", "uchar float" } })
    expect_failure("the ", "m.ply", replaced_first(text, old, replacement));
  expect_failure("line 5", "m.ply",
                 "ply\nformat ascii 1.0\nelement vertex 4000000000\nelement face 1\nend_header\n3 1 1");
}

TEST(Ply, Faults_in_bytes_are_refused_with_their_byte)
{
  const std::string content = binary_ply(triangle_model(), false);
  const std::size_t start = content.find("end_header\n") + 11, list = start + 3 * 24;
  const auto with = [&](const std::size_t at, const std::string& bytes)
  {
    return std::string(content).replace(at, bytes.size(), bytes);
  };
  for(const double value : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
    expect_failure("byte " + std::to_string(start + 24) + ": vertex 1 ", "m.ply",
                   with(start + 32, bytes_of(value, false)));
  for(const std::int32_t index : { -1, 3, 1 << 30 })
    expect_failure("byte " + std::to_string(list + 5), "m.ply", with(list + 1, bytes_of(index, false)));
  for(const char count : { '\0', '\4', '\xFF' })
    expect_failure("byte " + std::to_string(list + 1), "m.ply", with(list, std::string(1, count)));
}

// ---------------------------------------------------------------- STL

TEST(Stl, Text_and_bytes_are_told_apart_by_the_size)
{
  const Model model = random_model(13, 3, 3), expected = with_corners_numbered(model);
  for(const char* const start : { "", "solid", "solid model\nfacet normal 0 0 0\nouter loop\n", "\xEF\xBB\xBFsolid",
                                  "\xFF\xFE", "COLOR=" })
    expect_model(expected, "m.stl", binary_stl(model, start));
  for(const char* const start : { "", "# a comment\n", "\n\n \t", "exported by a program\n", "\xEF\xBB\xBF# solid\n" })
    for(const char* const name : { "", "model", "facet", "solid facet normal 0 0 1", "endsolid", "outer loop vertex",
                                   "a name of more than the eighty bytes that the header of a binary file has ......" })
      expect_model(expected, "m.stl", start + stl(model, name));
  expect_model(expected, "m.stl", replaced(stl(model), "solid ", "solid\t"));
  expect_model(expected, "m.stl", replaced(stl(model), "solid", "Solid"));
  expect_model(expected, "m.stl", replaced(stl(model), "solid model", "solid"));
}

TEST(Stl, Corners_in_the_same_place_are_one_vertex)
{
  const Raw_soup soup = read("m.stl", stl({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -0., 0, -0. } },
                                            { { 0, 1, 2 }, { 3, 2, 1 } } }));
  EXPECT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(soup.corners, (std::vector<std::size_t>{ 0, 1, 2, 0, 2, 1 }));
  Model model; // many points, so that their table grows
  for(std::size_t k = 0; k < 20000; ++k)
  {
    model.points.push_back({ static_cast<double>(k % 100), static_cast<double>(k / 100), 0 });
    model.polygons.push_back({ k, k / 2, k / 3 });
  }
  const Raw_soup grown = read("m.stl", binary_stl(model, ""));
  EXPECT_EQ(grown.points.size(), model.points.size());
  for(std::size_t k = 0; k < grown.corners.size(); ++k)
    ASSERT_EQ(grown.points[grown.corners[k]], model.points[model.polygons[k / 3][k % 3]]);
}

TEST(Stl, Solids_follow_each_other_and_unknown_lines_are_left_out)
{
  const Model model = random_model(14, 3, 3);
  Model twice = model;
  twice.polygons.insert(twice.polygons.end(), model.polygons.begin(), model.polygons.end());
  expect_model(with_corners_numbered(twice), "m.stl", stl(model) + stl(model, "second"));
  const std::string text = replaced(stl(model), "endfacet\n", "endfacet\ncolour 1 2 3\n");
  expect_model(with_corners_numbered(model), "m.stl", text);
  expect_warnings({ "lines left out: " + std::to_string(model.polygons.size()) + " of kind 'colour'" }, "m.stl", text);
}

TEST(Stl, Faults_are_refused_with_their_place)
{
  const std::string text = stl(triangle_model());
  for(const auto& [old, replacement, line] : std::vector<std::tuple<const char*, const char*, int> >{
        { "solid model\n", "", 1 }, { "facet normal", "faset normal", 3 }, { "normal", "", 2 }, { "0 nan 1", "0 1", 3 },
        { "outer ", "", 3 }, { "vertex 0 0 0\n", "", 6 }, { "vertex 0 0 0\n", "vertex 0 0\n", 5 },
        { "vertex 0 0 0\n", "vertex 0 0 0 0\n", 4 }, { "vertex 0 0 0\n", "point 0 0 0\n", 4 }, { "endloop\n", "\n", 8 },
        { "endfacet\n", "\n", 9 }, { "endsolid model\n", "", 9 }, { "endsolid model\n", "solid model\n", 9 },
        { "endfacet", "endfacet\n\x80", 9 }, { "endfacet", "endfacet\n0 0 1", 9 } })
    expect_failure("line " + std::to_string(line), "m.stl", replaced_first(text, old, replacement));

  const std::string content = binary_stl(random_model(15, 3, 3), "solid");
  expect_failure("byte 80: ", "m.stl", content.substr(0, content.size() - 1));
  expect_failure("byte 80: ", "m.stl", content + "x");
  expect_failure("byte 50: the file ends in its header", "m.stl", content.substr(0, 50));
  expect_failure("byte 96: facet 0 ", "m.stl", std::string(content).replace(100, 4, "\xFF\xFF\xFF\xFF"));
}

// ---------------------------------------------------------------- GOCAD

TEST(Gocad, Vertices_have_any_numbers)
{
  const Model model = random_model(16, 3, 3);
  for(const std::size_t first : { 0, 1, 2, 1000000 })
    expect_model(model, "m.ts", gocad(model, first));
  expect_model({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 1, 0, 2 }, { 1, 0, 2 } } }, "m.ts",
               "GOCAD TSurf 1\nHEADER {\nVRTX_of:no meaning\n}\nTFACE\nVRTX 5 0 0 0 CNXYZ\nPVRTX 4 1 0 0 0.5 x\n"
               "TRGL 4 5 999999999999\nVRTX 999999999999 0 1 0\nATOM 8 4\nTRGL 8 5 999999999999\nEND\n");
}

TEST(Gocad, Objects_number_their_vertices_themselves)
{
  const Model model = random_model(17, 3, 3);
  Model twice = model;
  twice.points.insert(twice.points.end(), model.points.begin(), model.points.end());
  for(std::vector<std::size_t> polygon : model.polygons)
  {
    for(std::size_t& vertex : polygon)
      vertex += model.points.size();
    twice.polygons.push_back(polygon);
  }
  expect_model(twice, "m.ts", gocad(model, 1) + gocad(model, 1));
  expect_warnings({ "lines left out: 1 of kind 'KEY'" }, "m.ts", replaced_first(gocad(model), "BSTONE 2", "KEY 1"));
}

TEST(Gocad, Faults_are_refused_with_their_line)
{
  const std::string text = gocad(triangle_model());
  for(const auto& [old, replacement, line] : std::vector<std::tuple<const char*, const char*, int> >{
        { "GOCAD", "GOCA", 1 }, { "TSurf", "VSet", 1 }, { "TFACE\n", "", 5 }, { "VRTX 1", "VRTX one", 6 },
        { "VRTX 1 0 0 0", "VRTX 1 0 0", 6 }, { "VRTX 2", "VRTX 1", 11 }, { "TRGL 1 2 3", "TRGL 1 2", 9 },
        { "TRGL 1 2 3", "TRGL 1 2 4", 9 }, { "TRGL 1 2 3", "TRGL 1 2 3 3", 9 }, { "TRGL 1 2 3", "ATOM 4 5", 9 },
        { "TRGL 1 2 3", "TRGL 1 2 3\n1 2 3", 10 },
        { "END\n", "", 11 }, { "END\n", "GOCAD TSurf 1\n", 11 }, { "END\n", "END\nEND\n", 12 } })
    expect_failure("line " + std::to_string(line), "m.ts", replaced_first(text, old, replacement));
}

// ---------------------------------------------------------------- VTP

TEST(Vtp, Arrays_have_several_encodings)
{
  for(unsigned int seed = 20; seed < 30; ++seed)
  {
    const Model model = random_model(seed, 3, 6);
    expect_model(model, "m.vtp", vtp(model));
    for(const bool is_big_endian : { false, true })
    {
      expect_model(model, "m.vtp", binary_vtp(model, is_big_endian, false, true));
      expect_model(model, "m.vtp", binary_vtp(model, is_big_endian, true, true));
      expect_model(model, "m.vtp", binary_vtp(model, is_big_endian, true, false));
    }
  }
}

TEST(Vtp, Pieces_and_strips_are_put_together)
{
  const Model model{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2, 3 } } };
  const std::string text = vtp(model), strips = replaced(replaced(text, "NumberOfPolys", "NumberOfStrips"), "Polys>",
                                                         "Strips>");
  const auto piece_of = [](const std::string& file)
  {
    const std::size_t begin = file.find("<Piece"), end = file.find("</PolyData>");
    return file.substr(begin, end - begin);
  };
  Model twice = model;
  twice.points.insert(twice.points.end(), model.points.begin(), model.points.end());
  twice.polygons.insert(twice.polygons.end(), { { 4, 5, 6 }, { 6, 5, 7 } });
  expect_model(twice, "m.vtp", replaced_first(text, "</PolyData>", piece_of(strips) + "</PolyData>"));
}

TEST(Vtp, Faults_are_refused_with_their_place)
{
  const Model model{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 9, 9 } }, { { 0, 1, 2 }, { 3, 2, 1 } } };
  const std::string text = vtp(model);
  for(const auto& [old, replacement, line] : std::vector<std::tuple<const char*, const char*, int> >{
        { "PolyData\"", "UnstructuredGrid\"", 2 }, { "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"", 4 },
        { "NumberOfPolys=\"2\"", "NumberOfPolys=\"1\"", 4 },
        { "NumberOfPoints=\"4\"", "NumberOfPoints=\"four\"", 4 },
        { "=\"3\"", "=\"2\"", 6 }, { "0 9 9", "0 9", 6 }, { "Float64", "Float80", 6 }, { "ascii", "unknown", 6 },
        { " 3 2 1", " 4 2 1", 14 }, { " 3 2 1", " -1 2 1", 14 }, { " 3 2 1", " 3 2 1 1", 14 }, { "\n6\n", "\n7\n", 18 },
        { "\n6\n", "\n3\n", 18 }, { "\n6\n", "\n2\n", 18 }, { "Int64", "Float32", 14 }, { "offsets", "ends", 4 },
        { "</VTKFile>", "", 26 }, { "</VTKFile>", "</VTKFile>\n0", 25 },
        { "</Piece>", "", 24 }, { "</Polys>", "</Polys", 22 }, { "\"ascii\"", "\"ascii", 6 },
        { "\"ascii\"", "\"appended\" offset=\"0\"", 6 } })
    expect_failure("line " + std::to_string(line), "m.vtp", replaced_first(text, old, replacement));
  expect_failure("line 6: arrays are compressed by", "m.vtp",
                 replaced_first(binary_vtp(model, false, false, true), "byte_order",
                                "compressor='vtkLZ4DataCompressor' byte_order"));

  const std::string bytes = binary_vtp(model, false, true, false);
  EXPECT_NE(failure_of("m.vtp", replaced_first(bytes, "offset=\"7\"", "offset=\"-7\"")), "");
  EXPECT_NE(failure_of("m.vtp", replaced_first(bytes, "offset=\"7\"", "offset=\"70000\"")), "");
  EXPECT_NE(failure_of("m.vtp", bytes.substr(0, bytes.size() - 40)), "");
  EXPECT_NE(failure_of("m.vtp", replaced(binary_vtp(model, false, false, true), "\"binary\">", "\"binary\">*")), "");
}

} // namespace
