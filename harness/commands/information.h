// What `modalbench` tells without running a case: what there is, what words mean, what the machine and the store hold.
// Results go to console.out, everything else to console.err; exit codes as in harness/main.h. Throws UsageError.
#pragma once

#include <string>
#include <vector>

#include "harness/catalogue.h"

namespace mb {

struct Console;  // harness/commands/commands.h

struct ListOptions {
  std::string pattern = "";  // part of the name; empty: all
  bool json = false;
};
struct NewOptions {
  std::string file = "";     // to be written; must not exist and ends in .toml
  bool json_schema = false;  // print a JSON schema of case files instead
};
struct ExplainOptions {
  std::string word = "";  // a case, metric, key, method, integrator, analysis or closed form
};
struct DoctorOptions {
  std::string store = "results";  // whose disk is looked at
  bool json = false;
};
struct CleanOptions {
  std::vector<std::string> cases = {};        // files of cases that are not found by name
  std::string store = "results", older = "";  // older: an age like 30d; empty: only what is not current
  bool yes = false;
};

int list_command(const ListOptions&, const Catalogue&, const Console&);
int new_command(const NewOptions&, const Catalogue&, const Console&);
int explain_command(const ExplainOptions&, const Catalogue&, const Console&);
int doctor_command(const DoctorOptions&, const Console&);
int clean_command(const CleanOptions&, const Catalogue&, const Console&);

}  // namespace mb
