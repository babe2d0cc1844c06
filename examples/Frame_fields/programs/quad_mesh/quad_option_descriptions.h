#ifndef FRAME_FIELDS_PROGRAMS_QUAD_OPTION_DESCRIPTIONS_H
#define FRAME_FIELDS_PROGRAMS_QUAD_OPTION_DESCRIPTIONS_H

#include "../shared/known_extensions.h"
#include "../shared/option_descriptions.h"

#include <boost/program_options.hpp>

#include <ostream>
#include <string>
#include <vector>

inline boost::program_options::options_description size_option_descriptions()
{
  namespace po = boost::program_options;
  po::options_description options("Size", 100);
  options.add_options()
    ("edge-length", po::value<double>()->value_name("L"),
     "the length that edges should have (a length of the model); the mean edge length of MODEL by default")
    ("quads", po::value<int>()->value_name("N"), "instead of a length: about how many quadrangles there should be")
    ("chord-height", po::value<double>()->value_name("S"),
     "shorter edges where they would be farther than S from bends of the surface and of features")
    ("edges-across-gap", po::value<int>()->value_name("N"),
     "shorter edges where there would be less than N between features, as across a fillet")
    ("gradation", po::value<double>()->value_name("G"),
     "with these two: the greatest ratio of the lengths of consecutive edges; 1.5 by default")
    ("min-edge-length", po::value<double>()->value_name("L"), "with these two: no shorter edges than L; 0 by default")
    ("field-follows-sizes",
     "with these two: irregular vertices where the lengths make rows of quadrangles end; best with a gradation of\n"
     "1.2 or less")
    ("no-refinement", "keep triangles that are much longer than the quadrangles; otherwise a copy of them is refined");
  return options;
}

inline boost::program_options::options_description quad_output_option_descriptions()
{
  namespace po = boost::program_options;
  po::options_description options("Output", 100);
  options.add_options()
    ("output,o", po::value<std::vector<std::string> >()->value_name("FILE"),
     "write the quadrangles: .obj, .off, .ply, .vtp (ParaView) or .msh (Gmsh 4.1, for solvers); can be given\n"
     "several times")
    ("ascii", "write PLY files as text")
    ("feature-lines", "write the feature edges to OBJ files as well, as lines (l)")
    ("blocks", po::value<std::string>()->value_name("KIND"),
     "divide the quadrangles into rectangular blocks, for PLY and VTP files: whole-sides, which meet along whole\n"
     "sides; by-patch, which do so between features; or t-junctions, the fewest")
    ("write-features", file_value(),
     "write the feature edges of the quadrangle mesh, in the format that the name's end tells as for --features");
  add_run_option_descriptions(options);
  return options;
}

inline boost::program_options::options_description quad_option_descriptions()
{
  boost::program_options::options_description options;
  options.add(model_option_descriptions()).add(feature_option_descriptions()).add(size_option_descriptions())
    .add(quad_output_option_descriptions()).add(field_option_descriptions());
  return options;
}

inline void print_quad_help(std::ostream& out)
{
  out << "cad_quad_mesh MODEL [--edge-length L | --quads N] -o OUT [options]\n\n"
         "Makes a mesh of quadrangles on a CAD model; each feature edge becomes a chain of edges.\n"
         "MODEL is a file whose name ends with one of " << known_extensions << ".\n"
         "What is not an oriented manifold triangle mesh is repaired before; warnings tell how.\n\n"
      << quad_option_descriptions()
      << "\nWhat the files hold beside the quadrangles:\n"
         "  .ply  faces: patch, counted from 0; vertices: feature, 1 on feature edges and borders\n"
         "  .vtp  quadrangles: patch, scaled_jacobian; feature edges as lines: curve; irregular vertices: valence,\n"
         "        on_feature (valence is then that of one sector between two feature edges)\n"
         "  .msh  quadrangles (type 3) in physical groups patch_0 ..., feature edges (type 1) in curve_0 ...\n"
         "With --blocks, .ply and .vtp have the block of each quadrangle, counted from 0.\n\n";
  print_exit_codes(out);
}

#endif // FRAME_FIELDS_PROGRAMS_QUAD_OPTION_DESCRIPTIONS_H
