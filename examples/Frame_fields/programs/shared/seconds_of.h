#ifndef FRAME_FIELDS_PROGRAMS_SECONDS_OF_H
#define FRAME_FIELDS_PROGRAMS_SECONDS_OF_H

#include <CGAL/Real_timer.h>

template <typename Function>
double seconds_of(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

#endif // FRAME_FIELDS_PROGRAMS_SECONDS_OF_H
