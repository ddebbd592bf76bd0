#include "results/ledger/provenance.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <stdexcept>

#include "solver/quantities.hpp"

namespace cpt::results {
namespace {

std::size_t common_prefix(const std::vector<double>& a, const std::vector<double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same).first -
                                  a.begin());
}

}  // namespace

std::string_view program_version() { return CPT_PROGRAM_VERSION; }

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto refuses to compute SHA-256");
  std::string text;
  for (const unsigned char byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

std::string solver_version(const solver::Setup& setup) {
  return setup.program ? setup.program->version : std::string(solver::solver_version());
}

std::string settings_hash(const solver::Setup& setup) {
  if (setup.program) return sha256(solver::canonical_text(setup));  // with its version
  return sha256(
      fmt::format("solver_version = {}\n{}", solver::solver_version(), solver::canonical_text(setup)));
}

std::string utc_now() {
  const auto now = std::chrono::system_clock::now();
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900, utc.tm_mon + 1,
                     utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec, ms);
}

std::optional<std::size_t> first_difference(const solver::DepthProfile& a, const solver::DepthProfile& b) {
  std::size_t same = common_prefix(a.depth, b.depth);
  bool all = same == a.depth.size() && same == b.depth.size();
  for (const solver::Channel& channel : solver::channels()) {
    const std::vector<double>&of_a = a.*channel.values, &of_b = b.*channel.values;
    if (!channel.required && (of_a.empty() || of_b.empty())) continue;
    const std::size_t prefix = common_prefix(of_a, of_b);
    all = all && prefix == of_a.size() && prefix == of_b.size();
    same = std::min(same, prefix);
  }
  all = all && std::ranges::equal(a.declared, b.declared, [](const auto& x, const auto& y) {
          return x.name == y.name && common_prefix(x.x, y.x) == std::max(x.x.size(), y.x.size()) &&
                 common_prefix(x.y, y.y) == std::max(x.y.size(), y.y.size());
        });
  return all ? std::nullopt : std::optional(same);
}

}  // namespace cpt::results
