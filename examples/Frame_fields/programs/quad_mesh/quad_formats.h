#ifndef FRAME_FIELDS_PROGRAMS_QUAD_FORMATS_H
#define FRAME_FIELDS_PROGRAMS_QUAD_FORMATS_H

#include "../shared/Failure.h"
#include "../shared/file_extension.h"

#include <string>

// Formats of quadrangle meshes.
enum class Quad_format
{
  OBJ,
  OFF,
  PLY,
  VTP, // VTK XML PolyData, for ParaView
  MSH  // Gmsh 4.1
};

inline Quad_format quad_format_of(const std::string& path)
{
  const std::string extension = lower_case_extension(path);
  if(extension == ".obj")
    return Quad_format::OBJ;
  if(extension == ".off")
    return Quad_format::OFF;
  if(extension == ".ply")
    return Quad_format::PLY;
  if(extension == ".vtp")
    return Quad_format::VTP;
  if(extension == ".msh")
    return Quad_format::MSH;
  throw Failure(BAD_USAGE, path + ": the name of a quadrangle mesh must end with .obj, .off, .ply, .vtp or .msh");
}

#endif // FRAME_FIELDS_PROGRAMS_QUAD_FORMATS_H
