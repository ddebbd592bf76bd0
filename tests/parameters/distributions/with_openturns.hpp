// Tests that ask distributions say that they were skipped where OpenTURNS is absent.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "parameters/distributions/library.hpp"

namespace cpt::parameters {

/// Why it is absent; empty where it is not.
inline std::string without_openturns() {
  try {
    (void)openturns();
    return "";
  } catch (const MissingLibrary& missing) {
    return missing.what();
  }
}

class WithOpenTurns : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = without_openturns(); !why.empty()) GTEST_SKIP() << why;
  }
};

}  // namespace cpt::parameters
