#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "benchmarks/estimators/coverage.hpp"
#ifdef CPT_WITH_OPENTURNS
#include "benchmarks/estimators/compare.hpp"
#endif

int main(int argc, char** argv) {
  const std::string asked = argc == 3 ? argv[1] : "";
  if (asked == "coverage") {
    cpt::benchmarks::print_coverage(std::max(1, std::atoi(argv[2])));
    return 0;
  }
#ifdef CPT_WITH_OPENTURNS
  if (asked == "compare") return cpt::benchmarks::print_comparison(argv[2]);
#endif
  std::fputs(
      "usage: estimators coverage REPETITIONS\n       estimators compare SAMPLE.csv (with OpenTURNS)\n",
      stderr);
  return 2;
}
