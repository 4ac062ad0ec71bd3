#include <burin/abi/ext/log.h>
#include <gtest/gtest.h>

#include "host_stub/system/console.h"

namespace burin {
namespace {

TEST(Console, MarksWarningsAndLinesForDebugging) {
  ::testing::internal::CaptureStderr();
  log_on_console(BURIN_LOG_DEBUG, "a");
  log_on_console(BURIN_LOG_INFO, "b");
  log_on_console(BURIN_LOG_WARNING, "c");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "burin: debug: a\nburin: b\nburin: warning: c\n");
}

}  // namespace
}  // namespace burin
