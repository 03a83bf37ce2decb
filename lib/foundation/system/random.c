/* Random bytes from the kernel itself: there may be no /dev/urandom, as in a bare tree. */

#include <caml/mlvalues.h>

#include <unistd.h>
#if defined(__linux__) || defined(__APPLE__)
#include <sys/random.h>
#endif

/* Fills a buffer of at most 256 bytes; false if the kernel has no such call. */
value scc_random_fill(value buffer)
{
  return Val_bool(getentropy(Bytes_val(buffer), caml_string_length(buffer)) == 0);
}
