// Preloaded into a run: its system time is set back an hour as soon as the file $F1TENTH_SET_BACK is there. Monotonic
// clocks go on. Debian's libfaketime is not used, because Python cannot sleep under it.
#include <dlfcn.h>
#include <pthread.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>

namespace
{
constexpr time_t kHour = 3600;                  // s
constexpr time_t kLongestMonotonic = 10 << 24;  // s: deadlines beyond, five years, are times of the system's clock

template <class Function>
Function * original(Function *, const char * name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_NEXT, name));
}

time_t setBack()
{
  static const char * const file = std::getenv("F1TENTH_SET_BACK");
  return file != nullptr && access(file, F_OK) == 0 ? kHour : 0;
}
}  // namespace

extern "C" {
int clock_gettime(clockid_t clock, timespec * now) noexcept
{
  static auto * const read = original(&clock_gettime, "clock_gettime");
  const int result = read(clock, now);
  if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) {
    now->tv_sec -= setBack();
  }
  return result;
}

int gettimeofday(timeval * now, void *) noexcept
{
  timespec exact{};
  const int result = clock_gettime(CLOCK_REALTIME, &exact);
  *now = {exact.tv_sec, exact.tv_nsec / 1000};
  return result;
}

time_t time(time_t * now) noexcept
{
  timespec exact{};
  clock_gettime(CLOCK_REALTIME, &exact);
  if (now != nullptr) {
    *now = exact.tv_sec;
  }
  return exact.tv_sec;
}

// The system knows nothing of the shift, so it gets deadlines in its own time.
int pthread_cond_timedwait(pthread_cond_t * condition, pthread_mutex_t * mutex, const timespec * deadline)
{
  static auto * const wait = original(&pthread_cond_timedwait, "pthread_cond_timedwait");
  timespec real = *deadline;
  real.tv_sec += real.tv_sec > kLongestMonotonic ? setBack() : 0;
  return wait(condition, mutex, &real);
}
}
