// One target as a coverage-guided fuzzer: libFuzzer brings main and calls this
// (llvm.org/docs/LibFuzzer.html). A broken promise leaves as an exception that nobody catches, which the
// fuzzer keeps as a crash.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)cpt::fuzz::CPT_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
