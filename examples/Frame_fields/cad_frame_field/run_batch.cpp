#include "run_batch.h"

#include "Batch_log.h"
#include "read_batch_list.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/dll/runtime_symbol_info.hpp>
#if __has_include(<boost/process/v1.hpp>)
#include <boost/process/v1.hpp>
namespace process = boost::process::v1;
#else
#include <boost/process.hpp>
namespace process = boost::process;
#endif

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <future>
#include <iostream>
#include <list>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace {

typedef std::chrono::steady_clock Clock;

// A model whose process runs.
struct Job
{
  Job(boost::asio::io_context& context, Json line) : line(std::move(line)), timer(context) {}

  Json line; // what is known of the result
  Clock::time_point start = Clock::now();
  std::future<std::string> report, messages;
  boost::asio::steady_timer timer;
  bool is_timed_out = false;
  std::optional<process::child> child;
};

std::string last_line(const std::string& text)
{
  const std::size_t end = text.find_last_not_of('\n');
  if(end == std::string::npos)
    return "";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin == std::string::npos ? -1 : begin));
}

class Batch
{
public:
  explicit Batch(const Batch_options& options)
    : m_options(options)
    , m_log((std::filesystem::path(options.folder) / "results.jsonl").string())
    , m_signals(m_context, SIGINT, SIGTERM)
  {
    for(const Batch_model& model : read_batch_list(options.list, has_outputs()))
    {
      Json line = line_of(model);
      if(m_log.has(line))
        ++m_number_of_known_models;
      else
        m_waiting.push_back(std::move(line));
    }
    std::reverse(m_waiting.begin(), m_waiting.end());
  }

  Exit_code run()
  {
    m_signals.async_wait([this](const boost::system::error_code& error, const int signal)
                         { if(!error) stop(signal); });
    for(int k = 0; k < m_options.number_of_jobs; ++k)
      start_next();
    if(m_jobs.empty())
      m_signals.cancel();
    m_context.run();
    if(m_signal != 0)
    {
      std::signal(m_signal, SIG_DFL);
      std::raise(m_signal);
    }
    if(!m_options.is_quiet)
      std::cout << m_number_of_models << " models computed, " << m_number_of_failures << " of them failed; "
                << m_number_of_known_models << " were in " << m_options.folder << "/results.jsonl before\n";
    return m_number_of_failures == 0 ? DONE : MODEL_FAILED;
  }

private:
  bool has_outputs() const
  {
    return std::any_of(m_options.arguments.begin(), m_options.arguments.end(),
                       [](const std::string& argument) { return argument.find("{}") != std::string::npos; });
  }

  Json line_of(const Batch_model& model) const
  {
    return { { "model", model.model }, { "features", model.features ? Json(*model.features) : Json() },
             { "arguments", m_options.arguments } };
  }

  // The arguments of the process of a model, which writes its report to the standard output.
  std::vector<std::string> arguments_of(const Json& line) const
  {
    const Batch_model model{ line["model"], std::nullopt };
    std::vector<std::string> result{ "--model=" + model.model, "--quiet", "--report=/dev/stdout" };
    if(!line["features"].is_null())
      result.push_back("--features=" + line["features"].get<std::string>());
    for(std::string argument : m_options.arguments)
    {
      const std::size_t place = argument.find("{}");
      if(place != std::string::npos)
      {
        argument.replace(place, 2, stem_of(model));
        const std::size_t value = argument.find('=') + 1;
        argument.replace(value, std::string::npos,
                         (std::filesystem::path(m_options.folder) / argument.substr(value)).string());
      }
      result.push_back(argument);
    }
    return result;
  }

  void start_next()
  {
    if(m_waiting.empty() || m_signal != 0)
      return;
    m_jobs.emplace_back(m_context, std::move(m_waiting.back()));
    m_waiting.pop_back();
    const std::list<Job>::iterator job = std::prev(m_jobs.end());
    job->child.emplace(m_program, process::args = arguments_of(job->line), process::std_in < process::null,
                       process::std_out > job->report, process::std_err > job->messages, m_context,
                       process::on_exit = [this, job](int, const std::error_code&)
                       { m_context.post([this, job] { finish(job); }); });
    if(!m_options.timeout)
      return;
    job->timer.expires_after(std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(*m_options.timeout)));
    job->timer.async_wait([job](const boost::system::error_code& error)
    {
      if(error)
        return;
      job->is_timed_out = true;
      ::kill(job->child->id(), SIGTERM);
    });
  }

  // Takes the result of a process that has ended.
  void finish(const std::list<Job>::iterator job)
  {
    job->timer.cancel();
    if(m_signal == 0)
    {
      const int status = job->child->native_exit_code();
      const std::string report = job->report.get(), message = last_line(job->messages.get());
      const bool is_done = WIFEXITED(status) && WEXITSTATUS(status) == DONE;
      Json line = job->line;
      line["exit_code"] = WIFEXITED(status) ? Json(WEXITSTATUS(status)) : Json();
      line["signal"] = WIFSIGNALED(status) ? Json(WTERMSIG(status)) : Json();
      line["error"] = is_done ? Json() : job->is_timed_out ? Json("stopped after the --timeout") : Json(message);
      line["seconds"] = std::chrono::duration<double>(Clock::now() - job->start).count();
      line["report"] = is_done ? Json::parse(report) : Json();
      m_log.append(line);
      ++m_number_of_models;
      m_number_of_failures += !is_done;
    }
    m_jobs.erase(job);
    start_next();
    if(m_jobs.empty())
      m_signals.cancel();
  }

  // Lets the processes end without unfinished files; what they had to do is left to the next start of the batch.
  void stop(const int signal)
  {
    m_signal = signal;
    for(const Job& job : m_jobs)
      ::kill(job.child->id(), SIGTERM);
  }

  const Batch_options& m_options;
  Batch_log m_log;
  boost::asio::io_context m_context;
  boost::asio::signal_set m_signals;
  const std::string m_program = boost::dll::program_location().string();
  std::vector<Json> m_waiting; // the next one last
  std::list<Job> m_jobs;
  std::size_t m_number_of_known_models = 0, m_number_of_models = 0, m_number_of_failures = 0;
  int m_signal = 0;
};

} // namespace

Exit_code run_batch(const Batch_options& options)
{
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if(!std::filesystem::is_directory(options.folder, error))
    throw Failure(BAD_FILE, options.folder + ": this folder cannot be made");
  return Batch(options).run();
}
