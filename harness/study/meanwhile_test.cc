// Another process works on the same store: what it has stored since a run began is neither written over nor missed.
#include <gmock/gmock.h>

#include "harness/commands/commands.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/catalogue_test.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

// Where the other process's results come from, and where they go while a contender is computed.
fs::path theirs, ours;

// The other process ends while the answer is computed.
class Overtaken : public Stepper {
 public:
  explicit Overtaken(std::unique_ptr<Stepper> own) : own_(std::move(own)) {}
  States run(const VectorXd& times) const override {
    for (const char* shelf : {"records", "timings"})
      fs::copy(theirs / shelf, ours / shelf, fs::copy_options::recursive | fs::copy_options::skip_existing);
    return own_->run(times);
  }
  double load_error() const override { return own_->load_error(); }

 private:
  std::unique_ptr<Stepper> own_;
};

Catalogue with_another_process() {
  Catalogue catalogue = default_catalogue();
  for (Integrator& integrator : catalogue.integrators)
    if (integrator.name == "exact")
      integrator.prepare = [](const System& system, const Settings& settings,
                              double duration) -> std::unique_ptr<Stepper> {
        return std::make_unique<Overtaken>(default_catalogue().integrator("exact").prepare(system, settings, duration));
      };
  return catalogue;
}

TEST(MeanwhileCases, MarksThatAnotherProcessStoredKeepTheirTimes) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--store", "theirs"}).code, 0);
  theirs = scratch / "theirs", ours = scratch / "ours";
  const Said said =
      modalbench(scratch.path(), {"run", "case.toml", "--store", "ours", "--untimed"}, with_another_process());
  EXPECT_EQ(said.code, 0) << said.err;
  int n_exact = 0;
  for (const auto& entry : fs::directory_iterator(theirs / "timings")) {
    const std::string run = entry.path().stem();
    if (Store(theirs).read_records_of(run).records.front().contender.integrator != "exact") continue;
    ++n_exact;
    EXPECT_EQ(text(ours / "timings" / entry.path().filename()), text(entry.path()));
  }
  EXPECT_EQ(n_exact, 2);
}

// Full-order runs that took ten seconds once are to be timed again; by then their marks are gone.
TEST(MeanwhileCases, MarksThatAreGoneAreNotTimed) {
  const ScratchFolder scratch;
  RunCommandOptions options;
  options.cases = {written(scratch / "case.toml", small_case())};
  options.store = scratch / "results";
  std::ostringstream out, err;
  ASSERT_EQ(run_command(options, default_catalogue(), {out, err}), 0);
  const Store store(options.store);
  int n_dear = 0;
  for (Record record : store.read_all_records().records) {
    if (record.metric != "online-time" || record.contender.method != "full-order") continue;
    record.value = 10, record.error_bar.reset();
    store.write_times(record.run, {record});
    ++n_dear;
  }
  ASSERT_EQ(n_dear, 2);
  int n_asked = 0;  // before the truths, then before each run that is timed
  options.interrupted = [&] {
    if (++n_asked == 2) fs::remove_all(scratch / "results/records");
    return false;
  };
  err.str("");
  EXPECT_NO_THROW(run_command(options, default_catalogue(), {out, err}));
  EXPECT_THAT(err.str(), HasSubstr("0 runs done, 4 found"));
  EXPECT_GE(n_asked, 2);
  EXPECT_EQ(err.str().find("timing"), std::string::npos) << err.str();
}

}  // namespace
}  // namespace mb
