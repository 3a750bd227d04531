#include "loaders/shapes/child_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr rlim_t kCpuSecondsMax = 60;
// A child of a process with threads may find a lock held for ever; a limit of wall time ends it all the same.
constexpr unsigned kWallSecondsMax = 600;
// What the child sends is one of these, then the result or the message.
constexpr char kDone = 'd';
constexpr char kThrown = 't';

void writeAll(int to, const std::string & bytes)
{
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::write(to, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno != EINTR) {
      return;
    }
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

std::string readAll(int from)
{
  std::string bytes;
  std::array<char, 65536> part{};
  for (ssize_t count = 1; count != 0;) {
    count = ::read(from, part.data(), part.size());
    if (count < 0 && errno != EINTR) {
      break;
    }
    bytes.append(part.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return bytes;
}

/// @param hard  what the kernel enforces with SIGKILL, where `soft` is a signal that tells its cause
void limit(decltype(RLIMIT_CORE) what, rlim_t soft, rlim_t hard)
{
  const rlimit limits{soft, hard};
  ::setrlimit(what, &limits);
}

[[noreturn]] void runAsChild(const std::function<std::string()> & work, int answer)
{
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_CPU, kCpuSecondsMax, kCpuSecondsMax + 1);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  for (const int ends_us : {SIGABRT, SIGALRM, SIGSEGV, SIGINT, SIGTERM, SIGXCPU}) {
    std::signal(ends_us, SIG_DFL);
  }
  ::alarm(kWallSecondsMax);
  try {
    writeAll(answer, kDone + work());
  } catch (const std::exception & error) {
    writeAll(answer, kThrown + std::string(error.what()));
  }
  ::_exit(0);
}

int waitFor(pid_t child)
{
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Why the child has not answered.
std::string reasonOf(int signal)
{
  switch (signal) {
    case SIGXCPU:
      return "takes longer than " + std::to_string(kCpuSecondsMax) + " s of the processor's time to read";
    case SIGALRM:
      return "takes longer than " + std::to_string(kWallSecondsMax) + " s to read";
    case SIGKILL:
      return "what reads it is killed, as when memory runs out";
    default:
      return "crashes what reads it (" + std::string(::strsignal(signal)) + ")";
  }
}
}  // namespace

std::string resultOfChild(const std::function<std::string()> & work)
{
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw Error("cannot be read: " + std::string(std::strerror(errno)));
  }
  const pid_t child = ::fork();
  if (child == 0) {
    runAsChild(work, ends[1]);
  }
  ::close(ends[1]);
  const std::string answer = child > 0 ? readAll(ends[0]) : "";
  ::close(ends[0]);
  if (child < 0) {
    throw Error("cannot be read: no process can be started");
  }
  const int status = waitFor(child);
  if (WIFSIGNALED(status)) {
    throw Error(reasonOf(WTERMSIG(status)));
  }
  if (answer.empty() || answer.front() != kDone) {
    throw Error(answer.empty() ? "cannot be read" : answer.substr(1));
  }
  return answer.substr(1);
}
}  // namespace f1tenth_sim2d
