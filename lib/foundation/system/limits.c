/* The limits that the system sets this process. */

#include <caml/mlvalues.h>

#include <sys/resource.h>

/* In the order of `Resources.limit': bytes, or -1 without a limit. */
long long scc_limit_in_bytes(int which)
{
  static const int limits[] = { RLIMIT_AS, RLIMIT_DATA, RLIMIT_STACK };
  struct rlimit found;
  if (getrlimit(limits[which], &found) != 0 || found.rlim_cur == RLIM_INFINITY) return -1;
  return found.rlim_cur > Max_long ? -1 : (long long) found.rlim_cur;
}

value scc_limit(value which) { return Val_long(scc_limit_in_bytes(Int_val(which))); }
