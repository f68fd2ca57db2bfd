#include "harness/provenance.h"

#include <fstream>
#include <thread>

#include "harness/measure.h"
#include "mechanics/algebra/threads.h"
#include "sources.h"

namespace mb {

namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::map<std::string, std::string> provenance(const std::string& profile) {
  return {{"commit", sources::commit},
          {"date", utc_date()},
          {"profile", profile},
          {"processor", processor()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"threads", std::to_string(blas_threads())},
          {"blas", blas_description()},
          {"libraries", sources::libraries}};
}

}  // namespace mb
