// A machine that fails: a library that is loaded before the C library (LD_PRELOAD) and makes the
// n-th call of a kind fail, or all calls from the n-th on. It counts from the program's main
// function on, for what the system does before is none of the program's. The environment says what
// fails:
//   FAULT=KIND:N[:ERRNO]   the n-th call fails, by this number of errno
//   FAULT=KIND+:N[:ERRNO]  that call and all after it
//   FAULT_COUNT=FILE       at the end the file tells how many calls of the kind there were
//   FAULT_UNNAMED=1        the file system knows no files without a name
//   FAULT_CLOCK=1          the clock on the wall jumps by hours and days at every look
// Kinds: malloc open read write fsync close rename link unlink mkdir mmap thread dup none.

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

// The C library's own allocation, which it exports for such libraries.
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

enum Kind {
  k_malloc,
  k_open,
  k_read,
  k_write,
  k_fsync,
  k_close,
  k_rename,
  k_link,
  k_unlink,
  k_mkdir,
  k_mmap,
  k_thread,
  k_dup,
  k_none
};
constexpr const char* kinds[] = {"malloc", "open",   "read",  "write", "fsync",  "close", "rename",
                                 "link",   "unlink", "mkdir", "mmap",  "thread", "dup",   "none"};
constexpr int usual_errno[] = {ENOMEM, EMFILE, EIO,    ENOSPC, EIO,    EIO,    EACCES,
                               EMLINK, EACCES, ENOSPC, ENOMEM, EAGAIN, EMFILE, 0};

std::atomic<bool> counts{false};
std::atomic<long> calls{0};
Kind failing = k_none;
long at = 0;
bool lasts = false;
int why = 0;
bool is_unnamed_unknown = false;
bool jumps = false;
const char* count_file = nullptr;

void read_environment() {
  is_unnamed_unknown = getenv("FAULT_UNNAMED") != nullptr;
  jumps = getenv("FAULT_CLOCK") != nullptr;
  count_file = getenv("FAULT_COUNT");
  const char* const fault = getenv("FAULT");
  if (fault == nullptr) return;
  for (int kind = 0; kind < k_none; ++kind) {
    const size_t length = strlen(kinds[kind]);
    if (strncmp(fault, kinds[kind], length) != 0) continue;
    const char* rest = fault + length;
    lasts = *rest == '+';
    rest += lasts ? 1 : 0;
    if (*rest != ':') continue;
    failing = static_cast<Kind>(kind);
    why = usual_errno[kind];
    char* end = nullptr;
    at = strtol(rest + 1, &end, 10);
    if (*end == ':') why = static_cast<int>(strtol(end + 1, nullptr, 10));
    return;
  }
}

bool fails(Kind kind) {
  if (kind != failing || !counts.load(std::memory_order_relaxed)) return false;
  const long number = ++calls;
  if (at == 0 || number < at || (number > at && !lasts)) return false;
  errno = why;
  return true;
}

template <typename Function>
Function next(Function, const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

void tell_count() {
  counts = false;
  if (count_file == nullptr) return;
  const auto open_file = next(&open, "open");
  const int file = open_file(count_file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  char text[32];
  const int length = snprintf(text, sizeof text, "%ld\n", calls.load());
  const auto write_file = next(&write, "write");
  if (write_file(file, text, static_cast<size_t>(length)) != length) abort();
  next(&close, "close")(file);
}

int (*real_main)(int, char**, char**) = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  read_environment();
  counts = true;
  const int status = real_main(argc, argv, environment);
  tell_count();
  return status;
}

}  // namespace

#define NEXT(name) static const auto real = next(&name, #name)

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(),
                      void (*fini)(), void (*rtld_fini)(), void* stack_end) {
  using Start =
      int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  const auto real = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return real(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

void* malloc(size_t size) {
  return fails(k_malloc) ? nullptr : __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  return fails(k_malloc) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
  return fails(k_malloc) ? nullptr : __libc_realloc(old, size);
}
void* memalign(size_t alignment, size_t size) {
  return fails(k_malloc) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(k_malloc) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** to, size_t alignment, size_t size) {
  if (fails(k_malloc)) return ENOMEM;
  *to = __libc_memalign(alignment, size);
  return *to == nullptr ? ENOMEM : 0;
}

// O_TMPFILE has the bit of O_DIRECTORY in it.
static bool makes_file(int flags) {
  return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

#define OPEN(name)                                                    \
  int name(const char* path, int flags, ...) {                        \
    NEXT(name);                                                       \
    va_list rest;                                                     \
    va_start(rest, flags);                                            \
    const mode_t mode = makes_file(flags) ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                     \
    if (is_unnamed_unknown && (flags & O_TMPFILE) == O_TMPFILE) {     \
      errno = EOPNOTSUPP;                                             \
      return -1;                                                      \
    }                                                                 \
    return fails(k_open) ? -1 : real(path, flags, mode);              \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                  \
  int name(int folder, const char* path, int flags, ...) {            \
    NEXT(name);                                                       \
    va_list rest;                                                     \
    va_start(rest, flags);                                            \
    const mode_t mode = makes_file(flags) ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                     \
    return fails(k_open) ? -1 : real(folder, path, flags, mode);      \
  }
OPENAT(openat)
OPENAT(openat64)

FILE* fopen(const char* path, const char* mode) {
  NEXT(fopen);
  return fails(k_open) ? nullptr : real(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  NEXT(fopen64);
  return fails(k_open) ? nullptr : real(path, mode);
}
ssize_t read(int file, void* to, size_t size) {
  NEXT(read);
  return fails(k_read) ? -1 : real(file, to, size);
}
ssize_t __read_chk(int file, void* to, size_t size, size_t) {
  return read(file, to, size);
}
ssize_t pread(int file, void* to, size_t size, off_t from) {
  NEXT(pread);
  return fails(k_read) ? -1 : real(file, to, size, from);
}
ssize_t pread64(int file, void* to, size_t size, off64_t from) {
  NEXT(pread64);
  return fails(k_read) ? -1 : real(file, to, size, from);
}
ssize_t __pread_chk(int file, void* to, size_t size, off_t from, size_t) {
  return pread(file, to, size, from);
}
ssize_t __pread64_chk(int file, void* to, size_t size, off64_t from, size_t) {
  return pread64(file, to, size, from);
}
ssize_t write(int file, const void* from, size_t size) {
  NEXT(write);
  // What a program says of the fault is no fault's.
  return file != STDERR_FILENO && fails(k_write) ? -1 : real(file, from, size);
}
ssize_t pwrite(int file, const void* from, size_t size, off_t to) {
  NEXT(pwrite);
  return fails(k_write) ? -1 : real(file, from, size, to);
}
ssize_t pwrite64(int file, const void* from, size_t size, off64_t to) {
  NEXT(pwrite64);
  return fails(k_write) ? -1 : real(file, from, size, to);
}
int ftruncate(int file, off_t size) noexcept {
  NEXT(ftruncate);
  return fails(k_write) ? -1 : real(file, size);
}
int ftruncate64(int file, off64_t size) noexcept {
  NEXT(ftruncate64);
  return fails(k_write) ? -1 : real(file, size);
}
int fsync(int file) {
  NEXT(fsync);
  return fails(k_fsync) ? -1 : real(file);
}
int fdatasync(int file) {
  NEXT(fdatasync);
  return fails(k_fsync) ? -1 : real(file);
}
int close(int file) {
  NEXT(close);
  const bool is_failing = fails(k_close);
  const int done = real(file);  // the number is free even so
  if (!is_failing) return done;
  errno = why;
  return -1;
}
int rename(const char* from, const char* to) noexcept {
  NEXT(rename);
  return fails(k_rename) ? -1 : real(from, to);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  NEXT(renameat2);
  return fails(k_rename) ? -1 : real(from_folder, from, to_folder, to, flags);
}
int link(const char* from, const char* to) noexcept {
  NEXT(link);
  return fails(k_link) ? -1 : real(from, to);
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  NEXT(linkat);
  return fails(k_link) ? -1 : real(from_folder, from, to_folder, to, flags);
}
int unlink(const char* path) noexcept {
  NEXT(unlink);
  return fails(k_unlink) ? -1 : real(path);
}
int mkdir(const char* path, mode_t mode) noexcept {
  NEXT(mkdir);
  return fails(k_mkdir) ? -1 : real(path, mode);
}
void* mmap(void* place, size_t size, int protection, int flags, int file, off_t from) noexcept {
  NEXT(mmap);
  return fails(k_mmap) ? MAP_FAILED : real(place, size, protection, flags, file, from);
}
void* mmap64(void* place, size_t size, int protection, int flags, int file, off64_t from) noexcept {
  NEXT(mmap64);
  return fails(k_mmap) ? MAP_FAILED : real(place, size, protection, flags, file, from);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* with) noexcept {
  NEXT(pthread_create);
  return fails(k_thread) ? why : real(thread, attributes, run, with);
}
int fcntl(int file, int command, ...) {
  NEXT(fcntl);
  va_list rest;
  va_start(rest, command);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  return (command == F_DUPFD_CLOEXEC || command == F_DUPFD) && fails(k_dup)
             ? -1
             : real(file, command, argument);
}

// A clock on the wall that jumps. The steady one does not: no administrator can set it.
static void jump(time_t& seconds) {
  static std::atomic<unsigned> looks{0};
  constexpr long jumps_by[] = {0, 86400, -3600, 5400, -864000, 31536000, -60, -31536000};
  if (jumps) seconds += jumps_by[looks++ % 8];
}
int clock_gettime(clockid_t clock, timespec* now) noexcept {
  NEXT(clock_gettime);
  const int failed = real(clock, now);
  if (failed == 0 && clock == CLOCK_REALTIME) jump(now->tv_sec);
  return failed;
}
int gettimeofday(timeval* now, void* zone) noexcept {
  NEXT(gettimeofday);
  const int failed = real(now, zone);
  if (failed == 0) jump(now->tv_sec);
  return failed;
}
time_t time(time_t* to) noexcept {
  timespec now = {};
  clock_gettime(CLOCK_REALTIME, &now);
  if (to != nullptr) *to = now.tv_sec;
  return now.tv_sec;
}

}  // extern "C"
