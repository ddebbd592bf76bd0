#include "campaign/external/program_results.hpp"

#include <gtest/gtest.h>

#include "campaign/messages.hpp"
#include "solver/quantities.hpp"

namespace cpt::campaign {
namespace {

using solver::ProgramOutput, solver::ProgramResult;

const std::vector<ProgramOutput> scalar_and_curve = {{"f", "m"}, {"s", "mm", "", "t", "d"}};

TEST(ProgramResults, AreReadFromJsonAndFromCsv) {
  const std::vector<ProgramResult> expected = {{"f", {}, {0.1}}, {"s", {0.0, 1.0, 2.5}, {3.0, -4e-300, 5.0}}};
  EXPECT_EQ(read_results(R"( {"t": [0, 1, 2.5], "s": [3, -4e-300, 5], "f": 0.1, "other": "words"})",
                         scalar_and_curve),
            expected);
  EXPECT_EQ(read_results("f,t,s\n0.1,0,3\n,1,-4e-300\n,2.5,5\n", scalar_and_curve), expected);
  EXPECT_EQ(read_results("\"s\", \"f\", \"t\"\r\n3, 0.1, 0\r\n-4e-300, 0.1, 1\r\n5, 0.1, 2.5\r\n\r\n",
                         scalar_and_curve),
            expected);
}

std::string problem_with(const std::string& text, bool not_finite = false) {
  try {
    (void)read_results(text, scalar_and_curve);
  } catch (const BadResults& bad) {
    EXPECT_EQ(bad.not_finite, not_finite) << text;
    return bad.what();
  }
  return "none";
}

TEST(ProgramResults, WhatIsWrongIsTold) {
  EXPECT_EQ(problem_with(""), "it wrote no results");
  EXPECT_EQ(problem_with(" \n"), "it wrote no results");
  EXPECT_EQ(problem_with("{\"f\": 1"), problem_with("{\"f\": 1"));
  EXPECT_EQ(problem_with("{\"f\": 1").substr(0, 24), "its results are no JSON:");
  EXPECT_EQ(problem_with("{\"f\": \"1\", \"t\": [1], \"s\": [1]}"),
            "f holds string where a number is expected");
  EXPECT_EQ(problem_with("{\"f\": [1], \"t\": [1], \"s\": [1]}"), "f is an array, and declared as a scalar");
  EXPECT_EQ(problem_with("{\"f\": 1, \"t\": [1], \"s\": 1}"), "s is one number, and declared as a curve");
  EXPECT_EQ(problem_with("{\"f\": 1, \"s\": [1]}"), "its results have no t");
  EXPECT_EQ(problem_with("{\"f\": 1, \"t\": [], \"s\": []}"), "its results have no s");
  EXPECT_EQ(problem_with("{\"f\": 1, \"t\": [1, 1], \"s\": [1, 2]}"), "t does not rise: 1 stands behind 1");
  EXPECT_EQ(problem_with("{\"f\": 1, \"t\": [1, 2], \"s\": [1]}"),
            "s has 1 numbers and its abscissa t has 2");
  EXPECT_EQ(problem_with("{\"f\": null, \"t\": [1], \"s\": [1]}", true), "f is not finite");
  EXPECT_EQ(problem_with("{\"f\": -Infinity}", true), "its results hold NaN or an infinite number");
  EXPECT_EQ(problem_with("f,t,s\nnan,1,2\n", true), "f is not finite");
  EXPECT_EQ(problem_with("f,t,s\n1,one,2\n"), "its results are no CSV: \"one\" in line 2 is no number");
  EXPECT_EQ(problem_with("[1, 2]"), "its results have no f");
}

TEST(ProgramResults, OrdersAndOutcomesCarryThemWhole) {
  solver::ExternalProgram program;
  program.command = {"model", "--input", "a b"};
  program.folder = "/studies";
  program.version = "2.1\n";
  program.template_name = "deck.in";
  program.template_text = "x \"{{x}}\"\n\\n";
  program.inputs = {{"x", "m", "length", 0.1, 0.0, 1.0, false}, {"n", "-", "", 3.0, 1.0, 5.0, true}};
  program.outputs = scalar_and_curve;
  program.limits = {5.0, 1e6, 2, true};
  Order order;
  order.work = "/studies/a.work/0001";
  order.setup.program = std::make_shared<const solver::ExternalProgram>(program);
  order.setup.program_inputs = {1.0 / 3.0, 4.0};
  const auto received = std::get<Order>(decode(encode(order)));
  ASSERT_NE(received.setup.program, nullptr);
  EXPECT_EQ(received.work, order.work);
  EXPECT_EQ(received.setup.program_inputs, order.setup.program_inputs);
  EXPECT_EQ(received.setup.program->command, program.command);
  EXPECT_EQ(received.setup.program->template_text, program.template_text);
  EXPECT_EQ(received.setup.program->inputs, program.inputs);
  EXPECT_EQ(received.setup.program->outputs, program.outputs);
  EXPECT_EQ(received.setup.program->limits.retries, 2);
  EXPECT_EQ(solver::canonical_text(received.setup), solver::canonical_text(order.setup));

  OutcomeReport report{1, {}};
  report.outcome.status = solver::Status::completed;
  report.outcome.profile.declared = {{"f", {}, {0.1}}, {"s", {1.0, 2.0}, {-0.0, 5e-324}}};
  EXPECT_EQ(std::get<OutcomeReport>(decode(encode(report))).outcome.profile.declared,
            report.outcome.profile.declared);
  report.outcome.profile.declared[1].y.pop_back();
  EXPECT_THROW((void)decode(encode(report)), MalformedMessage);
}

// Where nothing of it is asked for, it leaves no line of the settings.
TEST(ProgramResults, SettingsNameTheProgramAlone) {
  solver::Setup setup;
  EXPECT_EQ(solver::canonical_text(setup).find("solver."), std::string::npos);
  solver::ExternalProgram program;
  program.command = {"sh", "a b"};
  program.folder = "/somewhere";
  program.version = "1";
  program.inputs = {{"x"}};
  program.outputs = scalar_and_curve;
  setup.program = std::make_shared<const solver::ExternalProgram>(program);
  setup.program_inputs = {0.1};
  EXPECT_EQ(solver::canonical_text(setup),
            "solver.command = \"sh\" \"a b\"\nsolver.version = \"1\"\nx = 0.1\nsolver.outputs = f \"m\"\n"
            "solver.outputs = s \"mm\" over t \"d\"\n");
}

}  // namespace
}  // namespace cpt::campaign
