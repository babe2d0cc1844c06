#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_RAW_SOUP_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_RAW_SOUP_H

#include "../Failure.h"
#include "../file_extension.h"
#include "../known_extensions.h"
#include "File_content.h"
#include "Raw_soup.h"
#include "read_gocad.h"
#include "read_obj.h"
#include "read_off.h"
#include "read_ply.h"
#include "read_stl.h"
#include "read_vtp.h"

#include <string>
#include <string_view>

inline Raw_soup read_by_extension(const File_content& file)
{
  const std::string extension = lower_case_extension(file.path);
  if(extension == ".off")
    return read_off(file);
  if(extension == ".obj")
    return read_obj(file);
  if(extension == ".ply")
    return read_ply(file);
  if(extension == ".stl")
    return read_stl(file);
  if(extension == ".ts")
    return read_gocad(file);
  if(extension == ".vtp")
    return read_vtp(file);
  file.fail(std::string("the kind of file is unknown; its name must end with one of ") + known_extensions);
}

// Reads the content of a file whose kind its name tells. It fails with the line or the byte, and never takes more
// memory than a small multiple of the content.
inline Raw_soup read_raw_soup(const std::string& path, const std::string_view bytes)
{
  const File_content file{ path, bytes };
  if(bytes.empty())
    file.fail("byte 0: the file is empty");
  Raw_soup soup = read_by_extension(file);
  if(soup.ends.empty())
    file.fail("there are no faces in it" + (soup.warnings.empty() ? "" : "; " + soup.warnings.front()));
  return soup;
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_RAW_SOUP_H
