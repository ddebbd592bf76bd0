#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace cpt::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::array<Target, 10> all = {{
    {"study", study, "examples", 1500},
    {"request", request, "examples/diagnosis", 1000},
    {"plan", plan, "examples/concealed", 500},
    {"recording", recording, "tests/recordings/corpus", 10000},
    {"triaxial_curve", triaxial_curve, "", 2000},
    {"oedometer_curve", oedometer_curve, "", 2000},
    {"database", database, "", 150},
    {"stored_values", stored_values, "", 150},
    {"hdf5_file", hdf5_file, "", 300},
    {"hdf5_content", hdf5_content, "", 300},
}};

void add_files(const fs::path& folder, std::vector<fs::path>& files) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
}

}  // namespace

std::span<const Target> targets() { return all; }

std::vector<fs::path> corpus(const Target& target) {
  std::vector<fs::path> files;
  add_files(fs::path(PROJECT_ROOT) / "tests/fuzz/corpus" / target.name, files);
  if (!target.seeds.empty()) add_files(fs::path(PROJECT_ROOT) / target.seeds, files);
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> dictionary(const Target& target) {
  std::vector<std::string> words;
  std::ifstream stream(fs::path(PROJECT_ROOT) / "tests/fuzz/dictionaries" /
                       (std::string(target.name) + ".dict"));
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('"')) continue;  // a comment
    std::string& word = words.emplace_back();
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] == '\\' && line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
        i += 3;
      } else {
        word += line[i] == '\\' ? line[++i] : line[i];
      }
    }
  }
  return words;
}

}  // namespace cpt::fuzz
