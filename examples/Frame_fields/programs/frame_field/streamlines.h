#ifndef FRAME_FIELDS_PROGRAMS_STREAMLINES_H
#define FRAME_FIELDS_PROGRAMS_STREAMLINES_H

#include "Field.h"
#include "Options.h"

#include "../shared/Mesh.h"

#include <CGAL/Frame_fields/Streamline.h>
#include <CGAL/Frame_fields/trace_streamlines.h>

#include <CGAL/tags.h>

#include <iterator>
#include <optional>
#include <vector>

typedef CGAL::Frame_fields::Streamline<Point, Face> Streamline;

// The streamlines that the options ask for.
inline std::vector<Streamline> streamlines(const Mesh& mesh, const Feature_map is_feature, const Field& field,
                                           const Options& options)
{
  std::vector<Streamline> result;
  if(!options.streamline_spacing)
    return result;
  const double given = *options.streamline_spacing;
  const std::optional<double> spacing = given > 0 ? std::optional<double>(given) : std::nullopt;
  check(CGAL::Frame_fields::trace_streamlines(mesh, field.alpha, field.rho, field.matching, std::back_inserter(result),
                                              CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature)
                                                .streamline_spacing(spacing)
                                                .concurrency_tag(CGAL::Parallel_if_available_tag())),
        options);
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_STREAMLINES_H
