#ifndef FRAME_FIELDS_PROGRAMS_WRITE_QUADS_H
#define FRAME_FIELDS_PROGRAMS_WRITE_QUADS_H

#include "Quad_options.h"
#include "Quads.h"
#include "quad_formats.h"
#include "write_msh.h"
#include "write_quad_obj.h"
#include "write_quad_ply.h"
#include "write_quad_vtp.h"

#include "../shared/write_file.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <ostream>
#include <string>

inline void write_quads(const std::string& path, const Quad_options& options, Quads& quads)
{
  write_file(path, [&](std::ostream& out)
  {
    switch(quad_format_of(path))
    {
      case Quad_format::OBJ: return write_quad_obj(out, quads, options.writes_feature_lines);
      case Quad_format::OFF:
        CGAL::IO::write_OFF(out, quads.mesh, CGAL::parameters::stream_precision(17));
        return;
      case Quad_format::PLY: return write_quad_ply(out, quads, options.writes_ascii);
      case Quad_format::VTP: return write_quad_vtp(out, quads);
      case Quad_format::MSH: return write_msh(out, quads);
    }
  });
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_QUADS_H
