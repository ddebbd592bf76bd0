#include "validation/concealed/plan.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diagnosis/request_keys.hpp"
#include "parameters/fields.hpp"

namespace cpt::validation::concealed {
namespace {

using diagnosis::parse_request, diagnosis::Recordings, diagnosis::Request, diagnosis::request_keys,
    diagnosis::RequestOrErrors;

using namespace parameters;

void read_count(const Value& table, std::string_view name, ErrorList& errors, int& into) {
  const auto number = number_field(table, "cases", name, false, errors);
  if (!number) return;
  const Key& key = key_named(request_keys(), "cases", name);
  if (*number == std::round(*number) && *number >= key.least && *number <= key.most)
    into = static_cast<int>(*number);
  else
    errors.add(table.find(name)->value.place, joined("cases", name),
               fmt::format("{} must be a whole number from {} to {}", *number, key.least, key.most));
}

void read_cases(const Value& root, Plan& plan, ErrorList& errors) {
  const Value* table = section(root, "cases", errors);
  if (table == nullptr)
    return errors.add({}, "cases", "is missing: how many cases of which kind",
                      "add [cases] with nothing, single, pair, outside and two_soundings");
  refuse_unknown_keys(*table, "cases", known_names(request_keys(), "cases"), errors);
  Counts& cases = plan.cases;
  read_count(*table, "nothing", errors, cases.nothing);
  read_count(*table, "single", errors, cases.single);
  read_count(*table, "pair", errors, cases.pair);
  read_count(*table, "outside", errors, cases.outside);
  read_count(*table, "two_soundings", errors, cases.two_soundings);
  const auto refuse = [&](std::string_view key, std::string message) {
    const Member* member = table->find(key);
    errors.add(member != nullptr ? member->place : Place{}, joined("cases", key), std::move(message));
  };
  if (errors.empty() && cases.total() == 0) refuse("single", "no case is asked for");
  if (cases.two_soundings > cases.total())
    refuse("two_soundings", fmt::format("{} is more than the {} cases", cases.two_soundings, cases.total()));
  if (cases.two_soundings > 0 && plan.request.soundings.size() < 2)
    refuse("two_soundings", "needs a second [[soundings]]");
  if (cases.pair > 0 && plan.request.mechanisms.size() < 2) refuse("pair", "needs two mechanisms or more");
}

}  // namespace

PlanOrErrors parse_plan(std::string_view toml, const std::filesystem::path& file, const Study& study) {
  RequestOrErrors request = parse_request(toml, file, study, Recordings::to_be_made);
  if (auto* wrong = std::get_if<std::vector<StudyError>>(&request)) return std::move(*wrong);
  Plan plan;
  plan.request = std::get<Request>(std::move(request));
  plan.request.simulated = true;
  ErrorList errors(file.string());
  const auto document = parse_document(toml);
  const Value& root = std::get<Value>(document);
  read_cases(root, plan, errors);
  if (!(plan.request.measurement > 0.0))
    errors.add({}, "noise.measurement_percent", "is missing: the noise that the recordings get");
  if (plan.request.soundings.size() > 2)
    errors.add({}, "soundings", fmt::format("{} are too many: one or two", plan.request.soundings.size()));
  if (!errors.empty()) return errors.sorted();
  const std::filesystem::path folder = plan.request.file.parent_path();
  plan.cases_folder = folder / (plan.request.name + "-cases");
  plan.sealed_folder = folder / (plan.request.name + "-sealed");
  return plan;
}

}  // namespace cpt::validation::concealed
