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
char* SharedStage = nullptr; ///< in memory shared by parent and child
bool Supervised = false;

/// Limits memory to what the machine has. A damaged file that asks for more then fails at once, and does not stall the
/// machine.
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
    return 128 + signal; // interrupted by the user: the shell's convention
  }
  const std::string stage = SharedStage[0] ? SharedStage : "working";
  const std::map<std::string, std::string> remedies = {
    { "reading", "the file is damaged, cut off or not in the format that its name suggests" },
    { "opening", "try another --backend (egl, osmesa, x11); for x11, check DISPLAY" },
  };
  const auto remedy = remedies.find(stage.substr(0, stage.find(' ')));
  const std::map<int, std::string> known = {
    { SIGKILL, "the system stopped it, most likely because memory ran out" },
    { SIGXCPU, "it took too long" }, { SIGSEGV, "the reader or driver crashed" },
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

int Supervise(const std::function<int()>& run)
{
  void* shared =
    mmap(nullptr, StageLength, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  SharedStage = shared == MAP_FAILED ? nullptr : static_cast<char*>(shared);
  std::fflush(nullptr);
  const pid_t child = SharedStage && !std::getenv("PENUMBRA_NO_SUPERVISOR") ? fork() : -1;
  if (child < 0)
  {
    return run();
  }
  if (child == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    LimitMemory();
    Supervised = true;
    const int status = run();
    std::fflush(nullptr);
    // Not exit(), which would run destructors of graphics drivers and of readers of damaged files.
    _exit(status);
  }
  std::signal(SIGINT, SIG_IGN); // the child receives it too; wait for it to end
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
