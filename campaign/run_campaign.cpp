#include "campaign/run_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "campaign/clock.hpp"
#include "campaign/external/work_folder.hpp"
#include "campaign/forecast.hpp"
#include "campaign/pace.hpp"
#include "campaign/stop_signals.hpp"
#include "campaign/worker.hpp"
#include "parameters/all_realizations.hpp"
#include "parameters/run_order.hpp"
#include "results/files/patience.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/ledger/ledger.hpp"
#include "results/push/checkpoint.hpp"
#include "results/statistics/propagation_stop.hpp"
#include "results/statistics/stored_design.hpp"

namespace cpt::campaign {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_losses = 2;         // of ranks with the same realization, before it is given up
constexpr int most_interruptions = 3;  // of a realization by signals from outside, before it is given up
constexpr double longest_group = 0.1;  // [s] from a realization's end to its commit, where others keep ending
constexpr double lock_note_after = 2.0;      // [s] of waiting for a locked database, before it is told
constexpr double lock_note_interval = 60.0;  // [s] until it is told again
constexpr double mirror_share = 0.005;       // most of the master's time that the curve file may take
constexpr double page_share = 0.02;          // and the page
constexpr double usual_cost = 0.001;         // [s] of a realization in either, until measured
constexpr double muster_limit =
    0.8;  // [s] to wait for the workers' offers before the first realization starts

std::string describe(const parameters::Study& study, const parameters::Realization& realization) {
  if (realization.side == parameters::Side::baseline) return "baseline";
  if (realization.point >= 0) return std::string(parameter_name(study, realization));
  return fmt::format("{} = {}", parameter_name(study, realization), value_text(study, realization));
}

// Those of `order` that are among `ids`, which rise.
std::vector<int> in_order(const std::vector<int>& order, const std::vector<int>& ids) {
  std::vector<int> sorted;
  std::ranges::copy_if(order, std::back_inserter(sorted),
                       [&](int id) { return std::ranges::binary_search(ids, id); });
  return sorted;
}

// Adds the time until its end to a sum.
class Timed {
 public:
  explicit Timed(Spent& sum) : sum_(sum) {}
  ~Timed() {
    sum_.wall += monotonic_seconds() - wall_;
    sum_.processor += processor_seconds() - processor_;
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Spent& sum_;
  double wall_ = monotonic_seconds(), processor_ = processor_seconds();  // [s]
};

class Master {
 public:
  Master(const parameters::Study& study, const std::vector<parameters::Realization>& realizations,
         results::Ledger& ledger, Transport& transport, Executor& executor, const RunOptions& options,
         ProgressDisplay& display)
      : study_(study),
        ledger_(ledger),
        transport_(transport),
        options_(options),
        display_(display),
        executor_(executor),
        order_(parameters::run_order(study, realizations)),
        scheduler_(in_order(order_.ids, ledger.pending()), options.threads),
        before_(ledger.counts()),
        group_(ledger),
        started_(monotonic_seconds()) {
    for (const parameters::Realization& realization : realizations)
      realizations_[realization.id] = realization;
    scheduler_.add_rank(master, transport.node(), own_slots(transport, options));
    if (options.checkpoint_seconds > 0.0) keep_checkpoints();
    const std::vector<int> leading(order_.ids.begin(), order_.ids.begin() + order_.leading);
    for (const int id : in_order(leading, ledger.pending())) awaited_.insert(id);
    page_.news();
  }

  Summary run() {
    const int signal = work();
    display_.finish();
    return {whole_tally(), signal, ranks_lost_, time_, curves_problem_};
  }

 private:
  // The signal that stopped it; 0 if none did.
  int work() {
    const Timed timed(time_.whole);
    Napping napping;
    int signal = 0;
    mirror_curves(results::sync_curves);
    look_for_enough();
    while (!scheduler_.done() && (signal = stop_signal()) == 0) try {
        look_around(napping);
      } catch (const results::Busy&) {
        if (stop_signal() == 0)
          throw;  // else the wait for the database was broken off, and all ends in order
      }
    if (signal != 0) wind_up(signal);
    write_effects();
    commit();
    leave_work_folder(study_);
    if (curves_.stale()) mirror_curves(results::write_curves);
    if (signal != 0 && page_shown_) write_page(false);
    return signal;
  }

  void look_around(Napping& napping) {
    const double now = monotonic_seconds();
    bool busy = receive(now);
    for (Message& message : own_news(now)) {
      handle(master, message, now);
      busy = true;
    }
    drop_silent_ranks(now);
    if (mustered(now)) {
      hand_out(now);
      display_.update(standing(now), now);
    }
    // What has ended waits a moment for others, as long as they come, to share one commit with them.
    if (!busy || now > oldest_ + longest_group) commit();
    if (curves_.due(now, ended())) mirror_curves(results::write_curves);
    if (page_due(now)) write_page(true);
    if (looks_.due(now, ended())) look_for_enough();
    if (!scheduler_.done()) nap(napping.next(busy, now, transport_.longest_nap()));
  }

  // Another program may keep the database locked: its end is waited for, and meanwhile realizations go on.
  // Only a signal ends that, after a last moment.
  bool waits_for_database(const std::filesystem::path& database, double seconds) {
    if (seconds >= next_lock_note_) {
      display_.note(fmt::format("{}: {} keeps the database locked; waiting until it is free",
                                database.filename().string(), results::who_keeps(database)));
      next_lock_note_ = seconds + lock_note_interval;
    }
    if (seconds < lock_note_after) next_lock_note_ = lock_note_after;  // another wait
    return stop_signal() == 0 || seconds < lock_note_after;
  }

  [[nodiscard]] int stop_signal() const { return transport_.orphaned() ? 1 : StopSignals::received(); }

  std::vector<Message> own_news(double now) {
    const Timed timed(time_.realizations);
    return executor_.service(now);
  }

  void nap(double seconds) {
    const Timed timed(time_.waiting);
    executor_.nap(seconds);
  }

  std::optional<Received> poll() {
    const Timed timed(time_.messages);
    return transport_.poll();
  }

  // Realizations wait until all ranks have made their offers, for the sake of those that run with several
  // threads.
  [[nodiscard]] bool mustered(double now) const {
    return static_cast<int>(last_heard_.size()) + 1 >= transport_.size() || now > started_ + muster_limit;
  }

  void keep_checkpoints() {
    std::set<std::string> unfinished;
    for (const int id : ledger_.pending()) unfinished.insert(ledger_.settings_hash(id));
    checkpoints_.emplace(study_.database, unfinished);
  }

  // Stopped by a signal: lets all that runs keep its state. What still finishes meanwhile counts.
  void wind_up(int signal) {
    display_.note(fmt::format("signal {}: what runs keeps its state and ends", signal));
    stopping_ = true;
    executor_.ask_all_to_end();
    const bool workers_reachable = !transport_.orphaned();
    if (workers_reachable)
      for (const auto& [rank, heard] : last_heard_) transport_.send(rank, Stop{});
    Napping napping;
    const double until = monotonic_seconds() + stop_grace;
    for (double now = monotonic_seconds(); now < until; now = monotonic_seconds()) {
      if (executor_.running() == 0 && (last_heard_.empty() || !workers_reachable)) break;
      bool busy = true;
      try {
        busy = workers_reachable && receive(now);
        for (Message& message : executor_.service(now)) {
          handle(master, message, now);
          busy = true;
        }
        commit();
      } catch (const results::Busy&) {  // what ended is run again; the others still keep their states
      }
      executor_.nap(napping.next(busy, now, transport_.longest_nap()));
    }
    executor_.kill_all();
  }

  bool receive(double now) {
    bool any = false;
    while (std::optional<Received> received = poll()) {
      any = true;
      if (silenced_.contains(received->from)) continue;
      last_heard_[received->from] = now;
      handle(received->from, received->message, now);
    }
    return any;
  }

  void handle(int rank, Message& message, double now) {
    if (const auto* hello = std::get_if<Hello>(&message)) {
      if (offered_.insert(rank).second) scheduler_.add_rank(rank, hello->node, hello->slots);
    } else if (const auto* report = std::get_if<ProgressReport>(&message)) {
      const solver::Progress& progress = report->progress;
      if (scheduler_.runner(report->realization) == rank)
        forecast_.progressed(report->realization, progress.depth / progress.final_depth,
                             point_steps(progress), now);
    } else if (const auto* remark = std::get_if<Remark>(&message)) {
      display_.note(fmt::format("realization {}: {}", remark->realization, remark->text));
    } else if (const auto* ended = std::get_if<OutcomeReport>(&message)) {
      if (ended->interrupted) return interrupted(ended->realization, rank);
      const bool completed = ended->outcome.status == solver::Status::completed;
      if (!scheduler_.end(ended->realization, rank, !completed)) return;
      forecast_.ended(ended->realization, completed, point_steps(ended->outcome), now);
      record(ended->realization, ended->outcome);
    } else if (std::holds_alternative<Leaving>(message)) {
      if (stopping_)
        last_heard_.erase(rank);
      else
        lose(rank, "was told to stop");
    }
  }

  // Somebody told a realization to end, most likely the batch system all processes at once.
  void interrupted(int id, int rank) {
    if (stopping_ || !scheduler_.put_back(id, rank)) return;
    forecast_.restarted(id);
    if (++interruptions_[id] < most_interruptions) {
      display_.note(fmt::format("warning: realization {} was told to end from outside; it starts again", id));
      ledger_.mark_pending(id);
      return;
    }
    give_up(id, solver::Status::crashed,
            fmt::format("told to end from outside {} times", most_interruptions));
  }

  void give_up(int id, solver::Status status, std::string reason) {
    scheduler_.give_up(id);
    solver::Outcome outcome;
    outcome.status = status;
    outcome.reason = std::move(reason);
    record(id, outcome);
  }

  template <class Steps>
  static double point_steps(const Steps& of) {
    return static_cast<double>(of.steps) * static_cast<double>(of.material_points);
  }

  void hand_out(double now) {
    while (const std::optional<Assignment> assignment = scheduler_.next()) {
      const int id = assignment->realization;
      Order order{id, assignment->threads, study_.wall_limit_seconds, options_.hang_limit_seconds,
                  parameters::make_setup(study_, realizations_.at(id))};
      if (checkpoints_) {
        order.checkpoint = checkpoints_->file(ledger_.settings_hash(id));
        order.checkpoint_seconds = options_.checkpoint_seconds;
      }
      give_folders(order, study_);
      {
        const Timed timed(time_.database);
        ledger_.mark_running(id);
      }
      forecast_.started(id, assignment->threads, now);
      const Timed timed(assignment->rank == master ? time_.realizations : time_.messages);
      if (assignment->rank == master)
        executor_.start(order, now);
      else
        transport_.send(assignment->rank, order);
    }
  }

  // From here on a realization is only in the open group; commit() finishes it.
  void record(int id, const solver::Outcome& outcome) {
    try {
      const Timed timed(time_.database);
      ledger_.record(id, outcome);
    } catch (const results::Busy&) {  // it ends without this outcome, and nobody may count it
      (outcome.status == solver::Status::completed ? unrecorded_.finished : unrecorded_.failed) += 1;
      throw;
    }
    if (ended_.empty()) oldest_ = monotonic_seconds();
    ended_.push_back(id);
    const Tally tally = whole_tally();
    std::string line =
        fmt::format("[{}/{}] realization {} ({}): {}", tally.finished + tally.failed, tally.total(), id,
                    describe(study_, realizations_.at(id)), solver::to_string(outcome.status));
    line += fmt::format(" after {}", format_duration(outcome.wall_seconds));
    if (!outcome.reason.empty()) line += ": " + outcome.reason;
    news_.push_back(std::move(line));
  }

  // The user is told, and checkpoints go, only once it is on disk.
  void commit() {
    {
      const Timed timed(time_.database);
      group_.commit();
    }
    for (const std::string& line : news_) display_.note(line);
    if (checkpoints_)
      for (const int id : ended_) checkpoints_->remove(ledger_.settings_hash(id));
    if (!ended_.empty()) {
      curves_.news();
      page_.news();
      looks_.news();
    }
    for (const int id : ended_) awaited_.erase(id);
    news_.clear();
    ended_.clear();
    oldest_ = infinity;
  }

  // The ledger holds the curves; a mirror that cannot be written is worth a warning, not the campaign. It is
  // written whole, so its cost grows with the campaign: it follows at growing distances, and in the end.
  template <class Write>
  void mirror_curves(Write write) {
    commit();
    const double start = monotonic_seconds();
    try {
      const Timed timed(time_.curves);
      write(study_.curves, study_.database);
      curves_problem_.clear();
    } catch (const results::Error& problem) {
      if (curves_problem_.empty()) display_.note(fmt::format("warning: {}", problem.what()));
      curves_problem_ = problem.what();
    }
    curves_.wrote(start, monotonic_seconds(), ended());
  }

  // A design with a rule to stop: once its first runs suffice, those behind them are not needed. What has
  // been handed out ends; the design's numbers are of the runs that sufficed alone, so that they do not
  // depend on when somebody looked.
  void look_for_enough() {
    if (!study_.design.until || scheduler_.tally().pending == 0) return;
    commit();
    const double start = monotonic_seconds();
    const results::Snapshot stored = results::read_snapshot(study_.database);
    const results::StoredDesign design = results::stored_design(stored);
    looks_.wrote(start, monotonic_seconds(), ended());
    if (!design.enough) return;
    const std::vector<int> dropped = scheduler_.drop(results::ids_beyond(study_, *design.enough));
    if (dropped.empty()) return;
    {
      const Timed timed(time_.database);
      ledger_.mark_not_needed(dropped);
    }
    commit();
    display_.note(design.stopped);
  }

  // The ledger is whole without it, so a signal that comes meanwhile or a lock that stays loses nothing.
  void write_effects() try {
    const Timed timed(time_.database);
    ledger_.write_effects();
  } catch (const results::Busy&) {
  }

  // The first page once there is something to see.
  [[nodiscard]] bool page_due(double now) const {
    return options_.write_page && awaited_.empty() && !scheduler_.done() && page_.due(now, ended());
  }

  void write_page(bool running) {
    commit();
    const double start = monotonic_seconds();
    try {
      const Timed timed(time_.page);
      const std::string file = options_.write_page(running);
      if (!page_shown_) display_.note(fmt::format("report: {}; the open page fills itself", file));
      page_shown_ = true;
    } catch (const results::Error& problem) {
      if (!page_warned_) display_.note(fmt::format("warning: {}", problem.what()));
      page_warned_ = true;
    }
    page_.wrote(start, monotonic_seconds(), ended());
  }

  void drop_silent_ranks(double now) {
    std::vector<int> silent;
    for (const auto& [rank, heard] : last_heard_)
      if (now > heard + options_.rank_limit_seconds) silent.push_back(rank);
    for (const int rank : silent) {
      lose(rank, fmt::format("has been silent for {:g} s", options_.rank_limit_seconds));
      ranks_lost_ = true;
    }
  }

  void lose(int rank, const std::string& why) {
    last_heard_.erase(rank);
    silenced_.insert(rank);
    display_.note(fmt::format("warning: rank {} {}; its realizations start again elsewhere", rank, why));
    for (const int id : scheduler_.lose_rank(rank)) {
      forecast_.restarted(id);
      if (++losses_[id] < most_losses)
        ledger_.mark_pending(id);
      else
        give_up(id, solver::Status::rank_lost,
                fmt::format("{} ranks were lost while running it", most_losses));
    }
  }

  [[nodiscard]] Tally whole_tally() const {
    const Tally now = scheduler_.tally();
    return {now.pending + unrecorded_.finished + unrecorded_.failed, now.running,
            before_.completed + now.finished - unrecorded_.finished,
            before_.failed + now.failed - unrecorded_.failed};
  }

  [[nodiscard]] int ended() const { return whole_tally().finished + whole_tally().failed; }

  [[nodiscard]] Standing standing(double now) const {
    return {whole_tally(), forecast_.remaining_seconds(scheduler_.tally().pending, scheduler_.slots(), now),
            forecast_.point_steps_per_second(now)};
  }

  const parameters::Study& study_;
  std::map<int, parameters::Realization> realizations_;  // by id
  results::Ledger& ledger_;
  Transport& transport_;
  const RunOptions& options_;
  ProgressDisplay& display_;
  std::optional<results::CheckpointFolder> checkpoints_;
  Executor& executor_;
  MasterTime time_;
  parameters::RunOrder order_;
  Scheduler scheduler_;
  results::Counts before_;  // of earlier campaigns
  results::Ledger::Group group_;
  std::vector<std::string> news_;  // lines about realizations of the open group
  std::vector<int> ended_;         // realizations of the open group
  double oldest_ = infinity;       // [s] since when one of them waits
  Forecast forecast_;
  double started_;                    // [s]
  std::map<int, double> last_heard_;  // [s] by worker that is present
  Tally unrecorded_{};                // outcomes that a locked database did not take before the end
  std::set<int> offered_;             // workers whose slots are known
  std::set<int> silenced_;            // workers that are lost; late words from them do not count
  std::map<int, int> losses_;         // by realization
  std::map<int, int> interruptions_;  // by realization
  bool stopping_ = false;
  bool ranks_lost_ = false;
  std::string curves_problem_;               // why the curve file could not be written when last it was tried
  double next_lock_note_ = lock_note_after;  // [s] of waiting for a locked database
  results::Patience patience_{
      [this](const auto& database, double seconds) { return waits_for_database(database, seconds); }};
  Pace curves_{mirror_share, usual_cost};
  Pace page_{page_share, usual_cost};
  Pace looks_{page_share, usual_cost};
  std::set<int> awaited_;  // realizations that the first page waits for
  bool page_shown_ = false;
  bool page_warned_ = false;
};

}  // namespace

Summary run_campaign(const parameters::Study& study, const std::string& study_text, Transport& transport,
                     const RunOptions& options, ProgressDisplay& display) {
  ProcessExecutor executor(options.realization_command);
  return run_campaign(study, study_text, transport, executor, options, display);
}

Summary run_campaign(const parameters::Study& study, const std::string& study_text, Transport& transport,
                     Executor& executor, const RunOptions& options, ProgressDisplay& display) {
  const std::vector<parameters::Realization> realizations = parameters::all_realizations(study);
  results::Ledger ledger =
      results::Ledger::open_for_run(study, realizations,
                                    {study_text, options.retry_failed, options.file_system,
                                     [&](std::string_view message) { display.note(message); }});
  if (const int adopted = ledger.adopt(options.adopt_from); adopted > 0)
    display.note(fmt::format("{} realizations taken from {}", adopted, options.adopt_from.string()));
  return Master(study, realizations, ledger, transport, executor, options, display).run();
}

}  // namespace cpt::campaign
