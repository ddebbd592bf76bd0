#include "campaign/executor.hpp"

#include <poll.h>

namespace cpt::campaign {

void ProcessExecutor::start(const Order& order, double now) {
  processes_[order.realization] = std::make_unique<RealizationProcess>(
      order.setup.program ? command_.program : command_.push, order, now);
}

std::vector<Message> ProcessExecutor::service(double now) {
  std::vector<Message> messages;
  for (auto item = processes_.begin(); item != processes_.end();) {
    const int realization = item->first;
    RealizationProcess::News news = item->second->service(now);
    for (std::string& text : news.remarks) messages.emplace_back(Remark{realization, std::move(text)});
    if (news.outcome) {
      messages.emplace_back(OutcomeReport{realization, std::move(*news.outcome), news.interrupted});
      item = processes_.erase(item);
      continue;
    }
    if (news.progress) messages.emplace_back(ProgressReport{realization, *news.progress});
    ++item;
  }
  return messages;
}

void ProcessExecutor::ask_all_to_end() {
  for (const auto& [realization, process] : processes_) process->ask_to_end();
}

void ProcessExecutor::nap(double seconds) const {
  std::vector<pollfd> descriptors;
  for (const auto& [realization, process] : processes_)
    if (process->descriptor() >= 0) descriptors.push_back({process->descriptor(), POLLIN, 0});
  // A process whose channel has closed is about to end, which no descriptor announces.
  if (descriptors.size() < processes_.size() && seconds > 0.005) seconds = 0.005;
  ::poll(descriptors.data(), descriptors.size(), static_cast<int>(seconds * 1000.0));
}

}  // namespace cpt::campaign
