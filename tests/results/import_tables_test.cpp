// What was exported becomes an equal database again, and says that it was imported.
#include <algorithm>
#include <functional>
#include <random>

#include "parameters/field_table.hpp"
#include "recordings/delimited.hpp"
#include "results/files/database.hpp"
#include "results/ledger/salvage.hpp"
#include "results/ledger/schema.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/import_results.hpp"
#include "results/tables/json_document.hpp"
#include "results/tables/query.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

using parameters::FieldTable;
using Errors = std::vector<parameters::StudyError>;
using Texts = std::map<std::string, std::string>;  // CSV by the name of the table

const std::vector<ImportedFile> sources = {{"sand-export/realization.csv", std::string(64, 'a')}};

Texts as_csv(const std::filesystem::path& database) {
  Texts texts;
  for (const auto& [name, table] : campaign_tables(database)) texts[name] = format(table, Format::csv);
  return texts;
}

/// As the command reads a folder; nothing where a text is no table.
std::optional<std::vector<FieldTable>> read_csv(const Texts& texts) {
  std::vector<FieldTable> tables;
  for (const auto& [name, text] : texts) {
    recordings::Problems problems(name + ".csv");
    const recordings::DelimitedTable read = recordings::read_delimited(text, problems);
    if (problems.any()) return std::nullopt;
    FieldTable& table = tables.emplace_back(FieldTable{name + ".csv", name, {}, {}});
    for (const auto& field : read.names) table.names.push_back({field.text, {field.line, field.column}});
    for (const auto& row : read.rows) {
      auto& fields = table.rows.emplace_back();
      for (const auto& field : row) fields.push_back({field.text, {field.line, field.column}});
    }
  }
  return tables;
}

/// Every bit that is stored, but what tells of the import.
std::string all_of(const std::filesystem::path& database) {
  std::string all;
  for (const LedgerTable& table : ledger_tables())
    if (table.name != "import" && table.name != "curve")
      all += format(query_sql(database, "SELECT * FROM " + table.name + " ORDER BY " + table.order),
                    Format::json);
  return all + format(query_sql(database,
                                "SELECT realization, bins, hex(depth_m), hex(q_c_Pa), hex(f_s_Pa) "
                                "FROM curve ORDER BY realization"),
                      Format::json);
}

class ImportTables : public ScratchFolder {
 protected:
  ImportTables() {
    study.title = " A title, with \"quotes\" ";
    study.points = {
        {"both", {{solver::find_quantity("sand.H"), 75}, {solver::find_quantity("sand.nu"), 0.25}}},
        {"repeat 1", {{solver::find_quantity("numerics.point_shift"), 0.25}}, true},
        {"repeat 2", {{solver::find_quantity("numerics.point_shift"), -0.25}}, true}};
    Ledger ledger =
        Ledger::open_for_run(study, parameters::all_realizations(study), {"title = 1\r\n\n# ü\n", false});
    for (const int id : ledger.pending()) {
      solver::Outcome outcome = completed(1e6 / 3 + id);
      if (id == 4) {
        outcome = failed(solver::Status::did_not_converge, "step 7,\nno \"balance\"");
        outcome.profile = curve(7.7e5);  // as far as it came
        outcome.profile.q_c[5] = std::numeric_limits<double>::quiet_NaN();
      }
      if (id == 6) outcome = failed(solver::Status::crashed, "signal 11");
      if (id == 7) outcome.profile.f_s[9] = -1e-320;
      if (id != 5) ledger.record(id, outcome);
    }
  }

  Remarks import(const Texts& texts) {
    const auto tables = read_csv(texts);
    EXPECT_TRUE(tables.has_value());
    const RemarksOrErrors result = import_tables(*tables, sources, target);
    if (const auto* errors = std::get_if<Errors>(&result)) ADD_FAILURE() << parameters::format(*errors);
    return result.index() == 0 ? std::get<Remarks>(result) : Remarks();
  }

  /// The errors; the target must not be there.
  std::string refusal(const std::function<void(Texts&)>& change) {
    Texts texts = as_csv(study.database);
    change(texts);
    const auto tables = read_csv(texts);
    EXPECT_TRUE(tables.has_value());
    const RemarksOrErrors result = import_tables(*tables, sources, target);
    EXPECT_FALSE(std::filesystem::exists(target));
    EXPECT_FALSE(std::filesystem::exists(target.string() + ".tmp"));
    if (const auto* errors = std::get_if<Errors>(&result)) return parameters::format(*errors);
    ADD_FAILURE() << "was imported";
    return {};
  }

  static void replace(std::string& text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    ASSERT_NE(at, text.npos) << from;
    text.replace(at, from.size(), to);
  }
  static void expect_has(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), text.npos) << "'" << part << "' is not in:\n" << text;
  }

  parameters::Study study = sand_study(folder);
  std::filesystem::path target = folder / "copy.sqlite";
};

TEST_F(ImportTables, CsvGivesAnEqualDatabase) {
  EXPECT_EQ(import(as_csv(study.database)), Remarks());
  EXPECT_EQ(all_of(target), all_of(study.database));
  for (const char* name : {"realizations", "windows", "sensitivity", "tornado", "failures"})
    EXPECT_EQ(format(query(target, name), Format::csv), format(query(study.database, name), Format::csv))
        << name;
}

TEST_F(ImportTables, JsonGivesAnEqualDatabase) {
  const std::string json = json_document("campaign export", schema_version, campaign_tables(study.database));
  const auto read = read_json_document(json, "sand.json", "campaign export", schema_version);
  ASSERT_EQ(read.index(), 0U) << parameters::format(std::get<1>(read));
  ASSERT_EQ(import_tables(std::get<0>(read), sources, target).index(), 0U);
  EXPECT_EQ(all_of(target), all_of(study.database));
}

TEST_F(ImportTables, ASecondTripKeepsWhereTheFirstCameFrom) {
  import(as_csv(study.database));
  target = folder / "second.sqlite";
  import(as_csv(folder / "copy.sqlite"));
  EXPECT_EQ(all_of(target), all_of(study.database));
  const Snapshot s = read_snapshot(target);
  ASSERT_EQ(s.imports.size(), 2U);
  EXPECT_EQ(s.imports[0].file, "sand-export/realization.csv");
  EXPECT_EQ(s.imports[1].sha256, std::string(64, 'a'));
  EXPECT_TRUE(read_snapshot(study.database).imports.empty());
}

TEST_F(ImportTables, NoCampaignGoesOnWithImportedResults) {
  import(as_csv(study.database));
  const std::string before = all_of(target);
  parameters::Study own = study;
  own.database = target;
  try {
    open(own);
    FAIL() << "was opened";
  } catch (const Error& error) {
    expect_has(error.what(), "imported from sand-export/realization.csv");
  }
  EXPECT_EQ(all_of(target), before);
  EXPECT_TRUE(salvage(target, 100).runs.empty());
  EXPECT_FALSE(salvage(study.database, 100).runs.empty());
  own.database = folder / "new.sqlite";
  EXPECT_EQ(open(own).adopt(target), 0);
  EXPECT_GT(open(own).adopt(study.database), 0);
}

TEST_F(ImportTables, ChangedNumbersDoNotPassForRecordedOnes) {
  const auto change = [&](Texts& texts) { replace(texts["curve"], "\n3,0.00025,", "\n3,0.000251,"); };
  expect_has(refusal(change), "realization 3 is not what was recorded");
  expect_has(refusal([&](Texts& texts) { replace(texts["realization"], ",12345,", ",12346,"); }),
             "realization 1 is not what was recorded");
}

TEST_F(ImportTables, WithoutItsChecksumAChangedCurveIsAveragedAnew) {
  Texts texts = as_csv(study.database);
  texts["checksum"] = "realization,sha256\n";
  std::string& curve = texts["curve"];  // realization 3: no bins above 0.15 m
  const auto from = curve.find("\n3,"), to = curve.find("\n3,0.15");
  curve.erase(from, to - from);
  const Remarks remarks = import(texts);
  ASSERT_EQ(remarks.size(), 1U);
  expect_has(remarks[0], "1 of the averages given differ");
  EXPECT_NE(all_of(target), all_of(study.database));
}

TEST_F(ImportTables, AveragesWithoutCurvesAreTakenAsGiven) {
  Texts texts = as_csv(study.database);
  texts["checksum"] = "realization,sha256\n";
  texts["curve"] = "realization,depth_m,q_c_Pa,f_s_Pa\n";
  EXPECT_EQ(import(texts), Remarks());
  for (const char* name : {"windows", "sensitivity"})
    EXPECT_EQ(format(query(target, name), Format::csv), format(query(study.database, name), Format::csv));
}

TEST_F(ImportTables, WhatIsWrongIsToldWithItsPlaceAndNothingIsWritten) {
  const auto in = [](const char* table, const char* from, const char* to) {
    return [=](Texts& texts) { replace(texts[table], from, to); };
  };
  expect_has(refusal(in("realization", "status", "statsu")),
             "realization.csv:1:36: error: statsu: is no column of realization");
  expect_has(refusal(in("realization", "status", "statsu")), "did you mean status?");
  expect_has(refusal(in("realization", "status", "statsu")), "the column status is missing");
  expect_has(refusal(in("realization", "completed", "complete")), "realization.csv:2:1: error");
  expect_has(refusal(in("realization", "completed", "complete")), "did_not_converge");
  expect_has(refusal(in("realization", "\n3,", "\n2,")), "realization.csv:4:1: error");
  expect_has(refusal(in("realization", "\n3,", "\n-3,")), "\"-3\" is not a whole number");
  expect_has(refusal(in("curve", "\n1,0.00025,", "\n1,inf,")),
             "curve.csv:2:3: error: depth_m: \"inf\" is not");
  expect_has(refusal(in("curve", "\n1,0.00125,", "\n1,0.0001,")), "0.0001 is not below the depth before it");
  expect_has(refusal(in("curve", "\n1,0.00025,", "\n99,0.00025,")), "FOREIGN KEY");
  expect_has(refusal(in("checksum", "\n3,", "\n99,")), "checksum.csv:4:1: error");
  expect_has(refusal(in("parameter", ",20,", ",twenty,")), "\"twenty\" is not a finite number");
  expect_has(refusal(in("realization", ",upper,75,", ",baseline,75,")), "has 2 baselines");
  expect_has(refusal([](Texts& texts) { texts.erase("realization"); }),
             "this table of the export is missing");
  expect_has(refusal([](Texts& texts) { texts["campaign"].resize(texts["campaign"].find('\n') + 1); }),
             "campaign: has 0 rows");
}

// Under a wrong name, or twice, a table's rows would be lost in silence.
TEST_F(ImportTables, TablesThatAreNoneOrTwiceAreRefused) {
  expect_has(refusal([](Texts& texts) {
               texts["curves"] = texts["curve"];
               texts.erase("curve");
             }),
             "curves.csv: error: curves: is no table of an export\n    hint: did you mean curve?");
  auto tables = *read_csv(as_csv(study.database));
  tables.push_back(tables.front());
  const auto result = import_tables(tables, sources, target);
  ASSERT_EQ(result.index(), 1U);
  expect_has(parameters::format(std::get<1>(result)), "this table is there twice");
}

TEST_F(ImportTables, NumbersWrittenOtherwiseAreRefusedWithAHint) {
  const auto in_parameter = [&](const std::string& number) {
    return refusal([&](Texts& texts) { replace(texts["parameter"], ",20,", "," + number + ","); });
  };
  expect_has(in_parameter("\"20,5\""), "decimals follow a point, not a comma: 20.5");
  expect_has(in_parameter("\"1,020.5\""), "thousands are not set apart: 1020.5");
  expect_has(in_parameter("20 kPa"), "the number alone, without a unit: 20");
  for (const char* number : {"+20", "2D1", "+-20", "20-5",
                             "\xE2\x88\x92"
                             "20"})
    expect_has(in_parameter(number), "is not a finite number");
}

TEST_F(ImportTables, ADatabaseThatIsThereIsLeftAlone) {
  const std::string before = all_of(study.database);
  const auto tables = read_csv(as_csv(study.database));
  EXPECT_THROW((void)import_tables(*tables, sources, study.database), Error);
  EXPECT_EQ(all_of(study.database), before);
}

TEST(JsonDocument, WhatIsWrongIsTold) {
  const auto refused = [](std::string_view json) {
    const auto read = read_json_document(json, "a.json", "campaign export", 4);
    EXPECT_EQ(read.index(), 1U) << json;
    return read.index() == 1 ? parameters::format(std::get<1>(read)) : std::string();
  };
  const std::string head = "{\"format\": \"campaign export\", \"version\": 4, ";
  EXPECT_NE(refused("{\"a\": 1,\n  b}").find("a.json:2:3: error: is not JSON"), std::string::npos);
  EXPECT_NE(refused("[]").find("format"), std::string::npos);
  EXPECT_NE(refused("{\"format\": \"campaign export\", \"version\": 6}").find("from 1 to 4"),
            std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": 3}").find("layer: must be an array"), std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": 1}, {\"b\": 1}]}").find("row 2: lacks \"a\""),
            std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": [1]}]}").find("row 1: \"a\" must be"), std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": 1e999}]}"), "");
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": 1}], \"layer\": [{\"a\": 2}]}").find("layer: is there twice"),
            std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": 1, \"a\": 2}]}").find("a of a row of layer: is there twice"),
            std::string::npos);
  EXPECT_NE(refused(head + "\"layer\": [{\"a\": 0,5}]}").find("a.json:1:"), std::string::npos);
  EXPECT_NE(refused("\xFF\xFE{").find("the file is UTF-16"), std::string::npos);
  EXPECT_EQ(
      read_json_document(std::string_view("\xEF\xBB\xBF{\"format\": \"x\", \"version\": 4}\r\n\x1A\0", 39),
                         "a.json", "x", 4)
          .index(),
      0U);
}

const std::vector<std::string> fragments = {"\n",        ",",
                                            "\"",        "\"\"",
                                            "nan",       "-inf",
                                            "1e308",     "-0",
                                            "1e-320",    "\xff",
                                            "\r",        "-1",
                                            "null",      "[",
                                            "{",         "}",
                                            "]",         ":",
                                            "completed", "99999999999999999999",
                                            "point",     "\xEF\xBB\xBF",
                                            "\\u0000"};

// A smaller campaign, as every mutation makes a database.
class MutatedTables : public ScratchFolder {
 protected:
  MutatedTables() {
    study.rows.resize(2);
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) {
      solver::Outcome outcome = completed(1e6 + id);
      for (auto* values : {&outcome.profile.depth, &outcome.profile.q_c, &outcome.profile.f_s}) {
        values->erase(values->begin(), values->begin() + 300);
        values->resize(12);
      }
      ledger.record(id, id == 3 ? failed(solver::Status::crashed, "signal 11") : outcome);
    }
  }

  /// Imported: it can be read in every way. Refused: with reasons, and nothing is left.
  void expect_sound(const RemarksOrErrors& result) {
    const std::filesystem::path target = folder / "copy.sqlite";
    if (const auto* errors = std::get_if<Errors>(&result)) {
      ++refused;
      EXPECT_FALSE(errors->empty());
      for (const parameters::StudyError& error : *errors) EXPECT_FALSE(error.message.empty());
      EXPECT_FALSE(std::filesystem::exists(target));
    } else {
      ++imported;
      EXPECT_NO_THROW((void)campaign_tables(target));
      std::filesystem::remove(target);
    }
  }

  parameters::Study study = sand_study(folder);
  int imported = 0, refused = 0;
};

TEST_F(MutatedTables, AreImportedOrRefusedWithAReason) {
  const Texts texts = as_csv(study.database);
  std::vector<std::string> names;
  for (const LedgerTable& table : ledger_tables()) names.push_back(table.name);
  std::mt19937 random(20240511);
  for (int i = 0; i < 250; ++i) {
    Texts damaged = texts;
    std::string& text = damaged[names[random() % names.size()]];
    text = fuzz::mutated(text, fragments, random);
    if (const auto tables = read_csv(damaged))
      expect_sound(import_tables(*tables, sources, folder / "copy.sqlite"));
    ASSERT_FALSE(HasFailure()) << "mutation " << i << ":\n" << text;
  }
  EXPECT_GT(imported, 20);
  EXPECT_GT(refused, 20);
}

TEST_F(MutatedTables, AndSoAreDocuments) {
  const std::string json = json_document("campaign export", schema_version, campaign_tables(study.database));
  std::mt19937 random(20240512);
  for (int i = 0; i < 600; ++i) {
    const std::string text = fuzz::mutated(json, fragments, random);
    const auto read = read_json_document(text, "a.json", "campaign export", schema_version);
    if (const auto* tables = std::get_if<0>(&read))
      expect_sound(import_tables(*tables, sources, folder / "copy.sqlite"));
    else
      EXPECT_FALSE(std::get<1>(read).empty());
    ASSERT_FALSE(HasFailure()) << "mutation " << i << ":\n" << text;
  }
  EXPECT_GT(imported, 20);
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace cpt::results
