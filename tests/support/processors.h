#pragma once
#include <string>
#include <vector>

namespace burin::test {

/// A way to run a program as another x86-64 processor would: the prefix of the command and the environment
/// for run_process().
struct Processor {
  std::string name;
  std::vector<std::string> prefix, environment;

  std::vector<std::string> command(std::vector<std::string> words) const {
    words.insert(words.begin(), prefix.begin(), prefix.end());
    return words;
  }
};

/// This processor, this processor without fused multiplication in the C library, an emulated one with all
/// features of the emulator, and an emulated one of 2008 without fused multiplication and AVX. Builds with
/// sanitizers, which the emulator cannot run, have the first two only.
inline std::vector<Processor> processors() {
  std::vector<Processor> all{{"native", {}, {}},
                             {"no FMA", {}, {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2"}}};
#ifdef BURIN_QEMU
  for (const char* model : {"max", "Nehalem"}) all.push_back({model, {BURIN_QEMU, "-cpu", model}, {}});
#endif
  return all;
}

}  // namespace burin::test
