#include "validation/concealed/truth.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "diagnosis/prior_range.hpp"
#include "diagnosis/random.hpp"
#include "results/ledger/provenance.hpp"
#include "solver/channels.hpp"

namespace cpt::validation::concealed {
namespace {

using diagnosis::Index, diagnosis::mechanism_changes, diagnosis::Random, diagnosis::Request,
    diagnosis::row_changes, diagnosis::SoundingRequest, diagnosis::varied_parameters, diagnosis::VectorXd;

using parameters::Change;
using Json = nlohmann::json;

constexpr double reading_spacing = 0.001;  // [m] of the recordings

template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i)
    std::iter_swap(items.begin() + static_cast<std::ptrdiff_t>(i - 1),
                   items.begin() + random.below(static_cast<Index>(i)));
}

// 0 ... kinds - 1 over and over, every round in a random order of its own.
class Rotation {
 public:
  explicit Rotation(std::size_t kinds) : kinds_(kinds) {}
  std::size_t next(Random& random) {
    if (left_.empty()) {
      left_.resize(kinds_);
      std::iota(left_.begin(), left_.end(), std::size_t{0});
      shuffle(left_, random);
    }
    const std::size_t kind = left_.back();
    left_.pop_back();
    return kind;
  }

 private:
  std::size_t kinds_;
  std::vector<std::size_t> left_;
};

Part draw_part(const solver::Mechanism& mechanism, Random& random) {
  const auto dimensions = static_cast<Index>(varied_parameters(mechanism).size());
  Part part{mechanism, VectorXd(dimensions)};
  for (Index d = 0; d < dimensions; ++d) part.place(d) = random.uniform();
  return part;
}

Numerics draw_numerics(Random& random) {
  Numerics numerics{};
  numerics.point_shift = random.uniform() - 0.5;
  numerics.courant = 0.7 + 0.3 * random.uniform();
  numerics.near_height = 1.0 + 0.12 * random.uniform();
  numerics.noise_seed = static_cast<std::uint64_t>(random.uniform() * 0x1p52);
  return numerics;
}

std::vector<Change> changes_of(const Truth& truth, const SoundingRequest& known,
                               const parameters::Study& study, std::size_t sounding) {
  std::vector<Change> changes = row_changes(study.rows, truth.soil, known.changes);
  for (const Part& part : truth.parts)
    for (const Change& change : mechanism_changes(part.mechanism, part.place)) changes.push_back(change);
  const Numerics& numerics = truth.soundings[sounding];
  const auto set = [&](std::string_view name, double si) {
    const solver::Quantity* quantity = solver::find_quantity(name);
    changes.push_back({quantity, si / quantity->scale});
  };
  set("numerics.point_shift", numerics.point_shift);
  set("numerics.courant", numerics.courant * study.baseline.numerics.courant);
  set("numerics.near_height_m", numerics.near_height * study.baseline.numerics.near_height);
  return changes;
}

bool possible(const Truth& truth, const Plan& plan, const parameters::Study& study) {
  for (std::size_t s = 0; s < truth.soundings.size(); ++s) {
    solver::Setup setup = study.baseline;
    for (const Change& change : plan.request.soundings[s].changes)
      change.quantity->set_value(setup, change.value);
    for (const Change& change : changes_of(truth, plan.request.soundings[s], study, s))
      change.quantity->set_value(setup, change.value);
    if (!solver::problems(setup).empty()) return false;
  }
  return true;
}

Json array(const VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

VectorXd vector(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

std::string Truth::kind() const {
  if (outside) return catalogued(*outside) != nullptr ? "single" : "outside";
  return parts.empty() ? "nothing" : parts.size() == 1 ? "single" : "pair";
}

std::string case_name(int id) { return fmt::format("case-{:03}", id); }
std::string request_file(int id) { return case_name(id) + ".toml"; }
std::string recording_file(int id, std::size_t sounding) {
  return fmt::format("{}-{}.csv", case_name(id), sounding + 1);
}

std::vector<Truth> draw_truths(const Plan& plan, const parameters::Study& study, std::uint64_t seed) {
  Random random(seed, 0);
  const Counts& counts = plan.cases;
  std::vector<std::string_view> kinds;
  for (const auto& [kind, count] : {std::pair{"nothing", counts.nothing}, std::pair{"single", counts.single},
                                    std::pair{"pair", counts.pair}, std::pair{"outside", counts.outside}})
    kinds.insert(kinds.end(), static_cast<std::size_t>(count), kind);
  shuffle(kinds, random);
  std::vector<bool> two(kinds.size(), false);
  std::fill_n(two.begin(), counts.two_soundings, true);
  shuffle(two, random);

  Rotation mechanisms(plan.request.mechanisms.size()), outsides(outside_kinds().size());
  std::vector<Truth> truths;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    std::vector<std::size_t> chosen;  // of the plan's
    if (kinds[i] == "single" || kinds[i] == "pair") chosen.push_back(mechanisms.next(random));
    while (kinds[i] == "pair" && chosen.size() < 2) {
      const std::size_t second = mechanisms.next(random);
      if (second != chosen.front()) chosen.push_back(second);
    }
    const std::string_view outside = kinds[i] == "outside" ? outside_kinds()[outsides.next(random)] : "";
    for (int tries = 0;; ++tries) {
      if (tries == 100) throw std::invalid_argument("a hundred draws in turn were no possible setup");
      Truth truth{static_cast<int>(i) + 1, {}, std::nullopt, VectorXd(study.rows.size()), {}};
      for (double& place : truth.soil) place = random.uniform();
      for (const std::size_t k : chosen) truth.parts.push_back(draw_part(plan.request.mechanisms[k], random));
      const SoundingRequest& first = plan.request.soundings.front();
      if (!outside.empty()) truth.outside = draw_outside(outside, first.from, first.to, random);
      for (int s = 0; s < (two[i] ? 2 : 1); ++s) truth.soundings.push_back(draw_numerics(random));
      if (!possible(truth, plan, study)) continue;
      truths.push_back(std::move(truth));
      break;
    }
  }
  return truths;
}

parameters::Study truth_study(const Plan& plan, const parameters::Study& study,
                              const std::vector<Truth>& truths, std::size_t sounding) {
  parameters::Study made = study;
  for (const Change& change : plan.request.soundings[sounding].changes)
    change.quantity->set_value(made.baseline, change.value);
  made.name = fmt::format("sounding-{}", sounding + 1);
  made.title = plan.request.title + ", sealed runs";
  made.database = plan.sealed_folder / (made.name + ".sqlite");
  made.curves = plan.sealed_folder / (made.name + ".h5");
  made.report_dir = plan.sealed_folder / (made.name + "-report");
  made.points.clear();
  made.design = {};
  for (const Truth& truth : truths)
    if (sounding < truth.soundings.size())
      made.points.push_back(
          {case_name(truth.id), changes_of(truth, plan.request.soundings[sounding], study, sounding)});
  made.rows.clear();
  return made;
}

namespace {

// Means over a millimetre of one channel, where q_c is finite.
std::vector<double> readings(const solver::DepthProfile& profile, const std::vector<double>& values,
                             std::vector<double>& depth) {
  std::vector<double> sums, count;
  depth.clear();
  for (std::size_t i = 0; i < profile.depth.size(); ++i) {
    if (!std::isfinite(profile.q_c[i])) continue;
    const double place = (std::floor(profile.depth[i] / reading_spacing) + 0.5) * reading_spacing;
    if (depth.empty() || place - depth.back() > 0.5 * reading_spacing) {
      depth.push_back(place);
      sums.push_back(0.0);
      count.push_back(0.0);
    }
    sums.back() += values[i];
    count.back() += 1.0;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= count[i];
  return sums;
}

// AR(1) of unit deviation.
std::vector<double> noise_over(const std::vector<double>& depth, double correlation, Random random) {
  std::vector<double> noise(depth.size(), 0.0);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double kept = i == 0 ? 0.0 : std::exp(-(depth[i] - depth[i - 1]) / correlation);
    noise[i] = (i == 0 ? 0.0 : kept * noise[i - 1]) + std::sqrt(1.0 - kept * kept) * random.normal();
  }
  return noise;
}

}  // namespace

std::string recording_text(const Plan& plan, const Truth& truth, std::size_t sounding,
                           const solver::DepthProfile& profile) {
  constexpr std::uint64_t sleeve_stream = 1000;  // behind those of the soundings' q_c
  std::vector<double> depth;
  const std::vector<double> f_s = readings(profile, profile.f_s, depth);
  std::vector<double> q_c = readings(profile, profile.q_c, depth);
  if (truth.outside) q_c = with_outside(*truth.outside, depth, q_c);

  const std::uint64_t seed = truth.soundings[sounding].noise_seed;
  const double size = plan.request.measurement, length = plan.request.correlation;
  const std::vector<double> of_tip = noise_over(depth, length, Random(seed, sounding));
  const std::vector<double> of_sleeve = noise_over(depth, length, Random(seed, sleeve_stream + sounding));
  const double sleeve_size = size * solver::channel("f_s").deviation_over_q_c;
  std::string text = "depth_m,q_c_MPa,f_s_kPa\n";
  for (std::size_t i = 0; i < depth.size(); ++i)
    text += fmt::format("{:.4f},{:.6g},{:.6g}\n", depth[i], q_c[i] * std::exp(size * of_tip[i]) / 1e6,
                        f_s[i] * std::exp(sleeve_size * of_sleeve[i]) / 1e3);
  return text;
}

std::string request_text(const Plan& plan, const parameters::Study& study, const Truth& truth) {
  const Request& request = plan.request;
  const auto quoted = [](const std::string& text) { return Json(text).dump(); };  // TOML's basic strings
  std::string text = fmt::format("title = {}\nstudy = {}\nmechanisms = [", quoted(case_name(truth.id)),
                                 quoted(study.file.lexically_relative(plan.cases_folder).generic_string()));
  for (const solver::Mechanism& mechanism : request.mechanisms)
    text += fmt::format("\"{}\", ", mechanism.name);
  text += "]\n";
  for (std::size_t s = 0; s < truth.soundings.size(); ++s) {
    const SoundingRequest& sounding = request.soundings[s];
    text += fmt::format(
        "\n[[soundings]]\nname = {}\nrecording = \"{}\"\ncolumns = {{ depth_m = \"depth_m\", q_c_MPa = "
        "\"q_c_MPa\", f_s_kPa = \"f_s_kPa\" }}\nfrom_m = {}\nto_m = {}\n",
        quoted(sounding.name), recording_file(truth.id, s), sounding.from, sounding.to);
    if (sounding.changes.empty()) continue;
    text += "fixed = { ";
    for (std::size_t c = 0; c < sounding.changes.size(); ++c) {
      const Change& change = sounding.changes[c];
      const std::string value = change.quantity->format(change.value);
      text += fmt::format("{}\"{}\" = {}", c > 0 ? ", " : "", change.quantity->name,
                          change.quantity->choices.empty() ? value : quoted(value));
    }
    text += " }\n";
  }
  const std::string cone = request.cone_class > 0 ? fmt::format("cone_class = {}\n", request.cone_class) : "";
  text += fmt::format(
      "\n[noise]\n{}measurement_percent = {}\ncorrelation_mm = {}\nsimulated = true\n\n[options]\ncell_mm = "
      "{}\n"
      "repeats = {}\njoint = {}\nconfirm = {}\n",
      cone, 100.0 * request.measurement, 1e3 * request.correlation, 1e3 * request.cell_height,
      request.repeats, request.joint, request.confirm);
  return text;
}

Json to_json(const Truth& truth) {
  Json json{{"case", truth.id},
            {"soil", array(truth.soil)},
            {"parts", Json::array()},
            {"soundings", Json::array()}};
  for (const Part& part : truth.parts)
    json["parts"].push_back({{"mechanism", part.mechanism.name}, {"place", array(part.place)}});
  if (truth.outside)
    json["outside"] = {{"kind", truth.outside->kind},
                       {"size", truth.outside->size},
                       {"depth_m", truth.outside->depth},
                       {"length_m", truth.outside->length}};
  for (const Numerics& n : truth.soundings)
    json["soundings"].push_back({{"point_shift", n.point_shift},
                                 {"courant", n.courant},
                                 {"near_height", n.near_height},
                                 {"noise_seed", n.noise_seed}});
  return json;
}

Truth truth_from_json(const Json& json, const Plan& plan) {
  try {
    Truth truth{json.at("case").get<int>(), {}, std::nullopt, vector(json.at("soil")), {}};
    for (const Json& part : json.at("parts")) {
      const auto mechanism = std::ranges::find(
          plan.request.mechanisms, part.at("mechanism").get<std::string>(), &solver::Mechanism::name);
      if (mechanism == plan.request.mechanisms.end())
        throw std::invalid_argument("a mechanism that the plan has not");
      truth.parts.push_back({*mechanism, vector(part.at("place"))});
    }
    if (json.contains("outside")) {
      const Json& o = json["outside"];
      truth.outside = OutsideEffect{o.at("kind").get<std::string>(), o.at("size").get<double>(),
                                    o.at("depth_m").get<double>(), o.at("length_m").get<double>()};
    }
    for (const Json& n : json.at("soundings"))
      truth.soundings.push_back({n.at("point_shift").get<double>(), n.at("courant").get<double>(),
                                 n.at("near_height").get<double>(), n.at("noise_seed").get<std::uint64_t>()});
    return truth;
  } catch (const Json::exception& problem) {
    throw std::invalid_argument(std::string("not a concealed case: ") + problem.what());
  }
}

std::string seal_of(const std::string& salt, const Truth& truth) {
  return results::sha256(salt + "\n" + to_json(truth).dump());
}

}  // namespace cpt::validation::concealed
