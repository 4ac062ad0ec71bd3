#include <burin/abi/ext/log.h>
#include <burin/abi/ext/volume.h>
#include <burin/host/plugin/services.h>
#include <gtest/gtest.h>

#include <string>

namespace burin {
namespace {

std::string logged;

TEST(Services, PassLinesToTheLog) {
  const HostServices services([](int severity, std::string_view line) {
    logged = std::to_string(severity) + " " + std::string(line);
  });
  const burin_host* host = services.abi();
  const auto* log = static_cast<const burin_log*>(host->get_extension(host, BURIN_EXT_LOG));
  ASSERT_NE(log, nullptr);
  log->write(host, BURIN_LOG_WARNING, "blunt");
  EXPECT_EQ(logged, "3 blunt");
  log->write(host, BURIN_LOG_WARNING, nullptr);
}

TEST(Services, WithholdWhatThisHostDoesNotHave) {
  const HostServices services(nullptr);
  EXPECT_EQ(services.abi()->get_extension(services.abi(), BURIN_EXT_VOLUME), nullptr);
  EXPECT_EQ(services.abi()->get_extension(services.abi(), nullptr), nullptr);
  EXPECT_EQ(services.abi()->abi_major, BURIN_ABI_MAJOR);
}

}  // namespace
}  // namespace burin
