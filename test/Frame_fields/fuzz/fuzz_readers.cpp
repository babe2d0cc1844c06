// A target for libFuzzer: the first byte selects a format, the others are a file of it. What is read keeps the contract
// of Raw_soup, and is the same when it is written in another format and read again.

#include "../../../examples/Frame_fields/programs/shared/formats/read_raw_soup.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

namespace {

void expect(const bool is_true, const char* const fact)
{
  if(is_true)
    return;
  std::cerr << "broken: " << fact << std::endl;
  std::abort();
}

// `size` is that of the file, without compression.
void check_soup(const Raw_soup& soup, const std::size_t size)
{
  expect(!soup.ends.empty() && soup.ends.back() == soup.corners.size(), "there are polygons, of all corners");
  std::size_t start = 0;
  for(const std::size_t end : soup.ends)
  {
    expect(end > start, "each polygon has corners");
    start = end;
  }
  for(const std::size_t corner : soup.corners)
    expect(corner < soup.points.size(), "corners are points");
  for(const Coordinates& point : soup.points)
    for(const double coordinate : point)
      expect(std::isfinite(coordinate), "coordinates are finite");
  expect(soup.points.capacity() <= size && soup.corners.capacity() <= 6 * size && soup.ends.capacity() <= 2 * size,
         "memory is in proportion to the file");
}

std::string off_text(const Raw_soup& soup)
{
  std::string text = "OFF\n" + std::to_string(soup.points.size()) + " " + std::to_string(soup.ends.size()) + " 0\n";
  for(const Coordinates& point : soup.points)
  {
    char line[100];
    std::snprintf(line, sizeof(line), "%.17g %.17g %.17g\n", point[0], point[1], point[2]);
    text += line;
  }
  std::size_t start = 0;
  for(const std::size_t end : soup.ends)
  {
    text += std::to_string(end - start);
    for(; start < end; ++start)
      text += " " + std::to_string(soup.corners[start]);
    text += "\n";
  }
  return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size)
{
  static constexpr const char* paths[] = { "m.off", "m.obj", "m.ply", "m.stl", "m.ts", "m.vtp" };
  if(size == 0)
    return 0;
  const std::string path = paths[data[0] % std::size(paths)];
  try
  {
    const Raw_soup soup = read_raw_soup(path, { reinterpret_cast<const char*>(data) + 1, size - 1 });
    const std::size_t maximum_compression = path == "m.vtp" ? 1032 : 1;
    check_soup(soup, maximum_compression * size);
    const Raw_soup again = read_raw_soup("again.off", off_text(soup));
    expect(again.points == soup.points && again.corners == soup.corners && again.ends == soup.ends
           && again.warnings.empty(), "what is written is read again");
  }
  catch(const Failure& failure)
  {
    const std::string_view message = failure.what();
    expect(failure.exit_code == BAD_FILE && message.substr(0, path.size() + 2) == path + ": "
           && message.find('\n') == std::string_view::npos && message.size() < 500, "one line tells the fault");
  }
  return 0;
}
