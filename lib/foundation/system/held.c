/* Requests to end the program that come before it can answer them. */

#include <caml/mlvalues.h>
#include <caml/signals.h>

#include <signal.h>
#include <stddef.h>

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
