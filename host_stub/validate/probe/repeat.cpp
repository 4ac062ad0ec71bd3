// Runs work in a forked process, whose memory starts as this one's. The result comes back through a pipe.
#include "validate/probe/repeat.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>

#include "validate/probe/check.h"

namespace burin::validate {
namespace {

[[noreturn]] void send(int pipe, const std::function<std::string()>& work) {
  try {
    const std::string text = work();
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t bytes = write(pipe, text.data() + sent, text.size() - sent);
      if (bytes <= 0) _exit(2);
      sent += static_cast<std::size_t>(bytes);
    }
    _exit(0);
  } catch (const Skipped&) {
    _exit(3);
  } catch (const std::exception&) {
    _exit(1);
  }
}

}  // namespace

std::string in_process(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  require(pipe(ends.data()) == 0, "no pipe can be made");
  const pid_t process = fork();
  if (process == 0) send(ends[1], work);
  close(ends[1]);
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t bytes; (bytes = read(ends[0], part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(bytes));
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  if (process > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 3)
    throw Skipped("this machine cannot check it");
  require(process > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0, "a second process fails");
  return text;
}

}  // namespace burin::validate
