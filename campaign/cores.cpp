#include "campaign/cores.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>

namespace cpt::campaign {
namespace {

constexpr int most_cpus = 8192;

struct CpuSetDeleter {
  void operator()(cpu_set_t* set) const { CPU_FREE(set); }
};
using CpuSet = std::unique_ptr<cpu_set_t, CpuSetDeleter>;

// CPUs process `pid` may run on; null if the system does not tell.
CpuSet allowed_cpus(pid_t pid) {
  CpuSet set(CPU_ALLOC(most_cpus));
  CPU_ZERO_S(CPU_ALLOC_SIZE(most_cpus), set.get());
  if (::sched_getaffinity(pid, CPU_ALLOC_SIZE(most_cpus), set.get()) != 0) return nullptr;
  return set;
}

// Cores' worth of time the control group grants (cgroup v2); infinite without a quota.
double quota_cores() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  std::string quota;
  double period = 0.0;
  if (!(file >> quota >> period) || quota == "max" || period <= 0.0)
    return std::numeric_limits<double>::infinity();
  return std::stod(quota) / period;
}

}  // namespace

int use_allowed_cores(bool started_by_launcher) {
  // The launcher itself is not bound: what it may use is what the user or the batch system gave the job.
  CpuSet cpus = allowed_cpus(started_by_launcher ? ::getppid() : 0);
  int cores = 1;
  if (cpus) {
    if (started_by_launcher) ::sched_setaffinity(0, CPU_ALLOC_SIZE(most_cpus), cpus.get());
    cpus = allowed_cpus(0);
    cores = CPU_COUNT_S(CPU_ALLOC_SIZE(most_cpus), cpus.get());
  }
  const double quota = std::ceil(quota_cores());
  return std::max(1, quota < cores ? static_cast<int>(quota) : cores);
}

}  // namespace cpt::campaign
