/* What waits until the program can answer for itself: requests to end it, and its standard error. */

#include <caml/mlvalues.h>
#include <caml/signals.h>

#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <unistd.h>

static int held = 0;
static sigset_t before;

/* Called before the runtime begins: the signals of interruption.ml wait. */
void scc_hold_signals(void)
{
  static const int waiting[] = { SIGINT, SIGTERM, SIGHUP, SIGXCPU };
  sigset_t set;
  sigemptyset(&set);
  for (size_t i = 0; i < sizeof waiting / sizeof *waiting; i++) sigaddset(&set, waiting[i]);
  held = sigprocmask(SIG_BLOCK, &set, &before) == 0;
}

/* Signals that wait are delivered now, and so are later ones. */
value scc_heed_signals(value unit)
{
  if (held) {
    held = 0;
    sigprocmask(SIG_SETMASK, &before, NULL);
    caml_process_pending_actions();
  }
  return unit;
}

/* Standard error, while descriptor 2 leads nowhere. */
static int withheld = -1;

/* Called before the runtime begins: until `scc_give_errors', what others write to standard error is dropped. OCaml would
   report an exception there that comes before its handler is set up. */
void scc_withhold_errors(void)
{
  int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  withheld = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (withheld >= 0) dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

/* Where the program itself can write. */
int scc_errors(void) { return withheld >= 0 ? withheld : STDERR_FILENO; }

value scc_give_errors(value unit)
{
  if (withheld >= 0) {
    dup2(withheld, STDERR_FILENO);
    close(withheld);
    withheld = -1;
  }
  return unit;
}
