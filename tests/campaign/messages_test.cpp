#include "campaign/messages.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "campaign/cores.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"

namespace cpt::campaign {
namespace {

solver::Outcome outcome() {
  solver::Outcome outcome;
  outcome.status = solver::Status::energy_drift;
  outcome.reason = "because";
  outcome.profile = {{0.1, 0.2}, {1.0 / 3.0, -0.0}, {5e-324, std::nan("")}};
  outcome.audit.energy_error = 0.125;
  outcome.steps = std::int64_t{1} << 40;
  outcome.material_points = 71000;
  outcome.wall_seconds = 1.5;
  return outcome;
}

TEST(Messages, OutcomesKeepEveryBit) {
  const Message message = decode(encode(OutcomeReport{7, outcome()}));
  const auto& report = std::get<OutcomeReport>(message);
  const solver::Outcome sent = outcome();
  EXPECT_EQ(report.realization, 7);
  EXPECT_EQ(report.outcome.status, sent.status);
  EXPECT_EQ(report.outcome.reason, sent.reason);
  EXPECT_EQ(report.outcome.steps, sent.steps);
  EXPECT_EQ(report.outcome.material_points, sent.material_points);
  EXPECT_EQ(report.outcome.wall_seconds, sent.wall_seconds);
  EXPECT_EQ(report.outcome.audit.energy_error, sent.audit.energy_error);
  const auto same_bits = [](const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  };
  EXPECT_TRUE(same_bits(report.outcome.profile.depth, sent.profile.depth));
  EXPECT_TRUE(same_bits(report.outcome.profile.q_c, sent.profile.q_c));
  EXPECT_TRUE(same_bits(report.outcome.profile.f_s, sent.profile.f_s));
}

TEST(Messages, OrdersCarryTheSetupsOfAllProfilesAndPresets) {
  for (const solver::Profile profile : solver::all_profiles())
    for (const solver::Preset preset : solver::all_presets()) {
      const solver::Setup setup = solver::make_setup(profile, preset);
      const auto order = std::get<Order>(decode(encode(Order{3, 2, 60.0, 5.0, setup, "/x/y.h5", 7.0})));
      EXPECT_EQ(solver::canonical_text(order.setup), solver::canonical_text(setup));
      EXPECT_EQ(order.realization, 3);
      EXPECT_EQ(order.threads, 2);
      EXPECT_EQ(order.wall_limit_seconds, 60.0);
      EXPECT_EQ(order.hang_limit_seconds, 5.0);
      EXPECT_EQ(order.checkpoint, "/x/y.h5");
      EXPECT_EQ(order.checkpoint_seconds, 7.0);
    }
}

TEST(Messages, OrdersCarryEveryQuantity) {
  for (const solver::Quantity& quantity : solver::all_quantities()) {
    solver::Setup setup = solver::make_setup(solver::Profile::layered_sand_clay, solver::Preset::quick);
    quantity.set_value(setup, quantity.value(setup) == quantity.max ? quantity.min : quantity.max);
    const auto order = std::get<Order>(decode(encode(Order{1, 1, 1.0, 1.0, setup})));
    EXPECT_EQ(quantity.get(order.setup), quantity.get(setup)) << quantity.name;
  }
}

TEST(Messages, RemarksAndInterruptionsTravel) {
  const auto remark = std::get<Remark>(decode(encode(Remark{4, "goes on"})));
  EXPECT_EQ(remark.realization, 4);
  EXPECT_EQ(remark.text, "goes on");
  for (const bool interrupted : {false, true})
    EXPECT_EQ(std::get<OutcomeReport>(decode(encode(OutcomeReport{7, outcome(), interrupted}))).interrupted,
              interrupted);
  EXPECT_TRUE(std::holds_alternative<Stop>(decode(encode(Stop{}))));
}

TEST(Messages, TruncatedOrOverlongBytesAreMalformed) {
  const Bytes bytes = encode(OutcomeReport{7, outcome()});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW((void)decode(std::span(bytes).first(size)), MalformedMessage) << size;
  Bytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_THROW((void)decode(longer), MalformedMessage);
}

TEST(Messages, ImpossibleOutcomesAreMalformed) {
  solver::Outcome ragged = outcome();
  ragged.profile.q_c.pop_back();
  EXPECT_THROW((void)decode(encode(OutcomeReport{1, ragged})), MalformedMessage);
  solver::Outcome unknown = outcome();
  unknown.status = static_cast<solver::Status>(99);
  EXPECT_THROW((void)decode(encode(OutcomeReport{1, unknown})), MalformedMessage);
}

TEST(FrameReader, FindsMessagesInAnySlicing) {
  Bytes stream = frame(ProgressReport{1, {0.1, 0.5, 10, 20, 0.3}});
  for (const std::byte byte : frame(OutcomeReport{1, outcome()})) stream.push_back(byte);
  for (const std::size_t slice : {std::size_t{1}, std::size_t{7}, std::size_t{64}, stream.size()}) {
    FrameReader reader;
    std::vector<Message> messages;
    for (std::size_t at = 0; at < stream.size(); at += slice) {
      reader.feed(std::span(stream).subspan(at, std::min(slice, stream.size() - at)));
      while (auto message = reader.next()) messages.push_back(std::move(*message));
    }
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(std::get<ProgressReport>(messages[0]).progress.steps, 10);
    EXPECT_EQ(std::get<OutcomeReport>(messages[1]).outcome.steps, outcome().steps);
    EXPECT_FALSE(reader.partial());
  }
}

TEST(FrameReader, RefusesAForeignStream) {
  FrameReader reader;
  reader.feed(Bytes(64, std::byte{'x'}));
  EXPECT_THROW((void)reader.next(), MalformedMessage);
}

TEST(Cores, SharesAddUp) {
  for (int cores = 1; cores < 20; ++cores)
    for (int ranks = 1; ranks < 8; ++ranks) {
      int sum = 0;
      for (int rank = 0; rank < ranks; ++rank) sum += share_of_cores(cores, ranks, rank);
      EXPECT_EQ(sum, cores);
      EXPECT_GE(share_of_cores(cores, ranks, 0), 1);
    }
}

}  // namespace
}  // namespace cpt::campaign
