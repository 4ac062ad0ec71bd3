#pragma once
#include <string>
#include <vector>

namespace burin::test {

/// A way to run a program as another x86-64 processor would: for run_process(), what goes before the command
/// and its environment.
struct Processor {
  std::string name;
  std::vector<std::string> prefix, environment;

  std::vector<std::string> command(std::vector<std::string> words) const {
    words.insert(words.begin(), prefix.begin(), prefix.end());
    return words;
  }
};

/// This processor, the same without fused multiplication in the C library, an emulated one with all that the
/// emulator knows, and an emulated one of 2008 with neither fused multiplication nor AVX.
/// In builds with sanitizers, which the emulator cannot run, the first two.
inline std::vector<Processor> processors() {
  std::vector<Processor> all{{"native", {}, {}},
                             {"no FMA", {}, {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2"}}};
#ifdef BURIN_QEMU
  for (const char* model : {"max", "Nehalem"}) all.push_back({model, {BURIN_QEMU, "-cpu", model}, {}});
#endif
  return all;
}

}  // namespace burin::test
