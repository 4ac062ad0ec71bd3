// Runs a short version of `./dev fuzz`: seeds for every reader, intact and damaged.

#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "peak_memory.h"
#include "readers.h"
#include "support/shared_data.h"

namespace burin::fuzz {
namespace {

namespace fs = std::filesystem;

/// Damages bytes as files are damaged and as fuzzers do it.
class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string of(std::string bytes) {
    for (std::size_t times = 1 + below(3); times > 0 && !bytes.empty(); --times) once(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

  void once(std::string& bytes) {
    const std::size_t at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 2:
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << below(8));
        break;
      case 3:
        bytes.erase(at, 1 + below(8));
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(32)));
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), numbers[below(std::size(numbers))]);
    }
  }

  static constexpr const char* numbers[] = {"4294967295",      "-1", "1e308", "nan", "\xff\xff\xff\xff",
                                            "\x7f\xff\xff\xff"};
  std::mt19937 random_;
};

class Corpus : public testing::TestWithParam<Reader> {
 protected:
  test::TemporaryFolder folder_;
};

TEST_P(Corpus, HoldsFilesThatAreRead) {
  const std::vector<fs::path> seeds = write_seeds(GetParam(), folder_.path());
  EXPECT_FALSE(seeds.empty());
  for (const fs::path& seed : seeds) {
    // Shows the message that a refusal would have.
    EXPECT_NO_THROW(GetParam().read(seed)) << seed.filename();
    if (GetParam().compare) EXPECT_NO_THROW(GetParam().compare(seed)) << seed.filename();
  }
}

TEST_P(Corpus, IsReadOrRefusedHoweverDamagedAndWithoutMuchMemory) {
  constexpr unsigned seed = 13;
  std::cout << "seed " << seed << "\n";
  Damage damage(seed);
  const fs::path file = folder_.path() / ("damaged" + std::string(GetParam().extension));
  const double before = peak_memory();
  std::size_t accepted = 0, refused = 0;
  for (const fs::path& whole : write_seeds(GetParam(), folder_.path())) {
    const std::string bytes = read_file(whole);
    for (int i = 0; i < 300; ++i) {
      const std::string damaged = damage.of(bytes);
      write_file_whole(file, [&](std::ostream& out) { out << damaged; });
      ++(accepts_however_read(GetParam(), file) ? accepted : refused);
    }
  }
  EXPECT_GT(accepted, 0u);
  EXPECT_GT(refused, 0u);
  EXPECT_LT(peak_memory() - before, 700e6);
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(readers().begin(), readers().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace burin::fuzz
