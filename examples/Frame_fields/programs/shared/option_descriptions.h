#ifndef FRAME_FIELDS_PROGRAMS_OPTION_DESCRIPTIONS_H
#define FRAME_FIELDS_PROGRAMS_OPTION_DESCRIPTIONS_H

#include "known_extensions.h"

#include <boost/program_options.hpp>

#include <ostream>
#include <string>
#include <vector>

inline auto file_value()
{
  return boost::program_options::value<std::string>()->value_name("FILE");
}

inline auto number_value(const char* const name, const double default_value, const char* const text)
{
  return boost::program_options::value<double>()->value_name(name)->default_value(default_value, text);
}

inline boost::program_options::options_description model_option_descriptions()
{
  boost::program_options::options_description options("Model", 100);
  options.add_options()
    ("no-merge", "keep vertices at the same place apart; otherwise the surface goes on where borders meet there")
    ("close-cracks", number_value("L", 0, "0"),
     "join borders that are at most L (a length of the model) apart; a warning tells of cracks and a value of L");
  return options;
}

inline boost::program_options::options_description feature_option_descriptions()
{
  namespace po = boost::program_options;
  po::options_description options("Features", 100);
  options.add_options()
    ("features", file_value(),
     "read the feature edges: two vertex indices of MODEL a line, counted from 0; # starts a comment. The\n"
     "ends .sharp and .feature of the name stand for the formats of QuadWild, .yml for that of ABC")
    ("feature-angle", number_value("DEG", 40, "40"),
     "without --features: edges whose faces' normals differ by DEG degrees or more are features")
    ("weak-angle", boost::program_options::value<double>()->value_name("DEG"),
     "without --features: so are edges of DEG degrees or more that are connected with them by such edges")
    ("close-gaps", "without --features: features are joined where one edge is missing")
    ("min-chain-length", number_value("L", 0, "0"),
     "without --features: chains of features shorter than L (a length of the model) that end in a patch, or\n"
     "are closed and alone, are none");
  return options;
}

inline boost::program_options::options_description field_option_descriptions()
{
  namespace po = boost::program_options;
  po::options_description options("Field", 100);
  options.add_options()
    ("support", po::value<std::string>()->value_name("S")->default_value("rings:4"),
     "where the rotation prescribed at sharp corners is compensated: none, local, rings:K, radius:R\n"
     "(a length of the model), radius (from the lengths of the feature curves) or component")
    ("edge-weights", po::value<std::string>()->value_name("W")->default_value("uniform"),
     "uniform, or geometric: by the shapes of the triangles, so that the field depends little on the mesh")
    ("curvature-weight", number_value("W", 0, "0"),
     "how strongly the principal directions of curvature guide the field; 0 for not at all")
    ("index-targets", file_value(),
     "read singularities that the field must have: a vertex index of MODEL that is on no feature edge and 4 times\n"
     "its index a line; the patches of these vertices then have no other singularities inside")
    ("sharp-corner-bound", number_value("DEG", 135, "135"), "sectors of less than DEG degrees are sharp corners")
    ("blunt-corner-bound", number_value("DEG", 22.5, "22.5"),
     "other sectors that differ by more than DEG degrees from a straight line are blunt corners; 360 for none")
    ("no-repair", "leave sectors on feature edges at an index of 1/2 or more")
    ("no-relaxation", "keep the crosses orthogonal")
    ("threads", po::value<int>()->value_name("N"), "how many threads to use; all cores by default");
  return options;
}

inline void add_run_option_descriptions(boost::program_options::options_description& options)
{
  options.add_options()
    ("report", file_value(), "write the numbers as JSON")
    ("quiet", "print nothing but warnings and errors")
    ("verbose", "print more figures")
    ("help", "print this text")
    ("version", "print the version");
}

inline void print_exit_codes(std::ostream& out)
{
  out << "Exit codes: 0 done, 1 bad usage, 2 a file cannot be read or written or is invalid, 3 no solution was found.\n"
         "After a signal no unfinished file is left, and the signal ends the program.\n";
}

#endif // FRAME_FIELDS_PROGRAMS_OPTION_DESCRIPTIONS_H
