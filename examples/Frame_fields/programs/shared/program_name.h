#ifndef FRAME_FIELDS_PROGRAMS_PROGRAM_NAME_H
#define FRAME_FIELDS_PROGRAMS_PROGRAM_NAME_H

// The name that messages start with; the main file of each program defines it.
extern const char* const program_name;

#endif // FRAME_FIELDS_PROGRAMS_PROGRAM_NAME_H
