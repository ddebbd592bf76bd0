// The two folders of a benchmark: what everybody may read, and what only `reveal` opens.
#pragma once

#include <map>

#include "validation/concealed/truth.hpp"

namespace cpt::validation::concealed {

/// Draws the cases with a seed of the machine's entropy, salts them and writes NAME-sealed/truth.json, unless
/// it is there already: then what it holds. Throws std::invalid_argument if that is of another plan.
[[nodiscard]] std::vector<Truth> sealed_truths(const Plan& plan, const parameters::Study& study);

/// Writes NAME-cases/seals.json: the seal of every case whose recordings were made.
void publish_seals(const Plan& plan, const std::vector<int>& made);

/// Cases by number, with their seals, of NAME-cases/seals.json. Throws std::invalid_argument without it.
[[nodiscard]] std::map<int, std::string> published_seals(const Plan& plan);

/// When the cases were drawn, UTC. Throws as published_seals.
[[nodiscard]] std::string drawn_at(const Plan& plan);

/// Puts the answers' hashes, by case, on record before the truth is opened the first time; later tells
/// whether they are still those.
[[nodiscard]] bool are_first_answers(const Plan& plan, const std::map<int, std::string>& hashes);

/// The truths of the published cases. Throws std::invalid_argument if one does not fit its seal.
[[nodiscard]] std::map<int, Truth> opened_truths(const Plan& plan);

/// Writes whole or not at all, with the folder it needs. Throws results::Error if it cannot.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace cpt::validation::concealed
