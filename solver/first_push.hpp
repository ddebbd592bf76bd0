// The first of two pushes: what it leaves behind at the place of the second (mechanisms/previous_push.hpp).
#pragma once

#include "solver/simulate.hpp"

namespace cpt::solver {

/// Watches the first push: passes its progress on and looks at the material points at its end.
class FirstPush : public Observer {
 public:
  /// `setup` asks for the previous push; `observer` is told of its progress.
  FirstPush(const Setup& setup, Observer& observer);

  /// The setup to push first: the same without a previous push.
  [[nodiscard]] const Setup& setup() const { return setup_; }
  /// After the push: the share asked for of what it changed, averaged over radii within two cone diameters of
  /// the spacing.
  [[nodiscard]] const LeftBehind& left_behind() const { return left_; }

  void progress(const Progress& progress) override { observer_.progress(progress); }
  bool stop_requested(std::string& reason) override { return observer_.stop_requested(reason); }
  bool state_wanted() override { return observer_.state_wanted(); }
  void keep_state(PushState state) override { observer_.keep_state(std::move(state)); }
  [[nodiscard]] double next_look() const override;
  void look(double depth, const MaterialPoints& points) override;

 private:
  Setup setup_;
  PreviousPush asked_;
  Observer& observer_;
  LeftBehind left_;
  bool looked_ = false;
};

}  // namespace cpt::solver
