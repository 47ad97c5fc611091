// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "console/Supervisor.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <map>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace penumbra::tool
{
namespace
{
constexpr std::size_t StageLength = 1024;
char* SharedStage = nullptr; ///< in memory that parent and child share
bool Supervised = false;

/// All the memory there is: a damaged file that asks for more gets an error at once instead of taking
/// the machine down.
void LimitMemory()
{
#if !defined(__SANITIZE_ADDRESS__)
  const long pages = sysconf(_SC_PHYS_PAGES), pageSize = sysconf(_SC_PAGESIZE);
  rlim_t limit = pages > 0 ? rlim_t(pages) * pageSize : RLIM_INFINITY;
  unsigned long long group = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> group && group > 0)
  {
    limit = std::min<rlim_t>(limit, group);
  }
  rlimit current;
  if (getrlimit(RLIMIT_DATA, &current) == 0 && current.rlim_cur > limit)
  {
    current.rlim_cur = limit;
    setrlimit(RLIMIT_DATA, &current);
  }
  const rlimit noCore = { 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
#endif
}

int ReportSignal(int signal)
{
  if (signal == SIGINT || signal == SIGTERM)
  {
    return 128 + signal; // the user's own wish, by the shell's convention
  }
  const std::string stage = SharedStage[0] ? SharedStage : "working";
  const std::map<std::string, std::string> remedies = {
    { "reading", "the file is damaged, cut off or not of the format its name says" },
    { "opening", "try another --backend (egl, osmesa, x11), and check DISPLAY for x11" },
  };
  const auto remedy = remedies.find(stage.substr(0, stage.find(' ')));
  const std::map<int, std::string> known = {
    { SIGKILL, "the system stopped it, most likely for want of memory" },
    { SIGXCPU, "it came to no end" }, { SIGSEGV, "the reader or driver crashed" },
    { SIGABRT, "the reader or driver gave up" }
  };
  const auto found = known.find(signal);
  const std::string reason = found == known.end() ? strsignal(signal) : found->second;
  fmt::print(stderr, "penumbra: {} failed ({}): {}\n", stage, reason,
    remedy != remedies.end()
      ? remedy->second
      : "the data is damaged or too big for this machine, or the graphics driver failed");
  return 1;
}
}

int Supervise(const std::function<int()>& work)
{
  void* shared =
    mmap(nullptr, StageLength, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  SharedStage = shared == MAP_FAILED ? nullptr : static_cast<char*>(shared);
  std::fflush(nullptr);
  const pid_t child = SharedStage && !std::getenv("PENUMBRA_NO_SUPERVISOR") ? fork() : -1;
  if (child < 0)
  {
    return work();
  }
  if (child == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    LimitMemory();
    Supervised = true;
    const int status = work();
    std::fflush(nullptr);
    // Not exit(): destructors of graphics drivers and readers of damaged files have nothing to add.
    _exit(status);
  }
  std::signal(SIGINT, SIG_IGN); // the child gets it too, and its end is awaited
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  return WIFSIGNALED(status) ? ReportSignal(WTERMSIG(status)) : WEXITSTATUS(status);
}

void SetStage(const std::string& stage)
{
  if (SharedStage)
  {
    std::strncpy(SharedStage, stage.c_str(), StageLength - 1);
  }
}

void LimitProcessorTime(double seconds)
{
  rlimit limit;
  if (!Supervised || getrlimit(RLIMIT_CPU, &limit) != 0)
  {
    return;
  }
  const double used = double(std::clock()) / CLOCKS_PER_SEC;
  limit.rlim_cur =
    seconds > 0 ? std::min<rlim_t>(limit.rlim_max, rlim_t(used + seconds)) : limit.rlim_max;
  setrlimit(RLIMIT_CPU, &limit);
}
}
