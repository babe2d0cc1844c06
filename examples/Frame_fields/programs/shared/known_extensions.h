#ifndef FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H
#define FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H

// The ends of the names of files that can be read.
constexpr char known_extensions[] = ".off .obj .ply .stl .ts .vtp";

#endif // FRAME_FIELDS_PROGRAMS_KNOWN_EXTENSIONS_H
