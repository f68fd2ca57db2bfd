// What a case file can say, beyond what cylinder-compression says.
#include "cases/scene/read_toml.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

namespace fs = std::filesystem;
using test::cylinder_text;
using test::with;

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / ("modalbench-cases-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string with_history(const std::string& history) {
  return with(cylinder_text(), R"({ kind = "pulse", duration = 0.096881 })", history);
}

History history_of(const std::string& history) { return test::read(with_history(history)).loads.at(0).history; }

TEST(ReadToml, reads_every_kind_of_history) {
  EXPECT_EQ(history_of(R"({ kind = "step", amplitude = -2, start = 0.1 })"), History(Step{-2, 0.1}));
  EXPECT_EQ(history_of(R"({ kind = "ramp", duration = 0.1 })"), History(Ramp{0.1, 1, 0}));
  EXPECT_EQ(history_of(R"({ kind = "harmonic", omega = 60, phase = 1 })"), History(Harmonic{60, 1, 1, 0}));
  EXPECT_EQ(history_of(R"({ kind = "chirp", omega0 = 1, omega1 = 9, duration = 1 })"), History(Chirp{1, 9, 1, 1, 0}));
  EXPECT_EQ(history_of(R"({ kind = "table", t = [0, 0.1], s = [1, 2] })"), History(Table{{0, 0.1}, {1, 2}}));
  EXPECT_EQ(history_of(R"toml({ kind = "expression", formula = "sin(2 * pi * t)" })toml"),
            History(Expression{"sin(2 * pi * t)"}));
}

TEST(ReadToml, reads_supports_pressures_and_discs) {
  std::string text = with(cylinder_text(), "[body.resolution]", R"([[body.support]]
kind = "fixed"
face = "z-min"
[[body.support]]
kind = "mean"
face = "side"
disc = { centre = [0.05, 0, 0], radius = 0.02 }
[body.resolution])");
  text = with(text, "traction = [0, 0, -400]", "pressure = 400");
  text = with(text, "face     = \"z-min\"\ntraction = [0, 0, 400]", "face = \"side\"\ntraction = [1, 2, 3]");
  const Scene scene = test::read(text);
  const auto& supports = scene.bodies[0].supports;
  ASSERT_EQ(supports.size(), 2u);
  EXPECT_EQ(supports[0].kind, Support::Kind::fixed);
  EXPECT_EQ(supports[0].patch.face, "z-min");
  EXPECT_EQ(supports[1].kind, Support::Kind::mean);
  ASSERT_TRUE(supports[1].patch.disc.has_value());
  EXPECT_EQ(supports[1].patch.disc->radius, 0.02);
  EXPECT_EQ(scene.loads[0].tractions[0].pressure, 400);
  EXPECT_EQ(scene.loads[0].tractions[0].traction, Vector3d::Zero());
  EXPECT_EQ(scene.loads[0].tractions[1].pressure, 0);
  EXPECT_EQ(scene.loads[0].tractions[1].traction, Vector3d(1, 2, 3));
}

TEST(ReadToml, a_traction_along_a_sliding_face_does_work) {
  const std::string text = with(cylinder_text(), "[body.resolution]",
                                "[[body.support]]\nkind = \"sliding\"\nface = \"z-max\"\n[body.resolution]");
  EXPECT_NE(test::problems_of_text(text).find("does no work"), std::string::npos);
  EXPECT_EQ(test::problems_of_text(with(text, "[0, 0, -400]", "[1, 0, -400]")), "");
}

TEST(ReadToml, reads_tables_from_files_below_the_case) {
  const TemporaryFolder folder;
  folder.write("tables/pulse.csv", "# measured\nt, s\r\n0, 0\n 0.1 , +1.5e0\n\n0.2,-2\n");
  const auto file = folder.write("case.toml", with_history(R"({ kind = "table", file = "tables/pulse.csv" })"));
  EXPECT_EQ(read_toml(file, test::vocabulary()).loads[0].history, History(Table{{0, 0.1, 0.2}, {0, 1.5, -2}}));
}

// Nor is there a duration then that tells which times are apart.
TEST(ReadToml, a_wrong_duration_lets_no_table_of_equal_times_pass) {
  const auto problems = [](const std::string& duration, const std::string& times) {
    const std::string table = "{ kind = \"table\", t = " + times + ", s = [0, 1, 2] }";
    return test::problems_of_text(with(with_history(table), "duration           = 0.290643", "duration = " + duration));
  };
  for (const char* duration : {"0.290643", "-1"})
    for (const char* times : {"[0, 0.1, 0.1]", "[0, 0.1, 0.05]"})
      EXPECT_NE(problems(duration, times).find("times must ascend"), std::string::npos) << duration << ": " << times;
  EXPECT_EQ(problems("-1", "[0, 0.1, 0.2]").find("times must ascend"), std::string::npos);
}

TEST(ReadToml, follows_no_link_out_of_the_case_folder) {
  const TemporaryFolder folder;
  folder.write("outside.csv", "0, 0\n1, 1\n");
  folder.write("inside/own.csv", "0, 0\n1, 1\n");
  fs::create_symlink("../outside.csv", folder.path() / "inside" / "out.csv");
  fs::create_symlink("own.csv", folder.path() / "inside" / "in.csv");
  fs::create_directory_symlink("..", folder.path() / "inside" / "up");
  const auto says = [&](const std::string& table) {
    return test::problems(
        folder.write("inside/case.toml", with_history("{ kind = \"table\", file = \"" + table + "\" }")));
  };
  EXPECT_EQ(says("in.csv"), "");
  EXPECT_NE(says("out.csv").find("does not lie below"), std::string::npos);
  EXPECT_NE(says("up/outside.csv").find("does not lie below"), std::string::npos);
  EXPECT_NE(says("../outside.csv").find("does not lie below"), std::string::npos);
}

TEST(ReadToml, refuses_what_is_no_case_file) {
  const TemporaryFolder folder;
  EXPECT_NE(test::problems(folder.path() / "absent.toml").find("absent.toml: error: "), std::string::npos);
  EXPECT_NE(test::problems(folder.path() / "absent.toml").find("there is no such file"), std::string::npos);
  EXPECT_NE(test::problems(folder.path()).find("it is a directory"), std::string::npos);
  EXPECT_NE(test::problems("/dev/null").find("it is no regular file"), std::string::npos);
  const std::string padding((std::size_t{1} << 20) - cylinder_text().size(), '\n');
  EXPECT_EQ(test::problems(folder.write("largest.toml", cylinder_text() + padding)), "");
  EXPECT_NE(test::problems(folder.write("larger.toml", cylinder_text() + padding + "\n")).find("larger than"),
            std::string::npos);
}

TEST(ReadToml, takes_a_byte_order_mark_and_either_line_end) {
  std::string text = cylinder_text();
  const std::string plain = canonical(test::read(text));
  EXPECT_EQ(canonical(test::read("\xef\xbb\xbf" + text)), plain);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  EXPECT_EQ(canonical(test::read(text)), plain);
}

TEST(ReadToml, reads_boxes_and_spheres) {
  std::string text = with(cylinder_text(), "kind   = \"cylinder\"\nradius = 0.05  # [m]\nlength = 0.20",
                          "kind = \"box\"\nsize = [0.1, 0.1, 0.2]");
  EXPECT_NE(test::problems_of_text(text).find("'cells' in [body.resolution] has 2 entries"), std::string::npos);
  for (const char* resolution : {"cells  = [1, 4]", "{ degree = 4, cells = [2, 4] }", "{ degree = 3, cells = [2, 4] }",
                                 "[[1, 2], [1, 4], [2, 4]]"}) {
    std::string cells = resolution;
    for (std::size_t at = 0; (at = cells.find("4]", at)) != std::string::npos; at += 5) cells.replace(at, 2, "2, 4]");
    for (std::size_t at = 0; (at = cells.find("1, 2]", at)) != std::string::npos; at += 8)
      cells.replace(at, 5, "1, 1, 2]");
    text = with(text, resolution, cells);
  }
  const Scene scene = test::read(text);
  EXPECT_EQ(std::get<Box>(scene.bodies[0].shape).size, Vector3d(0.1, 0.1, 0.2));
  EXPECT_EQ(scene.bodies[0].resolution, (Resolution{4, {1, 2, 4}}));
}

TEST(ReadToml, points_are_taken_as_stated_to_rounding) {
  const std::string text = cylinder_text();
  EXPECT_EQ(test::problems_of_text(with(text, "[0.05, 0, 0]", "[0.0353553390593, 0.0353553390593, 0]")), "");
  EXPECT_NE(test::problems_of_text(with(text, "[0.05, 0, 0]", "[0.03536, 0.03536, 0]")).find("outside body"),
            std::string::npos);
  const Scene scene = test::read(with(text, "direction = [1, 0, 0]", "direction = [3, 4, 0]"));
  EXPECT_NEAR((scene.probes[1].direction - Vector3d(0.6, 0.8, 0)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace mb
