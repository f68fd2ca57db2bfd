// Every kind of file that the store keeps, cut anywhere or with any bit flipped: refused by its name, never read as
// something else. Cuts and bits are drawn with a fixed seed; records are tried whole.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <optional>
#include <random>

#include "cases/json/json.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

const std::string run(32, 'a');

// What was read as text, to be compared; nothing where it was refused by the file's own name.
using Reader = std::function<std::optional<std::string>(const Store&)>;

struct Damage {
  int n_refused = 0, n_same = 0;
};

// Written without fsync, which would take most of the time.
void overwrite(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

Damage damage(const Store& store, const std::filesystem::path& file, const Reader& read, int n_trials) {
  const std::string sound = read_file(file, 1 << 20), whole = read(store).value();
  std::mt19937 random(3);
  Damage met;
  for (int i = 0; i < n_trials; ++i) {
    std::string bytes = sound;
    if (i % 4 == 0)
      bytes.resize(random() % sound.size());
    else
      for (int k = 0; k < i % 3 + 1; ++k)
        bytes[random() % sound.size()] ^= static_cast<char>(1 << (random() % 8));  // NOLINT: a bit of a byte
    if (bytes == sound) continue;
    overwrite(file, bytes);
    const auto found = read(store);
    EXPECT_EQ(found.value_or(whole), whole) << i;
    found ? ++met.n_same : ++met.n_refused;
  }
  overwrite(file, sound);
  return met;
}

Record record(const std::string& metric, double value) {
  Record record;
  record.run = run, record.case_name = "a", record.profile = "quick", record.metric = metric, record.truth = "finer";
  record.contender = {"eigenmodes", "exact", {4, {1, 4}}, {}};
  record.value = value, record.unit = "-", record.status = "ok";
  return record;
}

std::optional<std::string> told(const RecordLines& lines, const std::string& folder) {
  for (const RefusedLine& line : lines.refused) {
    EXPECT_EQ(line.file.parent_path().filename(), folder);
    EXPECT_NE(line.reason, "");
  }
  if (!lines.refused.empty()) return {};
  std::string all;
  for (const Record& r : lines.records) all += to_line(to_json(r)) + "\n";
  return all;
}

TEST(Damage, OfRecordsAndTimesIsAlwaysFound) {
  const ScratchFolder folder;
  const Store store(folder.path());
  store.write_records(run, {record("displacement-error", 0.0123), record("strain-error", 0.0456)});
  store.write_times(run, {record("online-time", 1e-3)});
  const Damage marks = damage(
      store, folder / "records" / (run + ".jsonl"),
      [](const Store& s) { return told(s.read_records_of(run), "records"); }, 3000);
  EXPECT_EQ(marks.n_same, 0);
  const Damage times = damage(
      store, folder / "timings" / (run + ".jsonl"),
      [](const Store& s) { return told(s.read_times_of(run), "timings"); }, 3000);
  EXPECT_EQ(times.n_same, 0);
}

TEST(Damage, OfFindingsIsAlwaysFound) {
  const ScratchFolder folder;
  const Store store(folder.path());
  Finding finding;
  finding.run = run, finding.analysis = finding.name = "step-limits", finding.case_name = "a";
  finding.profile = "quick", finding.columns = {{"modes", ""}, {"dt", "s"}}, finding.rows = {{8.0, 0.0125}};
  store.write_findings(run, {finding, finding});
  const Damage met = damage(
      store, folder / "findings" / (run + ".json"),
      [](const Store& s) -> std::optional<std::string> {
        const auto all = s.read_findings_of(run);
        if (!all.refused.empty()) return {};
        std::string text;
        for (const Finding& f : all.findings)
          text += fmt::format("{} {}\n", f.name, std::get<double>(f.rows.at(0).at(1)));
        return text;
      },
      3000);
  EXPECT_EQ(met.n_same, 0);
}

// A few bytes of an HDF5 file mean nothing: there the values are the same.
TEST(Damage, OfTrajectoriesIsFoundOrChangesNothing) {
  const ScratchFolder folder;
  const Store store(folder.path());
  constexpr Index n_t = 20;
  Trajectory trajectory;
  trajectory.t = VectorXd::LinSpaced(n_t, 0, 1);
  trajectory.bodies = {{MatrixXd::Random(9, n_t), MatrixXd(0, n_t)}};
  BodyTrajectory& body = trajectory.bodies[0];
  body.contact = {MatrixXd::Random(3, n_t),
                  MatrixXd::Random(3, n_t),
                  VectorXd::Ones(n_t),
                  VectorXd::Ones(n_t),
                  {{0.1, 0.2, 3, 0.15, Vector3d(1, 2, 3)}}};
  body.energy = VectorXd::Random(n_t), body.momentum = MatrixXd::Random(6, n_t);
  store.write_trajectory(run, trajectory);
  const auto bytes_of = [](const MatrixXd& A) {
    return std::string(reinterpret_cast<const char*>(A.data()), static_cast<std::size_t>(A.size()) * sizeof(double));
  };
  const Damage met = damage(
      store, folder / "trajectories" / (run + ".h5"),
      [&](const Store& s) -> std::optional<std::string> {
        try {
          const Trajectory t = s.read_trajectory(run);
          const BodyTrajectory& b = t.bodies.at(0);
          std::string all = bytes_of(t.t) + to_string(t.status) + std::to_string(t.work.steps);
          for (const MatrixXd& A :
               {b.displacement, MatrixXd(b.contact.force), MatrixXd(b.contact.impulse), MatrixXd(b.energy), b.momentum})
            all += bytes_of(A);
          return all + std::to_string(b.contact.touches.at(0).peak_force);
        } catch (const StoreError& error) {
          EXPECT_EQ(error.file().stem(), run);
          return {};
        }
      },
      2000);
  EXPECT_GT(met.n_refused, 10 * met.n_same);
}

}  // namespace
}  // namespace mb
