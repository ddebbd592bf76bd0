// When to write again what is written whole, so that its cost grows with the campaign: at growing distances,
// at most a share of the time. Pure: the time is an argument.
#pragma once

namespace cpt::campaign {

class Pace {
 public:
  /// `share` of the time that writing may take; `cost` of one ended realization [s], until measured.
  Pace(double share, double cost) : share_(share), cost_(cost) {}

  /// Something came that is not written yet.
  void news() { stale_ = true; }
  [[nodiscard]] bool stale() const { return stale_; }
  [[nodiscard]] bool due(double now, int ended) const {
    return stale_ && share_ * (now - written_) > cost_ * ended;
  }
  /// Written from `start` to `end` [s], with so many realizations ended.
  void wrote(double start, double end, int ended) {
    stale_ = false;
    written_ = end;
    if (ended > 0) cost_ = (end - start) / ended;
  }

 private:
  double share_;
  double cost_;
  bool stale_ = false;
  double written_ = 0.0;  // [s]
};

}  // namespace cpt::campaign
