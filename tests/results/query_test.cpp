#include "results/tables/query.hpp"

#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class Query : public ScratchFolder {
 protected:
  void SetUp() override {
    Ledger ledger = open(study);
    for (const int id : {1, 2, 4, 5}) ledger.record(id, completed(1e6 * id));
    ledger.record(3, failed(solver::Status::did_not_converge, "said \"no\", twice"));
  }
  parameters::Study study = sand_study(folder);
};

TEST_F(Query, EveryNamedQueryAnswers) {
  ASSERT_EQ(named_queries().size(), 9u);
  for (const NamedQuery& named : named_queries()) {
    if (named.name == "effects" || named.name == "bands" || named.name == "convergence")
      continue;                            // need a design: effects_test.cpp
    if (named.name == "unused") continue;  // needs an edit: unused_test.cpp
    const Table table = query(study.database, named.name);
    EXPECT_FALSE(table.rows.empty()) << named.name;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  }
  EXPECT_EQ(query(study.database, "failures").rows.size(), 1u);
  EXPECT_EQ(query(study.database, "windows").rows.size(), 8u);
  EXPECT_THROW((void)query(study.database, "nonsense"), Error);
}

TEST_F(Query, WindowIsAUsableColumnName) {
  EXPECT_EQ(query_sql(study.database, "SELECT window FROM sensitivity GROUP BY window").rows.size(), 2u);
}

TEST_F(Query, NothingCanBeWritten) {
  const std::string before = dump_without_times(study.database);
  for (const char* sql :
       {"DELETE FROM curve", "UPDATE realization SET status = 'pending'", "DROP TABLE campaign",
        "INSERT INTO layer VALUES (9, 0, 1, 'sand')", "PRAGMA user_version = 5", "VACUUM", "BEGIN",
        "CREATE TEMP TABLE t (x)", "DELETE FROM curve RETURNING realization",
        "WITH x AS (SELECT 1) DELETE FROM curve", "SELECT 1; DELETE FROM curve", "", "SELEC 1"})
    EXPECT_THROW((void)query_sql(study.database, sql), Error) << sql;
  const std::string elsewhere = (folder / "elsewhere.sqlite").string();
  EXPECT_THROW((void)query_sql(study.database, "ATTACH '" + elsewhere + "' AS e"), Error);
  EXPECT_THROW((void)query_sql(study.database, "VACUUM INTO '" + elsewhere + "'"), Error);
  EXPECT_FALSE(std::filesystem::exists(elsewhere));
  EXPECT_EQ(dump_without_times(study.database), before);
}

TEST_F(Query, AWrongStatementIsTheUsersAndToldWithItsPlace) {
  const auto complaint = [&](std::string_view sql) -> std::string {
    try {
      (void)query_sql(study.database, sql);
    } catch (const BadQuery& problem) {
      return problem.what();
    }
    return "no BadQuery";
  };
  EXPECT_EQ(complaint("SELEC 1"), "sql:1:1: near \"SELEC\": syntax error");
  EXPECT_EQ(complaint("select parameter,\n  staus from realization"),
            "sql:2:3: no such column: staus; did you mean status?");
  EXPECT_EQ(complaint("select * from realisation"),
            "sql: no such table: realisation; did you mean realization?");
  EXPECT_EQ(complaint("select r.staus from realization as r"),
            "sql:1:8: no such column: r.staus; did you mean status?");
  EXPECT_EQ(complaint("select qqqqqqqq from realization"),
            "sql:1:8: no such column: qqqqqqqq; docs/schema.md has all tables and columns");
  EXPECT_EQ(complaint(" ; "), "sql: the statement is empty");
  EXPECT_EQ(complaint("select 1; select 2"), "sql: more than one SQL statement");
  EXPECT_EQ(complaint("delete from curve"), "sql: only statements that read are run");
  try {
    (void)query(study.database, "sensitivty");
    ADD_FAILURE();
  } catch (const BadQuery& problem) {
    EXPECT_NE(std::string(problem.what()).find("did you mean sensitivity?"), std::string::npos);
  }
}

// Its reason stands where its indices would.
TEST_F(Query, AWindowWithoutAnExtremeIsUndefinedWithItsReason) {
  parameters::Study rising = study;
  rising.windows[1] = {"peak", parameters::Window::Kind::peak, 0.16, 0.18,
                       0.010};  // q_c falls all through it
  Ledger ledger = open(rising);
  const Table table =
      query_sql(study.database, "SELECT DISTINCT note FROM sensitivity WHERE window = 'peak'");
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_NE(std::get<std::string>(table.rows[0][0])
                .find("undefined: the baseline has no peak between 0.16 and 0.18 m"),
            std::string::npos);
  EXPECT_EQ(query_sql(study.database, "SELECT * FROM window_mean WHERE window = 'peak'").rows.size(), 0u);
}

TEST_F(Query, MissingDatabaseSaysSo) {
  EXPECT_THROW((void)query_sql(folder / "none.sqlite", "SELECT 1"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.sqlite"));
}

const Table sample = {
    {"name", "n", "x"},
    {{std::string("a, \"b\""), std::int64_t{3}, 0.1}, {std::string("φ\nz"), std::monostate{}, 1e-300}}};

TEST(TableFormat, CsvQuotesWhatMustBeQuoted) {
  EXPECT_EQ(format(sample, Format::csv), "name,n,x\n\"a, \"\"b\"\"\",3,0.1\n\"φ\nz\",,1e-300\n");
}

TEST(TableFormat, JsonKeepsTypesAndOrder) {
  EXPECT_EQ(format(sample, Format::json),
            "[\n  {\n    \"name\": \"a, \\\"b\\\"\",\n    \"n\": 3,\n    \"x\": 0.1\n  },\n"
            "  {\n    \"name\": \"φ\\nz\",\n    \"n\": null,\n    \"x\": 1e-300\n  }\n]\n");
}

TEST(TableFormat, TableAlignsNumbersRightAndCountsCodePoints) {
  EXPECT_EQ(format(sample, Format::table),
            "name    n       x\n"
            "------  -  ------\n"
            "a, \"b\"  3     0.1\n"
            "φ z     -  1e-300\n");
}

TEST(TableFormat, EmptyTableSaysSo) {
  EXPECT_EQ(format({{"id"}, {}}, Format::table), "id\n--\n(none)\n");
  EXPECT_EQ(format({{"id"}, {}}, Format::csv), "id\n");
  EXPECT_EQ(format({{"id"}, {}}, Format::json), "[]\n");
}

TEST(TableFormat, NamesAreKnown) {
  EXPECT_EQ(format_from_string("csv"), Format::csv);
  EXPECT_FALSE(format_from_string("xml"));
}

}  // namespace
}  // namespace cpt::results
