// Files are there whole or as they were, whoever else writes them and whatever they are.
#include "results/files/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <future>

#include "results/files/vtk_file.hpp"
#include "results/tables/table_format.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class AtomicFile : public ScratchFolder {
 protected:
  [[nodiscard]] std::string name() const { return (folder / "file").string(); }
  [[nodiscard]] int files() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
};

TEST_F(AtomicFile, ReplacesWhatWasThereAndLeavesNothingElse) {
  write_atomically(name(), "one", " two");
  EXPECT_EQ(text_of(name()), "one two");
  replace_file(name(), "three");
  EXPECT_EQ(text_of(name()), "three");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, WritersOfTheSameFileDoNotMixOrFail) {
  constexpr int writers = 8;
  std::vector<std::future<void>> all;
  for (int k = 0; k < writers; ++k)
    all.push_back(std::async(std::launch::async, [this, k] {
      const std::string text(20'000 + 1000 * static_cast<std::size_t>(k), static_cast<char>('a' + k));
      for (int i = 0; i < 30; ++i) replace_file(name(), text);
    }));
  for (auto& one : all) EXPECT_NO_THROW(one.get());
  const std::string text = text_of(name());
  ASSERT_FALSE(text.empty());
  EXPECT_EQ(text, std::string(20'000 + 1000 * static_cast<std::size_t>(text[0] - 'a'), text[0]));
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ALinkStaysAndItsTargetIsReplaced) {
  fs::create_directory(folder / "elsewhere");
  replace_file(folder / "elsewhere" / "target", "old");
  fs::create_symlink("elsewhere/target", name());
  replace_file(name(), "new");
  EXPECT_TRUE(fs::is_symlink(name()));
  EXPECT_EQ(text_of(folder / "elsewhere" / "target"), "new");
}

// A rename would put an ordinary file in the device's place, /dev/null gone for the whole machine.
TEST_F(AtomicFile, DevicesAndPipesAreWrittenToAndStayWhatTheyAre) {
  fs::create_symlink("/dev/null", folder / "null");
  write_csv(folder / "null", {{"a"}, {{1.0}}});
  EXPECT_TRUE(fs::is_symlink(folder / "null"));
  EXPECT_TRUE(fs::is_character_file(fs::path("/dev/null")));

  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  replace_file(folder / "pipe", "through");
  char bytes[16] = {};
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 7);
  EXPECT_STREQ(bytes, "through");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST_F(AtomicFile, ErrorsNameFileCauseAndWhatToDo) {
  fs::create_symlink("/dev/full", folder / "full");
  for (const std::string& error : {error_of([&] {
                                     write_csv(folder / "full", {{"a"}, {{1.0}}});
                                   }),
                                   error_of([&] { write_pvd(folder / "full", {}); }),
                                   error_of([&] { write_atomically(folder / "full", "a", "b"); })})
    EXPECT_EQ(error, (folder / "full").string() +
                         ": cannot be written (No space left on device); free some space, or have the limit "
                         "raised, and run the same command again");
  fs::create_directory(folder / "folder");
  EXPECT_NE(
      error_of([&] { replace_file(folder / "folder", ""); }).find("(Is a directory); a folder is where"),
      std::string::npos);
  EXPECT_NE(error_of([&] { replace_file(folder / "none" / "file", ""); }).find("its folder does not exist"),
            std::string::npos);
  replace_file(name(), "a file");
  EXPECT_NE(error_of([&] { make_folder(name()); }).find("a file is where a folder is needed"),
            std::string::npos);
  EXPECT_NE(error_of([&] { make_folder(fs::path(name()) / "below"); }).find("(Not a directory)"),
            std::string::npos);
}

TEST_F(AtomicFile, NamesMayBeAsLongAsTheSystemTakes) {
  const std::string longest(255, 'n');
  replace_file(folder / longest, "whole");
  EXPECT_EQ(text_of(folder / longest), "whole");
  EXPECT_EQ(files(), 1);
  EXPECT_NE(error_of([&] { replace_file(folder / (longest + "n"), ""); }).find("a name may have 255 bytes"),
            std::string::npos);
}

}  // namespace
}  // namespace cpt::results
