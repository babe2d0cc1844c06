#ifndef FRAME_FIELDS_PROGRAMS_THREAD_LIMIT_H
#define FRAME_FIELDS_PROGRAMS_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <optional>

// Limits the threads of the program as long as it lives; one thread is the main one, and none is started then.
class Thread_limit
{
public:
  explicit Thread_limit(const std::optional<int> number_of_threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(number_of_threads)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, *number_of_threads);
#else
    static_cast<void>(number_of_threads);
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_control;
#endif
};

#endif // FRAME_FIELDS_PROGRAMS_THREAD_LIMIT_H
