#include "results/ledger/views.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "parameters/designs/variation.hpp"
#include "results/ledger/audit_bounds.hpp"
#include "results/statistics/repeat_noise.hpp"

namespace cpt::results {
namespace {

// Replaces the names of bounds in capitals: a definition is stored as it is sent, so it holds no parameters.
std::string with_bounds(std::string sql) {
  const std::pair<std::string_view, double> bounds[] = {{"ROUNDING", parameters::rounding_share},
                                                        {"MOST_ENERGY", most_energy_error},
                                                        {"MOST_MOMENTUM", most_momentum_error},
                                                        {"MOST_KINETIC", most_kinetic_fraction},
                                                        {"MOST_EMPTY", most_empty_share},
                                                        {"MOST_LIMITED", most_limited_share},
                                                        {"MOST_SAFEGUARDED", most_safeguarded_share}};
  const auto replace = [&](std::string_view name, const std::string& text) {
    for (auto at = sql.find(name); at != sql.npos; at = sql.find(name)) sql.replace(at, name.size(), text);
  };
  for (const auto& [name, value] : bounds) replace(name, fmt::format("{}", value));
  std::string students;
  for (int freedom = 2; freedom <= 20; ++freedom)
    students += fmt::format("{}({}, {})", freedom > 2 ? ", " : "", freedom, student_t(freedom));
  replace("STUDENTS_T", students);
  replace("DOES_NOT_VARY", fmt::format("'{}'", parameters::does_not_vary));
  return sql;
}

// Before solver 0.6 the momentum error of a repeat was that of its shift.
constexpr const char* audit_view = R"sql(
CREATE VIEW audit AS
SELECT id AS realization, parameter, side, status, mass_error, momentum_error, energy_error, kinetic_fraction,
       max_empty_cells, limited_share, safeguarded_share,
       CASE WHEN status = 'completed' THEN rtrim(
         CASE WHEN abs(energy_error) > MOST_ENERGY
              THEN printf('energy error %.0f %%, ', 100 * energy_error) ELSE '' END ||
         CASE WHEN momentum_error > MOST_MOMENTUM AND side <> 'repeat'
              THEN printf('momentum error %.0f %%, ', 100 * momentum_error) ELSE '' END ||
         CASE WHEN kinetic_fraction > MOST_KINETIC
              THEN printf('kinetic energy %.0f %%, ', 100 * kinetic_fraction) ELSE '' END ||
         CASE WHEN max_empty_cells > MOST_EMPTY * material_points
              THEN printf('%d empty cells, ', max_empty_cells) ELSE '' END ||
         CASE WHEN limited_share > MOST_LIMITED
              THEN printf('%.2f %% of the motion of mixed cells limited, ', 100 * limited_share) ELSE '' END ||
         CASE WHEN safeguarded_share > MOST_SAFEGUARDED
              THEN printf('%.2f %% of the points at a safeguard of their law, ', 100 * safeguarded_share) ELSE '' END, ', ')
       END AS out_of_line
FROM realization;
)sql";

// SI and SI_noise as in sensitivity.hpp. A bound without a realization of its own equals the baseline.
constexpr const char* sensitivity_view = R"sql(
CREATE VIEW sensitivity AS
WITH
baseline AS (
  SELECT id, status FROM realization WHERE side = 'baseline'
),
bound AS (
  SELECT w.name AS window, w.position AS window_position, w.problem AS window_problem,
         w.output AS output, coalesce(w.output, 'q_c') AS quantity, p.name AS parameter, p.position AS parameter_position, baseline.id AS baseline_id,
         coalesce((SELECT id FROM realization WHERE parameter = p.name AND side = 'lower'), baseline.id) AS lower_id,
         coalesce((SELECT id FROM realization WHERE parameter = p.name AND side = 'upper'), baseline.id) AS upper_id
  FROM depth_window AS w CROSS JOIN parameter AS p CROSS JOIN baseline
  WHERE p.lower <> p.upper  -- the seed of a random field has no bounds
),
state AS (
  SELECT id, CASE WHEN status IN ('pending', 'running', 'not_needed') THEN status
                  WHEN status = 'completed' THEN CASE WHEN EXISTS (SELECT 1 FROM program_output) THEN 'has no value in the window'
                                                   ELSE 'has no q_c in the window' END
                  ELSE 'failed (' || status || ')' END AS words
  FROM realization
),
spread AS (
  SELECT window, max(q_c_mean_kPa) - min(q_c_mean_kPa) > ROUNDING * max(abs(q_c_mean_kPa)) AS varies
  FROM window_mean JOIN realization ON id = realization
  WHERE side IN ('baseline', 'lower', 'upper')
  GROUP BY window
),
-- The runs of a row's two bounds that have their material points in one place: its own, and those of each repeat.
twins AS (
  SELECT DISTINCT parameter, lower_id, upper_id FROM bound
  UNION ALL
  SELECT p.name,
         coalesce((SELECT id FROM realization WHERE side = 'point'
                   AND parameter = r.parameter || ', ' || p.name || ' lower'), CASE WHEN p.lower = p.baseline THEN r.id END),
         coalesce((SELECT id FROM realization WHERE side = 'point'
                   AND parameter = r.parameter || ', ' || p.name || ' upper'), CASE WHEN p.upper = p.baseline THEN r.id END)
  FROM parameter AS p CROSS JOIN realization AS r WHERE r.side = 'repeat'
),
twin_index AS (
  SELECT twins.parameter AS parameter, u.window AS window, 1.0 - l.q_c_mean_kPa / u.q_c_mean_kPa AS si
  FROM twins
  JOIN window_mean AS u ON u.realization = upper_id
  JOIN window_mean AS l ON l.realization = lower_id AND l.window = u.window
  WHERE u.q_c_mean_kPa > 0
),
student (freedom, t) AS (VALUES STUDENTS_T),
paired AS (
  SELECT parameter, window, pairs, t * sqrt(squares / freedom) AS half_width
  FROM (SELECT parameter, window, count(*) AS pairs, count(*) - 1 AS freedom,
               sum((si - mean) * (si - mean)) AS squares
        FROM twin_index
        JOIN (SELECT parameter, window, avg(si) AS mean FROM twin_index GROUP BY parameter, window)
             USING (parameter, window)
        GROUP BY parameter, window)
  JOIN student USING (freedom)
),
value AS (
  SELECT bound.*, varies,
         l.q_c_mean_kPa AS q_lower, u.q_c_mean_kPa AS q_upper, b.q_c_mean_kPa AS q_baseline,
         b.q_c_max_kPa AS q_baseline_max,
         CASE WHEN varies AND u.q_c_mean_kPa > 0
              THEN CASE WHEN abs(u.q_c_mean_kPa - l.q_c_mean_kPa)
                             <= ROUNDING * max(abs(u.q_c_mean_kPa), abs(l.q_c_mean_kPa)) THEN 0.0
                        ELSE (u.q_c_mean_kPa - l.q_c_mean_kPa) / u.q_c_mean_kPa END END AS si,
         CASE WHEN bound.output IS NULL AND b.q_c_max_kPa > 0 THEN (b.q_c_max_kPa - b.q_c_min_kPa) / b.q_c_max_kPa END AS si_noise,
         n.si_half_width AS half_width_of_equals,
         coalesce(paired.half_width, n.si_half_width * abs(l.q_c_mean_kPa / u.q_c_mean_kPa)) AS si_half_width,
         pairs,
         CASE WHEN l.realization IS NULL AND lower_id <> baseline_id
              THEN 'lower run ' || (SELECT words FROM state WHERE id = lower_id) || ', ' ELSE '' END AS no_lower,
         CASE WHEN u.realization IS NULL AND upper_id <> baseline_id
              THEN 'upper run ' || (SELECT words FROM state WHERE id = upper_id) || ', ' ELSE '' END AS no_upper,
         CASE WHEN b.realization IS NULL
              THEN 'baseline run ' || (SELECT words FROM state WHERE id = baseline_id) ELSE '' END AS no_baseline
  FROM bound
  LEFT JOIN spread USING (window)
  LEFT JOIN repeat_noise AS n USING (window)
  LEFT JOIN paired USING (parameter, window)
  LEFT JOIN window_mean AS l ON l.realization = lower_id AND l.window = bound.window
  LEFT JOIN window_mean AS u ON u.realization = upper_id AND u.window = bound.window
  LEFT JOIN window_mean AS b ON b.realization = baseline_id AND b.window = bound.window
)
SELECT window, parameter, q_lower AS q_lower_kPa, q_upper AS q_upper_kPa, q_baseline AS q_baseline_kPa,
       si, abs(si) AS si_abs, si_noise,
       CASE WHEN si_half_width IS NULL THEN abs(si) > si_noise ELSE abs(si) > si_half_width END AS above_noise,
       CASE WHEN si IS NOT NULL THEN si_half_width END AS si_half_width, abs(si) > si_half_width AS above_repeats,
       abs(si) > si_noise AS above_si_noise, CASE WHEN si IS NOT NULL THEN pairs END AS pairs,
       CASE
         WHEN window_problem <> '' THEN 'undefined: ' || window_problem
         WHEN NOT varies AND q_lower IS NOT NULL AND q_upper IS NOT NULL THEN DOES_NOT_VARY
         WHEN si IS NULL AND q_lower IS NOT NULL AND q_upper IS NOT NULL
           THEN 'undefined: ' || quantity || ' at the upper bound is not positive'
         WHEN si IS NULL THEN 'undefined: ' || rtrim(no_lower || no_upper || no_baseline, ', ')
         ELSE rtrim(
           CASE WHEN si < 0 THEN 'negative: ' || quantity || ' is larger at the lower bound; ' ELSE '' END ||
           CASE WHEN (q_lower - q_baseline) * (q_upper - q_baseline) > 0
                     AND min(abs(q_lower - q_baseline), abs(q_upper - q_baseline))
                         > coalesce(half_width_of_equals, si_noise, CASE WHEN output IS NOT NULL THEN ROUNDING END) * abs(q_baseline)
                THEN CASE WHEN q_lower > q_baseline THEN 'one-sided: both bounds raise ' || quantity || '; '
                          ELSE 'one-sided: both bounds lower ' || quantity || '; ' END ELSE '' END ||
           CASE WHEN output IS NULL AND si_noise IS NULL AND half_width_of_equals IS NULL THEN 'noise undefined: ' ||
                CASE WHEN no_baseline <> '' THEN no_baseline
                     WHEN q_baseline_max IS NULL THEN 'only the average of the baseline was imported'
                     ELSE 'q_c of the baseline is not positive' END || '; '
                ELSE '' END ||
           coalesce((SELECT group_concat(CASE realization WHEN baseline_id THEN 'baseline' WHEN lower_id THEN 'lower'
                                                          ELSE 'upper' END
                                         || ' run out of line: ' || out_of_line, '; ')
                     FROM audit WHERE realization IN (lower_id, upper_id) AND out_of_line <> ''), ''), '; ')
       END AS note
FROM value
ORDER BY window_position, parameter_position;
)sql";

constexpr const char* tornado_view = R"sql(
CREATE VIEW tornado AS
SELECT s.window AS window,
       row_number() OVER (PARTITION BY s.window
                          ORDER BY s.swing DESC NULLS LAST, p.position) AS rank,
       s.parameter AS parameter, p.symbol AS symbol, p.unit AS unit,
       p.lower_text AS lower, p.baseline_text AS baseline, p.upper_text AS upper,
       s.q_lower_kPa AS q_lower_kPa, s.q_upper_kPa AS q_upper_kPa, s.q_baseline_kPa AS q_baseline_kPa,
       s.swing AS swing_kPa, s.si AS si, s.above_noise AS above_noise, s.note AS note
FROM (SELECT *, CASE WHEN abs(q_upper_kPa - q_lower_kPa) <= ROUNDING * max(abs(q_upper_kPa), abs(q_lower_kPa))
                     THEN 0.0 ELSE abs(q_upper_kPa - q_lower_kPa) END AS swing FROM sensitivity) AS s
JOIN parameter AS p ON p.name = s.parameter
JOIN depth_window AS w ON w.name = s.window
ORDER BY w.position, rank;
)sql";

}  // namespace

std::span<const View> views() {
  static const std::vector<View> all = {{"audit", with_bounds(audit_view)},
                                        {"sensitivity", with_bounds(sensitivity_view)},
                                        {"tornado", with_bounds(tornado_view)}};
  return all;
}

}  // namespace cpt::results
