// What every number of the suite means, once: marks, times, and what stands beside them. The report prints these, and
// `modalbench explain` does.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace mb {

struct MeasureDoc {
  std::string name, unit;
  std::string meaning;  // sentences
  std::string formula;  // plain text
  std::string source;   // where it comes from, or what of ours states it
};

// Every metric of the catalogue, then the times and errors that a run brings along.
const std::vector<MeasureDoc>& measure_docs();

std::map<std::string, std::string> meanings();  // name -> meaning

}  // namespace mb
