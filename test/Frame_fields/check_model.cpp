// Computes the field of a model and prints the facts of the contract that do not hold for it. The exit code is 0 if all
// hold, 1 if one does not, and 2 if the files cannot be read.
//
//   check_model MODEL.off FEATURES

#include "field_contract.h"
#include "test_cad_mesh.h"

#include <cstdlib>
#include <exception>
#include <iostream>

int main(int argc, char* argv[])
{
  if(argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " MODEL.off FEATURES" << std::endl;
    return 2;
  }
  test::Model model;
  try
  {
    model = test::read_model(argv[1], argv[2]);
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 2;
  }
  const test::Cad_mesh<test::Surface_mesh> cad_mesh(model);
  const std::string broken = test::broken_facts(cad_mesh.cut(), test::frame_field(cad_mesh));
  std::cout << broken;
  return broken.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
