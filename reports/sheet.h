// A table as a value (mb::Table is a load history): made once from the records, printed as Markdown, CSV, LaTeX and
// by the page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/contract/record.h"

namespace mb {

struct Cell {
  std::string text;                           // for people; untrusted: every format escapes it
  std::optional<double> value = {};           // unit of its column, full precision; none: text alone
  std::optional<double> bar = {};             // uncertainty of value, same unit
  std::string status = {};                    // of the record behind it; "" where there is none
  std::optional<double> low = {}, high = {};  // what uncertain parts leave of a quotient; none: unbounded, or not known
};

struct Column {
  // error and time carry a bar and a status, a quotient what its parts leave of it
  enum class Kind { text, number, error, time, quotient };
  std::string name, unit;
  Kind kind = Kind::text;
};

struct Sheet {
  std::string name;   // file stem
  std::string title;  // names case, profile and truth once the table is split
  std::string note;   // how to read it
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as columns
  int n_keys = 3;                       // leading text columns that split() moves into titles: case, profile, truth
};

Cell text_cell(std::string text);
Cell count_cell(long value);
Cell number_cell(std::optional<double> value);              // "" where none
Cell setting_cell(double value);                            // all digits that were chosen
Cell quotient_cell(double value, double low, double high);  // "354 (340 to 370)"

// "" where none, "failed (...)" where its status is not ok, "0.12, perturbed" of such a time: its status then, too.
Cell record_cell(const Record* record);

// One table for every combination of the leading keys, which move into the title; the largest error bar of every error
// column moves into the note.
std::vector<Sheet> split(const Sheet& table);

std::string header(const Column& column);  // "online time [s]"

}  // namespace mb
