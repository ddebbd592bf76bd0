#include "campaign/scheduler.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace cpt::campaign {
namespace {

std::vector<int> ids(int count) {
  std::vector<int> list(static_cast<std::size_t>(count));
  std::iota(list.begin(), list.end(), 1);
  return list;
}

std::vector<Assignment> hand_out(Scheduler& scheduler) {
  std::vector<Assignment> list;
  while (const auto assignment = scheduler.next()) list.push_back(*assignment);
  return list;
}

TEST(Scheduler, FillsAllSlotsInOrderAndNoMore) {
  Scheduler scheduler(ids(10));
  scheduler.add_rank(0, 0, 1);
  scheduler.add_rank(1, 0, 2);
  const auto started = hand_out(scheduler);
  ASSERT_EQ(started.size(), 3U);
  int on_rank_1 = 0;
  for (std::size_t i = 0; i < started.size(); ++i) {
    EXPECT_EQ(started[i].realization, static_cast<int>(i) + 1);
    EXPECT_EQ(started[i].threads, 1);
    on_rank_1 += started[i].rank == 1 ? 1 : 0;
  }
  EXPECT_EQ(on_rank_1, 2);
  EXPECT_EQ(scheduler.tally().pending, 7);
  EXPECT_EQ(scheduler.tally().running, 3);
}

TEST(Scheduler, WhatIsNotNeededIsNotStarted) {
  Scheduler scheduler(ids(10));
  scheduler.add_rank(0, 0, 2);
  ASSERT_EQ(hand_out(scheduler).size(), 2U);
  const std::vector<int> beyond = {2, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(scheduler.drop(beyond), (std::vector<int>{5, 6, 7, 8, 9, 10}));  // the second is running
  EXPECT_EQ(scheduler.tally().total(), 4);
  EXPECT_TRUE(scheduler.end(1, 0, false));
  EXPECT_TRUE(scheduler.end(2, 0, false));
  ASSERT_EQ(hand_out(scheduler).size(), 2U);
  EXPECT_TRUE(scheduler.end(3, 0, false));
  EXPECT_TRUE(scheduler.end(4, 0, false));
  EXPECT_TRUE(scheduler.done());
}

TEST(Scheduler, InterruptedRealizationIsTheNext) {
  Scheduler scheduler(ids(5));
  scheduler.add_rank(0, 0, 2);
  ASSERT_EQ(hand_out(scheduler).size(), 2U);
  EXPECT_FALSE(scheduler.put_back(2, 1)) << "not this rank's";
  EXPECT_TRUE(scheduler.put_back(2, 0));
  EXPECT_FALSE(scheduler.put_back(2, 0)) << "already";
  EXPECT_EQ(scheduler.tally().pending, 4);
  const auto next = hand_out(scheduler);
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(next[0].realization, 2);
}

TEST(Scheduler, EveryRealizationRunsExactlyOnce) {
  Scheduler scheduler(ids(21));
  scheduler.add_rank(0, 0, 1);
  scheduler.add_rank(1, 0, 1);
  std::vector<int> seen;
  while (!scheduler.done()) {
    const auto started = hand_out(scheduler);
    ASSERT_FALSE(started.empty());
    for (const Assignment& assignment : started) seen.push_back(assignment.realization);
    for (const Assignment& assignment : started)
      EXPECT_TRUE(scheduler.end(assignment.realization, assignment.rank, assignment.realization % 5 == 0));
  }
  EXPECT_EQ(seen, ids(21));
  EXPECT_EQ(scheduler.tally().failed, 4);
  EXPECT_EQ(scheduler.tally().finished, 17);
  EXPECT_EQ(scheduler.tally().total(), 21);
}

TEST(Scheduler, LastRealizationsShareTheCores) {
  Scheduler scheduler(ids(3));
  scheduler.add_rank(0, 0, 8);
  const auto started = hand_out(scheduler);
  ASSERT_EQ(started.size(), 3U);
  EXPECT_EQ(started[0].threads, 2);
  EXPECT_EQ(started[1].threads, 3);
  EXPECT_EQ(started[2].threads, 3);
}

TEST(Scheduler, ThreadsBorrowTheSlotsOfRanksOnTheSameNodeOnly) {
  Scheduler one_node(ids(1));
  one_node.add_rank(0, 0, 1);
  one_node.add_rank(1, 0, 1);
  EXPECT_EQ(one_node.next()->threads, 2);

  Scheduler two_nodes(ids(1));
  two_nodes.add_rank(0, 0, 1);
  two_nodes.add_rank(1, 1, 1);
  EXPECT_EQ(two_nodes.next()->threads, 1);
}

TEST(Scheduler, ARealizationOnAllCoresOfTheNodeKeepsOthersWaiting) {
  Scheduler scheduler(ids(2), 2);
  scheduler.add_rank(0, 0, 1);
  scheduler.add_rank(1, 0, 1);
  const auto first = scheduler.next();
  EXPECT_EQ(first->threads, 2);
  EXPECT_FALSE(scheduler.next());
  EXPECT_TRUE(scheduler.end(first->realization, first->rank, false));
  EXPECT_EQ(scheduler.next()->threads, 2);
}

TEST(Scheduler, FixedThreadsWaitForEnoughFreeSlots) {
  Scheduler scheduler(ids(3), 2);
  scheduler.add_rank(0, 0, 3);
  EXPECT_EQ(scheduler.next()->threads, 2);
  EXPECT_FALSE(scheduler.next());

  Scheduler narrow(ids(1), 16);
  narrow.add_rank(0, 0, 3);
  EXPECT_EQ(narrow.next()->threads, 3);
}

TEST(Scheduler, LostRankGivesItsRealizationsBackFirst) {
  Scheduler scheduler(ids(4));
  scheduler.add_rank(0, 0, 1);
  scheduler.add_rank(1, 1, 1);
  const auto started = hand_out(scheduler);
  ASSERT_EQ(started.size(), 2U);
  const int lost = started[0].rank == 1 ? 1 : 2;
  EXPECT_EQ(scheduler.lose_rank(1), std::vector<int>{lost});
  EXPECT_FALSE(scheduler.end(lost, 1, false)) << "a late word from a lost rank";
  EXPECT_EQ(scheduler.tally().pending, 3);
  EXPECT_EQ(scheduler.slots(), 1);
  EXPECT_TRUE(scheduler.end(3 - lost, 0, false));
  EXPECT_EQ(scheduler.next()->realization, lost);
  EXPECT_EQ(scheduler.runner(lost), 0);
}

TEST(Scheduler, ANeighbourInheritsTheSlotsOfALostRank) {
  Scheduler scheduler(ids(4));
  scheduler.add_rank(0, 0, 1);
  scheduler.add_rank(1, 0, 2);
  EXPECT_EQ(hand_out(scheduler).size(), 3U);
  scheduler.lose_rank(1);
  EXPECT_EQ(scheduler.slots(), 3);
  const auto again = hand_out(scheduler);
  EXPECT_EQ(again.size(), 2U);
  for (const Assignment& assignment : again) EXPECT_EQ(assignment.rank, 0);
}

TEST(Scheduler, GivenUpRealizationsCountAsFailed) {
  Scheduler scheduler(ids(1));
  scheduler.give_up(1);
  EXPECT_TRUE(scheduler.done());
  EXPECT_EQ(scheduler.tally().failed, 1);
  EXPECT_THROW(scheduler.give_up(1), std::invalid_argument);
}

TEST(Scheduler, RanksWithoutSlotsGetNothing) {
  Scheduler scheduler(ids(2));
  scheduler.add_rank(0, 0, 0);
  EXPECT_FALSE(scheduler.next());
  scheduler.add_rank(1, 0, 1);
  EXPECT_EQ(scheduler.next()->rank, 1);
  EXPECT_THROW(scheduler.add_rank(1, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::campaign
