// The solver runs that a diagnosis needs, as points of a study: the campaign runs, stores and resumes them
// like any other, and keeps them for the next diagnosis of the same study.
#pragma once

#include "diagnosis/depth_grid.hpp"
#include "diagnosis/request.hpp"

namespace cpt::diagnosis {

/// The runs of one mechanism; or, for one of the reading, the places where its curves are made from the
/// baseline's and, joint, from the runs at other soil (Design::first_joint). It has no points.
struct MechanismDesign {
  solver::Mechanism mechanism;
  std::vector<std::size_t> varied;  ///< of its parameters: those whose prior is a range
  MatrixXd unit;                    // runs x varied, in the unit cube
  std::size_t first_point;          ///< index into the study's points; its runs follow one another
  MatrixXd joint_unit;              // joint runs x varied: with the soil's parameters changed too
  std::size_t first_joint = 0;      ///< index into the study's points
};

struct Design {
  std::size_t first_repeat, repeats;  ///< indices into the study's points
  std::size_t first_joint, joint;
  std::vector<MechanismDesign> mechanisms;
};

/// The study of one sounding: the baseline with what is known to differ, the study's rows, and the design's
/// points; database NAME-diagnosis.sqlite beside the study's own, with a name of its own for each set of
/// known inputs.
struct SoundingStudy {
  parameters::Study study;
  Design design;
};
[[nodiscard]] SoundingStudy sounding_study(const parameters::Study& study, const SoundingRequest& sounding,
                                           const std::vector<solver::Mechanism>& mechanisms, int repeats,
                                           int joint);

/// The mechanism's varied quantities at phi, their places in the unit cube. The others stay as the study has
/// them.
[[nodiscard]] std::vector<parameters::Change> mechanism_changes(const solver::Mechanism& mechanism,
                                                                const VectorXd& phi);

/// Values of the rows' quantities at their places between the bounds, but for those that are known.
[[nodiscard]] std::vector<parameters::Change> row_changes(const std::vector<parameters::Row>& rows,
                                                          const VectorXd& places,
                                                          const std::vector<parameters::Change>& known);

}  // namespace cpt::diagnosis
