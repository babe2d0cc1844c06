#ifndef FRAME_FIELDS_PROGRAMS_READ_FIELD_H
#define FRAME_FIELDS_PROGRAMS_READ_FIELD_H

#include "field_formats.h"

#include "../shared/Mesh.h"
#include "../shared/input_file.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Two directions of a face.
typedef std::array<Vector, 2> Directions;

inline Vector read_vector(Word_reader& reader, const std::size_t face)
{
  std::array<double, 3> coordinates;
  for(double& coordinate : coordinates)
    coordinate = reader.next_number<double>("a coordinate of a vector of face " + std::to_string(face));
  return { coordinates[0], coordinates[1], coordinates[2] };
}

inline std::size_t read_count(Word_reader& reader, const std::string& expected)
{
  const long long count = reader.next_number<long long>(expected);
  if(count < 0)
    reader.fail(expected + " is negative");
  return static_cast<std::size_t>(count);
}

// What stands before the vectors; returns the number of faces.
inline std::size_t read_header(Word_reader& reader, const Field_format format)
{
  if(format == FFIELD)
  {
    reader.next(); // "target_frame"
    reader.skip_line();
    const std::size_t number = read_count(reader, "the number of faces");
    reader.next(); // the names of the columns
    reader.skip_line();
    return number;
  }
  std::size_t number = read_count(reader, format == ROSY ? "the number of faces" : "the number of directions");
  std::size_t degree = read_count(reader, format == ROSY ? "the number of directions" : "the number of faces");
  if(format == RAWFIELD)
    std::swap(number, degree);
  if(degree != 4)
    reader.fail("the field has " + std::to_string(degree) + " directions a face; it must have 4");
  return number;
}

// Reads a field of a mesh. Of the four vectors of Directional the first two count; of the cross of QuadWild only the
// first direction is in the file, and the second one is left zero.
inline std::vector<Directions> read_field(const std::string& path, const std::size_t number_of_faces)
{
  const Field_format format = field_format_of(path);
  Word_reader reader(path);
  const std::size_t number = read_header(reader, format);
  if(number != number_of_faces)
    reader.fail("the field has " + std::to_string(number) + " faces and the model " + std::to_string(number_of_faces));
  std::vector<Directions> result(number);
  for(std::size_t f = 0; f < number; ++f)
  {
    if(format == FFIELD)
      for(int k = 0; k < 2; ++k)
        reader.next_number<double>("a size of face " + std::to_string(f));
    const int number_of_vectors = format == RAWFIELD ? 4 : format == FFIELD ? 2 : 1;
    for(int k = 0; k < number_of_vectors; ++k)
    {
      const Vector vector = read_vector(reader, f);
      if(k < 2)
        result[f][k] = vector;
    }
  }
  reader.expect_end();
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_READ_FIELD_H
