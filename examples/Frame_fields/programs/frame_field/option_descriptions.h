#ifndef FRAME_FIELDS_PROGRAMS_FRAME_FIELD_OPTION_DESCRIPTIONS_H
#define FRAME_FIELDS_PROGRAMS_FRAME_FIELD_OPTION_DESCRIPTIONS_H

#include "../shared/known_extensions.h"
#include "../shared/option_descriptions.h"

#include <boost/program_options.hpp>

#include <ostream>
#include <string>
#include <vector>

inline boost::program_options::options_description comparison_option_descriptions()
{
  boost::program_options::options_description options("Comparison", 100);
  options.add_options()
    ("no-baseline", "do not compute the field without correction, for comparison")
    ("compare", file_value(),
     "read a field of another program on the faces of MODEL (.rawfield, .rosy or .ffield) and tell its figures, too");
  return options;
}

inline boost::program_options::options_description output_option_descriptions()
{
  namespace po = boost::program_options;
  po::options_description options("Output", 100);
  options.add_options()
    ("output,o", file_value(), "write the mesh and the field as PLY")
    ("ascii", "write the PLY file as text")
    ("vtp", file_value(), "write faces, features and singular sectors as VTK PolyData, for ParaView")
    ("streamlines", po::value<double>()->value_name("SPACING")->implicit_value(0, "default"),
     "write streamlines to the VTP file as well, at this distance (a length of the model) or a default one")
    ("field", po::value<std::vector<std::string> >()->value_name("FILE"),
     "write the field for other programs: .rawfield (Directional), .rosy (QuadWild) or .ffield (VCGlib); can\n"
     "be given several times")
    ("write-features", file_value(),
     "write the feature edges of the mesh of the field, in the format that the name's end tells as above");
  add_run_option_descriptions(options);
  return options;
}

inline boost::program_options::options_description option_descriptions()
{
  boost::program_options::options_description options;
  options.add(model_option_descriptions()).add(feature_option_descriptions()).add(field_option_descriptions())
    .add(comparison_option_descriptions()).add(output_option_descriptions());
  return options;
}

inline void print_help(std::ostream& out)
{
  out << "cad_frame_field MODEL [options]\n\n"
         "Computes a frame field that a quadrangle mesh can follow on a CAD model.\n"
         "MODEL is a file whose name ends with one of " << known_extensions << ".\n"
         "What is not an oriented manifold triangle mesh is repaired before; warnings tell how.\n\n"
      << option_descriptions()
      << "\nOUT.ply holds the mesh whose faces with several feature edges are split, and its properties:\n"
         "  face      alpha, rho in radians; unit vectors u, v (branches 0 and 1) as ux uy uz vx vy vz\n"
         "  edge      feature: 1 for features and borders\n"
         "  halfedge  matching; prescribed_rotation in radians; index: 4 times that of the sector at the target\n"
         "In the JSON report, the angles of unmeshable_sectors are in degrees and indices are multiplied by 4.\n\n";
  print_exit_codes(out);
}

#endif // FRAME_FIELDS_PROGRAMS_FRAME_FIELD_OPTION_DESCRIPTIONS_H
