#ifndef FRAME_FIELDS_PROGRAMS_FIELD_FORMATS_H
#define FRAME_FIELDS_PROGRAMS_FIELD_FORMATS_H

#include "../shared/Failure.h"
#include "../shared/file_extension.h"

#include <string>

// Formats of fields in other programs.
enum Field_format
{
  RAWFIELD, // Directional: four vectors a face
  ROSY,     // QuadWild, VCGlib: one vector a face, which stands for a cross
  FFIELD    // VCGlib: two vectors a face
};

inline Field_format field_format_of(const std::string& path)
{
  const std::string extension = lower_case_extension(path);
  if(extension == ".rawfield")
    return RAWFIELD;
  if(extension == ".rosy")
    return ROSY;
  if(extension == ".ffield")
    return FFIELD;
  throw Failure(BAD_USAGE, path + ": the name of a field must end with .rawfield, .rosy or .ffield");
}

#endif // FRAME_FIELDS_PROGRAMS_FIELD_FORMATS_H
