// What closed forms say of scenes which they do not hold for, in tests.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "cases/exact/exact.h"

namespace mb {

using Change = std::function<void(Scene&)>;

struct Wrong {
  Change change;
  const char* says;
};

// Nothing of the right scene, and of it with each change what that says.
inline void expect_problems(const std::string& name, const Scene& right, const std::vector<Wrong>& wrong) {
  const auto problem = exact_solution(name).problem;
  EXPECT_EQ(problem(right), "");
  for (const Wrong& w : wrong) {
    Scene scene = right;
    w.change(scene);
    EXPECT_THAT(problem(scene), ::testing::HasSubstr(w.says));
  }
}

}  // namespace mb
