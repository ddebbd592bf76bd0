// The inputs of a design that draws, in the unit interval: what its polynomials are functions of.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parameters/designs/shapley.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "parameters/study.hpp"

namespace cpt::results {

/// Of the design's rows but those that every run draws for itself, as the seed of a random field, which are
/// noise to a polynomial. A place is where a row's value lies between those of normal scores of -3.3 and 3.3;
/// beyond, at the end.
class PlacedInputs {
 public:
  explicit PlacedInputs(const parameters::Study& study);

  [[nodiscard]] std::size_t count() const { return rows_.size(); }
  [[nodiscard]] std::vector<int> values() const;  ///< of each how many it takes, 0: any (orthonormal.hpp)
  [[nodiscard]] std::vector<parameters::ScoredInput> scored() const;  ///< refers to this
  [[nodiscard]] Eigen::MatrixXd correlation() const;                  ///< of their normal scores
  /// Runs x inputs: of the design's first `runs`, whether it asks for so many or not.
  [[nodiscard]] Eigen::MatrixXd places(Eigen::Index runs) const;

 private:
  struct Placed {
    explicit Placed(const parameters::Row& of);
    [[nodiscard]] double place(double value) const;

    const parameters::Row* row;
    parameters::ValueOfScore value;
    double least, most;
  };
  const parameters::Study& study_;
  std::vector<Placed> rows_;
};

}  // namespace cpt::results
