// Runs the fuzz target on files and on all files of folders, without libFuzzer.

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void replay(const std::filesystem::path& file)
{
  std::cout << file.filename().string() << std::endl;
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{ std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

} // namespace

int main(int argc, char* argv[])
{
  int number_of_files = 0;
  for(int k = 1; k < argc; ++k)
  {
    if(!std::filesystem::is_directory(argv[k]))
    {
      replay(argv[k]);
      ++number_of_files;
      continue;
    }
    for(const auto& entry : std::filesystem::directory_iterator(argv[k]))
    {
      replay(entry.path());
      ++number_of_files;
    }
  }
  std::cout << number_of_files << " files" << std::endl;
  return number_of_files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
