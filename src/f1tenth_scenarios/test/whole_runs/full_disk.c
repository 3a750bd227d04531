// Preloaded: nothing new can be made below the folder FULL_DISK, as on a disk without space.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int is_refused(const char * path)
{
  const char * full = getenv("FULL_DISK");
  return full && strncmp(path, full, strlen(full)) == 0 && access(path, F_OK) != 0;
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define REFUSE(path, failure) \
  if (is_refused(path)) {     \
    errno = ENOSPC;           \
    return failure;           \
  }
#define OPEN(name)                            \
  int name(const char * path, int flags, ...) \
  {                                           \
    va_list rest;                             \
    va_start(rest, flags);                    \
    const mode_t mode = va_arg(rest, mode_t); \
    va_end(rest);                             \
    if (flags & O_CREAT) {                    \
      REFUSE(path, -1)                        \
    }                                         \
    return NEXT(name)(path, flags, mode);     \
  }
#define OPENAT(name)                                      \
  int name(int folder, const char * path, int flags, ...) \
  {                                                       \
    va_list rest;                                         \
    va_start(rest, flags);                                \
    const mode_t mode = va_arg(rest, mode_t);             \
    va_end(rest);                                         \
    if (flags & O_CREAT) {                                \
      REFUSE(path, -1)                                    \
    }                                                     \
    return NEXT(name)(folder, path, flags, mode);         \
  }
#define FOPEN(name)                                 \
  FILE * name(const char * path, const char * mode) \
  {                                                 \
    if (*mode != 'r') {                             \
      REFUSE(path, NULL)                            \
    }                                               \
    return NEXT(name)(path, mode);                  \
  }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)
FOPEN(fopen)
FOPEN(fopen64)
int mkdir(const char * path, mode_t mode)
{
  REFUSE(path, -1)
  return NEXT(mkdir)(path, mode);
}
