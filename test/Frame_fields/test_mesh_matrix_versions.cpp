#include <CGAL/version.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <string>

// Tells in the report of the tests what they were compiled with.
namespace {

std::string version(const int major, const int minor) { return std::to_string(major) + '.' + std::to_string(minor); }

class Versions : public testing::Environment
{
  void SetUp() override
  {
    testing::Test::RecordProperty("cgal", version(CGAL_VERSION_MAJOR, CGAL_VERSION_MINOR));
#if EIGEN_MAJOR_VERSION < 5 // the first number was the "world" before
    testing::Test::RecordProperty("eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION));
#else
    testing::Test::RecordProperty("eigen", version(EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
#endif
    testing::Test::RecordProperty("standard", "C++" + std::to_string(__cplusplus / 100 % 100));
#ifdef __clang__
    testing::Test::RecordProperty("compiler", "clang++ " + std::to_string(__clang_major__));
#else
    testing::Test::RecordProperty("compiler", "g++ " + std::to_string(__GNUC__));
#endif
  }
};

testing::Environment* const versions = testing::AddGlobalTestEnvironment(new Versions);

} // namespace
