// campaign view PUSH
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "campaign/progress_display.hpp"
#include "cli/command.hpp"
#include "cli/common/number_list.hpp"
#include "cli/common/study_argument.hpp"
#include "cli/exit_codes.hpp"
#include "parameters/nearest_name.hpp"
#include "reports/view/write_view.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

using reports::view::ScaleKind;
using reports::view::ViewQuantity;
using reports::view::ViewRequest;

struct ViewArguments {
  std::filesystem::path push, folder;
  std::vector<std::string> show, ranges;
  std::string around = "5";  // cone diameters, or metres with an m
  bool whole = false;
  std::optional<double> grid_mm;
  ViewRequest request;
};

const ViewQuantity& find_quantity(std::string_view option, const std::string& name) {
  if (const ViewQuantity* found = reports::view::find_view_quantity(name)) return *found;
  std::vector<std::string_view> names;
  for (const ViewQuantity& quantity : reports::view::view_quantities()) names.push_back(quantity.name);
  const std::string_view near = parameters::nearest_name(name, names);
  throw BadInput(fmt::format("{} {}: no such quantity{}; there are {}", option, name,
                             near.empty() ? "" : fmt::format(", did you mean {}?", near),
                             fmt::join(names, ", ")));
}

std::vector<std::string> quantities_shown(const ViewArguments& arguments) {
  std::vector<std::string> names;
  for (const std::string& words : arguments.show)
    for (std::size_t begin = 0; begin <= words.size();) {
      const std::size_t end = std::min(words.find(',', begin), words.size());
      names.emplace_back(find_quantity("--show", words.substr(begin, end - begin)).name);
      begin = end + 1;
    }
  if (names.empty()) return arguments.request.show;
  if (names.size() > 4)
    throw BadInput(fmt::format("--show: {} quantities; 1 to 4 fit beside each other", names.size()));
  return names;
}

// LOW,HIGH of "p=10,5000".
std::pair<std::string, drawing::Range> parse_range(const std::string& text,
                                                   const std::vector<std::string>& show) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw BadInput(fmt::format("--range {}: must be QUANTITY=LOW,HIGH, e.g. p=10,5000", text));
  const ViewQuantity& quantity = find_quantity("--range", text.substr(0, equals));
  if (std::ranges::find(show, quantity.name) == show.end())
    throw BadInput(fmt::format("--range {}: {} is not shown; add it to --show", text, quantity.name));
  const auto [low, high] = parse_pair("--range", "QUANTITY=LOW,HIGH", text.substr(equals + 1));
  if (!(low < high))
    throw BadInput(fmt::format("--range {}: the first number must be the smaller one", text));
  if (quantity.kind == ScaleKind::log && !(low > 0.0))
    throw BadInput(fmt::format("--range {}: the scale is logarithmic, so both must be above 0", text));
  if (quantity.kind == ScaleKind::diverging && low != -high)
    throw BadInput(
        fmt::format("--range {}: zero is the middle of this scale; give as much below it as above, "
                    "e.g. {}=-{},{}",
                    text, quantity.name, std::abs(high), std::abs(high)));
  return {std::string(quantity.name), {low, high}};
}

// Metres of "5" (cone diameters) or "0.1m".
double parse_radius(std::string text, double diameter, double chamber_radius) {
  const std::string whole = text;
  const bool metres = text.ends_with('m');
  if (metres) text.pop_back();
  const double unit = metres ? 1.0 : diameter;
  const std::vector<double> numbers = parse_numbers("--around", text);
  if (const double radius = numbers.front() * unit;
      numbers.size() == 1 && radius >= diameter && radius <= chamber_radius)
    return radius;
  throw BadInput(fmt::format(
      "--around {}: must be 1 to {:.4g} cone diameters, or {:.4g}m to {:.4g}m, the wall (--whole shows all)",
      whole, chamber_radius / diameter, diameter, chamber_radius));
}

void check(bool good, std::string_view option, double value, std::string_view range) {
  if (!good) throw BadInput(fmt::format("{} {}: must be {}", option, value, range));
}

ViewRequest plan(const ViewArguments& arguments, const results::StoredPush& push) {
  ViewRequest request = arguments.request;
  request.show = quantities_shown(arguments);
  for (const std::string& text : arguments.ranges) request.ranges.insert(parse_range(text, request.show));
  const double diameter = push.number("penetrometer.diameter_m");
  if (!arguments.whole)
    request.radius = parse_radius(arguments.around, diameter, push.number("chamber.radius_m"));
  request.grid = arguments.grid_mm ? *arguments.grid_mm * 1e-3 : (arguments.whole ? 2.0 : 0.5) * diameter;
  check(request.grid >= 0.0 && request.grid <= 1.0, "--grid", request.grid * 1e3, "0 (no grid) to 1000 mm");
  check(request.frames >= 0, "--frames", request.frames, "1 or more");
  check(request.width >= 400 && request.width <= 4000, "--width", request.width, "400 to 4000 pixels");
  check(request.seconds_per_frame >= 0.02 && request.seconds_per_frame <= 60.0, "--seconds",
        request.seconds_per_frame, "0.02 to 60");
  return request;
}

int view(const ViewArguments& arguments) {
  const results::StoredPush push = results::read_stored_push(arguments.push);
  const ViewRequest request = plan(arguments, push);
  const auto folder = arguments.folder.empty() ? push.folder / (push.name + "-view") : arguments.folder;

  campaign::ProgressDisplay display(stderr, campaign::ProgressDisplay::style_of(stderr));
  const auto begin = std::chrono::steady_clock::now();
  const auto written = write_view(push, request, folder, [&](std::size_t frames, std::size_t of) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    display.update(fmt::format("frame {} of {}", frames, of), seconds.count());
  });
  display.finish();

  fmt::print("{} frame(s), the last: {}\n", written.frames.size(), written.frames.back().string());
  if (!written.animation.empty())
    fmt::print("animation, {:.1f} MB: {}\n",
               static_cast<double>(std::filesystem::file_size(written.animation)) * 1e-6,
               written.animation.string());
  for (const auto& [quantity, scale] : written.panels)
    fmt::print("  {}: {:g} to {:g}{}{}{}\n", quantity->name, scale.low, scale.high,
               quantity->unit.empty() ? "" : " ", quantity->unit,
               scale.kind == ScaleKind::log ? ", logarithmic" : "");
  return all_well;
}

// One line a quantity, for the help.
std::string list_of_quantities() {
  std::string text;
  for (const ViewQuantity& quantity : reports::view::view_quantities())
    text += fmt::format("  {:<18} {}{}\n", quantity.name, quantity.meaning,
                        quantity.unit.empty() ? "" : fmt::format(" ({})", quantity.unit));
  return text;
}

}  // namespace

void add_view(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<ViewArguments>();
  ViewRequest& request = arguments->request;
  CLI::App* command =
      program.add_subcommand("view", "Draw the stored fields of a push: frames and an animation");
  command
      ->add_option("PUSH", arguments->push,
                   "Folder of campaign push, or its NAME-fields/NAME.pvd; nothing is run again")
      ->type_name("")
      ->required();
  command
      ->add_option("--show", arguments->show,
                   "What to draw, 1 to 4 quantities [void_ratio_change,p,displacement]")
      ->type_name("QUANTITY,...");
  CLI::Option* around =
      command
          ->add_option("--around", arguments->around,
                       "Radius of the soil shown about the tip, in cone diameters or, as 0.1m, in metres [5]")
          ->type_name("RADIUS");
  command->add_flag("--whole", arguments->whole, "Show the whole chamber")->excludes(around);
  command
      ->add_option("--range", arguments->ranges,
                   "Ends of a colour scale in place of the fitted ones, in the quantity's unit")
      ->type_name("QUANTITY=LOW,HIGH");
  command
      ->add_option("--grid", arguments->grid_mm,
                   "Side of the squares whose deformed lines are drawn on the displacement; 0: none [half a "
                   "cone diameter; with --whole two]")
      ->type_name("MM");
  command->add_option("--frames", request.frames, "At most so many, evenly over the stored depths [all]")
      ->type_name("N")
      ->check(CLI::Range(1, 100000).description(""));
  command->add_option("--width", request.width, "Of a frame, 400 to 4000 [1000]")->type_name("PIXELS");
  command->add_option("--seconds", request.seconds_per_frame, "That a frame of the animation stays [0.15]")
      ->type_name("S");
  command->add_option("--out", arguments->folder, "Folder for all files [NAME-view in that of the push]")
      ->type_name("FOLDER");
  command->footer(fmt::format(R"(Writes to FOLDER
  NAME-DEPTHm.png   one frame for each stored depth of the tip
  NAME-view.gif     all of them, one after the other

QUANTITY is one of
{}
Each frame is half a section through the chamber. Colour scales are the same in all frames: fitted so that 1 % of the
area shown lies below them and 0.5 % above (stresses: logarithmic, 0.1 % above), then rounded outward. Change of void
ratio: blue contracts, red dilates. In clay, which is undrained, stresses are total (docs/output.md).

Examples:
  campaign push sens.toml --fields-every 0.01 && campaign view sens-push
  campaign view sens-push --whole --show void_ratio,p --width 1600
  campaign view sens-push --around 0.08m --range p=10,5000 displacement=0,10 --frames 20)",
                              list_of_quantities()));
  command->callback([arguments, &action] { action = [arguments] { return view(*arguments); }; });
}

}  // namespace cpt::cli
