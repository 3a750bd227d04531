// A fixed amount of arithmetic, of memory work and of sending messages, which tells how fast this machine is just now.
// Uses nothing of the workspace, so that no change of the workspace changes it.
#include <benchmark/benchmark.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <thread>
#include <vector>

namespace
{
/// A chain of divisions and roots, in which every step waits for the one before, and a loop over floats in the first
/// level cache, which may use a vector unit: the two kinds of arithmetic in a simulator.
void calculate()
{
  double x = 1.5;
  for (int i = 0; i < 1'000'000; ++i) {
    x = std::sqrt(1.0 + x) + 1.0 / x;
  }
  std::vector<float> lanes(2048);
  std::iota(lanes.begin(), lanes.end(), 1.0F);
  for (int i = 0; i < 20'000; ++i) {
    for (float & lane : lanes) {
      lane = 0.75F * lane + 3.0F / (1.0F + lane * lane);
    }
  }
  benchmark::DoNotOptimize(x + std::accumulate(lanes.begin(), lanes.end(), 0.0F));
}

/// A walk through 256 KiB in an order that no prefetcher predicts, and copies of 256 KiB: what a simulation touches all
/// the time. More would ask how much of a shared cache the machine's other guests leave, which differs threefold from
/// one minute to the next and is not what the measured programs wait for.
class MemoryWork
{
public:
  MemoryWork() : next_(1U << 16U), source_(1U << 15U, 1.0), target_(source_.size())
  {
    // One cycle through all cells: of a power of two, this generator has the full period.
    for (std::uint32_t i = 0; i < next_.size(); ++i) {
      next_[i] = (1664525U * i + 1013904223U) % next_.size();
    }
  }

  void run()
  {
    std::uint32_t cell = 0;
    for (int i = 0; i < 3'000'000; ++i) {
      cell = next_[cell];
    }
    for (int i = 0; i < kCopies; ++i) {
      std::copy(source_.begin(), source_.end(), target_.begin());
      std::copy(target_.begin(), target_.end(), source_.begin());
    }
    benchmark::DoNotOptimize(cell + source_[cell]);
  }

private:
  static constexpr int kCopies = 300;

  std::vector<std::uint32_t> next_;
  std::vector<double> source_;
  std::vector<double> target_;
};

/// The result of a system call, if it has succeeded.
int succeeded(int result, const char * what)
{
  if (result < 0) {
    std::perror(what);
    std::exit(1);
  }
  return result;
}

/// Messages of the size of an odometry through TCP, to another thread and back: what nodes that talk to each other ask
/// of the kernel. Both share a processor, so that each message costs a switch from one to the other, and always the
/// same: on two, it depends on whether the other one sleeps.
class MessageWork
{
public:
  MessageWork()
  {
    const int listener = succeeded(socket(AF_INET, SOCK_STREAM, 0), "socket");
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto * const any = reinterpret_cast<sockaddr *>(&address);
    succeeded(bind(listener, any, size), "bind");
    succeeded(listen(listener, 1), "listen");
    succeeded(getsockname(listener, any, &size), "getsockname");
    answerer_ = succeeded(socket(AF_INET, SOCK_STREAM, 0), "socket");
    succeeded(connect(answerer_, any, size), "connect");
    asker_ = succeeded(accept(listener, nullptr, nullptr), "accept");
    const int at_once = 1;
    succeeded(setsockopt(asker_, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once), "setsockopt");
    close(listener);
  }

  MessageWork(const MessageWork &) = delete;
  MessageWork & operator=(const MessageWork &) = delete;

  ~MessageWork()
  {
    close(asker_);
    close(answerer_);
  }

  void run() const
  {
    cpu_set_t one = {};
    CPU_SET(succeeded(sched_getcpu(), "sched_getcpu"), &one);
    cpu_set_t all = {};
    succeeded(sched_getaffinity(0, sizeof all, &all), "sched_getaffinity");
    succeeded(sched_setaffinity(0, sizeof one, &one), "sched_setaffinity");
    std::thread answering([this] {
      for (int i = 0; i < kRoundTrips; ++i) {
        receive(answerer_);
        send(answerer_);
      }
    });
    for (int i = 0; i < kRoundTrips; ++i) {
      send(asker_);
      receive(asker_);
    }
    answering.join();
    succeeded(sched_setaffinity(0, sizeof all, &all), "sched_setaffinity");
  }

private:
  using Message = std::array<char, 720>;

  static constexpr int kRoundTrips = 2000;

  static void send(int socket)
  {
    const Message message = {};
    succeeded(static_cast<int>(write(socket, message.data(), message.size())), "write");
  }

  static void receive(int socket)
  {
    pollfd arrival = {socket, POLLIN, 0};
    succeeded(poll(&arrival, 1, -1), "poll");
    Message message = {};
    succeeded(static_cast<int>(recv(socket, message.data(), message.size(), MSG_WAITALL)), "recv");
  }

  int answerer_ = -1;
  int asker_ = -1;
};

void arithmetic(benchmark::State & state)
{
  for ([[maybe_unused]] const auto each : state) {
    calculate();
  }
}

template <typename Work>
void runs(benchmark::State & state)
{
  static Work work;  // warm in all repetitions but the first
  for ([[maybe_unused]] const auto each : state) {
    work.run();
  }
}

void severalTimes(benchmark::internal::Benchmark * benchmark)
{
  benchmark->Iterations(1)->Repetitions(5)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(arithmetic)->Apply(severalTimes);
BENCHMARK(runs<MemoryWork>)->Name("memory")->Apply(severalTimes);
BENCHMARK(runs<MessageWork>)->Name("messages")->Apply(severalTimes);
}  // namespace

BENCHMARK_MAIN();
