// What `modalbench` can be asked. Each command takes its options as values, writes results to `out` and everything else
// to `err`, and returns the exit code (harness/main.h).
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "harness/catalogue.h"
#include "harness/commands/information.h"

namespace mb {

struct Console {
  std::ostream &out, &err;
  bool quiet = false;  // no progress on err
};
void print(const CaseErrors& errors, std::ostream& err);  // every diagnostic of a case file

struct CheckOptions {
  std::vector<std::string> files;
  std::string profile = "quick";
};
struct ModesOptions {
  std::string case_name, body;
  int count = 30;
  bool json = false;
};
struct CountOptions {
  std::string case_name, profile = "quick";
};
struct RunCommandOptions {
  std::vector<std::string> cases;  // names or files; empty: every case of the catalogue
  std::string profile = "quick", store = "results";
  std::vector<std::string> overrides;  // --set KEY=VALUE,...: harness/study/overrides.h
  std::string shard = "1/1";           // which part of the jobs: harness/study/plan.h
  int jobs = 1;                        // processes; times are taken afterwards, alone
  int threads = 1;                     // of the BLAS; records name them
  bool again = false, plan = false, json = false, untimed = false, quiet = false;
  std::function<bool()> interrupted;
};
struct ReportOptions {
  std::vector<std::string> cases;  // names or files; empty: the cases of the store, found by name
  std::string directory = "report", store = "results";
  bool open = false, quiet = false;  // show the page; say nothing of what is left out
};

int check_command(const CheckOptions&, const Catalogue&, const Console&);
int modes_command(const ModesOptions&, const Catalogue&, const Console&);
// Instructions of the contest of harness/analysis/instruction_contest.h, by valgrind, which it starts.
int count_command(const CountOptions&, const Catalogue&, const Console&);
int run_command(const RunCommandOptions&, const Catalogue&, const Console&);
int report_command(const ReportOptions&, const Catalogue&, const Console&);

}  // namespace mb
