// Stands between a program and the system (LD_PRELOAD), and makes a call fail that the environment names:
//
//     REFRASTER_FAULT="write 3 once 28"    the 3rd write to a file fails with errno 28; "on" for once: and all after it
//     REFRASTER_FAULT="write 3 short 0"    … takes only half
//     REFRASTER_FAULT="write 3 kill 0"     … is not reached: SIGKILL
//     REFRASTER_FAULT="malloc 3 once 0"    the 3rd allocation of 16 KiB or more gives none
//     REFRASTER_FAULT_HIT=FILE             made when that happens
//     REFRASTER_NO_NAMELESS=1              there are no files without a name
//     REFRASTER_REPLACED="m.obj unlink"    a file of that name is removed, or becomes a pipe ("pipe") or a folder
//                                          ("folder"), when it is opened to be read: behind every check of its name
//
// Calls are open, write, fsync, close, linkat, rename; they count for files that were opened to be written.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

extern "C" {
void* __libc_malloc(std::size_t);                // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);   // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void*, std::size_t);        // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t, std::size_t); // NOLINT(bugprone-reserved-identifier)
}

namespace {

constexpr std::size_t large = 16 << 10; // libgomp ends the process if it gets no few bytes

struct Fault {
  char call[16] = "";
  char how[16] = "";
  long number = 0;
  int error = 0;
  const char* hit = nullptr;
  bool is_set = false;
};

Fault fault;
bool no_nameless = false;
char replaced_name[256] = "", replacement[16] = "";
std::atomic<long> calls{0};
std::atomic<bool> written[4096]; // descriptors of files that were opened to be written

__attribute__((constructor)) void read_environment() {
  if (const char* const text = std::getenv("REFRASTER_FAULT"))
    fault.is_set = std::sscanf(text, "%15s %ld %15s %d", fault.call, &fault.number, fault.how, &fault.error) == 4;
  no_nameless = std::getenv("REFRASTER_NO_NAMELESS") != nullptr;
  fault.hit = std::getenv("REFRASTER_FAULT_HIT");
  if (const char* const text = std::getenv("REFRASTER_REPLACED"))
    if (std::sscanf(text, "%255s %15s", replaced_name, replacement) != 2) replaced_name[0] = '\0';
}

bool is(const char* a, const char* b) {
  return std::strcmp(a, b) == 0;
}

/// Whether this call is the one.
bool fails(const char* call) {
  if (!fault.is_set || !is(call, fault.call)) return false;
  const long now = ++calls;
  if (now != fault.number && !(is(fault.how, "on") && now > fault.number)) return false;
  if (fault.hit) {
    const long file = syscall(SYS_openat, AT_FDCWD, fault.hit, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (file >= 0) syscall(SYS_close, file);
  }
  if (is(fault.how, "kill")) kill(getpid(), SIGKILL);
  return true;
}

int failed() {
  errno = fault.error;
  return -1;
}

bool is_written(int descriptor) {
  return descriptor >= 0 && descriptor < 4096 && written[descriptor];
}

void replace(const char* path) {
  const char* const slash = std::strrchr(path, '/');
  if (replaced_name[0] == '\0' || !is(slash ? slash + 1 : path, replaced_name)) return;
  unlink(path);
  if (is(replacement, "pipe")) mkfifo(path, 0600);
  if (is(replacement, "folder")) mkdir(path, 0700);
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
  const bool writes = (flags & O_ACCMODE) != O_RDONLY && std::strncmp(path, "/dev/", 5) != 0;
  if (!writes) replace(path);
  if (no_nameless && (flags & O_TMPFILE) == O_TMPFILE) return errno = EOPNOTSUPP, -1;
  if (writes && fails("open")) return failed();
  const auto descriptor = static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
  if (descriptor >= 0 && descriptor < 4096) written[descriptor] = writes;
  return descriptor;
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, mode_t) : 0;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_at(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  if (is_written(descriptor) && fails("write")) {
    if (!is(fault.how, "short")) return failed();
    if (size > 1) size /= 2;
  }
  return syscall(SYS_write, descriptor, bytes, size);
}

int fsync(int descriptor) {
  if (is_written(descriptor) && fails("fsync")) return failed();
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

int close(int descriptor) {
  const bool fault_here = is_written(descriptor) && fails("close");
  if (is_written(descriptor)) written[descriptor] = false;
  const auto result = static_cast<int>(syscall(SYS_close, descriptor)); // closed whatever it says, close(2)
  return fault_here ? failed() : result;
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  if (fails("linkat")) return failed();
  return static_cast<int>(syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}

int rename(const char* from, const char* to) {
  if (fails("rename")) return failed();
  return static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}

void* malloc(std::size_t size) {
  if (size >= large && fails("malloc")) return errno = ENOMEM, nullptr;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  if (count * size >= large && fails("malloc")) return errno = ENOMEM, nullptr;
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
  if (size >= large && fails("malloc")) return errno = ENOMEM, nullptr;
  return __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (size >= large && fails("malloc")) return errno = ENOMEM, nullptr;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  if (size >= large && fails("malloc")) return ENOMEM;
  *memory = __libc_memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}

} // extern "C"
