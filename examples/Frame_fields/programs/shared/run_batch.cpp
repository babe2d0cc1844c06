#include "run_batch.h"

#include "Batch_log.h"
#include "read_batch_list.h"

#include <boost/asio/io_context.hpp>
#include <boost/dll/runtime_symbol_info.hpp>
#if __has_include(<boost/process/v1.hpp>)
#include <boost/process/v1.hpp>
namespace process = boost::process::v1;
#else
#include <boost/process.hpp>
namespace process = boost::process;
#endif

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <future>
#include <iostream>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace {

// What the signal handler needs, which must neither lock nor allocate.
std::atomic<int> signal_that_came(0);
pid_t process_of_batch;
std::vector<std::atomic<pid_t> >* processes_of_models; // 0 where none runs

// Lets the processes of the models end without unfinished files; what they had to do is left to the next start.
extern "C" void stop_models(const int signal)
{
  if(getpid() != process_of_batch) // a process that is about to become a model's
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal); // takes place when this handler returns
    return;
  }
  signal_that_came = signal;
  for(const std::atomic<pid_t>& process : *processes_of_models)
    if(process != 0)
      kill(process, SIGTERM);
}

// What is left of the process of a model.
struct Outcome
{
  int status; // as waitpid() has it
  bool is_timed_out;
  std::string report, messages;
  double seconds;
};

std::string last_line(std::string text)
{
  while(!text.empty() && text.back() == '\n')
    text.pop_back();
  return text.substr(text.find_last_of('\n') + 1);
}

Json result_line(Json line, const Outcome& outcome)
{
  const bool is_done = WIFEXITED(outcome.status) && WEXITSTATUS(outcome.status) == DONE;
  line["exit_code"] = WIFEXITED(outcome.status) ? Json(WEXITSTATUS(outcome.status)) : Json();
  line["signal"] = WIFSIGNALED(outcome.status) ? Json(WTERMSIG(outcome.status)) : Json();
  line["error"] = is_done ? Json() : outcome.is_timed_out ? Json("stopped after the --timeout")
                                                          : Json(last_line(outcome.messages));
  line["seconds"] = outcome.seconds;
  line["report"] = is_done ? Json::parse(outcome.report) : Json();
  return line;
}

class Batch
{
public:
  Batch(const Batch_options& options, const std::vector<Batch_model>& models)
    : m_options(options)
    , m_log((std::filesystem::path(options.folder) / "results.jsonl").string())
    , m_processes(options.number_of_jobs)
  {
    for(const Batch_model& model : models)
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
    process_of_batch = getpid();
    processes_of_models = &m_processes;
    for(const int signal : { SIGINT, SIGTERM, SIGHUP })
      if(std::signal(signal, stop_models) == SIG_IGN)
        std::signal(signal, SIG_IGN);
    run_all();
    if(signal_that_came != 0)
    {
      std::signal(signal_that_came, SIG_DFL);
      std::raise(signal_that_came);
    }
    if(!m_options.is_quiet)
      std::cout << m_number_of_models << " models computed, " << m_number_of_failures << " of them failed; "
                << m_number_of_known_models << " were in " << m_options.folder << "/results.jsonl before\n";
    return m_number_of_failures == 0 ? DONE : MODEL_FAILED;
  }

private:
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
    if(m_options.has_one_thread_a_model)
      result.push_back("--threads=1");
    if(!line["features"].is_null())
      result.push_back("--features=" + line["features"].get<std::string>());
    for(const std::string& argument : m_options.arguments)
      result.push_back(with_name_of_output(argument, stem_of(model)));
    return result;
  }

  std::string with_name_of_output(std::string argument, const std::string& stem) const
  {
    const std::size_t place = argument.find("{}");
    if(place == std::string::npos)
      return argument;
    argument.replace(place, 2, stem);
    const std::size_t value = argument.find('=') + 1;
    return argument.substr(0, value) + (std::filesystem::path(m_options.folder) / argument.substr(value)).string();
  }

  // The pipes are made one process at a time, as otherwise another one would inherit them and keep them open.
  process::child start(const std::vector<std::string>& arguments, boost::asio::io_context& context,
                       std::future<std::string>& report, std::future<std::string>& messages)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return process::child(m_program, process::args = arguments, process::std_in < process::null,
                          process::std_out > report, process::std_err > messages, context);
  }

  // Runs the process of a model to its end, which the end of its output tells.
  Outcome run_model(const Json& line, std::atomic<pid_t>& process_number)
  {
    const auto begin = std::chrono::steady_clock::now();
    boost::asio::io_context context;
    std::future<std::string> report, messages;
    process::child child = start(arguments_of(line), context, report, messages);
    process_number = child.id();
    if(signal_that_came != 0) // it did not know of this process
      kill(child.id(), SIGTERM);

    Outcome outcome;
    if(m_options.timeout)
      context.run_for(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(*m_options.timeout)));
    outcome.is_timed_out = !context.stopped() && m_options.timeout;
    if(outcome.is_timed_out)
      kill(child.id(), SIGTERM);
    context.run();
    process_number = 0; // before the system can give its number to another process
    child.wait();
    outcome.status = child.native_exit_code();
    outcome.report = report.get();
    outcome.messages = messages.get();
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
  }

  std::optional<Json> next_line()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_waiting.empty() || signal_that_came != 0 || m_error)
      return std::nullopt;
    Json line = std::move(m_waiting.back());
    m_waiting.pop_back();
    return line;
  }

  void take(const Json& line)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_log.append(line);
    ++m_number_of_models;
    m_number_of_failures += !line["error"].is_null();
  }

  // Takes one model after the other.
  void work(std::atomic<pid_t>& process_number)
  try
  {
    while(const std::optional<Json> line = next_line())
    {
      const Outcome outcome = run_model(*line, process_number);
      if(signal_that_came == 0)
        take(result_line(*line, outcome));
    }
  }
  catch(...)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_error = std::current_exception();
  }

  void run_all()
  {
    std::vector<std::thread> threads;
    for(std::atomic<pid_t>& process_number : m_processes)
      threads.emplace_back([this, &process_number] { work(process_number); });
    for(std::thread& thread : threads)
      thread.join();
    if(m_error)
      std::rethrow_exception(m_error);
  }

  const Batch_options& m_options;
  Batch_log m_log;
  const std::string m_program = boost::dll::program_location().string();
  std::vector<std::atomic<pid_t> > m_processes;
  std::mutex m_mutex; // of all below
  std::vector<Json> m_waiting; // the next one last
  std::exception_ptr m_error;
  std::size_t m_number_of_known_models = 0, m_number_of_models = 0, m_number_of_failures = 0;
};

bool has_outputs(const Batch_options& options)
{
  return std::any_of(options.arguments.begin(), options.arguments.end(),
                     [](const std::string& argument) { return argument.find("{}") != std::string::npos; });
}

} // namespace

Exit_code run_batch(const Batch_options& options)
{
  const std::vector<Batch_model> models = read_batch_list(options.list, has_outputs(options));
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if(!std::filesystem::is_directory(options.folder, error))
    throw Failure(BAD_FILE, options.folder + ": this folder cannot be made");
  return Batch(options, models).run();
}
