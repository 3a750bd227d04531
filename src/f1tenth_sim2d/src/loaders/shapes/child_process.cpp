#include "loaders/shapes/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
[[noreturn]] void failToStart(const std::string & program, int error)
{
  throw Error("cannot be read: " + program + " cannot be started: " + std::strerror(error));
}

/// What a program starts with: signals as by default, output to a pipe, nothing else.
class Start
{
public:
  explicit Start(int output)
  {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, output, kOutputDescriptor);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&files_, descriptor, "/dev/null", O_RDWR, 0);
    }
    posix_spawn_file_actions_addclosefrom_np(&files_, kOutputDescriptor + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  Start(const Start &) = delete;
  Start & operator=(const Start &) = delete;
  ~Start()
  {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  pid_t run(const std::vector<std::string> & command) const
  {
    std::vector<char *> arguments;
    for (const std::string & argument : command) {
      arguments.push_back(const_cast<char *>(argument.c_str()));
    }
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (const int error = posix_spawn(&child, arguments[0], &files_, &attributes_, arguments.data(), environ)) {
      failToStart(command[0], error);
    }
    return child;
  }

private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

/// A pipe whose ends close by themselves, and before that by hand.
struct Pipe
{
  std::array<int, 2> ends{-1, -1};

  ~Pipe()
  {
    close(0);
    close(1);
  }
  void close(std::size_t end)
  {
    if (ends.at(end) >= 0) {
      ::close(std::exchange(ends.at(end), -1));
    }
  }
};

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

std::string outputOf(const std::vector<std::string> & command)
{
  Pipe pipe;
  if (::pipe2(pipe.ends.data(), O_CLOEXEC) != 0) {
    failToStart(command.at(0), errno);
  }
  const pid_t child = Start(pipe.ends[1]).run(command);
  pipe.close(1);
  std::string output = readAll(pipe.ends[0]);
  const int status = waitFor(child);
  if (WIFSIGNALED(status)) {
    throw Error(reasonOf(WTERMSIG(status)));
  }
  if (WEXITSTATUS(status) != 0) {
    throw Error(output.empty() ? "cannot be read" : output);
  }
  return output;
}
}  // namespace f1tenth_sim2d
