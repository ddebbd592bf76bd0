#include "validation/concealed/sealed_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>

#include "parameters/all_realizations.hpp"
#include "results/files/atomic_file.hpp"
#include "results/files/file_bytes.hpp"
#include "results/ledger/provenance.hpp"

namespace cpt::validation::concealed {
namespace {

using Json = nlohmann::json;

Json read_json(const std::filesystem::path& file) {
  std::error_code why;
  const std::optional<std::string> text = results::bytes_of(file, why);
  if (!text)
    throw std::invalid_argument(
        fmt::format("cannot read {} ({})", file.string(), results::cause_of(file, why)));
  Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw std::invalid_argument(fmt::format("{} is not what `campaign conceal` wrote", file.string()));
  return json;
}

// 256 bits that nobody chose.
std::string entropy() {
  std::random_device device;
  std::string text;
  for (int i = 0; i < 8; ++i) text += fmt::format("{:08x}", device());
  return text;
}

// All that the draw depends on: a plan that was edited after the draw must not be mixed with it.
std::string plan_hash(const Plan& plan, const parameters::Study& study) {
  std::string text = request_text(plan, study, Truth{0, {}, {}, {}, {Numerics{}}});
  for (const diagnosis::SoundingRequest& sounding : plan.request.soundings) {
    text += sounding.name;
    for (const parameters::Change& c : sounding.changes) text += c.quantity->format(c.value);
  }
  const Counts& c = plan.cases;
  text += fmt::format("{} {} {} {} {}", c.nothing, c.single, c.pair, c.outside, c.two_soundings);
  for (const parameters::Realization& realization : parameters::all_realizations(study))
    text += parameters::settings_text(study, realization);
  return results::sha256(text);
}

std::filesystem::path truth_file(const Plan& plan) { return plan.sealed_folder / "truth.json"; }
std::filesystem::path seals_file(const Plan& plan) { return plan.cases_folder / "seals.json"; }

std::string salt_of(const Json& sealed, int id) {
  return results::sha256(sealed.at("salt").get<std::string>() + case_name(id));
}

}  // namespace

void write_whole(const std::filesystem::path& file, const std::string& text) {
  results::make_folder(file.parent_path());
  results::write_atomically(file, text, "");
}

std::vector<Truth> sealed_truths(const Plan& plan, const parameters::Study& study) {
  const std::string hash = plan_hash(plan, study);
  if (std::filesystem::exists(truth_file(plan))) {
    const Json sealed = read_json(truth_file(plan));
    if (sealed.value("plan", "") != hash)
      throw std::invalid_argument(fmt::format(
          "{} was drawn for another plan or study; conceal under another name, or remove {} and {}",
          truth_file(plan).string(), plan.sealed_folder.string(), plan.cases_folder.string()));
    std::vector<Truth> truths;
    for (const Json& one : sealed.at("cases")) truths.push_back(truth_from_json(one, plan));
    return truths;
  }
  const std::string drawn = entropy();
  std::vector<Truth> truths = draw_truths(plan, study, std::stoull(drawn.substr(0, 16), nullptr, 16));
  Json sealed{{"plan", hash}, {"salt", entropy()}, {"drawn", results::utc_now()}, {"cases", Json::array()}};
  for (const Truth& truth : truths) sealed["cases"].push_back(to_json(truth));
  write_whole(truth_file(plan), sealed.dump(1));
  return truths;
}

void publish_seals(const Plan& plan, const std::vector<int>& made) {
  const Json sealed = read_json(truth_file(plan));
  Json cases = Json::object();
  for (const Json& one : sealed.at("cases")) {
    const Truth truth = truth_from_json(one, plan);
    if (std::ranges::find(made, truth.id) != made.end())
      cases[case_name(truth.id)] = seal_of(salt_of(sealed, truth.id), truth);
  }
  write_whole(seals_file(plan), Json{{"title", plan.request.title},
                                     {"seal", "sha256(salt, line end, truth as JSON)"},
                                     {"drawn", sealed.at("drawn")},
                                     {"solver_version", solver::solver_version()},
                                     {"program_version", results::program_version()},
                                     {"cases", cases}}
                                        .dump(1) +
                                    "\n");
}

std::map<int, std::string> published_seals(const Plan& plan) {
  const Json published = read_json(seals_file(plan));
  std::map<int, std::string> seals;
  for (const auto& [name, seal] : published.at("cases").items())
    seals[std::stoi(name.substr(name.rfind('-') + 1))] = seal.get<std::string>();
  return seals;
}

std::string drawn_at(const Plan& plan) { return read_json(seals_file(plan)).at("drawn").get<std::string>(); }

bool are_first_answers(const Plan& plan, const std::map<int, std::string>& hashes) {
  const std::filesystem::path file = plan.cases_folder / "answers.json";
  Json answers = Json::object();
  for (const auto& [id, hash] : hashes) answers[case_name(id)] = hash;
  if (std::filesystem::exists(file)) return read_json(file).value("answers", Json()) == answers;
  write_whole(file, Json{{"revealed", results::utc_now()}, {"answers", answers}}.dump(1) + "\n");
  return true;
}

std::map<int, Truth> opened_truths(const Plan& plan) {
  const Json sealed = read_json(truth_file(plan));
  const std::map<int, std::string> seals = published_seals(plan);
  std::map<int, Truth> truths;
  for (const Json& one : sealed.at("cases")) {
    Truth truth = truth_from_json(one, plan);
    const auto seal = seals.find(truth.id);
    if (seal == seals.end()) continue;
    if (seal->second != seal_of(salt_of(sealed, truth.id), truth))
      throw std::invalid_argument(
          fmt::format("{} does not fit its seal: truth or seal was changed", case_name(truth.id)));
    truths.emplace(truth.id, std::move(truth));
  }
  if (truths.size() != seals.size())
    throw std::invalid_argument("there are seals of cases that are not among the truths");
  return truths;
}

}  // namespace cpt::validation::concealed
