#ifndef TEST_FRAME_FIELDS_RANDOM_MODELS_H
#define TEST_FRAME_FIELDS_RANDOM_MODELS_H

#include "test_models.h"

#include <iosfwd>
#include <string>
#include <vector>

// Models that are drawn at random. The same seed gives the same model.
namespace test {

// The number that an environment variable holds.
int number_from_environment(const char* name, int default_value);

// A regular polygon, most sides of which carry a spike of a random apex angle between 0.5 and 44 degrees. Every side is
// cut into a few edges, most apexes have a fan of several triangles, and the inside has a few random points.
Model spiked_domain(unsigned int seed);

// All of these have random walks along edges as features; those that bound a volume have their sharp edges, too.
Model random_planar_domain(unsigned int seed);
Model random_convex_polyhedron(unsigned int seed);
Model random_star_shaped_polyhedron(unsigned int seed);
Model random_gear(unsigned int seed);
Model random_torus(unsigned int seed); // subdivided; every fourth one has no features

struct Random_models
{
  std::string name;
  Model (*draw)(unsigned int seed);
};
std::ostream& operator<<(std::ostream& out, const Random_models& models);

std::vector<Random_models> kinds_of_random_models();

} // namespace test

#endif // TEST_FRAME_FIELDS_RANDOM_MODELS_H
