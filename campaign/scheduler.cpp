#include "campaign/scheduler.hpp"

#include <algorithm>
#include <stdexcept>

namespace cpt::campaign {

Scheduler::Scheduler(std::span<const int> realizations, int threads)
    : fixed_threads_(threads), pending_(realizations.begin(), realizations.end()) {}

void Scheduler::add_rank(int rank, int node, int slots) {
  if (!ranks_.emplace(rank, Rank{node, slots}).second)
    throw std::invalid_argument("rank offered its slots twice");
}

std::vector<int> Scheduler::lose_rank(int rank) {
  std::vector<int> lost;
  for (const auto& [realization, running] : running_)
    if (running.rank == rank) lost.push_back(realization);
  for (const int realization : lost) running_.erase(realization);
  pending_.insert(pending_.begin(), lost.begin(), lost.end());
  if (const auto gone = ranks_.find(rank); gone != ranks_.end()) {
    const Rank offer = gone->second;
    ranks_.erase(gone);
    for (auto& [other, heir] : ranks_) {
      if (heir.node != offer.node) continue;
      heir.slots += offer.slots;
      break;
    }
  }
  return lost;
}

std::optional<Assignment> Scheduler::next() {
  if (pending_.empty()) return std::nullopt;
  const std::map<int, int> free = free_slots();
  int free_everywhere = 0;
  int node = 0;
  int free_here = 0;
  for (const auto& [candidate, slots] : free) {
    free_everywhere += std::max(slots, 0);
    if (slots > free_here) {
      node = candidate;
      free_here = slots;
    }
  }
  if (free_here == 0) return std::nullopt;
  const int threads = choose_threads(free_here, free_everywhere, node);
  if (threads > free_here) return std::nullopt;  // fixed threads: wait for the node's other slots

  const Assignment assignment{pending_.front(), choose_rank(node), threads};
  pending_.pop_front();
  running_[assignment.realization] = {assignment.rank, threads};
  ++ranks_.at(assignment.rank).realizations;
  return assignment;
}

bool Scheduler::end(int realization, int rank, bool failed) {
  const auto found = running_.find(realization);
  if (found == running_.end() || found->second.rank != rank) return false;
  --ranks_.at(rank).realizations;
  running_.erase(found);
  ++(failed ? failed_ : finished_);
  return true;
}

bool Scheduler::put_back(int realization, int rank) {
  const auto found = running_.find(realization);
  if (found == running_.end() || found->second.rank != rank) return false;
  --ranks_.at(rank).realizations;
  running_.erase(found);
  pending_.push_front(realization);
  return true;
}

void Scheduler::give_up(int realization) {
  if (std::erase(pending_, realization) == 0) throw std::invalid_argument("realization is not pending");
  ++failed_;
}

std::vector<int> Scheduler::drop(std::span<const int> realizations) {
  std::vector<int> dropped;
  for (const int realization : realizations)
    if (std::erase(pending_, realization) > 0) dropped.push_back(realization);
  return dropped;
}

Tally Scheduler::tally() const {
  return {static_cast<int>(pending_.size()), static_cast<int>(running_.size()), finished_, failed_};
}

int Scheduler::slots() const {
  int sum = 0;
  for (const auto& [rank, offer] : ranks_) sum += offer.slots;
  return sum;
}

std::optional<int> Scheduler::runner(int realization) const {
  const auto found = running_.find(realization);
  if (found == running_.end()) return std::nullopt;
  return found->second.rank;
}

std::map<int, int> Scheduler::free_slots() const {
  std::map<int, int> free;
  for (const auto& [rank, offer] : ranks_) free[offer.node] += offer.slots;
  for (const auto& [realization, running] : running_) free[ranks_.at(running.rank).node] -= running.threads;
  return free;
}

int Scheduler::node_slots(int node) const {
  int sum = 0;
  for (const auto& [rank, offer] : ranks_)
    if (offer.node == node) sum += offer.slots;
  return sum;
}

int Scheduler::choose_threads(int free_here, int free_everywhere, int node) const {
  if (fixed_threads_ > 0) return std::min(fixed_threads_, node_slots(node));
  const int share = free_everywhere / static_cast<int>(pending_.size());
  return std::clamp(share, 1, free_here);
}

int Scheduler::choose_rank(int node) const {
  // The rank with the most slots left to itself; threads may then borrow those of its neighbours.
  int best = -1;
  int most = 0;
  for (const auto& [rank, offer] : ranks_) {
    const int left = offer.slots - offer.realizations;
    if (offer.node == node && (best < 0 || left > most)) {
      best = rank;
      most = left;
    }
  }
  return best;
}

}  // namespace cpt::campaign
