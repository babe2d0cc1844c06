#ifndef CAD_FRAME_FIELD_WRITE_FILE_H
#define CAD_FRAME_FIELD_WRITE_FILE_H

#include "Failure.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

inline bool is_device_or_pipe(const std::string& path)
{
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

// Finds before a long computation that its result could not be written.
inline void check_output_path(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(path, error).parent_path();
  if(fs::is_directory(path, error))
    throw Failure(BAD_FILE, path + ": this is a folder; give the name of a file");
  if(!fs::is_directory(folder, error))
    throw Failure(BAD_FILE, path + ": there is no folder " + folder.string());
  if(!is_device_or_pipe(path) && access(folder.c_str(), W_OK) != 0)
    throw Failure(BAD_FILE, path + ": no permission to write to the folder " + folder.string());
}

template <typename Write>
void write_directly(const std::string& path, const std::string& name, const Write& write)
{
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  write(out);
  out.close();
  if(!out)
    throw Failure(BAD_FILE, name + ": cannot be written"
                            + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

// Writes a file wholly or not at all: a new file beside it takes its name when it is complete. Nothing can take the
// name of a device or a pipe, these are written directly. `write` gets a binary output stream.
template <typename Write>
void write_file(const std::string& path, const Write& write)
{
  namespace fs = std::filesystem;
  if(is_device_or_pipe(path))
    return write_directly(path, path, write);

  const fs::path target = fs::weakly_canonical(path); // a symbolic link keeps pointing to the file
  const fs::path unfinished = target.string() + "." + std::to_string(getpid()) + ".part";
  try
  {
    write_directly(unfinished.string(), path, write);
    fs::rename(unfinished, target);
  }
  catch(...)
  {
    std::error_code error;
    fs::remove(unfinished, error);
    throw;
  }
}

#endif // CAD_FRAME_FIELD_WRITE_FILE_H
