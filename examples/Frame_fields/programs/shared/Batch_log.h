#ifndef FRAME_FIELDS_PROGRAMS_BATCH_LOG_H
#define FRAME_FIELDS_PROGRAMS_BATCH_LOG_H

#include "Failure.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

typedef nlohmann::ordered_json Json;

// The results of a batch, a line of JSON for each model. What a killed batch left of a line is dropped.
class Batch_log
{
public:
  explicit Batch_log(const std::string& path)
    : m_path(path)
    , m_descriptor(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
  {
    if(m_descriptor < 0)
      throw Failure(BAD_FILE, path + ": cannot be written; check the permissions of its folder");
    if(flock(m_descriptor, LOCK_EX | LOCK_NB) != 0)
      throw Failure(BAD_FILE, path + ": another batch is writing to it");
    read_lines();
    std::filesystem::resize_file(path, m_size);
    m_out.open(path, std::ios::binary | std::ios::app);
  }

  Batch_log(const Batch_log&) = delete;
  ~Batch_log() { close(m_descriptor); }

  // The task of a model: all that its result depends on.
  static std::string task_of(const Json& line)
  {
    return Json{ line.at("model"), line.at("features"), line.at("arguments") }.dump();
  }

  bool has(const Json& line) const { return m_tasks.count(task_of(line)) > 0; }

  void append(const Json& line)
  {
    // File names may hold any bytes, but JSON must be UTF-8.
    m_out << line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" << std::flush;
    if(!m_out)
      throw Failure(BAD_FILE, m_path + ": cannot be written");
  }

private:
  void read_lines()
  {
    std::ifstream in(m_path, std::ios::binary);
    std::size_t number = 0;
    for(std::string line; std::getline(in, line) && !in.eof();)
    {
      ++number;
      try
      {
        m_tasks.insert(task_of(Json::parse(line)));
      }
      catch(const Json::exception&)
      {
        throw Failure(BAD_FILE, m_path + ":" + std::to_string(number) + ": this is no result of a batch");
      }
      m_size += line.size() + 1;
    }
  }

  std::string m_path;
  int m_descriptor; // holds the lock
  std::ofstream m_out;
  std::set<std::string> m_tasks;
  std::uintmax_t m_size = 0;
};

#endif // FRAME_FIELDS_PROGRAMS_BATCH_LOG_H
