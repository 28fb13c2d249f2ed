#include "app/base/other_load.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

namespace app {
namespace {

// The first line of /proc/stat: "cpu user nice system idle iowait irq softirq steal ...", in ticks of all cores
// [proc(5)].
std::optional<double> busy_seconds() {
  std::ifstream in("/proc/stat");
  std::string name;
  double user = 0, nice = 0, system = 0, idle = 0, waiting = 0, irq = 0, softirq = 0, steal = 0;
  if (!(in >> name >> user >> nice >> system >> idle >> waiting >> irq >> softirq >> steal) || name != "cpu") return {};
  return (user + nice + system + irq + softirq + steal) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

double own_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

OtherLoad::OtherLoad() : busy_(busy_seconds()), own_(own_cpu_seconds()) {}

std::optional<double> OtherLoad::cores() const {
  const auto now = busy_seconds();
  const double seconds = watch_.seconds();
  if (!now || !busy_ || !(seconds > 0)) return {};
  return std::max(0.0, (*now - *busy_ - (own_cpu_seconds() - own_)) / seconds);
}

}  // namespace app
