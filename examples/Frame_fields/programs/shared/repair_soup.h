#ifndef FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H
#define FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Shared_options.h"
#include "Soup.h"
#include "soup/Near_borders.h"
#include "soup/Triangle.h"
#include "soup/Triangle_surface.h"
#include "soup/close_cracks.h"
#include "soup/remove_duplicates.h"
#include "soup/triangulate_soup.h"

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Warnings about a model with a number at their ends, unless it is 0.
struct Repair_log
{
  const std::string& path;
  Console& console;
  bool has_all_faces = true; // each one is a triangle of the file

  void warn(const char* const change, const std::size_t number) const
  {
    if(number > 0)
      console.warn(path + ": " + change + ": " + std::to_string(number));
  }

  void warn_of_faces(const char* const change, const std::size_t number)
  {
    warn(change, number);
    has_all_faces = has_all_faces && number == 0;
  }
};

// The polygons as triangles without duplicates.
inline std::vector<Triangle> repaired_triangles(const Soup& soup, const std::vector<std::size_t>& place,
                                                Repair_log& log)
{
  Triangulated_soup triangulated = triangulate_soup(soup.points, soup.polygons, place);
  if(triangulated.number_of_wrong_polygons > 0)
    throw Failure(BAD_FILE, log.path + ": faces that cannot be triangulated: "
                            + std::to_string(triangulated.number_of_wrong_polygons) + ", the first is face "
                            + std::to_string(triangulated.first_wrong_polygon) + " (counted from 0), which "
                            + triangulated.fault_of_first + "; triangulate it before");
  std::vector<Triangle> triangles = std::move(triangulated.triangles);
  const std::size_t number_of_triangles = triangles.size();
  remove_duplicate_triangles(place, triangles);
  if(triangles.empty())
    throw Failure(BAD_FILE, log.path + ": all its faces are degenerate");
  log.warn_of_faces("degenerate or duplicate faces removed",
                    triangulated.number_of_degenerate_polygons + number_of_triangles - triangles.size());
  log.warn_of_faces("faces of more than three vertices triangulated", triangulated.number_of_triangulated_polygons);
  return triangles;
}

inline void check_number_of_borders(const bool is_searched, const std::string& path)
{
  if(!is_searched)
    throw Failure(BAD_FILE, path + ": too many borders are nearer to one another than the tolerance of --close-cracks");
}

inline void remove_useless_triangles(const std::vector<std::size_t>& place, std::vector<Triangle>& triangles)
{
  remove_degenerate_triangles(place, triangles);
  remove_duplicate_triangles(place, triangles);
}

// The surface whose border sides are joined across gaps of at most `tolerance`; places that become one are united.
inline Triangle_surface surface_without_cracks(const std::vector<Point>& points, const Triangle_surface& surface,
                                               const double tolerance, std::vector<std::size_t>& place, Repair_log& log)
{
  const std::vector<Border> borders = borders_of(points, surface);
  std::vector<Triangle> triangles = surface.triangles();
  check_number_of_borders(unite_near_places(points, borders, tolerance, place), log.path);
  remove_useless_triangles(place, triangles);
  const Triangle_surface united(points, place, triangles);
  check_number_of_borders(split_sides_at_near_places(points, united, tolerance, triangles), log.path);
  const std::size_t number_of_parts = triangles.size();
  remove_useless_triangles(place, triangles);
  if(triangles.empty())
    throw Failure(BAD_FILE, log.path + ": all its faces are smaller than the tolerance of --close-cracks");

  const std::size_t number_of_united = united.triangles().size();
  log.warn_of_faces("faces removed that lay in cracks", surface.triangles().size() - number_of_united
                                                          + number_of_parts - triangles.size());
  log.warn_of_faces("faces added by splitting where others end at cracks", number_of_parts - number_of_united);
  Triangle_surface closed(points, place, std::move(triangles));
  const std::size_t number_of_borders = borders_of(points, closed).size();
  if(number_of_borders < borders.size())
    log.warn("border edges joined across cracks", borders.size() - number_of_borders);
  return closed;
}

inline std::string rounded_text(const double number)
{
  std::ostringstream text;
  text.precision(2);
  text << number;
  return text.str();
}

inline void warn_of_cracks(const std::vector<Point>& points, const Triangle_surface& surface, const Repair_log& log)
{
  const double relative_tolerance = 1e-6;
  CGAL::Bbox_3 box;
  for(std::size_t corner = 0; corner < surface.number_of_sides(); ++corner)
    box += points[surface.place_at(corner)].bbox();
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const double tolerance = relative_tolerance * diagonal;
  const std::vector<Border> borders = borders_of(points, surface);
  if(borders.empty() || !std::isfinite(diagonal))
    return;
  const Crack_figures cracks = find_cracks(borders, tolerance);
  if(cracks.number_of_sides > 0)
    log.console.warn(log.path + ": border edges that run along others, at most " + rounded_text(cracks.maximum_distance)
                     + " apart: " + std::to_string(cracks.number_of_sides) + "; --close-cracks "
                     + rounded_text(tolerance) + " joins them");
}

inline Triangle_surface repaired_surface(const Soup& soup, const Shared_options& options,
                                         std::vector<std::size_t>& place, Repair_log& log)
{
  Triangle_surface surface(soup.points, place, repaired_triangles(soup, place, log));
  if(options.crack_tolerance > 0)
    return surface_without_cracks(soup.points, surface, options.crack_tolerance, place, log);
  return surface;
}

#endif // FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H
