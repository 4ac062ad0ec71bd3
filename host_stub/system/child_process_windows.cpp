// Runs programs by CreateProcessW(), with temporary files for their output.
#if defined(_WIN32)
#include <burin/base/error.h>
#include <io.h>
#include <windows.h>

#include <filesystem>
#include <system_error>

#include "system/capture_file.h"
#include "system/child_process.h"

namespace burin {
namespace {

/// Quotes an argument by the rules by which the C runtime of the started program splits its command line.
std::wstring quoted(const std::string& argument) {
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : std::filesystem::path(argument).wstring()) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L"\"";
}

HANDLE inherited(const CaptureFile& file) {
  const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(file.stream())));
  SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
  return handle;
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command) {
  const CaptureFile out, err;
  STARTUPINFOW startup{};
  startup.cb = sizeof startup;
  startup.dwFlags = STARTF_USESTDHANDLES;
  startup.hStdOutput = inherited(out);
  startup.hStdError = inherited(err);
  std::wstring line;
  for (const std::string& argument : command) line += (line.empty() ? L"" : L" ") + quoted(argument);
  PROCESS_INFORMATION process{};
  if (!CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &startup,
                      &process)) {
    const std::error_code error(static_cast<int>(GetLastError()), std::system_category());
    throw FileError(command[0], error.message());
  }
  WaitForSingleObject(process.hProcess, INFINITE);
  DWORD exit_code = 0;
  GetExitCodeProcess(process.hProcess, &exit_code);
  CloseHandle(process.hThread);
  CloseHandle(process.hProcess);
  return {static_cast<int>(exit_code), out.text(), err.text()};
}

}  // namespace burin
#endif
