#include "diagnosis/parameters_prior.hpp"

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {

NullModel null_model(ResponseSurface parameters, MatrixXd sigma) {
  VectorXd mean = parameters.prior_mean();
  const MatrixXd factors = parameters.prior_factors();
  MatrixXd covariance = sigma + factors * factors.transpose();
  return {std::move(parameters), std::move(sigma), std::move(mean), std::move(covariance)};
}

MatrixXd draw_null(const NullModel& null, int count, std::uint64_t seed) {
  const Whitener noise(null.sigma);
  const ResponseSurface& model = null.parameters;
  MatrixXd z(null.mean.size(), count);
  MatrixXd curves(null.mean.size(), count);
  for (int k = 0; k < count; ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    VectorXd t(model.parameters());
    for (Index j = 0; j < t.size(); ++j) {
      t(j) = random.uniform();
      if (model.two_valued(j)) t(j) = t(j) < 0.5 ? 0.0 : 1.0;
    }
    curves.col(k) = model.predict(t) - null.mean;
    z.col(k) = random.normals(z.rows());
  }
  return curves + noise.colour(z);
}

}  // namespace cpt::diagnosis
