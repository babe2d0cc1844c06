#ifndef FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H
#define FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H

// The ends of the names of files that can be read.
#ifdef CGAL_USE_VTK
constexpr char known_extensions[] = ".off .obj .ply .stl .ts .vtp";
#else
constexpr char known_extensions[] = ".off .obj .ply .stl .ts";
#endif

#endif // FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H
