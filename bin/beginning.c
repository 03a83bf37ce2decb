/* What could end the program beside the guard of lib/foundation/system/ending.ml: the runtime of OCaml, while it sets itself up
   and where it finds no memory for its own needs, and long numbers (GMP). They would end it by a signal, or with the
   exit code 2, which here is a verdict. */

#define CAML_INTERNALS
#include <caml/mlvalues.h>
#include <caml/misc.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Those of lib/verification/session/exit_code.ml. */
enum { STOPPED = 4, BUG = 70 };

/* Of lib/foundation/system/held.c and limits.c. */
extern void scc_hold_signals(void);
extern void scc_withhold_errors(void);
extern int scc_errors(void);
extern long long scc_limit_in_bytes(int which);
enum { ADDRESSES, DATA, STACK };

/* Of gmp.h, which need not be where this is compiled; zarith links the library. */
extern void __gmp_set_memory_functions(void *(*)(size_t), void *(*)(void *, size_t, size_t), void (*)(void *, size_t));

/* The lesser of the limits of addresses and of data, in MiB; 0 where there is none. */
static long long limit(void)
{
  long long addresses = scc_limit_in_bytes(ADDRESSES), data = scc_limit_in_bytes(DATA);
  long long least = addresses < 0 || (data >= 0 && data < addresses) ? data : addresses;
  return least < 0 ? 0 : least / 1048576;
}

/* No channel is used, and nothing is allocated. */
static void leave(int code, const char *why, const char *detail)
{
  char line[512], set[128] = "";
  long long mib = code == STOPPED ? limit() : 0;
  if (mib > 0)
    snprintf(set, sizeof set,
             " within the memory limit of %lld MiB that the system sets this process (ulimit -v or -d)", mib);
  int n = snprintf(line, sizeof line, "scc: %s%s%s%.200s\n", why, set, *detail ? ": " : "", detail);
  if (write(scc_errors(), line, n) != n) { /* Nobody can be told. */ }
  _exit(code);
}

/* What the runtime calls fatal is a want of memory, or a fault of the program or of the runtime. A runtime of OCaml 5 that
   finds no memory before it has a domain says that there is no lock of a domain. */
static void on_fatal_error(char *format, va_list arguments)
{
  static const char *const of_memory[] = { "memory", "allocat", "heap", "initiali", "reserve", "create", "domain lock" };
  char what[256];
  vsnprintf(what, sizeof what, format, arguments);
  what[strcspn(what, "\n")] = 0;
  for (size_t i = 0; i < sizeof of_memory / sizeof *of_memory; i++)
    if (strstr(what, of_memory[i]) != NULL) leave(STOPPED, "no memory left", what);
  leave(BUG, "internal error", what);
}

/* The guard ends the program at once. Whoever calls `exit' does it for an exception that came before the guard was
   there, or in it: for want of memory. */
static void on_exit_of_others(void) { leave(STOPPED, "no memory left", ""); }

/* The runtime prints such an exception to C's stderr, and calls `exit'. Nothing flushes this buffer: `leave' writes the
   words of scc instead. */
static char unsaid[4096];

static void *allocated(void *there)
{
  if (there == NULL) leave(STOPPED, "no memory left", "for a number");
  return there;
}

static void *allocate(size_t size) { return allocated(malloc(size)); }
static void release(void *there, size_t size) { (void) size; free(there); }

static void *reallocate(void *there, size_t before, size_t size)
{
  (void) before;
  return allocated(realloc(there, size));
}

/* Below it the runtime cannot set itself up. */
enum { LEAST_STACK = 128 * 1024 };

/* Before the runtime begins. */
__attribute__((constructor)) static void begin(void)
{
  long long stack = scc_limit_in_bytes(STACK);
  if (stack >= 0 && stack < LEAST_STACK)
    leave(STOPPED, "no stack left: the system sets this process a limit of less than 128 KiB (ulimit -s)", "");
  scc_hold_signals();
  scc_withhold_errors();
  setvbuf(stderr, unsaid, _IOFBF, sizeof unsaid);
  caml_fatal_error_hook = on_fatal_error;
  __gmp_set_memory_functions(allocate, reallocate, release);
  atexit(on_exit_of_others);
}
