// Several effects at once for a request: which channels are heard, with what noise, and what is said of it.
#pragma once

#include "diagnosis/assemble.hpp"
#include "diagnosis/several/findings.hpp"

namespace cpt::cli {

/// The problem that the findings are about, and they.
struct SeveralEffects {
  diagnosis::Assembled assembled;
  diagnosis::Findings findings;
};

/// q_c and, where every sounding has it recorded, f_s. f_s has the noise of q_c times what the list of
/// channels says, and the level of recordings that are no simulations is free by 35 %, which is what mass
/// scaling moves it by (docs/numerical-uncertainty.md). Throws as assemble.
[[nodiscard]] SeveralEffects several_effects(const diagnosis::Request& request,
                                             const std::vector<diagnosis::SoundingData>& soundings);

/// For the console.
[[nodiscard]] std::string several_text(const SeveralEffects& effects);

}  // namespace cpt::cli
