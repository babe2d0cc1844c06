#ifndef FRAME_FIELDS_PROGRAMS_PEAK_MEMORY_H
#define FRAME_FIELDS_PROGRAMS_PEAK_MEMORY_H

#include <sys/resource.h>

// The largest resident size that the program had so far, in MiB.
inline double peak_memory_mib()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  const double bytes_per_unit = 1;
#else
  const double bytes_per_unit = 1024;
#endif
  return usage.ru_maxrss * bytes_per_unit / (1024 * 1024);
}

#endif // FRAME_FIELDS_PROGRAMS_PEAK_MEMORY_H
