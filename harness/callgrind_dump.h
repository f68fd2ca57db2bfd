// One dump of callgrind: text of lines, among them
//
//   desc: Trigger: Client Request: NAME      who asked for it; without this line nobody did, as at the program's end
//   totals: N                                instructions, if they are all that was counted; at the end of the dump
#pragma once

#include <string>
#include <string_view>

namespace mb {

struct DumpedCount {
  std::string name;         // "": a dump that nobody asked for
  double instructions = 0;  // a whole number in [0, 2^64], rounded from 2^53 on
  std::string problem;      // empty: the count was read, if somebody asked for it
};
// Of a dump that is cut off anywhere: the count of the whole one, or none.
DumpedCount dumped_count(std::string_view dump);

}  // namespace mb
